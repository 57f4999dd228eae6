"""Made by `python3 -m isolux._stub`; a test compares."""

import os
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from typing import Any, Literal, TypedDict

import numpy as np
from numpy.typing import ArrayLike, NDArray

Progress = bool | Callable[[float, str], Any] | None
Path = str | os.PathLike[str]
Look = Literal["blinn_phong", "lambert", "tone", "kappa1", "kappa2", "mean_curvature", "gaussian_curvature", "shape_index", "curvedness", "flowline_curvature", "curvature_2d", "accessibility", "edge_offset", "flow", "gi", "normal", "curvature_direction", "depth"]

SettingsDict = TypedDict("SettingsDict", {
    "source.path": str | os.PathLike[str],  # Volume to draw: a file, a DICOM folder, a triangle mesh, or phantom:NAME[:SIZE].
    "source.raw": str | os.PathLike[str],  # Layout of a file without a header: "WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]".
    "source.series": str | os.PathLike[str],  # SeriesInstanceUID of the series to read from a DICOM folder; empty selects the series with the most slices.
    "source.component": int,  # Channel to read from a file with several values per voxel; -1 reads the magnitude of the vector.
    "source.time_step": float,  # Time step to read from a file with several, counted from 0; a fraction blends a step with the next.
    "source.kind": Literal["auto", "ct_hu", "ct", "mr", "microscopy", "simulation", "distance", "labels", "other"],  # Kind of data: CT in Hounsfield or other units, MR, distance field …; auto derives it from the file and its values. Presets and the first isovalue depend on it.
    "source.level": int,  # Resolution level of a large file: 0 is full resolution, each further level halves it along each axis. Levels stored in the file are used; others are averaged.
    "source.around_damage": bool,  # Treats unreadable voxels of a chunked file as missing; otherwise the file is rejected.
    "source.mesh_voxels": int,  # Resolution of the distance field made from a triangle mesh: voxels along the longest axis.
    "source.labels": str | os.PathLike[str],  # Labels of a label map whose surface is drawn: numbers, ranges and names, as "2,4-7,liver"; empty draws all but 0.
    "source.smoothing": float,  # Smoothing of the surface of labels: standard deviation of the Gaussian. Every voxel's centre keeps its label whatever it is; 0 shows the voxels' own steps.
    "source.label_names": str | os.PathLike[str],  # File that names the labels, instead of what the volume states: .tsv, .ctbl, .label, .txt, .json.
    "source.csg": Literal["none", "union", "intersection", "difference", "blend"],  # Boolean operation that combines a second volume with the first, as solids on one grid.
    "source.csg_path": str | os.PathLike[str],  # Second volume of the Boolean operation, given as in source.path. A phantom without SIZE uses the first volume's grid.
    "source.csg_value": float | Literal["auto"] | None,  # Isovalue of the second volume, in its own units; auto uses the suggested one.
    "source.csg_weight": float,  # Weight of the second volume where source.csg is blend: 0 shows the first volume's surface, 1 the second's.
    "isosurface.suggestion": Literal["object", "contrast"],  # Automatic isovalue of the first surface: the boundary of the whole object (skin in a scan of a head), or the clearest boundary inside it (often bone).
    "isosurface.inside": Literal["above", "below"],  # Side of the isovalue that is solid; the normal points away from it.
    "isosurface.albedo_source": Literal["color", "map"],  # Source of the isosurfaces' reflectances: a colour per surface, or a colour map over the isovalue.
    "isosurface.albedo_map": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # Colour map over the isovalue; auto is viridis.
    "isosurface.albedo_low": float | Literal["auto"] | None,  # Isovalue at the lower end of that map; auto is the volume's minimum.
    "isosurface.albedo_high": float | Literal["auto"] | None,  # Isovalue at the upper end of that map; auto is the volume's maximum.
    "isosurface.layers": int,  # Maximum number of surface crossings composited along a ray, where surfaces are transparent.
    "isosurface.ghost_opacity": float,  # Opacity of the uncertainty surfaces.
    "pieces.keep": int,  # Maximum number of connected components (pieces) shown per isosurface, largest first; 0 shows all.
    "pieces.smallest": float,  # Hides connected components that enclose a smaller volume.
    "pieces.hidden": Sequence[Any] | str,  # Hides the connected components that contain one of these world points.
    "pieces.only": Sequence[Any] | str,  # If not empty, shows only the connected components that contain one of these world points.
    "pieces.within": float | Literal["auto"] | None,  # Shows only connected components with at least half inside the body above this value, for example the skin's. This hides a headrest or a table. Structures thinner than 8 mm do not count as body; auto shows components everywhere.
    "pieces.depth": float,  # Minimum depth inside that body for half of a component, as a fraction of the body's greatest depth. A brain is deep enough; its scalp is not.
    "clip.planes": Sequence[Any] | str,  # Up to six clip planes "px,py,pz nx,ny,nz; ...", a point and a normal each; they remove the side that the normal points to.
    "clip.box": Sequence[Any] | str,  # Two opposite corners "x,y,z; x,y,z" of the clip box, which removes everything outside it; empty removes nothing.
    "clip.box_rotation": Sequence[Any] | str,  # Rotation of the clip box about its centre.
    "clip.removed": Sequence[Any] | str,  # Two opposite corners "x,y,z; x,y,z" of each removed box, at most eight boxes. Everything inside them is clipped; they may extend beyond the volume.
    "clip.cap": Literal["none", "inside", "whole"],  # Caps of clip planes and boxes: none, the voxel values where the inside is cut, or the voxel values of the whole face.
    "slice.level": float | Literal["auto"] | None,  # Window level: the value shown as middle grey in slices and on caps; auto derives it from the volume.
    "slice.width": float | Literal["auto"] | None,  # Window width: the range of values from black to white in slices and on caps; auto derives it from the volume.
    "slice.map": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # Colour map of slices and caps; auto is gray.
    "slice.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # Interpolation between voxels in slices and on caps.
    "slice.slab": float,  # Slab thickness of slices, half in front of and half behind their plane; 0 shows the plane itself.
    "slice.slab_mode": Literal["mean", "maximum", "minimum"],  # Projection through a slab: maximum (MIP), minimum (MinIP) or average along its normal.
    "slice.convention": Literal["radiological", "neurological"],  # Display convention of axial and coronal slices: the patient's right on the left (radiological) or on the right (neurological).
    "slice.contour_width": float,  # Width of the isosurfaces' contours in slices; 0 draws none.
    "slice.noise_band": float,  # Fills the uncertainty band of the first surface's contour: its isovalue ± this many standard deviations of the noise; 0 fills nothing.
    "slice.position": Sequence[Any] | str | Literal["auto"] | None,  # Point where the three slices meet; auto is the centre of the volume.
    "marks.list": Sequence[Any] | str,  # List of measurements: {kind, name, points, color, shown} each.
    "hit.method": Literal["sampled", "exact"],  # Intersection of rays with the surface: equidistant samples with refinement, or the first root of the interpolant in each cell.
    "hit.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # Interpolant whose surface is drawn: trilinear, cubic B-spline or interpolating cubic B-spline. The B-spline is the smoothest, but shrinks thin structures until they vanish. The interpolating one keeps wires, twigs and vessels connected where trilinear hits draw beads.
    "hit.rate": float,  # Sampling rate along a ray; method sampled only.
    "hit.near_factor": float,  # Factor by which sampling is denser near the isovalue; method sampled only.
    "hit.near_threshold": float | Literal["auto"] | None,  # Distance from the isovalue within which sampling is denser, for method sampled only. auto is the typical change of value from one sample to the next.
    "hit.refinements": int,  # Number of regula falsi steps after a sampled hit; method sampled only.
    "derivatives.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # Interpolant for gradients and curvature: trilinear, the cubic B-spline, or the interpolating cubic B-spline.
    "derivatives.fetch": Literal["fast", "exact"],  # Voxel access of cubic derivatives: the texture unit's linear filter, whose weights many GPUs round to 8 bits, or single voxels weighted in float.
    "derivatives.noise": float | Literal["auto"] | None,  # Standard deviation of a voxel's noise, from which the confidence in curvature is computed; auto estimates it from the volume.
    "derivatives.scale": float | Literal["auto"] | None,  # Scale σ of curvature, lines and flow: standard deviation of the isotropic Gaussian that smooths the volume before second derivatives. 0 does not smooth; auto chooses from the noise.
    "derivatives.normal_scale": float | Literal["auto"] | None,  # Scale σ of the normals used by shading and contours, as derivatives.scale.
    "edge.search": float | Literal["auto"] | None,  # Search distance for the edge of the object along the normal, in both directions; auto depends on spacing and scale.
    "edge.contrast": float,  # Minimum gradient magnitude of an edge, in standard deviations of the gradient's noise; weaker maxima are ignored.
    "color.volume": str | os.PathLike[str],  # Second volume whose values colour the surface, given as in source.path; if empty, none is used.
    "color.raw": str | os.PathLike[str],  # Layout of the second volume's file without a header, as source.raw.
    "color.component": int,  # Channel of the second volume, as source.component.
    "color.time_step": int,  # Time step of the second volume, as source.time_step.
    "color.field": Literal["trilinear", "cubic", "cubic_interpolating"],  # Interpolation of the second volume.
    "color.map": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # Colour map over the second volume's values; auto is viridis.
    "color.low": float | Literal["auto"] | None,  # Value at the lower end of the map; auto derives it from the values on the surface.
    "color.high": float | Literal["auto"] | None,  # Value at the upper end of the map; auto derives it from the values on the surface.
    "color.below": float,  # Shows the largest value within this depth below the surface; 0 shows the value at the surface.
    "color.strength": float,  # Opacity of these colours over the surface's own colour.
    "color.fade": bool,  # Fades the strength in, from 0 at the lower end of the map to its full value at the upper end.
    "color.isolines": float,  # Interval between isolines of the second volume; 0 draws none.
    "color.isoline_width": float,  # Width of the isolines.
    "look.mode": Literal["blinn_phong", "lambert", "tone", "kappa1", "kappa2", "mean_curvature", "gaussian_curvature", "shape_index", "curvedness", "flowline_curvature", "curvature_2d", "accessibility", "edge_offset", "flow", "gi", "normal", "curvature_direction", "depth"],  # Look (display mode): the shaded surface, or a quantity shown in colour.
    "look.shading": Literal["unlit", "lambert", "blinn_phong", "tone", "gi"],  # Shading of looks that give a colour: the curvature maps, crevice shading and flow; gi is baked global illumination.
    "look.ambient": float,  # Ambient light, as a fraction of the albedo.
    "look.ambient_variation": float,  # Hemisphere lighting: how much brighter the ambient light is from the top of the image than from the bottom.
    "look.specular": float,  # Strength of the highlight.
    "look.shininess": float,  # Specular exponent; higher values give a smaller, sharper highlight.
    "look.tone_cool": Sequence[Any] | str,  # Tone shading: colour of parts that face away from the light.
    "look.tone_warm": Sequence[Any] | str,  # Tone shading: colour of parts that face the light.
    "look.inner_tint": Sequence[Any] | str,  # Back-face tint: multiplies the surface's own colour where its back face is visible; white does not tint.
    "look.texture": Literal["none", "marble", "wood", "checker"],  # Solid (3-D) texture that varies the albedo.
    "look.texture_scale": float | Literal["auto"] | None,  # Size of the solid texture's features; auto is a tenth of the volume's diagonal.
    "look.shadow": float,  # Strength of the key light's hard shadow, found with one exact shadow ray per pixel.
    "look.occlusion": float,  # Strength of screen-space occlusion: nearby surfaces visible in the image darken crevices.
    "look.occlusion_radius": float | Literal["auto"] | None,  # Radius within which surfaces occlude; auto is a fifth of the volume's diagonal.
    "look.fog": float,  # Amount by which the far end of the volume fades.
    "look.fog_color": Sequence[Any] | str | Literal["auto"] | None,  # Colour of the fog; auto is the background.
    "look.colormap": Literal["auto", "viridis", "cividis", "inferno", "gray", "coolwarm", "blue_orange", "purple_green", "spectral"],  # Colour map of the quantity; auto is diverging for signed quantities, otherwise viridis.
    "look.colormap_points": Sequence[Any] | str | Literal["auto"] | None,  # Transfer function of your own for the quantity: control points [position, r, g, b] in linear RGB, positions as fractions of the range; auto uses look.colormap.
    "look.range_low": float | Literal["auto"] | None,  # Quantity at the lower end of the colour map; auto derives it from the values on the surface.
    "look.range_high": float | Literal["auto"] | None,  # Quantity at the upper end of the colour map; auto derives it from the values on the surface.
    "look.curvature_points": Sequence[Any] | str | Literal["auto"] | None,  # Control points [kappa1, kappa2, r, g, b] of the colour map of curvature_2d; kappa1 and kappa2 are fractions of the range. auto: hue from the shape index, chroma from the curvedness.
    "look.legend": bool,  # Draws a legend with units where colours show a quantity.
    "look.legend_corner": Literal["auto", "lower_right", "lower_left", "upper_right", "upper_left"],  # Corner of the legend; auto is the corner that covers least of the surface.
    "look.accessibility": float,  # Crevice shading (accessibility, Miller 1994): darkens hollows by curvature, like dirt.
    "look.accessibility_points": Sequence[Any] | str | Literal["auto"] | None,  # Transfer function of crevice shading: control points [position, r, g, b], from the deepest hollow at 0 to the open surface at 1; the colours multiply the surface's own. auto darkens hollows to brown.
    "look.overlay": Literal["none", "blocks", "bricks", "texels"],  # Work of the renderer drawn over the surface: blocks that rays enter, bricks in graphics memory, or lit texels.
    "look.ridges": float,  # Strength of ridge and valley lines: curvature maxima across the line.
    "look.ridge_threshold": float | Literal["auto"] | None,  # Minimum curvature of ridge and valley lines; auto derives it from the values on the surface.
    "look.ridge_width": float,  # Width of ridge and valley lines, in the unit of look.ridge_width_unit.
    "look.ridge_width_unit": Literal["pixels", "mm"],  # Unit of the width of ridge and valley lines: pixels of the image, or mm on the surface.
    "look.ridge_length": float | Literal["auto"] | None,  # Minimum length of ridge and valley lines. Shorter lines, and those below 3 % of the image width, fade out. auto is the radius of the least curvature drawn.
    "look.ridge_color": Sequence[Any] | str,  # Colour of ridges.
    "look.valley_color": Sequence[Any] | str,  # Colour of valleys.
    "look.contours": float | Literal["auto"] | None,  # Strength of silhouette lines; auto is 0.5 under tone shading, otherwise 0.
    "look.suggestive_contours": float,  # Strength of suggestive contours: lines that would be silhouettes in a nearby view.
    "look.contour_width": float,  # Width of contour lines, uniform across the image.
    "look.contour_color": Sequence[Any] | str,  # Colour of contour lines.
    "look.background_top": Sequence[Any] | str,  # Background at the top of the image.
    "look.background_bottom": Sequence[Any] | str,  # Background at the bottom of the image.
    "flow.strength": float,  # Strength of streaks along the principal curvature directions, over any look.
    "flow.direction": Literal["maximum", "minimum"],  # Direction of the streaks: of the larger or the smaller principal curvature.
    "flow.length": float,  # Length of a streak.
    "flow.grain": float,  # Grain size of the noise that the streaks follow.
    "flow.animate": bool,  # Animates the streaks in the window.
    "flow.speed": float,  # Speed of the animation: periods of the pattern per second.
    "flow.time": float,  # Current time of the flow animation.
    "light.setup": Literal["three_point", "key"],  # Lighting: three_point has a key light, a fill light and rim lights, each occluded by nearby surfaces; key has the key light alone.
    "light.space": Literal["camera", "world"],  # Fixes the key light to the viewer or to the volume.
    "light.direction": Sequence[Any] | str,  # Direction towards the key light, in camera axes (right, up, towards the viewer) or world axes; any length but zero.
    "light.color": Sequence[Any] | str,  # Colour of the key light.
    "light.intensity": float,  # Brightness of the key light.
    "light.fill": float,  # Brightness of the fill light, on the viewer's other side, as a fraction of the key light's.
    "light.rim": float,  # Brightness of the two rim lights, behind left and right, as a fraction of the key light's.
    "light.headlight": float,  # Brightness of a white light at the eye.
    "light.environment.file": str | os.PathLike[str],  # Equirectangular environment map (.hdr, .exr, ...), with its first row at the top; if empty, none is used.
    "light.environment.constant": Sequence[Any] | str | Literal["auto"] | None,  # Radiance of a constant environment, used if there is no environment map; auto uses none.
    "light.environment.builtin": Literal["studio", "window", "overcast", "sunset", "dark_studio"],  # Built-in environment, used if there is neither an environment map nor a constant environment.
    "light.environment.azimuth": float,  # Rotation of the environment about the vertical, counterclockwise as seen from above.
    "light.environment.elevation": float,  # Tilt of the environment before its rotation; positive values raise light from the front.
    "light.environment.rotation": Sequence[Any] | str,  # Rotation from the environment's axes to the world's, before azimuth and elevation.
    "light.environment.exposure": float,  # Exposure of the environment: multiplies its radiance by 2 to this power.
    "light.environment.moves": bool,  # With gi.mode=auto, bakes light such that the environment can be rotated or exchanged without another bake.
    "light.environment.visible": bool,  # Shows the environment behind the surface.
    "light.environment.shadows": bool,  # The surface occludes the environment; off, its light reaches every point, and reflected light stays.
    "gi.mode": Literal["auto", "off", "irradiance", "transfer", "vicinity", "shadow"],  # Quantity that is baked: irradiance (static light), transfer (spherical harmonics, rotatable environment), vicinity (constant environment, no bounces) or shadow (no bounces). auto bakes the cheapest that the scene allows.
    "gi.extent": Literal["full", "band", "view"],  # Texels that are lit: all, those needed for the isovalues of gi.band, or the visible ones.
    "gi.band": Sequence[Any] | str | Literal["auto"] | None,  # Isovalues of interest, low and high; auto is the isovalue ± a twentieth of the volume's range.
    "gi.texels": Literal["auto", "own", "shown"],  # Surface on which texels are lit. own: each sample's own isosurface, for any isovalue. shown: the displayed isosurface, which is more accurate, but for one isovalue. auto is shown with gi.extent=view, otherwise own. With several isosurfaces that are not too transparent, it is own.
    "gi.samples": int,  # Light paths per texel; four times as many halve the noise.
    "gi.sequence": Literal["sobol_owen", "r2", "random"],  # Sampling sequence of path directions: scrambled Sobol points, Roberts' R2 shifted per texel, or independent random numbers.
    "gi.bounces": int,  # Maximum number of diffuse reflections of a light path; 0 is direct light only.
    "gi.roulette_depth": int,  # Bounce at which Russian roulette begins: paths then end at random, with the probability that light is absorbed.
    "gi.environment_share": float | Literal["auto"] | None,  # Fraction of light samples drawn from the environment instead of the surface (MIS). auto is 0.75 under an environment map, 0.5 with more than one bounce.
    "gi.lattice_scale": float,  # Resolution of the lattice of baked light.
    "gi.interpolation": Literal["closest_isovalue", "nearest", "trilinear", "tricubic", "weighted"],  # Interpolation of baked light between texels; weighted favours texels whose normal fits, and smooths noise along their isosurfaces.
    "gi.precision": Literal["r11g11b10", "half"],  # Number format of irradiance on the GPU: 4 or 8 bytes per texel.
    "gi.sh_order": int,  # Number of spherical harmonic bands of baked transfer; more bands resolve sharper light.
    "gi.sh_window": float,  # Damping of the environment's high bands against ringing.
    "gi.components": int,  # Maximum number of principal components to which baked transfer is compressed.
    "gi.component_bits": int,  # Mean number of bits per principal component; components that vary more get more. The bits of a texel are rounded up to a multiple of 32.
    "gi.ground": bool,  # Shows the shadow of the surface on the ground: a horizontal plane under it, seen from above.
    "camera.eye": Sequence[Any] | str | Literal["auto"] | None,  # Position of the viewer; auto follows camera.frames.
    "camera.target": Sequence[Any] | str | Literal["auto"] | None,  # Point that the camera looks at and turns about; auto is the centre of the framed object.
    "camera.up": Sequence[Any] | str | Literal["auto"] | None,  # Upward direction of the image; auto is superior (y for meshes), or anterior (the front) when looking along it.
    "camera.frames": Literal["surface", "volume"],  # Object that the automatic camera frames: the surface or the volume. A patient's surface and the volume are seen from the front, other surfaces from where most of them is visible.
    "camera.fov": float,  # Vertical field of view; an orthographic image has this height at the target's distance.
    "camera.projection": Literal["perspective", "orthographic"],  # Perspective (distant parts look smaller) or orthographic projection.
    "picture.supersampling": int,  # Supersampling (anti-aliasing) of final images.
    "picture.rest_hits": Literal["auto", "same", "cubic_interpolating"],  # Interpolant of final images if hit.field is trilinear: same, or the interpolating B-spline. auto uses the spline if more than a tenth of the visible surface deviates by over a tenth of a voxel. AOVs and baked light use hit.field.
    "picture.exposure": float | Literal["auto"] | None,  # Exposure of images lit by global illumination; auto follows picture.metering.
    "picture.metering": Literal["surface", "lights", "brightness"],  # Basis of automatic exposure: the light that the surface receives, whatever its colour, or the lights. The surface is that of the image when a volume is drawn, and that of the front in sessions and the window. The lights make an unoccluded white surface nearly white. brightness: the light that leaves the front, with its colour, as before session version 9.
    "picture.curve": Literal["auto", "linear", "filmic"],  # Tone curve of final images: linear clips at white; filmic rolls highlights off as film does. auto is filmic under global illumination, otherwise linear. Linear files (EXR) are not affected.
    "picture.letters": bool,  # Draws orientation labels at the edges of the final image: the ends of the patient's axes. If the patient orientation is unknown, they name the world's axes. The window always shows them.
    "picture.scale_bar": bool,  # Draws a scale bar of a round length on the final image. In perspective it is valid at the depth of camera.target. The window always shows it.
    "picture.isovalue": bool,  # Writes the isovalues of the visible surfaces, with their unit, on the final image.
    "picture.caveats": bool,  # Writes a line on the final image for each omission or interpolation, such as hidden connected components or interpolated missing slices.
    "picture.transparent": bool,  # Leaves out the background of the final image; its alpha is the covered fraction of each pixel.
    "picture.pixel_ratio": float,  # Pixels of the final image per pixel in which line and streak sizes are stated. For the same look in an image twice as large, use 2.
    "memory.gpu_budget_mb": int,  # Graphics memory for voxels, baked light and images.
    "memory.layout": Literal["auto", "whole", "bricks"],  # Layout of the volume on the GPU: one texture, or bricks of which only those needed are resident. auto uses one texture if it fits.
    "memory.voxels": Literal["auto", "memory", "file"],  # Location of the voxels while drawing: memory, or the file, which is read in parts when needed (out of core). auto uses the file if the volume does not fit in memory.
    "memory.ram_budget_mb": int,  # Memory for bricks of an out-of-core volume.
    "gi.threads": int | Literal["auto"] | None,  # CPU threads that compute light; auto is one per core.
    "picture.adaptive": bool,  # Draws interactive frames at a lower resolution until they are fast enough; the full image follows when the view is idle.
    "picture.motion_target": float,  # Time limit of an interactive frame.
    "picture.executor": Literal["auto", "gpu", "cpu"],  # Device that computes hits and derivatives: the GPU, or the CPU (exact hits only). auto uses the CPU if OpenGL is software.
    "window.canvas": Literal["auto", "textures", "pixels"],  # How the window shows images: as textures that stay on the graphics card, or as pixels copied to main memory. auto uses textures on a graphics card. A change to textures may need a restart.
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
    def measure_labels(self, smoothing: float = ..., *, anyway: bool = ..., progress: Progress = ...) -> Record: ...
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
