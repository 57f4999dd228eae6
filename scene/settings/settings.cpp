#include "scene/settings/settings.h"

#include <algorithm>

#include "base/words.h"
#include "scene/settings/host_settings.h"
#include "scene/settings/scene_list.h"
#include "scene/settings/setting_entry.h"

namespace isolux::scene {

namespace {

std::vector<Setting> makeSettings() {
  SettingList<Scene> list;

  list.add("source.path", ISOLUX_MEMBER(source.path),
           "Volume to draw: a file, a DICOM folder, a triangle mesh, or phantom:NAME[:SIZE].");
  list.add("source.raw", ISOLUX_MEMBER(source.raw),
           "Layout of a file without a header: \"WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]\".");
  list.add("source.series", ISOLUX_MEMBER(source.series),
           "SeriesInstanceUID of the series to read from a DICOM folder; empty selects the series with the "
           "most slices.");
  list.add(
      "source.component", ISOLUX_MEMBER(source.component), {-1, 65535}, "",
      "Channel to read from a file with several values per voxel; -1 reads the magnitude of the vector.");
  list.add(
      "source.time_step", ISOLUX_MEMBER(source.timeStep), {0, 1e6}, "",
      "Time step to read from a file with several, counted from 0; a fraction blends a step with the next.");
  list.add("source.kind", ISOLUX_MEMBER(source.kind),
           "Kind of data: CT in Hounsfield or other units, MR, distance field …; auto derives it from the "
           "file and its values. Presets and the first isovalue depend on it.");
  list.add("source.level", ISOLUX_MEMBER(source.level), {0, 16}, "",
           "Resolution level of a large file: 0 is full resolution, each further level halves it along each "
           "axis. Levels stored in the file are used; others are averaged.");
  list.add("source.around_damage", ISOLUX_MEMBER(source.aroundDamage),
           "Treats unreadable voxels of a chunked file as missing; otherwise the file is rejected.");
  list.add("source.mesh_voxels", ISOLUX_MEMBER(source.meshVoxels), {16, 1024}, "voxels",
           "Resolution of the distance field made from a triangle mesh: voxels along the longest axis.");
  list.add(
      "source.labels", ISOLUX_MEMBER(source.labels),
      "Labels of a label map whose surface is drawn: numbers, ranges and names, as \"2,4-7,liver\"; empty "
      "draws all but 0.");
  list.add(
      "source.smoothing", ISOLUX_MEMBER(source.smoothing), {0, 2}, "voxels",
      "Smoothing of the surface of labels: standard deviation of the Gaussian. Every voxel's centre keeps "
      "its label whatever it is; 0 shows the voxels' own steps.");
  list.add("source.label_names", ISOLUX_MEMBER(source.labelNames),
           "File that names the labels, instead of what the volume states: .tsv, .ctbl, .label, .txt, .json.");
  list.add("source.csg", ISOLUX_MEMBER(source.csg),
           "Boolean operation that combines a second volume with the first, as solids on one grid.");
  list.add("source.csg_path", ISOLUX_MEMBER(source.csgPath),
           "Second volume of the Boolean operation, given as in source.path. A phantom without SIZE uses the "
           "first volume's grid.");
  list.add("source.csg_value", ISOLUX_MEMBER(source.csgValue), {-1e38, 1e38}, "data units",
           "Isovalue of the second volume, in its own units; auto uses the suggested one.");

  list.add("source.csg_weight", ISOLUX_MEMBER(source.csgWeight), unitRange, "",
           "Weight of the second volume where source.csg is blend: 0 shows the first volume's surface, 1 the "
           "second's.");

  list.add("isosurface.suggestion", ISOLUX_MEMBER(isosurface.suggestion),
           "Automatic isovalue of the first surface: the boundary of the whole object (skin in a scan of a "
           "head), or the clearest boundary inside it (often bone).");
  list.add("isosurface.inside", ISOLUX_MEMBER(isosurface.inside),
           "Side of the isovalue that is solid; the normal points away from it.");
  list.add(
      "isosurface.albedo_source", ISOLUX_MEMBER(isosurface.albedoSource),
      "Source of the isosurfaces' reflectances: a colour per surface, or a colour map over the isovalue.");
  list.add("isosurface.albedo_map", ISOLUX_MEMBER(isosurface.albedoMap),
           "Colour map over the isovalue; auto is viridis.");
  list.add("isosurface.albedo_low", ISOLUX_MEMBER(isosurface.albedoLow), {-1e38, 1e38}, "data units",
           "Isovalue at the lower end of that map; auto is the volume's minimum.");
  list.add("isosurface.albedo_high", ISOLUX_MEMBER(isosurface.albedoHigh), {-1e38, 1e38}, "data units",
           "Isovalue at the upper end of that map; auto is the volume's maximum.");
  list.add("isosurface.layers", ISOLUX_MEMBER(isosurface.layers), {1, 64}, "",
           "Maximum number of surface crossings composited along a ray, where surfaces are transparent.");
  list.add("isosurface.ghost_opacity", ISOLUX_MEMBER(isosurface.ghostOpacity), unitRange, "",
           "Opacity of the uncertainty surfaces.");

  list.add(
      "pieces.keep", ISOLUX_MEMBER(pieces.keep), {0, 1000000}, "",
      "Maximum number of connected components (pieces) shown per isosurface, largest first; 0 shows all.");
  list.add("pieces.smallest", ISOLUX_MEMBER(pieces.smallest), {0, 1e18}, "mm³",
           "Hides connected components that enclose a smaller volume.");
  list.add("pieces.hidden", ISOLUX_MEMBER(pieces.hidden), positionRange, "mm",
           "Hides the connected components that contain one of these world points.");
  list.add("pieces.only", ISOLUX_MEMBER(pieces.only), positionRange, "mm",
           "If not empty, shows only the connected components that contain one of these world points.");
  list.add("pieces.within", ISOLUX_MEMBER(pieces.within), {-1e38, 1e38}, "data units",
           "Shows only connected components with at least half inside the body above this value, for example "
           "the skin's. This hides a headrest or a table. Structures thinner than 8 mm do not count as body; "
           "auto shows components everywhere.");
  list.add("pieces.depth", ISOLUX_MEMBER(pieces.depth), unitRange, "",
           "Minimum depth inside that body for half of a component, as a fraction of the body's greatest "
           "depth. A brain is deep enough; its scalp is not.");

  list.add("clip.planes", ISOLUX_MEMBER(clip.planes), positionRange, "mm",
           "Up to six clip planes \"px,py,pz nx,ny,nz; ...\", a point and a normal each; they remove the "
           "side that the normal points to.");
  list.add("clip.box", ISOLUX_MEMBER(clip.box), positionRange, "mm",
           "Two opposite corners \"x,y,z; x,y,z\" of the clip box, which removes everything outside it; "
           "empty removes nothing.");
  list.check(
      ISOLUX_MEMBER(clip.box),
      [](const std::vector<glm::dvec3>& box) { return box.empty() || box.size() == 2; },
      "a box has two corners");
  list.addRotation("clip.box_rotation", ISOLUX_MEMBER(clip.boxRotation),
                   "Rotation of the clip box about its centre.");
  list.add("clip.removed", ISOLUX_MEMBER(clip.removed), positionRange, "mm",
           "Two opposite corners \"x,y,z; x,y,z\" of each removed box, at most eight boxes. Everything "
           "inside them is clipped; they may extend beyond the volume.");
  list.check(
      ISOLUX_MEMBER(clip.removed),
      [](const std::vector<glm::dvec3>& corners) {
        return corners.size() % 2 == 0 && corners.size() <= 2 * kRemovedBoxes;
      },
      "a box has two corners, and there are at most eight boxes");
  list.add("clip.cap", ISOLUX_MEMBER(clip.cap),
           "Caps of clip planes and boxes: none, the voxel values where the inside is cut, or the voxel "
           "values of the whole face.");

  list.add(
      "slice.level", ISOLUX_MEMBER(slice.level), {-1e38, 1e38}, "data units",
      "Window level: the value shown as middle grey in slices and on caps; auto derives it from the volume.");
  list.add("slice.width", ISOLUX_MEMBER(slice.width), {0, 1e38}, "data units",
           "Window width: the range of values from black to white in slices and on caps; auto derives it "
           "from the volume.");
  list.add("slice.map", ISOLUX_MEMBER(slice.map), "Colour map of slices and caps; auto is gray.");
  list.add("slice.field", ISOLUX_MEMBER(slice.field), "Interpolation between voxels in slices and on caps.");
  list.add(
      "slice.slab", ISOLUX_MEMBER(slice.slab), {0, 1e6}, "mm",
      "Slab thickness of slices, half in front of and half behind their plane; 0 shows the plane itself.");
  list.add("slice.slab_mode", ISOLUX_MEMBER(slice.slabMode),
           "Projection through a slab: maximum (MIP), minimum (MinIP) or average along its normal.");
  list.add("slice.convention", ISOLUX_MEMBER(slice.convention),
           "Display convention of axial and coronal slices: the patient's right on the left (radiological) "
           "or on the right (neurological).");
  list.add("slice.contour_width", ISOLUX_MEMBER(slice.contourWidth), {0, 20}, "pixels",
           "Width of the isosurfaces' contours in slices; 0 draws none.");
  list.add("slice.noise_band", ISOLUX_MEMBER(slice.noiseBand), {0, 100}, "standard deviations of the noise",
           "Fills the uncertainty band of the first surface's contour: its isovalue ± this many standard "
           "deviations of the noise; 0 fills nothing.");
  list.add("slice.position", ISOLUX_MEMBER(slice.position), positionRange, "mm",
           "Point where the three slices meet; auto is the centre of the volume.");

  list.add("marks.list", ISOLUX_MEMBER(marks), positionRange, "mm",
           "List of measurements: {kind, name, points, color, shown} each.");

  list.add("hit.method", ISOLUX_MEMBER(hit.method),
           "Intersection of rays with the surface: equidistant samples with refinement, or the first root of "
           "the interpolant in each cell.");
  list.add("hit.field", ISOLUX_MEMBER(hit.field),
           "Interpolant whose surface is drawn: trilinear, cubic B-spline or interpolating cubic B-spline. "
           "The B-spline is the smoothest, but shrinks thin structures until they vanish. The interpolating "
           "one keeps wires, twigs and vessels connected where trilinear hits draw beads.");
  list.add("hit.rate", ISOLUX_MEMBER(hit.rate), {0.125, 64}, "samples per voxel",
           "Sampling rate along a ray; method sampled only.");
  list.add("hit.near_factor", ISOLUX_MEMBER(hit.nearFactor), {1, 64}, "",
           "Factor by which sampling is denser near the isovalue; method sampled only.");
  list.add("hit.near_threshold", ISOLUX_MEMBER(hit.nearThreshold), {0, 1e38}, "data units",
           "Distance from the isovalue within which sampling is denser, for method sampled only. auto is the "
           "typical change of value from one sample to the next.");
  list.add("hit.refinements", ISOLUX_MEMBER(hit.refinements), {0, 32}, "",
           "Number of regula falsi steps after a sampled hit; method sampled only.");

  list.add("derivatives.field", ISOLUX_MEMBER(derivatives.field),
           "Interpolant for gradients and curvature: trilinear, the cubic B-spline, or the interpolating "
           "cubic B-spline.");
  list.add("derivatives.fetch", ISOLUX_MEMBER(derivatives.fetch),
           "Voxel access of cubic derivatives: the texture unit's linear filter, whose weights many GPUs "
           "round to 8 bits, or single voxels weighted in float.");
  list.add("derivatives.noise", ISOLUX_MEMBER(derivatives.noise), {0, 1e38}, "data units",
           "Standard deviation of a voxel's noise, from which the confidence in curvature is computed; auto "
           "estimates it from the volume.");
  list.add("derivatives.scale", ISOLUX_MEMBER(derivatives.scale), {0, 1e6}, "mm",
           "Scale σ of curvature, lines and flow: standard deviation of the isotropic Gaussian that smooths "
           "the volume before second derivatives. 0 does not smooth; auto chooses from the noise.");
  list.add("derivatives.normal_scale", ISOLUX_MEMBER(derivatives.normalScale), {0, 1e6}, "mm",
           "Scale σ of the normals used by shading and contours, as derivatives.scale.");

  list.add("edge.search", ISOLUX_MEMBER(edge.search), {0, 1e6}, "mm",
           "Search distance for the edge of the object along the normal, in both directions; auto depends on "
           "spacing and scale.");
  list.add("edge.contrast", ISOLUX_MEMBER(edge.contrast), {0, 1e6}, "standard deviations",
           "Minimum gradient magnitude of an edge, in standard deviations of the gradient's noise; weaker "
           "maxima are ignored.");

  list.add("color.volume", ISOLUX_MEMBER(color.volume),
           "Second volume whose values colour the surface, given as in source.path; if empty, none is used.");
  list.add("color.raw", ISOLUX_MEMBER(color.raw),
           "Layout of the second volume's file without a header, as source.raw.");
  list.add("color.component", ISOLUX_MEMBER(color.component), {-1, 65535}, "",
           "Channel of the second volume, as source.component.");
  list.add("color.time_step", ISOLUX_MEMBER(color.timeStep), {0, 1e6}, "",
           "Time step of the second volume, as source.time_step.");
  list.add("color.field", ISOLUX_MEMBER(color.field), "Interpolation of the second volume.");
  list.add("color.map", ISOLUX_MEMBER(color.map),
           "Colour map over the second volume's values; auto is viridis.");
  list.add("color.low", ISOLUX_MEMBER(color.low), {-1e38, 1e38}, "its data units",
           "Value at the lower end of the map; auto derives it from the values on the surface.");
  list.add("color.high", ISOLUX_MEMBER(color.high), {-1e38, 1e38}, "its data units",
           "Value at the upper end of the map; auto derives it from the values on the surface.");
  list.add("color.below", ISOLUX_MEMBER(color.below), {0, 1e6}, "mm",
           "Shows the largest value within this depth below the surface; 0 shows the value at the surface.");
  list.add("color.strength", ISOLUX_MEMBER(color.strength), unitRange, "",
           "Opacity of these colours over the surface's own colour.");
  list.add("color.fade", ISOLUX_MEMBER(color.fade),
           "Fades the strength in, from 0 at the lower end of the map to its full value at the upper end.");
  list.add("color.isolines", ISOLUX_MEMBER(color.isolines), {0, 1e38}, "its data units",
           "Interval between isolines of the second volume; 0 draws none.");
  list.add("color.isoline_width", ISOLUX_MEMBER(color.isolineWidth), {0.5, 20}, "pixels",
           "Width of the isolines.");

  list.add("look.mode", ISOLUX_MEMBER(look.mode),
           "Look (display mode): the shaded surface, or a quantity shown in colour.");
  list.add("look.shading", ISOLUX_MEMBER(look.shading),
           "Shading of looks that give a colour: the curvature maps, crevice shading and flow; gi is baked "
           "global illumination.");
  list.add("look.ambient", ISOLUX_MEMBER(look.ambient), unitRange, "",
           "Ambient light, as a fraction of the albedo.");
  list.add("look.ambient_variation", ISOLUX_MEMBER(look.ambientVariation), unitRange, "",
           "Hemisphere lighting: how much brighter the ambient light is from the top of the image than from "
           "the bottom.");
  list.add("look.specular", ISOLUX_MEMBER(look.specular), {0, 4}, "", "Strength of the highlight.");
  list.add("look.shininess", ISOLUX_MEMBER(look.shininess), {1, 1000}, "",
           "Specular exponent; higher values give a smaller, sharper highlight.");
  list.add("look.tone_cool", ISOLUX_MEMBER(look.toneCool), unitRange, "linear RGB",
           "Tone shading: colour of parts that face away from the light.");
  list.add("look.tone_warm", ISOLUX_MEMBER(look.toneWarm), unitRange, "linear RGB",
           "Tone shading: colour of parts that face the light.");
  list.add("look.inner_tint", ISOLUX_MEMBER(look.innerTint), unitRange, "linear RGB",
           "Back-face tint: multiplies the surface's own colour where its back face is visible; white does "
           "not tint.");
  list.add("look.texture", ISOLUX_MEMBER(look.texture), "Solid (3-D) texture that varies the albedo.");
  list.add("look.texture_scale", ISOLUX_MEMBER(look.textureScale), {1e-12, 1e13}, "mm",
           "Size of the solid texture's features; auto is a tenth of the volume's diagonal.");
  list.add("look.shadow", ISOLUX_MEMBER(look.shadow), unitRange, "",
           "Strength of the key light's hard shadow, found with one exact shadow ray per pixel.");
  list.add("look.occlusion", ISOLUX_MEMBER(look.occlusion), unitRange, "",
           "Strength of screen-space occlusion: nearby surfaces visible in the image darken crevices.");
  list.add("look.occlusion_radius", ISOLUX_MEMBER(look.occlusionRadius), {1e-12, 1e13}, "mm",
           "Radius within which surfaces occlude; auto is a fifth of the volume's diagonal.");
  list.add("look.fog", ISOLUX_MEMBER(look.fog), unitRange, "",
           "Amount by which the far end of the volume fades.");
  list.add("look.fog_color", ISOLUX_MEMBER(look.fogColor), unitRange, "linear RGB",
           "Colour of the fog; auto is the background.");
  list.add("look.colormap", ISOLUX_MEMBER(look.colormap),
           "Colour map of the quantity; auto is diverging for signed quantities, otherwise viridis.");
  list.add("look.colormap_points", ISOLUX_MEMBER(look.colormapPoints), unitRange, "",
           "Transfer function of your own for the quantity: control points [position, r, g, b] in linear "
           "RGB, positions as fractions of the range; auto uses look.colormap.");
  list.add("look.range_low", ISOLUX_MEMBER(look.rangeLow), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
           "Quantity at the lower end of the colour map; auto derives it from the values on the surface.");
  list.add("look.range_high", ISOLUX_MEMBER(look.rangeHigh), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
           "Quantity at the upper end of the colour map; auto derives it from the values on the surface.");
  list.add("look.curvature_points", ISOLUX_MEMBER(look.curvaturePoints), {-1, 1}, "",
           "Control points [kappa1, kappa2, r, g, b] of the colour map of curvature_2d; kappa1 and kappa2 "
           "are fractions of the range. auto: hue from the shape index, chroma from the curvedness.");
  list.add("look.legend", ISOLUX_MEMBER(look.legend),
           "Draws a legend with units where colours show a quantity.");
  list.add("look.legend_corner", ISOLUX_MEMBER(look.legendCorner),
           "Corner of the legend; auto is the corner that covers least of the surface.");
  list.add("look.accessibility", ISOLUX_MEMBER(look.accessibility), unitRange, "",
           "Crevice shading (accessibility, Miller 1994): darkens hollows by curvature, like dirt.");
  list.add(
      "look.accessibility_points", ISOLUX_MEMBER(look.accessibilityPoints), unitRange, "",
      "Transfer function of crevice shading: control points [position, r, g, b], from the deepest hollow at "
      "0 to the open surface at 1; the colours multiply the surface's own. auto darkens hollows to brown.");
  list.add("look.overlay", ISOLUX_MEMBER(look.overlay),
           "Work of the renderer drawn over the surface: blocks that rays enter, bricks in graphics memory, "
           "or lit texels.");
  list.add("look.ridges", ISOLUX_MEMBER(look.ridges), unitRange, "",
           "Strength of ridge and valley lines: curvature maxima across the line.");
  list.add("look.ridge_threshold", ISOLUX_MEMBER(look.ridgeThreshold), {0, 1e38}, "1/mm",
           "Minimum curvature of ridge and valley lines; auto derives it from the values on the surface.");
  list.add("look.ridge_width", ISOLUX_MEMBER(look.ridgeWidth), {0.01, 100}, "pixels or mm",
           "Width of ridge and valley lines, in the unit of look.ridge_width_unit.");
  list.add("look.ridge_width_unit", ISOLUX_MEMBER(look.ridgeWidthUnit),
           "Unit of the width of ridge and valley lines: pixels of the image, or mm on the surface.");
  list.add("look.ridge_length", ISOLUX_MEMBER(look.ridgeLength), {0, 1e9}, "mm",
           "Minimum length of ridge and valley lines. Shorter lines, and those below 3 % of the image width, "
           "fade out. auto is the radius of the least curvature drawn.");
  list.add("look.ridge_color", ISOLUX_MEMBER(look.ridgeColor), unitRange, "linear RGB", "Colour of ridges.");
  list.add("look.valley_color", ISOLUX_MEMBER(look.valleyColor), unitRange, "linear RGB",
           "Colour of valleys.");
  list.add("look.contours", ISOLUX_MEMBER(look.contours), unitRange, "",
           "Strength of silhouette lines; auto is 0.5 under tone shading, otherwise 0.");
  list.add("look.suggestive_contours", ISOLUX_MEMBER(look.suggestiveContours), unitRange, "",
           "Strength of suggestive contours: lines that would be silhouettes in a nearby view.");
  list.add("look.contour_width", ISOLUX_MEMBER(look.contourWidth), {0.5, 20}, "pixels",
           "Width of contour lines, uniform across the image.");
  list.add("look.contour_color", ISOLUX_MEMBER(look.contourColor), unitRange, "linear RGB",
           "Colour of contour lines.");
  list.add("look.background_top", ISOLUX_MEMBER(look.backgroundTop), unitRange, "linear RGB",
           "Background at the top of the image.");
  list.add("look.background_bottom", ISOLUX_MEMBER(look.backgroundBottom), unitRange, "linear RGB",
           "Background at the bottom of the image.");

  list.add("flow.strength", ISOLUX_MEMBER(flow.strength), unitRange, "",
           "Strength of streaks along the principal curvature directions, over any look.");
  list.add("flow.direction", ISOLUX_MEMBER(flow.direction),
           "Direction of the streaks: of the larger or the smaller principal curvature.");
  list.add("flow.length", ISOLUX_MEMBER(flow.length), {2, 200}, "pixels", "Length of a streak.");
  list.add("flow.grain", ISOLUX_MEMBER(flow.grain), {1, 20}, "pixels",
           "Grain size of the noise that the streaks follow.");
  list.add("flow.animate", ISOLUX_MEMBER(flow.animate), "Animates the streaks in the window.");
  list.add("flow.speed", ISOLUX_MEMBER(flow.speed), {0.05, 10}, "1/s",
           "Speed of the animation: periods of the pattern per second.");
  list.add("flow.time", ISOLUX_MEMBER(flow.time), {0, 1e6}, "s", "Current time of the flow animation.");

  list.add("light.setup", ISOLUX_MEMBER(light.setup),
           "Lighting: three_point has a key light, a fill light and rim lights, each occluded by nearby "
           "surfaces; key has the key light alone.");
  list.add("light.space", ISOLUX_MEMBER(light.space), "Fixes the key light to the viewer or to the volume.");
  list.addDirection("light.direction", ISOLUX_MEMBER(light.direction),
                    "Direction towards the key light, in camera axes (right, up, towards the viewer) or "
                    "world axes; any length but zero.");
  list.add("light.color", ISOLUX_MEMBER(light.color), unitRange, "linear RGB", "Colour of the key light.");
  list.add("light.intensity", ISOLUX_MEMBER(light.intensity), {0, 1e6}, "", "Brightness of the key light.");
  list.add("light.fill", ISOLUX_MEMBER(light.fill), {0, 1e6}, "",
           "Brightness of the fill light, on the viewer's other side, as a fraction of the key light's.");
  list.add("light.rim", ISOLUX_MEMBER(light.rim), {0, 1e6}, "",
           "Brightness of the two rim lights, behind left and right, as a fraction of the key light's.");
  list.add("light.headlight", ISOLUX_MEMBER(light.headlight), {0, 1e6}, "",
           "Brightness of a white light at the eye.");

  list.add("light.environment.file", ISOLUX_MEMBER(light.environment.file),
           "Equirectangular environment map (.hdr, .exr, ...), with its first row at the top; if empty, none "
           "is used.");
  list.add("light.environment.constant", ISOLUX_MEMBER(light.environment.constant), {0, 1e6},
           "linear RGB radiance",
           "Radiance of a constant environment, used if there is no environment map; auto uses none.");
  list.add("light.environment.builtin", ISOLUX_MEMBER(light.environment.builtIn),
           "Built-in environment, used if there is neither an environment map nor a constant environment.");
  list.add("light.environment.azimuth", ISOLUX_MEMBER(light.environment.azimuth), {-360, 360}, "degrees",
           "Rotation of the environment about the vertical, counterclockwise as seen from above.");
  list.add("light.environment.elevation", ISOLUX_MEMBER(light.environment.elevation), {-180, 180}, "degrees",
           "Tilt of the environment before its rotation; positive values raise light from the front.");
  list.addRotation("light.environment.rotation", ISOLUX_MEMBER(light.environment.rotation),
                   "Rotation from the environment's axes to the world's, before azimuth and elevation.");
  list.add("light.environment.exposure", ISOLUX_MEMBER(light.environment.exposure), {-40, 40}, "stops",
           "Exposure of the environment: multiplies its radiance by 2 to this power.");
  list.add("light.environment.moves", ISOLUX_MEMBER(light.environment.moves),
           "With gi.mode=auto, bakes light such that the environment can be rotated or exchanged without "
           "another bake.");
  list.add("light.environment.visible", ISOLUX_MEMBER(light.environment.visible),
           "Shows the environment behind the surface.");
  list.add(
      "light.environment.shadows", ISOLUX_MEMBER(light.environment.shadows),
      "The surface occludes the environment; off, its light reaches every point, and reflected light stays.");

  list.add("gi.mode", ISOLUX_MEMBER(gi.mode),
           "Quantity that is baked: irradiance (static light), transfer (spherical harmonics, rotatable "
           "environment), vicinity (constant environment, no bounces) or shadow (no bounces). auto bakes the "
           "cheapest that the scene allows.");
  list.add("gi.extent", ISOLUX_MEMBER(gi.extent),
           "Texels that are lit: all, those needed for the isovalues of gi.band, or the visible ones.");
  list.add("gi.band", ISOLUX_MEMBER(gi.band), {-1e38, 1e38}, "data units",
           "Isovalues of interest, low and high; auto is the isovalue ± a twentieth of the volume's range.");
  list.check(
      ISOLUX_MEMBER(gi.band),
      [](const std::optional<glm::dvec2>& band) { return !band || !(band->x > band->y); },
      "the lower end must not be above the upper end");
  list.add(
      "gi.texels", ISOLUX_MEMBER(gi.texels),
      "Surface on which texels are lit. own: each sample's own isosurface, for any isovalue. shown: the "
      "displayed isosurface, which is more accurate, but for one isovalue. auto is shown with "
      "gi.extent=view, otherwise own. With several isosurfaces that are not too transparent, it is own.");
  list.add("gi.samples", ISOLUX_MEMBER(gi.samples), {1, 1000000}, "paths per texel",
           "Light paths per texel; four times as many halve the noise.");
  list.add("gi.sequence", ISOLUX_MEMBER(gi.sequence),
           "Sampling sequence of path directions: scrambled Sobol points, Roberts' R2 shifted per texel, or "
           "independent random numbers.");
  list.add("gi.bounces", ISOLUX_MEMBER(gi.bounces), {0, 1000}, "",
           "Maximum number of diffuse reflections of a light path; 0 is direct light only.");
  list.add("gi.roulette_depth", ISOLUX_MEMBER(gi.rouletteDepth), {0, 1000}, "bounces",
           "Bounce at which Russian roulette begins: paths then end at random, with the probability that "
           "light is absorbed.");
  list.add("gi.environment_share", ISOLUX_MEMBER(gi.environmentShare), {0, 0.95}, "",
           "Fraction of light samples drawn from the environment instead of the surface (MIS). auto is 0.75 "
           "under an environment map, 0.5 with more than one bounce.");
  list.add("gi.lattice_scale", ISOLUX_MEMBER(gi.latticeScale), {0.125, 4}, "texels per voxel and axis",
           "Resolution of the lattice of baked light.");
  list.add("gi.interpolation", ISOLUX_MEMBER(gi.interpolation),
           "Interpolation of baked light between texels; weighted favours texels whose normal fits, and "
           "smooths noise along their isosurfaces.");
  list.add("gi.precision", ISOLUX_MEMBER(gi.precision),
           "Number format of irradiance on the GPU: 4 or 8 bytes per texel.");
  list.add("gi.sh_order", ISOLUX_MEMBER(gi.shOrder), {1, 8}, "",
           "Number of spherical harmonic bands of baked transfer; more bands resolve sharper light.");
  list.add("gi.sh_window", ISOLUX_MEMBER(gi.shWindow), unitRange, "",
           "Damping of the environment's high bands against ringing.");
  list.add("gi.components", ISOLUX_MEMBER(gi.components), {4, 192}, "numbers per texel",
           "Maximum number of principal components to which baked transfer is compressed.");
  list.add("gi.component_bits", ISOLUX_MEMBER(gi.componentBits), {1, 16}, "bits per number",
           "Mean number of bits per principal component; components that vary more get more. The bits of a "
           "texel are rounded up to a multiple of 32.");
  list.add("gi.ground", ISOLUX_MEMBER(gi.ground),
           "Shows the shadow of the surface on the ground: a horizontal plane under it, seen from above.");

  list.add("camera.eye", ISOLUX_MEMBER(camera.eye), positionRange, "mm",
           "Position of the viewer; auto follows camera.frames.");
  list.add("camera.target", ISOLUX_MEMBER(camera.target), positionRange, "mm",
           "Point that the camera looks at and turns about; auto is the centre of the framed object.");
  list.addDirection("camera.up", ISOLUX_MEMBER(camera.up),
                    "Upward direction of the image; auto is superior (y for meshes), or anterior (the front) "
                    "when looking along it.");
  list.add("camera.frames", ISOLUX_MEMBER(camera.frames),
           "Object that the automatic camera frames: the surface or the volume. A patient's surface and the "
           "volume are seen from the front, other surfaces from where most of them is visible.");
  list.add("camera.fov", ISOLUX_MEMBER(camera.fov), {1, 160}, "degrees",
           "Vertical field of view; an orthographic image has this height at the target's distance.");
  list.add("camera.projection", ISOLUX_MEMBER(camera.projection),
           "Perspective (distant parts look smaller) or orthographic projection.");

  list.add("picture.supersampling", ISOLUX_MEMBER(picture.supersampling), {1, 4}, "rays per pixel and axis",
           "Supersampling (anti-aliasing) of final images.");
  list.add("picture.rest_hits", ISOLUX_MEMBER(picture.restHits),
           "Interpolant of final images if hit.field is trilinear: same, or the interpolating B-spline. auto "
           "uses the spline if more than a tenth of the visible surface deviates by over a tenth of a voxel. "
           "AOVs and baked light use hit.field.");
  list.add("picture.exposure", ISOLUX_MEMBER(picture.exposure), {-40, 40}, "stops",
           "Exposure of images lit by global illumination; auto follows picture.metering.");
  list.add("picture.metering", ISOLUX_MEMBER(picture.metering),
           "Basis of automatic exposure: the light that the surface receives, whatever its colour, or the "
           "lights. The surface is that of the image when a volume is drawn, and that of the front in "
           "sessions and the window. The lights make an unoccluded white surface nearly white. brightness: "
           "the light that leaves the front, with its colour, as before session version 9.");
  list.add(
      "picture.curve", ISOLUX_MEMBER(picture.curve),
      "Tone curve of final images: linear clips at white; filmic rolls highlights off as film does. auto is "
      "filmic under global illumination, otherwise linear. Linear files (EXR) are not affected.");
  list.add("picture.letters", ISOLUX_MEMBER(picture.letters),
           "Draws orientation labels at the edges of the final image: the ends of the patient's axes. If the "
           "patient orientation is unknown, they name the world's axes. The window always shows them.");
  list.add("picture.scale_bar", ISOLUX_MEMBER(picture.scaleBar),
           "Draws a scale bar of a round length on the final image. In perspective it is valid at the depth "
           "of camera.target. The window always shows it.");
  list.add("picture.isovalue", ISOLUX_MEMBER(picture.isovalue),
           "Writes the isovalues of the visible surfaces, with their unit, on the final image.");
  list.add("picture.caveats", ISOLUX_MEMBER(picture.caveats),
           "Writes a line on the final image for each omission or interpolation, such as hidden connected "
           "components or interpolated missing slices.");
  list.add("picture.transparent", ISOLUX_MEMBER(picture.transparent),
           "Leaves out the background of the final image; its alpha is the covered fraction of each pixel.");
  list.add("picture.pixel_ratio", ISOLUX_MEMBER(picture.pixelRatio), {0.1, 32}, "pixels",
           "Pixels of the final image per pixel in which line and streak sizes are stated. For the same look "
           "in an image twice as large, use 2.");
  return list.take();
}

}  // namespace

std::span<const Setting> settings() {
  static const std::vector<Setting> list = makeSettings();
  return list;
}

bool covers(std::string_view pattern, std::string_view path) {
  std::size_t at = 0;
  for (const char wanted : pattern) {
    const std::size_t before = at;
    if (wanted == '#')
      at = std::min(path.find('.', at), path.size());
    else if (at < path.size() && path[at] == wanted)
      ++at;
    if (at == before) return false;
  }
  return pattern.ends_with('.') ? at < path.size() : at == path.size();
}

Setting setting(std::string_view path) {
  const std::span<const Setting> list = settings();
  const auto found = std::ranges::find_if(list, [&](const Setting& s) { return s.path == path; });
  if (found != list.end()) return *found;
  if (std::optional<Setting> ofItem = itemSetting(path)) return *std::move(ofItem);
  std::vector<std::string> paths;
  for (const Setting& known : list) paths.push_back(known.path);
  for (const HostSetting& known : hostSettings()) paths.push_back(known.path);
  for (const SceneList& known : sceneLists()) {
    for (const SettingInfo& field : known.fields) {
      paths.push_back(field.path);
      if (known.firstHadNoNumber) paths.push_back((known.former + '.').append(nameOfField(known, field)));
    }
  }
  std::string suggestion = base::nearest(path, paths);
  if (suggestion.empty()) {  // "fov", "view.fov": the right name in no or the wrong group
    const std::string name = '.' + std::string(path.substr(path.rfind('.') + 1));
    const auto same = std::ranges::find_if(paths, [&](const auto& p) { return p.ends_with(name); });
    if (same != paths.end()) suggestion = *same;
  }
  refuse(std::string(path.substr(0, 200)), suggestion.empty()
                                               ? "unknown setting; `isolux settings` lists all"
                                               : "unknown setting, did you mean " + suggestion + "?");
}

}  // namespace isolux::scene
