#include "scene/settings/settings.h"

#include <algorithm>

#include "base/suggestion.h"
#include "scene/settings/machine.h"
#include "scene/settings/setting_entry.h"

namespace isolux::scene {

namespace {

std::vector<Setting> makeSettings() {
  std::vector<Setting> list;
  const auto add = [&list](Setting setting) { list.push_back(std::move(setting)); };

  add(entry<Scene>("source.path", ISOLUX_MEMBER(source.path), noRange, "",
                   "Volume to draw: a file, a DICOM folder, a triangle mesh, or phantom:NAME[:SIZE]."));
  add(entry<Scene>(
      "source.raw", ISOLUX_MEMBER(source.raw), noRange, "",
      "Layout of a file without a header: \"WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]\"."));
  add(entry<Scene>("source.series", ISOLUX_MEMBER(source.series), noRange, "",
                   "SeriesInstanceUID of the series to read from a DICOM folder; empty selects the series "
                   "with the most slices."));
  add(entry<Scene>(
      "source.component", ISOLUX_MEMBER(source.component), {-1, 65535}, "",
      "Channel to read from a file with several values per voxel; -1 reads the magnitude of the vector."));
  add(entry<Scene>(
      "source.time_step", ISOLUX_MEMBER(source.timeStep), {0, 1e6}, "",
      "Time step to read from a file with several, counted from 0; a fraction blends a step with the next."));
  add(choiceEntry<Scene>("source.kind", ISOLUX_MEMBER(source.kind),
                         "Kind of data: CT in Hounsfield or other units, MR, distance field …; auto derives "
                         "it from the file and its values. Presets and the first isovalue depend on it."));
  add(entry<Scene>("source.level", ISOLUX_MEMBER(source.level), {0, 16}, "",
                   "Resolution level of a large file: 0 is full resolution, each further level halves it "
                   "along each axis. Levels stored in the file are used; others are averaged."));
  add(entry<Scene>("source.around_damage", ISOLUX_MEMBER(source.aroundDamage), noRange, "",
                   "Treats unreadable voxels of a chunked file as missing; otherwise the file is rejected."));
  add(entry<Scene>(
      "source.mesh_voxels", ISOLUX_MEMBER(source.meshVoxels), {16, 1024}, "voxels",
      "Resolution of the distance field made from a triangle mesh: voxels along the longest axis."));
  add(choiceEntry<Scene>(
      "source.csg", ISOLUX_MEMBER(source.csg),
      "Boolean operation that combines a second volume with the first, as solids on one grid."));
  add(entry<Scene>("source.csg_path", ISOLUX_MEMBER(source.csgPath), noRange, "",
                   "Second volume of the Boolean operation, given as in source.path. A phantom without SIZE "
                   "uses the first volume's grid."));
  add(entry<Scene>("source.csg_value", ISOLUX_MEMBER(source.csgValue), {-1e38, 1e38}, "data units",
                   "Isovalue of the second volume, in its own units; auto uses the suggested one."));

  add(entry<Scene>("source.csg_weight", ISOLUX_MEMBER(source.csgWeight), unitRange, "",
                   "Weight of the second volume where source.csg is blend: 0 shows the first volume's "
                   "surface, 1 the second's."));

  add(entry<Scene>("isosurface.name", ISOLUX_MEMBER(isosurface.name), noRange, "",
                   "Name of the surface in lists and on the histogram."));
  add(entry<Scene>("isosurface.value", ISOLUX_MEMBER(isosurface.value), {-1e38, 1e38}, "data units",
                   "Isovalue of the first surface; auto follows isosurface.suggestion."));
  add(choiceEntry<Scene>("isosurface.suggestion", ISOLUX_MEMBER(isosurface.suggestion),
                         "Automatic isovalue: the boundary of the whole object (skin in a scan of a head), "
                         "or the clearest boundary inside it (often bone)."));
  add(choiceEntry<Scene>("isosurface.inside", ISOLUX_MEMBER(isosurface.inside),
                         "Side of the isovalue that is solid; the normal points away from it."));
  add(entry<Scene>("isosurface.albedo", ISOLUX_MEMBER(isosurface.albedo), unitRange, "linear RGB",
                   "Diffuse reflectance of the surface."));
  add(entry<Scene>("isosurface.specular", ISOLUX_MEMBER(isosurface.specular), unitRange, "",
                   "Gloss under global illumination: reflectance of the surface seen head on. Water and skin "
                   "have 0.02 to 0.04, teeth 0.06, metal 0.5 to 0.9; 0 is matt."));
  add(entry<Scene>("isosurface.roughness", ISOLUX_MEMBER(isosurface.roughness), {0.05, 1.0}, "",
                   "Roughness of that gloss: small values reflect sharply, 1 spreads over half the sky."));
  add(choiceEntry<Scene>(
      "isosurface.albedo_source", ISOLUX_MEMBER(isosurface.albedoSource),
      "Source of the isosurfaces' reflectances: a colour per surface, or a colour map over the isovalue."));
  add(choiceEntry<Scene>("isosurface.albedo_map", ISOLUX_MEMBER(isosurface.albedoMap),
                         "Colour map over the isovalue; auto is viridis."));
  add(entry<Scene>("isosurface.albedo_low", ISOLUX_MEMBER(isosurface.albedoLow), {-1e38, 1e38}, "data units",
                   "Isovalue at the lower end of that map; auto is the volume's minimum."));
  add(entry<Scene>("isosurface.albedo_high", ISOLUX_MEMBER(isosurface.albedoHigh), {-1e38, 1e38},
                   "data units", "Isovalue at the upper end of that map; auto is the volume's maximum."));
  add(entry<Scene>("isosurface.opacity", ISOLUX_MEMBER(isosurface.opacity), unitRange, "",
                   "Opacity of the surface; 1 hides everything behind it."));
  add(entry<Scene>("isosurface.facing_opacity", ISOLUX_MEMBER(isosurface.facingOpacity), unitRange, "",
                   "View-dependent opacity: factor on the opacity where the surface faces the viewer; "
                   "edge-on the opacity is unchanged."));
  add(entry<Scene>(
      "isosurface.layers", ISOLUX_MEMBER(isosurface.layers), {1, 64}, "",
      "Maximum number of surface crossings composited along a ray, where surfaces are transparent."));
  add(entry<Scene>(
      "isosurface.ghost", ISOLUX_MEMBER(isosurface.ghost), {0, 100}, "standard deviations of the noise",
      "Draws two uncertainty surfaces: transparent isosurfaces at the first isovalue ± this many standard "
      "deviations of the noise. They bound the shift due to noise; 0 draws none."));
  add(entry<Scene>("isosurface.ghost_opacity", ISOLUX_MEMBER(isosurface.ghostOpacity), unitRange, "",
                   "Opacity of the uncertainty surfaces."));
  add(entry<Scene>("isosurface.clipped", ISOLUX_MEMBER(isosurface.clipped), noRange, "",
                   "Applies clip planes and clip box to the first surface."));
  for (std::size_t i = 0; i < kExtraIsosurfaces; ++i) {
    const std::string group = "isosurface" + std::to_string(i + 2) + '.';
    add(entry<Scene>(group + "shown", ISOLUX_ITEM(extraIsosurfaces, i, shown), noRange, "",
                     "Draws one more isosurface of the same volume."));
    add(entry<Scene>(group + "name", ISOLUX_ITEM(extraIsosurfaces, i, name), noRange, "",
                     "Name of that surface."));
    add(entry<Scene>(group + "value", ISOLUX_ITEM(extraIsosurfaces, i, value), {-1e38, 1e38}, "data units",
                     "Isovalue of that surface; auto uses the histogram's next suggestion outside the first "
                     "surface, or inside if there is none."));
    add(entry<Scene>(group + "albedo", ISOLUX_ITEM(extraIsosurfaces, i, albedo), unitRange, "linear RGB",
                     "Diffuse reflectance of that surface."));
    add(entry<Scene>(group + "specular", ISOLUX_ITEM(extraIsosurfaces, i, specular), unitRange, "",
                     "Gloss of that surface under global illumination; 0 is matt."));
    add(entry<Scene>(group + "roughness", ISOLUX_ITEM(extraIsosurfaces, i, roughness), {0.05, 1.0}, "",
                     "Roughness of that gloss."));
    add(entry<Scene>(group + "opacity", ISOLUX_ITEM(extraIsosurfaces, i, opacity), unitRange, "",
                     "Opacity of that surface; 1 hides everything behind it."));
    add(entry<Scene>(group + "facing_opacity", ISOLUX_ITEM(extraIsosurfaces, i, facingOpacity), unitRange, "",
                     "View-dependent opacity: factor on that opacity where the surface faces the viewer."));
    add(entry<Scene>(group + "clipped", ISOLUX_ITEM(extraIsosurfaces, i, clipped), noRange, "",
                     "Applies clip planes and clip box to that surface."));
  }

  add(entry<Scene>(
      "pieces.keep", ISOLUX_MEMBER(pieces.keep), {0, 1000000}, "",
      "Maximum number of connected components (pieces) shown per isosurface, largest first; 0 shows all."));
  add(entry<Scene>("pieces.smallest", ISOLUX_MEMBER(pieces.smallest), {0, 1e18}, "mm³",
                   "Hides connected components that enclose a smaller volume."));
  add(entry<Scene>("pieces.hidden", ISOLUX_MEMBER(pieces.hidden), positionRange, "mm",
                   "Hides the connected components that contain one of these world points."));
  add(entry<Scene>(
      "pieces.only", ISOLUX_MEMBER(pieces.only), positionRange, "mm",
      "If not empty, shows only the connected components that contain one of these world points."));
  add(entry<Scene>("pieces.within", ISOLUX_MEMBER(pieces.within), {-1e38, 1e38}, "data units",
                   "Shows only connected components with at least half inside the body above this value, for "
                   "example the skin's. This hides a headrest or a table. Structures thinner than 8 mm do "
                   "not count as body; auto shows components everywhere."));
  add(entry<Scene>("pieces.depth", ISOLUX_MEMBER(pieces.depth), unitRange, "",
                   "Minimum depth inside that body for half of a component, as a fraction of the body's "
                   "greatest depth. A brain is deep enough; its scalp is not."));

  add(entry<Scene>("clip.planes", ISOLUX_MEMBER(clip.planes), positionRange, "mm",
                   "Up to six clip planes \"px,py,pz nx,ny,nz; ...\", a point and a normal each; they remove "
                   "the side that the normal points to."));
  add(onlyWhere<Scene>(
      entry<Scene>("clip.box", ISOLUX_MEMBER(clip.box), positionRange, "mm",
                   "Two opposite corners \"x,y,z; x,y,z\" of the clip box, which removes everything outside "
                   "it; empty removes nothing."),
      ISOLUX_MEMBER(clip.box),
      [](const std::vector<glm::dvec3>& box) { return box.empty() || box.size() == 2; },
      "a box has two corners"));
  add(rotationEntry<Scene>("clip.box_rotation", ISOLUX_MEMBER(clip.boxRotation),
                           "Rotation of the clip box about its centre."));
  add(onlyWhere<Scene>(
      entry<Scene>("clip.removed", ISOLUX_MEMBER(clip.removed), positionRange, "mm",
                   "Two opposite corners \"x,y,z; x,y,z\" of each removed box, at most eight boxes. "
                   "Everything inside them is clipped; they may extend beyond the volume."),
      ISOLUX_MEMBER(clip.removed),
      [](const std::vector<glm::dvec3>& corners) {
        return corners.size() % 2 == 0 && corners.size() <= 2 * kRemovedBoxes;
      },
      "a box has two corners, and there are at most eight boxes"));
  add(choiceEntry<Scene>("clip.cap", ISOLUX_MEMBER(clip.cap),
                         "Caps of clip planes and boxes: none, the voxel values where the inside is cut, or "
                         "the voxel values of the whole face."));

  add(entry<Scene>("slice.level", ISOLUX_MEMBER(slice.level), {-1e38, 1e38}, "data units",
                   "Window level: the value shown as middle grey in slices and on caps; auto derives it from "
                   "the volume."));
  add(entry<Scene>("slice.width", ISOLUX_MEMBER(slice.width), {0, 1e38}, "data units",
                   "Window width: the range of values from black to white in slices and on caps; auto "
                   "derives it from the volume."));
  add(choiceEntry<Scene>("slice.map", ISOLUX_MEMBER(slice.map),
                         "Colour map of slices and caps; auto is gray."));
  add(choiceEntry<Scene>("slice.field", ISOLUX_MEMBER(slice.field),
                         "Interpolation between voxels in slices and on caps."));
  add(entry<Scene>(
      "slice.slab", ISOLUX_MEMBER(slice.slab), {0, 1e6}, "mm",
      "Slab thickness of slices, half in front of and half behind their plane; 0 shows the plane itself."));
  add(choiceEntry<Scene>(
      "slice.slab_mode", ISOLUX_MEMBER(slice.slabMode),
      "Projection through a slab: maximum (MIP), minimum (MinIP) or average along its normal."));
  add(choiceEntry<Scene>("slice.convention", ISOLUX_MEMBER(slice.convention),
                         "Display convention of axial and coronal slices: the patient's right on the left "
                         "(radiological) or on the right (neurological)."));
  add(entry<Scene>("slice.contour_width", ISOLUX_MEMBER(slice.contourWidth), {0, 20}, "pixels",
                   "Width of the isosurfaces' contours in slices; 0 draws none."));
  add(entry<Scene>("slice.noise_band", ISOLUX_MEMBER(slice.noiseBand), {0, 100},
                   "standard deviations of the noise",
                   "Fills the uncertainty band of the first surface's contour: its isovalue ± this many "
                   "standard deviations of the noise; 0 fills nothing."));
  add(entry<Scene>("slice.position", ISOLUX_MEMBER(slice.position), positionRange, "mm",
                   "Point where the three slices meet; auto is the centre of the volume."));

  add(entry<Scene>("marks.list", ISOLUX_MEMBER(marks), positionRange, "mm",
                   "List of measurements: {kind, name, points, color, shown} each."));

  add(choiceEntry<Scene>("hit.method", ISOLUX_MEMBER(hit.method),
                         "Intersection of rays with the surface: equidistant samples with refinement, or the "
                         "first root of the interpolant in each cell."));
  add(choiceEntry<Scene>(
      "hit.field", ISOLUX_MEMBER(hit.field),
      "Interpolant whose surface is drawn: trilinear, cubic B-spline or interpolating cubic B-spline. The "
      "B-spline is the smoothest, but shrinks thin structures until they vanish. The interpolating one keeps "
      "wires, twigs and vessels connected where trilinear hits draw beads."));
  add(entry<Scene>("hit.rate", ISOLUX_MEMBER(hit.rate), {0.125, 64}, "samples per voxel",
                   "Sampling rate along a ray; method sampled only."));
  add(entry<Scene>("hit.near_factor", ISOLUX_MEMBER(hit.nearFactor), {1, 64}, "",
                   "Factor by which sampling is denser near the isovalue; method sampled only."));
  add(entry<Scene>("hit.near_threshold", ISOLUX_MEMBER(hit.nearThreshold), {0, 1e38}, "data units",
                   "Distance from the isovalue within which sampling is denser, for method sampled only. "
                   "auto is the typical change of value from one sample to the next."));
  add(entry<Scene>("hit.refinements", ISOLUX_MEMBER(hit.refinements), {0, 32}, "",
                   "Number of regula falsi steps after a sampled hit; method sampled only."));

  add(choiceEntry<Scene>("derivatives.field", ISOLUX_MEMBER(derivatives.field),
                         "Interpolant for gradients and curvature: trilinear, the cubic B-spline, or the "
                         "interpolating cubic B-spline."));
  add(choiceEntry<Scene>("derivatives.fetch", ISOLUX_MEMBER(derivatives.fetch),
                         "Voxel access of cubic derivatives: the texture unit's linear filter, whose weights "
                         "many GPUs round to 8 bits, or single voxels weighted in float."));
  add(entry<Scene>("derivatives.noise", ISOLUX_MEMBER(derivatives.noise), {0, 1e38}, "data units",
                   "Standard deviation of a voxel's noise, from which the confidence in curvature is "
                   "computed; auto estimates it from the volume."));
  add(entry<Scene>(
      "derivatives.scale", ISOLUX_MEMBER(derivatives.scale), {0, 1e6}, "mm",
      "Scale σ of curvature, lines and flow: standard deviation of the isotropic Gaussian that smooths the "
      "volume before second derivatives. 0 does not smooth; auto chooses from the noise."));
  add(entry<Scene>("derivatives.normal_scale", ISOLUX_MEMBER(derivatives.normalScale), {0, 1e6}, "mm",
                   "Scale σ of the normals used by shading and contours, as derivatives.scale."));

  add(entry<Scene>("edge.search", ISOLUX_MEMBER(edge.search), {0, 1e6}, "mm",
                   "Search distance for the edge of the object along the normal, in both directions; auto "
                   "depends on spacing and scale."));
  add(entry<Scene>("edge.contrast", ISOLUX_MEMBER(edge.contrast), {0, 1e6}, "standard deviations",
                   "Minimum gradient magnitude of an edge, in standard deviations of the gradient's noise; "
                   "weaker maxima are ignored."));

  add(entry<Scene>(
      "color.volume", ISOLUX_MEMBER(color.volume), noRange, "",
      "Second volume whose values colour the surface, given as in source.path; if empty, none is used."));
  add(entry<Scene>("color.raw", ISOLUX_MEMBER(color.raw), noRange, "",
                   "Layout of the second volume's file without a header, as source.raw."));
  add(entry<Scene>("color.component", ISOLUX_MEMBER(color.component), {-1, 65535}, "",
                   "Channel of the second volume, as source.component."));
  add(entry<Scene>("color.time_step", ISOLUX_MEMBER(color.timeStep), {0, 1e6}, "",
                   "Time step of the second volume, as source.time_step."));
  add(choiceEntry<Scene>("color.field", ISOLUX_MEMBER(color.field), "Interpolation of the second volume."));
  add(choiceEntry<Scene>("color.map", ISOLUX_MEMBER(color.map),
                         "Colour map over the second volume's values; auto is viridis."));
  add(entry<Scene>("color.low", ISOLUX_MEMBER(color.low), {-1e38, 1e38}, "its data units",
                   "Value at the lower end of the map; auto derives it from the values on the surface."));
  add(entry<Scene>("color.high", ISOLUX_MEMBER(color.high), {-1e38, 1e38}, "its data units",
                   "Value at the upper end of the map; auto derives it from the values on the surface."));
  add(entry<Scene>(
      "color.below", ISOLUX_MEMBER(color.below), {0, 1e6}, "mm",
      "Shows the largest value within this depth below the surface; 0 shows the value at the surface."));
  add(entry<Scene>("color.strength", ISOLUX_MEMBER(color.strength), unitRange, "",
                   "Opacity of these colours over the surface's own colour."));
  add(entry<Scene>(
      "color.fade", ISOLUX_MEMBER(color.fade), noRange, "",
      "Fades the strength in, from 0 at the lower end of the map to its full value at the upper end."));
  add(entry<Scene>("color.isolines", ISOLUX_MEMBER(color.isolines), {0, 1e38}, "its data units",
                   "Interval between isolines of the second volume; 0 draws none."));
  add(entry<Scene>("color.isoline_width", ISOLUX_MEMBER(color.isolineWidth), {0.5, 20}, "pixels",
                   "Width of the isolines."));

  add(choiceEntry<Scene>("look.mode", ISOLUX_MEMBER(look.mode),
                         "Look (display mode): the shaded surface, or a quantity shown in colour."));
  add(choiceEntry<Scene>("look.shading", ISOLUX_MEMBER(look.shading),
                         "Shading of looks that give a colour: the curvature maps, crevice shading and flow; "
                         "gi is baked global illumination."));
  add(entry<Scene>("look.ambient", ISOLUX_MEMBER(look.ambient), unitRange, "",
                   "Ambient light, as a fraction of the albedo."));
  add(entry<Scene>("look.ambient_variation", ISOLUX_MEMBER(look.ambientVariation), unitRange, "",
                   "Hemisphere lighting: how much brighter the ambient light is from the top of the image "
                   "than from the bottom."));
  add(entry<Scene>("look.specular", ISOLUX_MEMBER(look.specular), {0, 4}, "", "Strength of the highlight."));
  add(entry<Scene>("look.shininess", ISOLUX_MEMBER(look.shininess), {1, 1000}, "",
                   "Specular exponent; higher values give a smaller, sharper highlight."));
  add(entry<Scene>("look.tone_cool", ISOLUX_MEMBER(look.toneCool), unitRange, "linear RGB",
                   "Tone shading: colour of parts that face away from the light."));
  add(entry<Scene>("look.tone_warm", ISOLUX_MEMBER(look.toneWarm), unitRange, "linear RGB",
                   "Tone shading: colour of parts that face the light."));
  add(entry<Scene>("look.inner_tint", ISOLUX_MEMBER(look.innerTint), unitRange, "linear RGB",
                   "Back-face tint: multiplies the surface's own colour where its back face is visible; "
                   "white does not tint."));
  add(choiceEntry<Scene>("look.texture", ISOLUX_MEMBER(look.texture),
                         "Solid (3-D) texture that varies the albedo."));
  add(entry<Scene>("look.texture_scale", ISOLUX_MEMBER(look.textureScale), {1e-12, 1e13}, "mm",
                   "Size of the solid texture's features; auto is a tenth of the volume's diagonal."));
  add(entry<Scene>("look.shadow", ISOLUX_MEMBER(look.shadow), unitRange, "",
                   "Strength of the key light's hard shadow, found with one exact shadow ray per pixel."));
  add(entry<Scene>(
      "look.occlusion", ISOLUX_MEMBER(look.occlusion), unitRange, "",
      "Strength of screen-space occlusion: nearby surfaces visible in the image darken crevices."));
  add(entry<Scene>("look.occlusion_radius", ISOLUX_MEMBER(look.occlusionRadius), {1e-12, 1e13}, "mm",
                   "Radius within which surfaces occlude; auto is a fifth of the volume's diagonal."));
  add(entry<Scene>("look.fog", ISOLUX_MEMBER(look.fog), unitRange, "",
                   "Amount by which the far end of the volume fades."));
  add(entry<Scene>("look.fog_color", ISOLUX_MEMBER(look.fogColor), unitRange, "linear RGB",
                   "Colour of the fog; auto is the background."));
  add(choiceEntry<Scene>(
      "look.colormap", ISOLUX_MEMBER(look.colormap),
      "Colour map of the quantity; auto is diverging for signed quantities, otherwise viridis."));
  add(entry<Scene>("look.colormap_points", ISOLUX_MEMBER(look.colormapPoints), unitRange, "",
                   "Transfer function of your own for the quantity: control points [position, r, g, b] in "
                   "linear RGB, positions as fractions of the range; auto uses look.colormap."));
  add(entry<Scene>(
      "look.range_low", ISOLUX_MEMBER(look.rangeLow), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
      "Quantity at the lower end of the colour map; auto derives it from the values on the surface."));
  add(entry<Scene>(
      "look.range_high", ISOLUX_MEMBER(look.rangeHigh), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
      "Quantity at the upper end of the colour map; auto derives it from the values on the surface."));
  add(entry<Scene>(
      "look.curvature_points", ISOLUX_MEMBER(look.curvaturePoints), {-1, 1}, "",
      "Control points [kappa1, kappa2, r, g, b] of the colour map of curvature_2d; kappa1 and kappa2 are "
      "fractions of the range. auto: hue from the shape index, chroma from the curvedness."));
  add(entry<Scene>("look.legend", ISOLUX_MEMBER(look.legend), noRange, "",
                   "Draws a legend with units where colours show a quantity."));
  add(choiceEntry<Scene>("look.legend_corner", ISOLUX_MEMBER(look.legendCorner),
                         "Corner of the legend; auto is the corner that covers least of the surface."));
  add(entry<Scene>("look.accessibility", ISOLUX_MEMBER(look.accessibility), unitRange, "",
                   "Crevice shading (accessibility, Miller 1994): darkens hollows by curvature, like dirt."));
  add(entry<Scene>("look.accessibility_points", ISOLUX_MEMBER(look.accessibilityPoints), unitRange, "",
                   "Transfer function of crevice shading: control points [position, r, g, b], from the "
                   "deepest hollow at 0 to the open surface at 1; the colours multiply the surface's own. "
                   "auto darkens hollows to brown."));
  add(choiceEntry<Scene>("look.overlay", ISOLUX_MEMBER(look.overlay),
                         "Work of the renderer drawn over the surface: blocks that rays enter, bricks in "
                         "graphics memory, or lit texels."));
  add(entry<Scene>("look.ridges", ISOLUX_MEMBER(look.ridges), unitRange, "",
                   "Strength of ridge and valley lines: curvature maxima across the line."));
  add(entry<Scene>(
      "look.ridge_threshold", ISOLUX_MEMBER(look.ridgeThreshold), {0, 1e38}, "1/mm",
      "Minimum curvature of ridge and valley lines; auto derives it from the values on the surface."));
  add(entry<Scene>("look.ridge_width", ISOLUX_MEMBER(look.ridgeWidth), {0.01, 100}, "pixels or mm",
                   "Width of ridge and valley lines, in the unit of look.ridge_width_unit."));
  add(choiceEntry<Scene>(
      "look.ridge_width_unit", ISOLUX_MEMBER(look.ridgeWidthUnit),
      "Unit of the width of ridge and valley lines: pixels of the image, or mm on the surface."));
  add(entry<Scene>("look.ridge_length", ISOLUX_MEMBER(look.ridgeLength), {0, 1e9}, "mm",
                   "Minimum length of ridge and valley lines. Shorter lines, and those below 3 % of the "
                   "image width, fade out. auto is the radius of the least curvature drawn."));
  add(entry<Scene>("look.ridge_color", ISOLUX_MEMBER(look.ridgeColor), unitRange, "linear RGB",
                   "Colour of ridges."));
  add(entry<Scene>("look.valley_color", ISOLUX_MEMBER(look.valleyColor), unitRange, "linear RGB",
                   "Colour of valleys."));
  add(entry<Scene>("look.contours", ISOLUX_MEMBER(look.contours), unitRange, "",
                   "Strength of silhouette lines; auto is 0.5 under tone shading, otherwise 0."));
  add(entry<Scene>("look.suggestive_contours", ISOLUX_MEMBER(look.suggestiveContours), unitRange, "",
                   "Strength of suggestive contours: lines that would be silhouettes in a nearby view."));
  add(entry<Scene>("look.contour_width", ISOLUX_MEMBER(look.contourWidth), {0.5, 20}, "pixels",
                   "Width of contour lines, uniform across the image."));
  add(entry<Scene>("look.contour_color", ISOLUX_MEMBER(look.contourColor), unitRange, "linear RGB",
                   "Colour of contour lines."));
  add(entry<Scene>("look.background_top", ISOLUX_MEMBER(look.backgroundTop), unitRange, "linear RGB",
                   "Background at the top of the image."));
  add(entry<Scene>("look.background_bottom", ISOLUX_MEMBER(look.backgroundBottom), unitRange, "linear RGB",
                   "Background at the bottom of the image."));

  add(entry<Scene>("flow.strength", ISOLUX_MEMBER(flow.strength), unitRange, "",
                   "Strength of streaks along the principal curvature directions, over any look."));
  add(choiceEntry<Scene>("flow.direction", ISOLUX_MEMBER(flow.direction),
                         "Direction of the streaks: of the larger or the smaller principal curvature."));
  add(entry<Scene>("flow.length", ISOLUX_MEMBER(flow.length), {2, 200}, "pixels", "Length of a streak."));
  add(entry<Scene>("flow.grain", ISOLUX_MEMBER(flow.grain), {1, 20}, "pixels",
                   "Grain size of the noise that the streaks follow."));
  add(entry<Scene>("flow.animate", ISOLUX_MEMBER(flow.animate), noRange, "",
                   "Animates the streaks in the window."));
  add(entry<Scene>("flow.speed", ISOLUX_MEMBER(flow.speed), {0.05, 10}, "1/s",
                   "Speed of the animation: periods of the pattern per second."));
  add(entry<Scene>("flow.time", ISOLUX_MEMBER(flow.time), {0, 1e6}, "s",
                   "Current time of the flow animation."));

  add(choiceEntry<Scene>("light.setup", ISOLUX_MEMBER(light.setup),
                         "Lighting: three_point has a key light, a fill light and rim lights, each occluded "
                         "by nearby surfaces; key has the key light alone."));
  add(choiceEntry<Scene>("light.space", ISOLUX_MEMBER(light.space),
                         "Fixes the key light to the viewer or to the volume."));
  add(directionEntry<Scene>("light.direction", ISOLUX_MEMBER(light.direction), "",
                            "Direction towards the key light, in camera axes (right, up, towards the viewer) "
                            "or world axes; any length but zero."));
  add(entry<Scene>("light.color", ISOLUX_MEMBER(light.color), unitRange, "linear RGB",
                   "Colour of the key light."));
  add(entry<Scene>("light.intensity", ISOLUX_MEMBER(light.intensity), {0, 1e6}, "",
                   "Brightness of the key light."));
  add(entry<Scene>(
      "light.fill", ISOLUX_MEMBER(light.fill), {0, 1e6}, "",
      "Brightness of the fill light, on the viewer's other side, as a fraction of the key light's."));
  add(entry<Scene>(
      "light.rim", ISOLUX_MEMBER(light.rim), {0, 1e6}, "",
      "Brightness of the two rim lights, behind left and right, as a fraction of the key light's."));
  add(entry<Scene>("light.headlight", ISOLUX_MEMBER(light.headlight), {0, 1e6}, "",
                   "Brightness of a white light at the eye."));

  add(entry<Scene>("light.environment.file", ISOLUX_MEMBER(light.environment.file), noRange, "",
                   "Equirectangular environment map (.hdr, .exr, ...), with its first row at the top; if "
                   "empty, none is used."));
  add(entry<Scene>(
      "light.environment.constant", ISOLUX_MEMBER(light.environment.constant), {0, 1e6},
      "linear RGB radiance",
      "Radiance of a constant environment, used if there is no environment map; auto uses none."));
  add(choiceEntry<Scene>(
      "light.environment.builtin", ISOLUX_MEMBER(light.environment.builtIn),
      "Built-in environment, used if there is neither an environment map nor a constant environment."));
  add(entry<Scene>("light.environment.azimuth", ISOLUX_MEMBER(light.environment.azimuth), {-360, 360},
                   "degrees",
                   "Rotation of the environment about the vertical, counterclockwise as seen from above."));
  add(entry<Scene>(
      "light.environment.elevation", ISOLUX_MEMBER(light.environment.elevation), {-180, 180}, "degrees",
      "Tilt of the environment before its rotation; positive values raise light from the front."));
  add(rotationEntry<Scene>(
      "light.environment.rotation", ISOLUX_MEMBER(light.environment.rotation),
      "Rotation from the environment's axes to the world's, before azimuth and elevation."));
  add(entry<Scene>("light.environment.exposure", ISOLUX_MEMBER(light.environment.exposure), {-40, 40},
                   "stops", "Exposure of the environment: multiplies its radiance by 2 to this power."));
  add(entry<Scene>("light.environment.moves", ISOLUX_MEMBER(light.environment.moves), noRange, "",
                   "With gi.mode=auto, bakes light such that the environment can be rotated or exchanged "
                   "without another bake."));
  add(entry<Scene>("light.environment.visible", ISOLUX_MEMBER(light.environment.visible), noRange, "",
                   "Shows the environment behind the surface."));
  add(entry<Scene>("light.environment.shadows", ISOLUX_MEMBER(light.environment.shadows), noRange, "",
                   "The surface occludes the environment; off, its light reaches every point, and reflected "
                   "light stays."));
  for (std::size_t i = 0; i < kLamps; ++i) {
    const std::string group = "lamp" + std::to_string(i + 1) + '.';
    add(entry<Scene>(group + "shown", ISOLUX_ITEM(lamps, i, shown), noRange, "",
                     "Switches on a light source of global illumination."));
    add(choiceEntry<Scene>(group + "kind", ISOLUX_ITEM(lamps, i, kind),
                           "Kind of the light source: point, distant (directional) or sphere light."));
    add(entry<Scene>(
        group + "position", ISOLUX_ITEM(lamps, i, position), positionRange, "mm",
        "Position of a point or sphere light; auto is above the volume, towards the front and the left."));
    add(directionEntry<Scene>(group + "direction", ISOLUX_ITEM(lamps, i, direction), "",
                              "Direction towards a distant light, world axes; any length but zero."));
    add(entry<Scene>(group + "radius", ISOLUX_ITEM(lamps, i, radius), {1e-12, 1e13}, "mm",
                     "Radius of a sphere light; a larger one gives softer shadows; auto is a tenth of the "
                     "volume's diagonal."));
    add(entry<Scene>(group + "angle", ISOLUX_ITEM(lamps, i, angle), {0, 90}, "degrees",
                     "Angular diameter of a distant light; the sun has 0.53, 0 gives hard shadows."));
    add(entry<Scene>(group + "color", ISOLUX_ITEM(lamps, i, color), unitRange, "linear RGB",
                     "Colour of the light source."));
    add(entry<Scene>(group + "intensity", ISOLUX_ITEM(lamps, i, intensity), {0, 1e6}, "",
                     "Brightness of a white surface that faces the light source at the volume's centre."));
    add(entry<Scene>(group + "shadows", ISOLUX_ITEM(lamps, i, shadows), noRange, "",
                     "The light source casts shadows; off, its light reaches every point that faces it, and "
                     "reflected light stays."));
  }

  add(choiceEntry<Scene>("gi.mode", ISOLUX_MEMBER(gi.mode),
                         "Quantity that is baked: irradiance (static light), transfer (spherical harmonics, "
                         "rotatable environment), vicinity (constant environment, no bounces) or shadow (no "
                         "bounces). auto bakes the cheapest that the scene allows."));
  add(choiceEntry<Scene>(
      "gi.extent", ISOLUX_MEMBER(gi.extent),
      "Texels that are lit: all, those needed for the isovalues of gi.band, or the visible ones."));
  add(bandEntry<Scene>(
      "gi.band", ISOLUX_MEMBER(gi.band), "data units",
      "Isovalues of interest, low and high; auto is the isovalue ± a twentieth of the volume's range."));
  add(choiceEntry<Scene>(
      "gi.texels", ISOLUX_MEMBER(gi.texels),
      "Surface on which texels are lit. own: each sample's own isosurface, for any isovalue. shown: the "
      "displayed isosurface, which is more accurate, but for one isovalue. auto is shown with "
      "gi.extent=view, otherwise own. With several isosurfaces that are not too transparent, it is own."));
  add(entry<Scene>("gi.samples", ISOLUX_MEMBER(gi.samples), {1, 1000000}, "paths per texel",
                   "Light paths per texel; four times as many halve the noise."));
  add(choiceEntry<Scene>("gi.sequence", ISOLUX_MEMBER(gi.sequence),
                         "Sampling sequence of path directions: scrambled Sobol points, Roberts' R2 shifted "
                         "per texel, or independent random numbers."));
  add(entry<Scene>("gi.bounces", ISOLUX_MEMBER(gi.bounces), {0, 1000}, "",
                   "Maximum number of diffuse reflections of a light path; 0 is direct light only."));
  add(entry<Scene>("gi.roulette_depth", ISOLUX_MEMBER(gi.rouletteDepth), {0, 1000}, "bounces",
                   "Bounce at which Russian roulette begins: paths then end at random, with the probability "
                   "that light is absorbed."));
  add(entry<Scene>("gi.environment_share", ISOLUX_MEMBER(gi.environmentShare), {0, 0.95}, "",
                   "Fraction of light samples drawn from the environment instead of the surface (MIS). auto "
                   "is 0.75 under an environment map, 0.5 with more than one bounce."));
  add(entry<Scene>("gi.lattice_scale", ISOLUX_MEMBER(gi.latticeScale), {0.125, 4},
                   "texels per voxel and axis", "Resolution of the lattice of baked light."));
  add(choiceEntry<Scene>("gi.interpolation", ISOLUX_MEMBER(gi.interpolation),
                         "Interpolation of baked light between texels; weighted favours texels whose normal "
                         "fits, and smooths noise along their isosurfaces."));
  add(choiceEntry<Scene>("gi.precision", ISOLUX_MEMBER(gi.precision),
                         "Number format of irradiance on the GPU: 4 or 8 bytes per texel."));
  add(entry<Scene>(
      "gi.sh_order", ISOLUX_MEMBER(gi.shOrder), {1, 8}, "",
      "Number of spherical harmonic bands of baked transfer; more bands resolve sharper light."));
  add(entry<Scene>("gi.sh_window", ISOLUX_MEMBER(gi.shWindow), unitRange, "",
                   "Damping of the environment's high bands against ringing."));
  add(entry<Scene>("gi.components", ISOLUX_MEMBER(gi.components), {4, 192}, "numbers per texel",
                   "Maximum number of principal components to which baked transfer is compressed."));
  add(entry<Scene>(
      "gi.component_bits", ISOLUX_MEMBER(gi.componentBits), {1, 16}, "bits per number",
      "Mean number of bits per principal component; components that vary more get more. The bits "
      "of a texel are rounded up to a multiple of 32."));
  add(entry<Scene>(
      "gi.ground", ISOLUX_MEMBER(gi.ground), noRange, "",
      "Shows the shadow of the surface on the ground: a horizontal plane under it, seen from above."));

  add(entry<Scene>("camera.eye", ISOLUX_MEMBER(camera.eye), positionRange, "mm",
                   "Position of the viewer; auto follows camera.frames."));
  add(entry<Scene>(
      "camera.target", ISOLUX_MEMBER(camera.target), positionRange, "mm",
      "Point that the camera looks at and turns about; auto is the centre of the framed object."));
  add(directionEntry<Scene>("camera.up", ISOLUX_MEMBER(camera.up), "",
                            "Upward direction of the image; auto is superior (y for meshes), or anterior "
                            "(the front) when looking along it."));
  add(choiceEntry<Scene>(
      "camera.frames", ISOLUX_MEMBER(camera.frames),
      "Object that the automatic camera frames: the surface or the volume. A patient's surface and the "
      "volume are seen from the front, other surfaces from where most of them is visible."));
  add(entry<Scene>(
      "camera.fov", ISOLUX_MEMBER(camera.fov), {1, 160}, "degrees",
      "Vertical field of view; an orthographic image has this height at the target's distance."));
  add(choiceEntry<Scene>("camera.projection", ISOLUX_MEMBER(camera.projection),
                         "Perspective (distant parts look smaller) or orthographic projection."));

  add(entry<Scene>("picture.supersampling", ISOLUX_MEMBER(picture.supersampling), {1, 4},
                   "rays per pixel and axis", "Supersampling (anti-aliasing) of final images."));
  add(choiceEntry<Scene>("picture.rest_hits", ISOLUX_MEMBER(picture.restHits),
                         "Interpolant of final images if hit.field is trilinear: same, or the interpolating "
                         "B-spline. auto uses the spline if more than a tenth of the visible surface "
                         "deviates by over a tenth of a voxel. AOVs and baked light use hit.field."));
  add(entry<Scene>("picture.exposure", ISOLUX_MEMBER(picture.exposure), {-40, 40}, "stops",
                   "Exposure of images lit by global illumination; auto follows picture.metering."));
  add(choiceEntry<Scene>(
      "picture.metering", ISOLUX_MEMBER(picture.metering),
      "Basis of automatic exposure: the light that the surface receives, whatever its "
      "colour, or the lights. The surface is that of the image when a volume is drawn, "
      "and that of the front in sessions and the window. The lights make an unoccluded "
      "white surface nearly white. brightness: the light that leaves the front, with its colour, as "
      "before session version 9."));
  add(choiceEntry<Scene>("picture.curve", ISOLUX_MEMBER(picture.curve),
                         "Tone curve of final images: linear clips at white; filmic rolls highlights off as "
                         "film does. auto is filmic under global illumination, otherwise linear. Linear "
                         "files (EXR) are not affected."));
  add(entry<Scene>(
      "picture.letters", ISOLUX_MEMBER(picture.letters), noRange, "",
      "Draws orientation labels at the edges of the final image: the ends of the patient's axes. If the "
      "patient orientation is unknown, they name the world's axes. The window always shows them."));
  add(entry<Scene>("picture.scale_bar", ISOLUX_MEMBER(picture.scaleBar), noRange, "",
                   "Draws a scale bar of a round length on the final image. In perspective it is valid at "
                   "the depth of camera.target. The window always shows it."));
  add(entry<Scene>("picture.isovalue", ISOLUX_MEMBER(picture.isovalue), noRange, "",
                   "Writes the isovalues of the visible surfaces, with their unit, on the final image."));
  add(entry<Scene>("picture.caveats", ISOLUX_MEMBER(picture.caveats), noRange, "",
                   "Writes a line on the final image for each omission or interpolation, such as hidden "
                   "connected components or interpolated missing slices."));
  add(entry<Scene>(
      "picture.transparent", ISOLUX_MEMBER(picture.transparent), noRange, "",
      "Leaves out the background of the final image; its alpha is the covered fraction of each pixel."));
  add(entry<Scene>("picture.pixel_ratio", ISOLUX_MEMBER(picture.pixelRatio), {0.1, 32}, "pixels",
                   "Pixels of the final image per pixel in which line and streak sizes are stated. For the "
                   "same look in an image twice as large, use 2."));
  return list;
}

}  // namespace

std::span<const Setting> settings() {
  static const std::vector<Setting> list = makeSettings();
  return list;
}

bool covers(std::string_view pattern, std::string_view path) {
  const auto same = [](char wanted, char given) {
    return wanted == given || (wanted == '#' && given >= '0' && given <= '9');
  };
  const bool group = pattern.ends_with('.');
  if (group ? path.size() <= pattern.size() : path.size() != pattern.size()) return false;
  return std::equal(pattern.begin(), pattern.end(), path.begin(), same);
}

const Setting& setting(std::string_view path) {
  const std::span<const Setting> list = settings();
  const auto found = std::find_if(list.begin(), list.end(), [&](const Setting& s) { return s.path == path; });
  if (found != list.end()) return *found;
  std::vector<std::string> paths;
  for (const Setting& known : list) paths.push_back(known.path);
  for (const MachineSetting& known : machineSettings()) paths.push_back(known.path);
  std::string suggestion = base::nearest(path, paths);
  if (suggestion.empty()) {  // "fov", "view.fov": the right name in no or the wrong group
    const std::string name = '.' + std::string(path.substr(path.rfind('.') + 1));
    const auto same =
        std::find_if(paths.begin(), paths.end(), [&](const auto& p) { return p.ends_with(name); });
    if (same != paths.end()) suggestion = *same;
  }
  refuse(std::string(path.substr(0, 200)), suggestion.empty()
                                               ? "unknown setting; `isolux settings` lists all"
                                               : "unknown setting, did you mean " + suggestion + "?");
}

}  // namespace isolux::scene
