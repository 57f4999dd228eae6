"""Made by `python3 -m isolux._stub`; a test compares."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

Progress = bool | Callable[[float, str], Any] | None
Path = str | os.PathLike[str]
Look = Literal["blinn_phong", "lambert", "tone", "kappa1", "kappa2", "mean_curvature", "gaussian_curvature", "shape_index", "curvedness", "curvature_2d", "accessibility", "edge_offset", "flow", "gi", "normal", "depth"]

SettingsDict = TypedDict("SettingsDict", {
    "source.path": str | os.PathLike[str],  # The volume: a file, a DICOM folder, a triangle mesh, or phantom:NAME[:SIZE].
    "source.raw": str | os.PathLike[str],  # How to read a file without a header: "WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]".
    "source.series": str | os.PathLike[str],  # The SeriesInstanceUID to take from a DICOM folder; empty takes the series with most slices.
    "source.component": int,  # Which component of a file with several per voxel; -1 is their magnitude.
    "source.time_step": int,  # Which time step of a file with several.
    "source.kind": Literal["auto", "ct_hu", "ct", "mr", "microscopy", "simulation", "distance", "labels", "other"],  # What kind of data the volume is: a CT in Hounsfield units or in others, an MR scan, a distance field; auto decides by its file and its values. Presets and the first isovalue depend on it.
    "source.level": int,  # How coarsely a large file is read: 0 is its own voxels, each further level the means of twice as many along each axis, from the file where it has them.
    "source.around_damage": bool,  # Whether voxels that cannot be read of a file in chunks are missing ones; otherwise the file is refused.
    "source.mesh_voxels": int,  # How finely a triangle mesh becomes a distance field: voxels along its longest axis.
    "source.csg": Literal["none", "union", "intersection", "difference"],  # How a second volume is combined with the first, as solids on one grid.
    "source.csg_path": str | os.PathLike[str],  # The second volume, as source.path. A phantom without SIZE is made on the first volume's grid.
    "source.csg_value": float | Literal["auto"] | None,  # The isovalue of the second volume's surface, in its own units; auto takes the suggested one.
    "isosurface.name": str | os.PathLike[str],  # What the surface is called in lists and at its line on the histogram.
    "isosurface.value": float | Literal["auto"] | None,  # The isovalue; auto is by isosurface.suggestion.
    "isosurface.suggestion": Literal["object", "contrast"],  # What an automatic isovalue is: the border of the whole object to what surrounds it (skin in a scan of a head), or the clearest border within it (often bone).
    "isosurface.inside": Literal["above", "below"],  # Which side of the isovalue is solid; the normal points away from it.
    "isosurface.albedo": Sequence[Any] | str,  # The diffuse reflectance of the surface.
    "isosurface.albedo_source": Literal["color", "map"],  # Whether isosurfaces have the reflectances given, or those of a colour map over the isovalue.
    "isosurface.albedo_map": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # The colour map over the isovalue; auto is viridis.
    "isosurface.albedo_low": float | Literal["auto"] | None,  # The isovalue at the lower end of that map; auto is the volume's minimum.
    "isosurface.albedo_high": float | Literal["auto"] | None,  # The isovalue at the upper end of that map; auto is the volume's maximum.
    "isosurface.opacity": float,  # How much of what lies behind the surface it hides; 1 hides all.
    "isosurface.facing_opacity": float,  # Times the opacity where the surface faces the viewer; where it is seen edge on it keeps its opacity.
    "isosurface.layers": int,  # How many crossings along a ray are composited at most, where surfaces are transparent.
    "isosurface.ghost": float,  # Draws the first surface twice more, transparent, at its isovalue plus and minus this many times the noise: how far noise may move it; 0 draws none.
    "isosurface.ghost_opacity": float,  # How much of what lies behind them those two surfaces hide.
    "isosurface.clipped": bool,  # Whether planes and box of clip. cut the first surface, too.
    "isosurface2.shown": bool,  # Draws one more isosurface of the same volume.
    "isosurface2.name": str | os.PathLike[str],  # What that surface is called.
    "isosurface2.value": float | Literal["auto"] | None,  # Its isovalue; auto takes the next suggestion of the histogram outside the first surface, or inside where there is none.
    "isosurface2.albedo": Sequence[Any] | str,  # The diffuse reflectance of that surface.
    "isosurface2.opacity": float,  # How much of what lies behind that surface it hides; 1 hides all.
    "isosurface2.facing_opacity": float,  # Times that opacity where the surface faces the viewer.
    "isosurface2.clipped": bool,  # Whether planes and box of clip. cut that surface, too.
    "isosurface3.shown": bool,  # Draws one more isosurface of the same volume.
    "isosurface3.name": str | os.PathLike[str],  # What that surface is called.
    "isosurface3.value": float | Literal["auto"] | None,  # Its isovalue; auto takes the next suggestion of the histogram outside the first surface, or inside where there is none.
    "isosurface3.albedo": Sequence[Any] | str,  # The diffuse reflectance of that surface.
    "isosurface3.opacity": float,  # How much of what lies behind that surface it hides; 1 hides all.
    "isosurface3.facing_opacity": float,  # Times that opacity where the surface faces the viewer.
    "isosurface3.clipped": bool,  # Whether planes and box of clip. cut that surface, too.
    "isosurface4.shown": bool,  # Draws one more isosurface of the same volume.
    "isosurface4.name": str | os.PathLike[str],  # What that surface is called.
    "isosurface4.value": float | Literal["auto"] | None,  # Its isovalue; auto takes the next suggestion of the histogram outside the first surface, or inside where there is none.
    "isosurface4.albedo": Sequence[Any] | str,  # The diffuse reflectance of that surface.
    "isosurface4.opacity": float,  # How much of what lies behind that surface it hides; 1 hides all.
    "isosurface4.facing_opacity": float,  # Times that opacity where the surface faces the viewer.
    "isosurface4.clipped": bool,  # Whether planes and box of clip. cut that surface, too.
    "pieces.keep": int,  # How many connected pieces of each isosurface are shown, the largest first; 0 shows all.
    "pieces.smallest": float,  # Pieces that enclose less than this are not shown.
    "pieces.hidden": Sequence[Any] | str,  # World points; pieces that hold one of them are not shown.
    "pieces.only": Sequence[Any] | str,  # World points; where there are any, only pieces that hold one of them are shown.
    "pieces.within": float | Literal["auto"] | None,  # Only pieces of which at least half lies in the body above this value are shown, the skin's for example: a headrest and a table are not. What is thinner than 8 mm is no body; auto shows pieces wherever they lie.
    "pieces.depth": float,  # How deep in that body half of a piece must lie, as a fraction of the body's greatest depth: a brain does, its scalp does not.
    "clip.planes": Sequence[Any] | str,  # Up to six planes "px,py,pz nx,ny,nz; ...", a point and a normal each: what lies on the side that the normal points to is cut away.
    "clip.box": Sequence[Any] | str,  # Two opposite corners "x,y,z; x,y,z" of a box outside which everything is cut away; none cuts nothing.
    "clip.box_rotation": Sequence[Any] | str,  # How the box is turned about its centre.
    "clip.removed": Sequence[Any] | str,  # Two opposite corners "x,y,z; x,y,z" of each of up to eight boxes in which everything is cut away; they may lie far outside the volume.
    "clip.cap": Literal["none", "inside", "whole"],  # What cut faces show: nothing, the voxels' values where the inside was cut, or the values of the whole face.
    "slice.level": float | Literal["auto"] | None,  # The value shown as middle grey in slices and on cut faces; auto is found from the volume.
    "slice.width": float | Literal["auto"] | None,  # How far values reach from black to white there; auto is found from the volume.
    "slice.map": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # Their colour map; auto is gray.
    "slice.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # The reconstruction that slices and cut faces show between the voxels.
    "slice.slab": float,  # How thick slices are, half before and half behind their plane; 0 shows the plane itself.
    "slice.slab_mode": Literal["mean", "maximum", "minimum"],  # What a thick slice shows of the values along its normal.
    "slice.convention": Literal["radiological", "neurological"],  # Whether the patient's right is on the left of axial and coronal slices (radiological), or on the right.
    "slice.contour_width": float,  # The width of the isosurfaces' curves in slices; 0 draws none.
    "slice.noise_band": float,  # Fills where the first surface's curve would lie at its isovalue plus and minus this many times the noise; 0 fills nothing.
    "slice.position": Sequence[Any] | str | Literal["auto"] | None,  # Where the three slices meet; auto is the centre of the volume.
    "marks.list": Sequence[Any] | str,  # What is marked and measured: a list of {kind, name, points, color, shown}.
    "hit.method": Literal["sampled", "exact"],  # How rays find the surface: equidistant samples with refinement, or the first root of the interpolant in every cell.
    "hit.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # The reconstruction whose surface is hit: trilinear; the tri-cubic B-spline, which is the smoothest and shrinks what is thin until it is gone; or the B-spline that passes through the samples, which holds wires, twigs and vessels together where trilinear hits draw beads.
    "hit.rate": float,  # How densely a ray is sampled; method sampled only.
    "hit.near_factor": float,  # How many times denser the samples are near the isovalue; method sampled only.
    "hit.near_threshold": float | Literal["auto"] | None,  # Samples closer to the isovalue than this are near; auto is what the volume's values change by from one sample to the next; method sampled only.
    "hit.refinements": int,  # Regula falsi steps after a sampled hit; method sampled only.
    "derivatives.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # The reconstruction that gradients and curvature come from: trilinear, the tri-cubic B-spline, or the B-spline that passes through the samples.
    "derivatives.fetch": Literal["fast", "exact"],  # How cubic derivatives read the volume: by the texture unit's linear filter, whose weights many GPUs round to 8 bits, or by single voxels weighted in float.
    "derivatives.noise": float | Literal["auto"] | None,  # Standard deviation of the noise of a voxel, which the confidence in curvature is measured against; auto estimates it from the volume.
    "derivatives.scale": float | Literal["auto"] | None,  # The scale of curvature, lines and flow: standard deviation of the Gaussian that the volume is smoothed with before second derivatives are taken, the same in all directions; 0 smooths nothing, auto chooses by the noise.
    "derivatives.normal_scale": float | Literal["auto"] | None,  # The same for the normals of shading and contours.
    "edge.search": float | Literal["auto"] | None,  # How far along the normal, each way, the edge of the object is looked for; auto takes what the spacing and the scale ask for.
    "edge.contrast": float,  # How far the gradient at an edge must stand out of what noise makes of gradients; weaker ones are no edges.
    "color.volume": str | os.PathLike[str],  # A second volume that colours the surface by its values there, as source.path; empty takes none.
    "color.raw": str | os.PathLike[str],  # How to read it, as source.raw.
    "color.component": int,  # Which of its components, as source.component.
    "color.time_step": int,  # Which of its time steps, as source.time_step.
    "color.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # The reconstruction its values are taken from.
    "color.map": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # The colour map over its values; auto is viridis.
    "color.low": float | Literal["auto"] | None,  # The value at the lower end of the map; auto is found from what the surface shows.
    "color.high": float | Literal["auto"] | None,  # The value at the upper end of the map; auto is found from what the surface shows.
    "color.below": float,  # Shows the largest value within this distance below the surface; 0 shows that of the surface itself.
    "color.strength": float,  # How much of the surface's own colour is covered.
    "color.fade": bool,  # Lets the strength rise from nothing at the lower end of the map to its value at the upper end.
    "color.isolines": float,  # Lines of equal values this far apart; 0 draws none.
    "color.isoline_width": float,  # Their width.
    "look.mode": Literal["blinn_phong", "lambert", "tone", "kappa1", "kappa2", "mean_curvature", "gaussian_curvature", "shape_index", "curvedness", "curvature_2d", "accessibility", "edge_offset", "flow", "gi", "normal", "depth"],  # What the picture shows: the surface under a shading, or a measure of it in colour.
    "look.shading": Literal["unlit", "lambert", "blinn_phong", "tone", "gi"],  # The shading under the modes that give a colour: the curvature maps, accessibility and flow; gi is stored global illumination.
    "look.ambient": float,  # Light from everywhere, as a fraction of the albedo.
    "look.ambient_variation": float,  # How much brighter the ambient light is from above the picture than from below.
    "look.specular": float,  # Strength of the highlight.
    "look.shininess": float,  # Exponent of the highlight; larger is smaller and sharper.
    "look.tone_cool": Sequence[Any] | str,  # Tone shading: the colour of what faces away from the light.
    "look.tone_warm": Sequence[Any] | str,  # Tone shading: the colour of what faces the light.
    "look.inner_tint": Sequence[Any] | str,  # Multiplies the surface's own colour where its inner side is seen; white is no tint.
    "look.texture": Literal["none", "marble", "wood", "checker"],  # A solid texture, carved from rather than wrapped around the surface; varies the albedo.
    "look.texture_scale": float | Literal["auto"] | None,  # Size of the solid texture's features; auto is a tenth of the volume.
    "look.shadow": float,  # Strength of the light's hard shadow, found by a second exact ray from each point.
    "look.occlusion": float,  # How much what stands near keeps light away, as far as the picture shows it: darkens crevices.
    "look.occlusion_radius": float | Literal["auto"] | None,  # How far things count as near; auto is a fifth of the volume.
    "look.fog": float,  # How much the far end of the volume fades.
    "look.fog_color": Sequence[Any] | str | Literal["auto"] | None,  # What distant things fade to; auto is the background.
    "look.colormap": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # Colours of a measure; auto takes a diverging map for what has a sign, else viridis.
    "look.range_low": float | Literal["auto"] | None,  # The measure at the lower end of the colour map; auto from the surface's own values.
    "look.range_high": float | Literal["auto"] | None,  # The measure at the upper end of the colour map; auto from the surface's own values.
    "look.curvature_points": Sequence[Any] | str | Literal["auto"] | None,  # Mode curvature_2d: control points [kappa1, kappa2, r, g, b] of the colour map, kappas in parts of the range; auto is hue by the kind of shape and saturation by how curved it is.
    "look.legend": bool,  # Draws a legend with units where colours stand for numbers.
    "look.legend_corner": Literal["auto", "lower_right", "lower_left", "upper_right", "upper_left"],  # Where the legend stands; auto is the corner that shows least of the surface.
    "look.accessibility": float,  # Darkens what is hollow, by curvature, as if dirt had gathered there.
    "look.ridges": float,  # Strength of ridge and valley lines: where the surface is most curved, across the line.
    "look.ridge_threshold": float | Literal["auto"] | None,  # Curvature from which on a ridge or valley is drawn; auto from the surface's own values.
    "look.ridge_width": float,  # Width of ridge and valley lines, in the unit of look.ridge_width_unit.
    "look.ridge_width_unit": Literal["pixels", "mm"],  # Whether ridge and valley lines are as wide in the picture or on the surface.
    "look.ridge_length": float | Literal["auto"] | None,  # Ridges and valleys that are shorter, or shorter than 3 % of the picture's width, fade out; auto is the radius of the least curvature that is drawn.
    "look.ridge_color": Sequence[Any] | str,  # Colour of ridges.
    "look.valley_color": Sequence[Any] | str,  # Colour of valleys.
    "look.contours": float | Literal["auto"] | None,  # Strength of the silhouette lines; auto is 0.5 under tone shading, else none.
    "look.suggestive_contours": float,  # Strength of suggestive contours: where a silhouette would appear from nearby.
    "look.contour_width": float,  # Width of contour lines, the same all over the picture.
    "look.contour_color": Sequence[Any] | str,  # Colour of contour lines.
    "look.background_top": Sequence[Any] | str,  # Background at the top of the picture.
    "look.background_bottom": Sequence[Any] | str,  # Background at the bottom of the picture.
    "flow.strength": float,  # Streaks along the directions of curvature, over any look.
    "flow.direction": Literal["maximum", "minimum"],  # Along the direction of the larger or of the smaller principal curvature.
    "flow.length": float,  # Length of a streak.
    "flow.grain": float,  # Size of the noise's grains.
    "flow.animate": bool,  # Lets the streaks move, in the window.
    "flow.speed": float,  # How often the pattern passes in a second.
    "flow.time": float,  # Where the animation stands.
    "light.setup": Literal["three_point", "key"],  # How the surface is lit: three_point by the light (the key light), a fill light and rim lights, each kept away by what stands near; key by the light alone.
    "light.space": Literal["camera", "world"],  # Whether the light moves with the viewer or stays with the volume.
    "light.direction": Sequence[Any] | str,  # Toward the light, in camera axes (right, up, toward the viewer) or world axes; any length but zero.
    "light.color": Sequence[Any] | str,  # Colour of the light.
    "light.intensity": float,  # Brightness of the light.
    "light.fill": float,  # Brightness of a light from the viewer's other side, in parts of the light's own.
    "light.rim": float,  # Brightness of two lights from behind, left and right, in parts of the light's own.
    "light.headlight": float,  # Brightness of a white light at the eye.
    "light.environment.file": str | os.PathLike[str],  # The light probe around everything, equirectangular, its first row up: .hdr, .exr, ...; empty is none.
    "light.environment.constant": Sequence[Any] | str | Literal["auto"] | None,  # The radiance of a sky of one colour, where there is no light probe; auto is none.
    "light.environment.builtin": Literal["studio", "window", "overcast", "sunset"],  # The light where there is neither a light probe nor a sky of one colour.
    "light.environment.azimuth": float,  # Turns the environment about the vertical: counterclockwise from above.
    "light.environment.elevation": float,  # Tilts the environment before it is turned: raises the light that comes from the front.
    "light.environment.rotation": Sequence[Any] | str,  # Turns the environment from its own axes to the world's, before azimuth and elevation.
    "light.environment.exposure": float,  # Multiplies the environment's radiance by 2 to this power.
    "light.environment.moves": bool,  # The environment will be turned or exchanged: gi.mode auto then stores light so that this costs nothing anew.
    "light.environment.visible": bool,  # Shows the environment behind the surface.
    "lamp1.shown": bool,  # Switches on a lamp of global illumination.
    "lamp1.kind": Literal["point", "directional", "sphere"],  # A point, a distant lamp, or a luminous sphere.
    "lamp1.position": Sequence[Any] | str | Literal["auto"] | None,  # Where a point or sphere is; auto is above the volume, toward the front and the left.
    "lamp1.direction": Sequence[Any] | str,  # Toward a distant lamp, world axes; any length but zero.
    "lamp1.radius": float | Literal["auto"] | None,  # Of a luminous sphere; larger gives softer shadows; auto is a tenth of the volume.
    "lamp1.angle": float,  # Diameter of a distant lamp as seen from the volume; the sun has 0.53, 0 gives hard shadows.
    "lamp1.color": Sequence[Any] | str,  # Colour of the lamp.
    "lamp1.intensity": float,  # Brightness of a white surface at the volume's centre that faces the lamp.
    "lamp2.shown": bool,  # Switches on a lamp of global illumination.
    "lamp2.kind": Literal["point", "directional", "sphere"],  # A point, a distant lamp, or a luminous sphere.
    "lamp2.position": Sequence[Any] | str | Literal["auto"] | None,  # Where a point or sphere is; auto is above the volume, toward the front and the left.
    "lamp2.direction": Sequence[Any] | str,  # Toward a distant lamp, world axes; any length but zero.
    "lamp2.radius": float | Literal["auto"] | None,  # Of a luminous sphere; larger gives softer shadows; auto is a tenth of the volume.
    "lamp2.angle": float,  # Diameter of a distant lamp as seen from the volume; the sun has 0.53, 0 gives hard shadows.
    "lamp2.color": Sequence[Any] | str,  # Colour of the lamp.
    "lamp2.intensity": float,  # Brightness of a white surface at the volume's centre that faces the lamp.
    "lamp3.shown": bool,  # Switches on a lamp of global illumination.
    "lamp3.kind": Literal["point", "directional", "sphere"],  # A point, a distant lamp, or a luminous sphere.
    "lamp3.position": Sequence[Any] | str | Literal["auto"] | None,  # Where a point or sphere is; auto is above the volume, toward the front and the left.
    "lamp3.direction": Sequence[Any] | str,  # Toward a distant lamp, world axes; any length but zero.
    "lamp3.radius": float | Literal["auto"] | None,  # Of a luminous sphere; larger gives softer shadows; auto is a tenth of the volume.
    "lamp3.angle": float,  # Diameter of a distant lamp as seen from the volume; the sun has 0.53, 0 gives hard shadows.
    "lamp3.color": Sequence[Any] | str,  # Colour of the lamp.
    "lamp3.intensity": float,  # Brightness of a white surface at the volume's centre that faces the lamp.
    "gi.mode": Literal["auto", "off", "irradiance", "transfer", "vicinity", "shadow"],  # What is stored of the light: irradiance (static light), transfer (spherical harmonics: the environment may move), vicinity (a sky of one colour, no bounces), shadow (no bounces); auto takes the least that the scene needs.
    "gi.extent": Literal["full", "band", "view"],  # Which texels are lit: all, those that isovalues of gi.band can show, or those that are seen.
    "gi.band": Sequence[Any] | str | Literal["auto"] | None,  # The isovalues of interest, low and high; auto is a twentieth of the volume's range about the isovalue.
    "gi.texels": Literal["auto", "own", "shown"],  # Where texels are lit: each on its own isosurface, so that light is there for every isovalue, or where the shown isosurface passes it, which is more exact and of one isovalue; auto is shown with gi.extent=view. Where several isosurfaces are shown, texels are lit on their own.
    "gi.samples": int,  # More have less noise: four times as many halve it.
    "gi.sequence": Literal["sobol_owen", "r2", "random"],  # The directions of a texel's paths: scrambled Sobol points, Roberts' R2 with a shift for each texel, or independent random numbers.
    "gi.bounces": int,  # Diffuse reflections on a light's way to a texel; 0 is direct light only.
    "gi.roulette_depth": int,  # From this bounce on paths end at random, with the probability that light is absorbed.
    "gi.environment_share": float | Literal["auto"] | None,  # The part of the directions that is drawn from the environment instead of the surface; auto is 0.75 under a light probe, 0.5 with more than one bounce.
    "gi.lattice_scale": float,  # How finely light is stored.
    "gi.interpolation": Literal["closest_isovalue", "nearest", "trilinear", "tricubic", "weighted"],  # How stored light is read between texels; weighted favours texels whose normal fits, and takes the noise out along their isosurfaces.
    "gi.precision": Literal["r11g11b10", "half"],  # Numbers in which irradiance is kept on the graphics card: 4 or 8 bytes per texel.
    "gi.sh_order": int,  # Bands of spherical harmonics of stored transfer; more follow sharper light.
    "gi.sh_window": float,  # Damps high bands of the environment against ringing.
    "gi.components": int,  # Stored transfer is compressed to at most this many principal components.
    "gi.component_bits": int,  # On average: those that vary more get more. A texel's bits are rounded up to 32.
    "camera.eye": Sequence[Any] | str | Literal["auto"] | None,  # Where the viewer is; auto is by camera.frames.
    "camera.target": Sequence[Any] | str | Literal["auto"] | None,  # The point looked at and turned about; auto is the centre of what is framed.
    "camera.up": Sequence[Any] | str | Literal["auto"] | None,  # The direction that points up in the picture; auto is superior (y for meshes), or anterior (the front) when looking along it.
    "camera.frames": Literal["surface", "volume"],  # What fills the picture of an automatic camera: the surface, a patient's from the front, anything else's from where most of it is seen; or the volume, from the front.
    "camera.fov": float,  # Vertical field of view; an orthographic picture is as high as this at the target's distance.
    "camera.projection": Literal["perspective", "orthographic"],  # Whether distant things look smaller.
    "picture.supersampling": int,  # Anti-aliasing of a picture at rest.
    "picture.rest_hits": Literal["auto", "same", "cubic_interpolating"],  # The reconstruction whose surface pictures at rest show where hit.field is trilinear: the same, or the B-spline that passes through the samples; auto takes that where more than a tenth of the visible surface lies over a tenth of a voxel beside it. Deferred images (--aov) and stored light keep hit.field.
    "picture.exposure": float | Literal["auto"] | None,  # Brightness of pictures lit by global illumination; auto is by picture.metering.
    "picture.metering": Literal["surface", "lights"],  # What an automatic exposure fits: the lit surface as it is seen from the front, whatever the view, or the lights, so that a white surface in the open is nearly white.
    "picture.letters": bool,  # Letters at the edges of the finished picture: which end of the patient's axes, or of the world's where the file states no orientation, lies there. The window always shows them.
    "picture.scale_bar": bool,  # A bar of a round length on the finished picture; in perspective it is that of the depth of camera.target. The window always shows it.
    "picture.isovalue": bool,  # The isovalues of the surfaces that are shown, with their unit, on the finished picture.
    "picture.caveats": bool,  # A line on the finished picture for each thing that it leaves out or that nobody measured: pieces that are hidden, missing slices that are interpolated. Without any, nothing is written.
    "picture.transparent": bool,  # The finished picture has no background: its alpha is how much of each pixel is covered.
    "picture.pixel_ratio": float,  # Pixels of the finished picture for each pixel that widths and lengths of lines and streaks are stated in: 2 in a picture twice as large, for the same look.
    "memory.gpu_budget_mb": int,  # Graphics memory that the voxels may use.
    "memory.layout": Literal["auto", "whole", "bricks"],  # The volume as one texture, or as bricks of which only those needed are resident; auto takes one texture where it fits.
    "memory.voxels": Literal["auto", "memory", "file"],  # Where a volume's voxels are while it is drawn: all in memory, or in the file, of which parts are read when they are needed; auto leaves them in the file where they do not fit into memory.
    "memory.ram_budget_mb": int,  # Memory for parts of a volume that stays in its file.
    "gi.threads": int | Literal["auto"] | None,  # Threads that compute light; auto is one per core.
    "picture.adaptive": bool,  # Pictures in motion shrink until they are quick enough; the full picture follows at rest.
    "picture.motion_target": float,  # How long a picture in motion may take.
    "picture.executor": Literal["auto", "gpu", "cpu"],  # What computes hits and derivatives of pictures: the graphics card, or the processor (exact hits only); auto takes the processor where OpenGL is software.
}, total=False)

class IsoluxWarning(UserWarning): ...

class Record(dict[str, Any]):
    def __getattr__(self, name: str) -> Any: ...

class Setting:
    path: str
    type: str
    default: Any
    unit: str
    meaning: str
    automatic: bool
    of: str
    choices: tuple[str, ...]
    minimum: float | None
    maximum: float | None
    def allowed(self) -> str: ...
    def text(self) -> str: ...

class Settings(Mapping[str, Setting]):
    def __getattr__(self, name: str) -> Any: ...
    def __getitem__(self, path: str) -> Setting: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...

class Picture:
    def __init__(self, drawn: Any) -> None: ...
    @property
    def size(self) -> tuple[int, int]: ...
    @property
    def image(self) -> NDArray[np.uint8] | None: ...
    @property
    def linear(self) -> NDArray[np.float32] | None: ...
    @property
    def aov(self) -> Record: ...
    @property
    def stats(self) -> Record: ...
    @property
    def session(self) -> str: ...
    def save(self, path: Path) -> None: ...
    def _repr_png_(self) -> bytes | None: ...
    def __array__(self, dtype: Any = ...) -> NDArray[Any]: ...

class Volume:
    def __init__(self, array: ArrayLike, spacing: float | Sequence[float] = ..., origin: Sequence[float] = ..., directions: ArrayLike = ..., axes: str = ..., *, name: str = ..., unit: str = ..., anatomical: bool = ..., progress: Progress = ...) -> None: ...
    @property
    def axes(self) -> str: ...
    @property
    def shape(self) -> tuple[int, int, int]: ...
    @property
    def spacing(self) -> tuple[float, float, float]: ...
    @property
    def directions(self) -> NDArray[np.float64]: ...
    @property
    def origin(self) -> tuple[float, float, float]: ...
    @property
    def name(self) -> str: ...
    @property
    def unit(self) -> str: ...
    @property
    def kind(self) -> str: ...
    @property
    def range(self) -> tuple[float, float]: ...
    @property
    def suggested_isovalue(self) -> float: ...
    @property
    def warnings(self) -> list[str]: ...
    @property
    def facts(self) -> Record: ...
    def world(self, index: ArrayLike) -> NDArray[np.float64]: ...
    def close(self) -> None: ...
    def render(self, isovalue: float | None = ..., look: Look | None = ..., size: tuple[int, int] | None = ..., camera: str | Sequence[Any] | Mapping[str, Any] | None = ..., aovs: str | Iterable[str] = ..., settings: SettingsDict | Mapping[str, Any] | None = ..., *, environment: Path | None = ..., image: bool = ..., linear: bool = ..., light: Path = ..., light_around: bool = ..., accuracy: bool = ..., explain: bool = ..., context: Literal["auto", "software", "egl", "osmesa"] = ..., progress: Progress = ..., **view: Any) -> Picture: ...
    def forget_light(self) -> None: ...
    def hits(self, origins: ArrayLike, directions: ArrayLike, isovalue: float | None = ..., *, settings: SettingsDict | Mapping[str, Any] | None = ..., progress: Progress = ...) -> Record: ...
    def probe(self, points: ArrayLike, isovalue: float | None = ..., *, settings: SettingsDict | Mapping[str, Any] | None = ..., progress: Progress = ...) -> Record: ...
    def measure(self, isovalue: float | None = ..., *, anyway: bool = ..., settings: SettingsDict | Mapping[str, Any] | None = ..., progress: Progress = ...) -> Record: ...
    def bake(self, path: Path, isovalue: float | None = ..., *, environment: Path | None = ..., overwrite: bool = ..., mix_arithmetic: bool = ..., settings: SettingsDict | Mapping[str, Any] | None = ..., progress: Progress = ...) -> Record: ...
    def study(self, knobs: str | Iterable[str] = ..., isovalue: float | None = ..., *, size: tuple[int, int] | None = ..., repeat: int = ..., settings: SettingsDict | Mapping[str, Any] | None = ..., progress: Progress = ...) -> Record: ...
    def __enter__(self) -> "Volume": ...
    def __exit__(self, *_: Any) -> None: ...

def open(path: Path, *, settings: SettingsDict | Mapping[str, Any] | None = ..., raw: str = ..., progress: Progress = ...) -> Volume: ...
def from_nibabel(image: Any, *, progress: Progress = ...) -> Volume: ...
def film(pictures: Iterable[Picture | NDArray[np.uint8]], path: Path, fps: float = ...) -> str: ...
def settings(word: str = ...) -> Settings: ...
def doctor(progress: Progress = ...) -> str: ...

__all__: list[str]
__version__: str
