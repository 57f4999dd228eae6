#include "scene/settings.h"

#include <algorithm>

#include "base/suggestion.h"
#include "scene/machine.h"
#include "scene/setting/setting_entry.h"

namespace isolux::scene {

namespace {

std::vector<Setting> makeSettings() {
  std::vector<Setting> list;
  const auto add = [&list](Setting setting) { list.push_back(std::move(setting)); };

  add(entry<Scene>("source.path", ISOLUX_MEMBER(source.path), noRange, "",
                   "The volume: a file, a DICOM folder, a triangle mesh, or phantom:NAME[:SIZE]."));
  add(entry<Scene>(
      "source.raw", ISOLUX_MEMBER(source.raw), noRange, "",
      "How to read a file without a header: \"WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]\"."));
  add(entry<Scene>(
      "source.series", ISOLUX_MEMBER(source.series), noRange, "",
      "The SeriesInstanceUID to take from a DICOM folder; empty takes the series with most slices."));
  add(entry<Scene>("source.component", ISOLUX_MEMBER(source.component), {-1, 65535}, "",
                   "Which component of a file with several per voxel; -1 is their magnitude."));
  add(entry<Scene>("source.time_step", ISOLUX_MEMBER(source.timeStep), {0, 1e6}, "",
                   "Which time step of a file with several."));
  add(choiceEntry<Scene>(
      "source.kind", ISOLUX_MEMBER(source.kind),
      "What kind of data the volume is: a CT in Hounsfield units or in others, an MR scan, a distance "
      "field; auto decides by its file and its values. Presets and the first isovalue depend on it."));
  add(entry<Scene>(
      "source.level", ISOLUX_MEMBER(source.level), {0, 16}, "",
      "How coarsely a large file is read: 0 is its own voxels, each further level the means of twice as "
      "many along each axis, from the file where it has them."));
  add(entry<Scene>("source.around_damage", ISOLUX_MEMBER(source.aroundDamage), noRange, "",
                   "Whether voxels that cannot be read of a file in chunks are missing ones; otherwise the "
                   "file is refused."));
  add(entry<Scene>("source.mesh_voxels", ISOLUX_MEMBER(source.meshVoxels), {16, 1024}, "voxels",
                   "How finely a triangle mesh becomes a distance field: voxels along its longest axis."));
  add(choiceEntry<Scene>("source.csg", ISOLUX_MEMBER(source.csg),
                         "How a second volume is combined with the first, as solids on one grid."));
  add(entry<Scene>(
      "source.csg_path", ISOLUX_MEMBER(source.csgPath), noRange, "",
      "The second volume, as source.path. A phantom without SIZE is made on the first volume's grid."));
  add(entry<Scene>(
      "source.csg_value", ISOLUX_MEMBER(source.csgValue), {-1e38, 1e38}, "data units",
      "The isovalue of the second volume's surface, in its own units; auto takes the suggested one."));

  add(entry<Scene>("isosurface.name", ISOLUX_MEMBER(isosurface.name), noRange, "",
                   "What the surface is called in lists and at its line on the histogram."));
  add(entry<Scene>("isosurface.value", ISOLUX_MEMBER(isosurface.value), {-1e38, 1e38}, "data units",
                   "The isovalue; auto is by isosurface.suggestion."));
  add(choiceEntry<Scene>("isosurface.suggestion", ISOLUX_MEMBER(isosurface.suggestion),
                         "What an automatic isovalue is: the border of the whole object to what surrounds it "
                         "(skin in a scan of a head), or the clearest border within it (often bone)."));
  add(choiceEntry<Scene>("isosurface.inside", ISOLUX_MEMBER(isosurface.inside),
                         "Which side of the isovalue is solid; the normal points away from it."));
  add(entry<Scene>("isosurface.albedo", ISOLUX_MEMBER(isosurface.albedo), unitRange, "linear RGB",
                   "The diffuse reflectance of the surface."));
  add(choiceEntry<Scene>("isosurface.albedo_source", ISOLUX_MEMBER(isosurface.albedoSource),
                         "Whether isosurfaces have the reflectances given, or those of a colour map over the "
                         "isovalue."));
  add(choiceEntry<Scene>("isosurface.albedo_map", ISOLUX_MEMBER(isosurface.albedoMap),
                         "The colour map over the isovalue; auto is viridis."));
  add(entry<Scene>("isosurface.albedo_low", ISOLUX_MEMBER(isosurface.albedoLow), {-1e38, 1e38}, "data units",
                   "The isovalue at the lower end of that map; auto is the volume's minimum."));
  add(entry<Scene>("isosurface.albedo_high", ISOLUX_MEMBER(isosurface.albedoHigh), {-1e38, 1e38},
                   "data units", "The isovalue at the upper end of that map; auto is the volume's maximum."));
  add(entry<Scene>("isosurface.opacity", ISOLUX_MEMBER(isosurface.opacity), unitRange, "",
                   "How much of what lies behind the surface it hides; 1 hides all."));
  add(entry<Scene>("isosurface.facing_opacity", ISOLUX_MEMBER(isosurface.facingOpacity), unitRange, "",
                   "Times the opacity where the surface faces the viewer; where it is seen edge on it keeps "
                   "its opacity."));
  add(entry<Scene>("isosurface.layers", ISOLUX_MEMBER(isosurface.layers), {1, 64}, "",
                   "How many crossings along a ray are composited at most, where surfaces are transparent."));
  add(entry<Scene>("isosurface.ghost", ISOLUX_MEMBER(isosurface.ghost), {0, 100},
                   "standard deviations of the noise",
                   "Draws the first surface twice more, transparent, at its isovalue plus and minus this "
                   "many times the noise: how far noise may move it; 0 draws none."));
  add(entry<Scene>("isosurface.ghost_opacity", ISOLUX_MEMBER(isosurface.ghostOpacity), unitRange, "",
                   "How much of what lies behind them those two surfaces hide."));
  add(entry<Scene>("isosurface.clipped", ISOLUX_MEMBER(isosurface.clipped), noRange, "",
                   "Whether planes and box of clip. cut the first surface, too."));
  for (std::size_t i = 0; i < kExtraIsosurfaces; ++i) {
    const std::string group = "isosurface" + std::to_string(i + 2) + '.';
    add(entry<Scene>(group + "shown", ISOLUX_ITEM(extraIsosurfaces, i, shown), noRange, "",
                     "Draws one more isosurface of the same volume."));
    add(entry<Scene>(group + "name", ISOLUX_ITEM(extraIsosurfaces, i, name), noRange, "",
                     "What that surface is called."));
    add(entry<Scene>(
        group + "value", ISOLUX_ITEM(extraIsosurfaces, i, value), {-1e38, 1e38}, "data units",
        "Its isovalue; auto takes the next suggestion of the histogram outside the first surface, "
        "or inside where there is none."));
    add(entry<Scene>(group + "albedo", ISOLUX_ITEM(extraIsosurfaces, i, albedo), unitRange, "linear RGB",
                     "The diffuse reflectance of that surface."));
    add(entry<Scene>(group + "opacity", ISOLUX_ITEM(extraIsosurfaces, i, opacity), unitRange, "",
                     "How much of what lies behind that surface it hides; 1 hides all."));
    add(entry<Scene>(group + "facing_opacity", ISOLUX_ITEM(extraIsosurfaces, i, facingOpacity), unitRange, "",
                     "Times that opacity where the surface faces the viewer."));
    add(entry<Scene>(group + "clipped", ISOLUX_ITEM(extraIsosurfaces, i, clipped), noRange, "",
                     "Whether planes and box of clip. cut that surface, too."));
  }

  add(entry<Scene>(
      "pieces.keep", ISOLUX_MEMBER(pieces.keep), {0, 1000000}, "",
      "How many connected pieces of each isosurface are shown, the largest first; 0 shows all."));
  add(entry<Scene>("pieces.smallest", ISOLUX_MEMBER(pieces.smallest), {0, 1e18}, "mm³",
                   "Pieces that enclose less than this are not shown."));
  add(entry<Scene>("pieces.hidden", ISOLUX_MEMBER(pieces.hidden), positionRange, "mm",
                   "World points; pieces that hold one of them are not shown."));
  add(entry<Scene>("pieces.only", ISOLUX_MEMBER(pieces.only), positionRange, "mm",
                   "World points; where there are any, only pieces that hold one of them are shown."));
  add(entry<Scene>(
      "pieces.within", ISOLUX_MEMBER(pieces.within), {-1e38, 1e38}, "data units",
      "Only pieces of which at least half lies in the body above this value are shown, the skin's "
      "for example: a headrest and a table are not. What is thinner than 8 mm is no body; auto shows "
      "pieces wherever they lie."));
  add(entry<Scene>(
      "pieces.depth", ISOLUX_MEMBER(pieces.depth), unitRange, "",
      "How deep in that body half of a piece must lie, as a fraction of the body's greatest depth: "
      "a brain does, its scalp does not."));

  add(entry<Scene>(
      "clip.planes", ISOLUX_MEMBER(clip.planes), positionRange, "mm",
      "Up to six planes \"px,py,pz nx,ny,nz; ...\", a point and a normal each: what lies on the side "
      "that the normal points to is cut away."));
  add(onlyWhere<Scene>(
      entry<Scene>(
          "clip.box", ISOLUX_MEMBER(clip.box), positionRange, "mm",
          "Two opposite corners \"x,y,z; x,y,z\" of a box outside which everything is cut away; none cuts "
          "nothing."),
      ISOLUX_MEMBER(clip.box),
      [](const std::vector<glm::dvec3>& box) { return box.empty() || box.size() == 2; },
      "a box has two corners"));
  add(rotationEntry<Scene>("clip.box_rotation", ISOLUX_MEMBER(clip.boxRotation),
                           "How the box is turned about its centre."));
  add(onlyWhere<Scene>(
      entry<Scene>(
          "clip.removed", ISOLUX_MEMBER(clip.removed), positionRange, "mm",
          "Two opposite corners \"x,y,z; x,y,z\" of each of up to eight boxes in which everything is cut "
          "away; they may lie far outside the volume."),
      ISOLUX_MEMBER(clip.removed),
      [](const std::vector<glm::dvec3>& corners) {
        return corners.size() % 2 == 0 && corners.size() <= 2 * kRemovedBoxes;
      },
      "a box has two corners, and there are at most eight boxes"));
  add(choiceEntry<Scene>(
      "clip.cap", ISOLUX_MEMBER(clip.cap),
      "What cut faces show: nothing, the voxels' values where the inside was cut, or the values "
      "of the whole face."));

  add(entry<Scene>(
      "slice.level", ISOLUX_MEMBER(slice.level), {-1e38, 1e38}, "data units",
      "The value shown as middle grey in slices and on cut faces; auto is found from the volume."));
  add(entry<Scene>("slice.width", ISOLUX_MEMBER(slice.width), {0, 1e38}, "data units",
                   "How far values reach from black to white there; auto is found from the volume."));
  add(choiceEntry<Scene>("slice.map", ISOLUX_MEMBER(slice.map), "Their colour map; auto is gray."));
  add(choiceEntry<Scene>("slice.field", ISOLUX_MEMBER(slice.field),
                         "The reconstruction that slices and cut faces show between the voxels."));
  add(entry<Scene>(
      "slice.slab", ISOLUX_MEMBER(slice.slab), {0, 1e6}, "mm",
      "How thick slices are, half before and half behind their plane; 0 shows the plane itself."));
  add(choiceEntry<Scene>("slice.slab_mode", ISOLUX_MEMBER(slice.slabMode),
                         "What a thick slice shows of the values along its normal."));
  add(choiceEntry<Scene>(
      "slice.convention", ISOLUX_MEMBER(slice.convention),
      "Whether the patient's right is on the left of axial and coronal slices (radiological), or "
      "on the right."));
  add(entry<Scene>("slice.contour_width", ISOLUX_MEMBER(slice.contourWidth), {0, 20}, "pixels",
                   "The width of the isosurfaces' curves in slices; 0 draws none."));
  add(entry<Scene>(
      "slice.noise_band", ISOLUX_MEMBER(slice.noiseBand), {0, 100}, "standard deviations of the noise",
      "Fills where the first surface's curve would lie at its isovalue plus and minus this many times "
      "the noise; 0 fills nothing."));
  add(entry<Scene>("slice.position", ISOLUX_MEMBER(slice.position), positionRange, "mm",
                   "Where the three slices meet; auto is the centre of the volume."));

  add(entry<Scene>("marks.list", ISOLUX_MEMBER(marks), positionRange, "mm",
                   "What is marked and measured: a list of {kind, name, points, color, shown}."));

  add(choiceEntry<Scene>(
      "hit.method", ISOLUX_MEMBER(hit.method),
      "How rays find the surface: equidistant samples with refinement, or the first root of "
      "the interpolant in every cell."));
  add(choiceEntry<Scene>(
      "hit.field", ISOLUX_MEMBER(hit.field),
      "The reconstruction whose surface is hit: trilinear; the tri-cubic B-spline, which is the smoothest "
      "and "
      "shrinks what is thin until it is gone; or the B-spline that passes through the samples, which holds "
      "wires, twigs and vessels together where trilinear hits draw beads."));
  add(entry<Scene>("hit.rate", ISOLUX_MEMBER(hit.rate), {0.125, 64}, "samples per voxel",
                   "How densely a ray is sampled; method sampled only."));
  add(entry<Scene>("hit.near_factor", ISOLUX_MEMBER(hit.nearFactor), {1, 64}, "",
                   "How many times denser the samples are near the isovalue; method sampled only."));
  add(entry<Scene>(
      "hit.near_threshold", ISOLUX_MEMBER(hit.nearThreshold), {0, 1e38}, "data units",
      "Samples closer to the isovalue than this are near; auto is what the volume's values change by "
      "from one sample to the next; method sampled only."));
  add(entry<Scene>("hit.refinements", ISOLUX_MEMBER(hit.refinements), {0, 32}, "",
                   "Regula falsi steps after a sampled hit; method sampled only."));

  add(choiceEntry<Scene>(
      "derivatives.field", ISOLUX_MEMBER(derivatives.field),
      "The reconstruction that gradients and curvature come from: trilinear, the tri-cubic "
      "B-spline, or the B-spline that passes through the samples."));
  add(choiceEntry<Scene>(
      "derivatives.fetch", ISOLUX_MEMBER(derivatives.fetch),
      "How cubic derivatives read the volume: by the texture unit's linear filter, whose weights many "
      "GPUs round to 8 bits, or by single voxels weighted in float."));
  add(entry<Scene>(
      "derivatives.noise", ISOLUX_MEMBER(derivatives.noise), {0, 1e38}, "data units",
      "Standard deviation of the noise of a voxel, which the confidence in curvature is measured against; "
      "auto estimates it from the volume."));
  add(entry<Scene>("derivatives.scale", ISOLUX_MEMBER(derivatives.scale), {0, 1e6}, "mm",
                   "The scale of curvature, lines and flow: standard deviation of the Gaussian that the "
                   "volume is smoothed "
                   "with before second derivatives are taken, the same in all directions; 0 smooths nothing, "
                   "auto chooses by "
                   "the noise."));
  add(entry<Scene>("derivatives.normal_scale", ISOLUX_MEMBER(derivatives.normalScale), {0, 1e6}, "mm",
                   "The same for the normals of shading and contours."));

  add(entry<Scene>("edge.search", ISOLUX_MEMBER(edge.search), {0, 1e6}, "mm",
                   "How far along the normal, each way, the edge of the object is looked for; auto takes "
                   "what the spacing and the scale ask for."));
  add(entry<Scene>("edge.contrast", ISOLUX_MEMBER(edge.contrast), {0, 1e6}, "standard deviations",
                   "How far the gradient at an edge must stand out of what noise makes of gradients; weaker "
                   "ones are no edges."));

  add(entry<Scene>(
      "color.volume", ISOLUX_MEMBER(color.volume), noRange, "",
      "A second volume that colours the surface by its values there, as source.path; empty takes none."));
  add(entry<Scene>("color.raw", ISOLUX_MEMBER(color.raw), noRange, "", "How to read it, as source.raw."));
  add(entry<Scene>("color.component", ISOLUX_MEMBER(color.component), {-1, 65535}, "",
                   "Which of its components, as source.component."));
  add(entry<Scene>("color.time_step", ISOLUX_MEMBER(color.timeStep), {0, 1e6}, "",
                   "Which of its time steps, as source.time_step."));
  add(choiceEntry<Scene>("color.field", ISOLUX_MEMBER(color.field),
                         "The reconstruction its values are taken from."));
  add(choiceEntry<Scene>("color.map", ISOLUX_MEMBER(color.map),
                         "The colour map over its values; auto is viridis."));
  add(entry<Scene>("color.low", ISOLUX_MEMBER(color.low), {-1e38, 1e38}, "its data units",
                   "The value at the lower end of the map; auto is found from what the surface shows."));
  add(entry<Scene>("color.high", ISOLUX_MEMBER(color.high), {-1e38, 1e38}, "its data units",
                   "The value at the upper end of the map; auto is found from what the surface shows."));
  add(entry<Scene>(
      "color.below", ISOLUX_MEMBER(color.below), {0, 1e6}, "mm",
      "Shows the largest value within this distance below the surface; 0 shows that of the surface itself."));
  add(entry<Scene>("color.strength", ISOLUX_MEMBER(color.strength), unitRange, "",
                   "How much of the surface's own colour is covered."));
  add(entry<Scene>(
      "color.fade", ISOLUX_MEMBER(color.fade), noRange, "",
      "Lets the strength rise from nothing at the lower end of the map to its value at the upper end."));
  add(entry<Scene>("color.isolines", ISOLUX_MEMBER(color.isolines), {0, 1e38}, "its data units",
                   "Lines of equal values this far apart; 0 draws none."));
  add(entry<Scene>("color.isoline_width", ISOLUX_MEMBER(color.isolineWidth), {0.5, 20}, "pixels",
                   "Their width."));

  add(choiceEntry<Scene>(
      "look.mode", ISOLUX_MEMBER(look.mode),
      "What the picture shows: the surface under a shading, or a measure of it in colour."));
  add(choiceEntry<Scene>(
      "look.shading", ISOLUX_MEMBER(look.shading),
      "The shading under the modes that give a colour: the curvature maps, accessibility and "
      "flow; gi is stored "
      "global illumination."));
  add(entry<Scene>("look.ambient", ISOLUX_MEMBER(look.ambient), unitRange, "",
                   "Light from everywhere, as a fraction of the albedo."));
  add(entry<Scene>("look.ambient_variation", ISOLUX_MEMBER(look.ambientVariation), unitRange, "",
                   "How much brighter the ambient light is from above the picture than from below."));
  add(entry<Scene>("look.specular", ISOLUX_MEMBER(look.specular), {0, 4}, "", "Strength of the highlight."));
  add(entry<Scene>("look.shininess", ISOLUX_MEMBER(look.shininess), {1, 1000}, "",
                   "Exponent of the highlight; larger is smaller and sharper."));
  add(entry<Scene>("look.tone_cool", ISOLUX_MEMBER(look.toneCool), unitRange, "linear RGB",
                   "Tone shading: the colour of what faces away from the light."));
  add(entry<Scene>("look.tone_warm", ISOLUX_MEMBER(look.toneWarm), unitRange, "linear RGB",
                   "Tone shading: the colour of what faces the light."));
  add(entry<Scene>("look.inner_tint", ISOLUX_MEMBER(look.innerTint), unitRange, "linear RGB",
                   "Multiplies the surface's own colour where its inner side is seen; white is no tint."));
  add(choiceEntry<Scene>(
      "look.texture", ISOLUX_MEMBER(look.texture),
      "A solid texture, carved from rather than wrapped around the surface; varies the albedo."));
  add(entry<Scene>("look.texture_scale", ISOLUX_MEMBER(look.textureScale), {1e-12, 1e13}, "mm",
                   "Size of the solid texture's features; auto is a tenth of the volume."));
  add(entry<Scene>("look.shadow", ISOLUX_MEMBER(look.shadow), unitRange, "",
                   "Strength of the light's hard shadow, found by a second exact ray from each point."));
  add(entry<Scene>(
      "look.occlusion", ISOLUX_MEMBER(look.occlusion), unitRange, "",
      "How much what stands near keeps light away, as far as the picture shows it: darkens crevices."));
  add(entry<Scene>("look.occlusion_radius", ISOLUX_MEMBER(look.occlusionRadius), {1e-12, 1e13}, "mm",
                   "How far things count as near; auto is a fifth of the volume."));
  add(entry<Scene>("look.fog", ISOLUX_MEMBER(look.fog), unitRange, "",
                   "How much the far end of the volume fades."));
  add(entry<Scene>("look.fog_color", ISOLUX_MEMBER(look.fogColor), unitRange, "linear RGB",
                   "What distant things fade to; auto is the background."));
  add(choiceEntry<Scene>(
      "look.colormap", ISOLUX_MEMBER(look.colormap),
      "Colours of a measure; auto takes a diverging map for what has a sign, else viridis."));
  add(entry<Scene>("look.range_low", ISOLUX_MEMBER(look.rangeLow), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
                   "The measure at the lower end of the colour map; auto from the surface's own values."));
  add(entry<Scene>("look.range_high", ISOLUX_MEMBER(look.rangeHigh), {-1e38, 1e38}, "1/mm, 1/mm² or 1",
                   "The measure at the upper end of the colour map; auto from the surface's own values."));
  add(entry<Scene>(
      "look.curvature_points", ISOLUX_MEMBER(look.curvaturePoints), {-1, 1}, "",
      "Mode curvature_2d: control points [kappa1, kappa2, r, g, b] of the colour map, kappas in parts of the "
      "range; auto is hue by the kind of shape and saturation by how curved it is."));
  add(entry<Scene>("look.legend", ISOLUX_MEMBER(look.legend), noRange, "",
                   "Draws a legend with units where colours stand for numbers."));
  add(choiceEntry<Scene>("look.legend_corner", ISOLUX_MEMBER(look.legendCorner),
                         "Where the legend stands; auto is the corner that shows least of the surface."));
  add(entry<Scene>("look.accessibility", ISOLUX_MEMBER(look.accessibility), unitRange, "",
                   "Darkens what is hollow, by curvature, as if dirt had gathered there."));
  add(entry<Scene>("look.ridges", ISOLUX_MEMBER(look.ridges), unitRange, "",
                   "Strength of ridge and valley lines: where the surface is most curved, across the line."));
  add(entry<Scene>(
      "look.ridge_threshold", ISOLUX_MEMBER(look.ridgeThreshold), {0, 1e38}, "1/mm",
      "Curvature from which on a ridge or valley is drawn; auto from the surface's own values."));
  add(entry<Scene>("look.ridge_width", ISOLUX_MEMBER(look.ridgeWidth), {0.01, 100}, "pixels or mm",
                   "Width of ridge and valley lines, in the unit of look.ridge_width_unit."));
  add(choiceEntry<Scene>("look.ridge_width_unit", ISOLUX_MEMBER(look.ridgeWidthUnit),
                         "Whether ridge and valley lines are as wide in the picture or on the surface."));
  add(entry<Scene>(
      "look.ridge_length", ISOLUX_MEMBER(look.ridgeLength), {0, 1e9}, "mm",
      "Ridges and valleys that are shorter, or shorter than 3 % of the picture's width, fade out; "
      "auto is the radius of the least curvature that is drawn."));
  add(entry<Scene>("look.ridge_color", ISOLUX_MEMBER(look.ridgeColor), unitRange, "linear RGB",
                   "Colour of ridges."));
  add(entry<Scene>("look.valley_color", ISOLUX_MEMBER(look.valleyColor), unitRange, "linear RGB",
                   "Colour of valleys."));
  add(entry<Scene>("look.contours", ISOLUX_MEMBER(look.contours), unitRange, "",
                   "Strength of the silhouette lines; auto is 0.5 under tone shading, else none."));
  add(entry<Scene>("look.suggestive_contours", ISOLUX_MEMBER(look.suggestiveContours), unitRange, "",
                   "Strength of suggestive contours: where a silhouette would appear from nearby."));
  add(entry<Scene>("look.contour_width", ISOLUX_MEMBER(look.contourWidth), {0.5, 20}, "pixels",
                   "Width of contour lines, the same all over the picture."));
  add(entry<Scene>("look.contour_color", ISOLUX_MEMBER(look.contourColor), unitRange, "linear RGB",
                   "Colour of contour lines."));
  add(entry<Scene>("look.background_top", ISOLUX_MEMBER(look.backgroundTop), unitRange, "linear RGB",
                   "Background at the top of the picture."));
  add(entry<Scene>("look.background_bottom", ISOLUX_MEMBER(look.backgroundBottom), unitRange, "linear RGB",
                   "Background at the bottom of the picture."));

  add(entry<Scene>("flow.strength", ISOLUX_MEMBER(flow.strength), unitRange, "",
                   "Streaks along the directions of curvature, over any look."));
  add(choiceEntry<Scene>("flow.direction", ISOLUX_MEMBER(flow.direction),
                         "Along the direction of the larger or of the smaller principal curvature."));
  add(entry<Scene>("flow.length", ISOLUX_MEMBER(flow.length), {2, 200}, "pixels", "Length of a streak."));
  add(entry<Scene>("flow.grain", ISOLUX_MEMBER(flow.grain), {1, 20}, "pixels",
                   "Size of the noise's grains."));
  add(entry<Scene>("flow.animate", ISOLUX_MEMBER(flow.animate), noRange, "",
                   "Lets the streaks move, in the window."));
  add(entry<Scene>("flow.speed", ISOLUX_MEMBER(flow.speed), {0.05, 10}, "1/s",
                   "How often the pattern passes in a second."));
  add(entry<Scene>("flow.time", ISOLUX_MEMBER(flow.time), {0, 1e6}, "s", "Where the animation stands."));

  add(choiceEntry<Scene>("light.setup", ISOLUX_MEMBER(light.setup),
                         "How the surface is lit: three_point by the light (the key light), a fill light and "
                         "rim lights, each kept away by what stands near; key by the light alone."));
  add(choiceEntry<Scene>("light.space", ISOLUX_MEMBER(light.space),
                         "Whether the light moves with the viewer or stays with the volume."));
  add(directionEntry<Scene>(
      "light.direction", ISOLUX_MEMBER(light.direction), "",
      "Toward the light, in camera axes (right, up, toward the viewer) or world axes; any length but zero."));
  add(entry<Scene>("light.color", ISOLUX_MEMBER(light.color), unitRange, "linear RGB",
                   "Colour of the light."));
  add(entry<Scene>("light.intensity", ISOLUX_MEMBER(light.intensity), {0, 1e6}, "",
                   "Brightness of the light."));
  add(entry<Scene>("light.fill", ISOLUX_MEMBER(light.fill), {0, 1e6}, "",
                   "Brightness of a light from the viewer's other side, in parts of the light's own."));
  add(entry<Scene>("light.rim", ISOLUX_MEMBER(light.rim), {0, 1e6}, "",
                   "Brightness of two lights from behind, left and right, in parts of the light's own."));
  add(entry<Scene>("light.headlight", ISOLUX_MEMBER(light.headlight), {0, 1e6}, "",
                   "Brightness of a white light at the eye."));

  add(entry<Scene>(
      "light.environment.file", ISOLUX_MEMBER(light.environment.file), noRange, "",
      "The light probe around everything, equirectangular, its first row up: .hdr, .exr, ...; empty is "
      "none."));
  add(entry<Scene>("light.environment.constant", ISOLUX_MEMBER(light.environment.constant), {0, 1e6},
                   "linear RGB radiance",
                   "The radiance of a sky of one colour, where there is no light probe; auto is none."));
  add(choiceEntry<Scene>("light.environment.builtin", ISOLUX_MEMBER(light.environment.builtIn),
                         "The light where there is neither a light probe nor a sky of one colour."));
  add(entry<Scene>("light.environment.azimuth", ISOLUX_MEMBER(light.environment.azimuth), {-360, 360},
                   "degrees", "Turns the environment about the vertical: counterclockwise from above."));
  add(entry<Scene>("light.environment.elevation", ISOLUX_MEMBER(light.environment.elevation), {-180, 180},
                   "degrees",
                   "Tilts the environment before it is turned: raises the light that comes from the front."));
  add(rotationEntry<Scene>(
      "light.environment.rotation", ISOLUX_MEMBER(light.environment.rotation),
      "Turns the environment from its own axes to the world's, before azimuth and elevation."));
  add(entry<Scene>("light.environment.exposure", ISOLUX_MEMBER(light.environment.exposure), {-40, 40},
                   "stops", "Multiplies the environment's radiance by 2 to this power."));
  add(entry<Scene>(
      "light.environment.moves", ISOLUX_MEMBER(light.environment.moves), noRange, "",
      "The environment will be turned or exchanged: gi.mode auto then stores light so that this costs "
      "nothing anew."));
  add(entry<Scene>("light.environment.visible", ISOLUX_MEMBER(light.environment.visible), noRange, "",
                   "Shows the environment behind the surface."));
  for (std::size_t i = 0; i < kLamps; ++i) {
    const std::string group = "lamp" + std::to_string(i + 1) + '.';
    add(entry<Scene>(group + "shown", ISOLUX_ITEM(lamps, i, shown), noRange, "",
                     "Switches on a lamp of global illumination."));
    add(choiceEntry<Scene>(group + "kind", ISOLUX_ITEM(lamps, i, kind),
                           "A point, a distant lamp, or a luminous sphere."));
    add(entry<Scene>(group + "position", ISOLUX_ITEM(lamps, i, position), positionRange, "mm",
                     "Where a point or sphere is; auto is above the volume, toward the front and the left."));
    add(directionEntry<Scene>(group + "direction", ISOLUX_ITEM(lamps, i, direction), "",
                              "Toward a distant lamp, world axes; any length but zero."));
    add(entry<Scene>(group + "radius", ISOLUX_ITEM(lamps, i, radius), {1e-12, 1e13}, "mm",
                     "Of a luminous sphere; larger gives softer shadows; auto is a tenth of the volume."));
    add(entry<Scene>(
        group + "angle", ISOLUX_ITEM(lamps, i, angle), {0, 90}, "degrees",
        "Diameter of a distant lamp as seen from the volume; the sun has 0.53, 0 gives hard shadows."));
    add(entry<Scene>(group + "color", ISOLUX_ITEM(lamps, i, color), unitRange, "linear RGB",
                     "Colour of the lamp."));
    add(entry<Scene>(group + "intensity", ISOLUX_ITEM(lamps, i, intensity), {0, 1e6}, "",
                     "Brightness of a white surface at the volume's centre that faces the lamp."));
  }

  add(choiceEntry<Scene>(
      "gi.mode", ISOLUX_MEMBER(gi.mode),
      "What is stored of the light: irradiance (static light), transfer (spherical harmonics: the "
      "environment may move), vicinity (a sky of one colour, no bounces), shadow (no bounces); auto "
      "takes the least that the scene needs."));
  add(choiceEntry<Scene>(
      "gi.extent", ISOLUX_MEMBER(gi.extent),
      "Which texels are lit: all, those that isovalues of gi.band can show, or those that are "
      "seen."));
  add(bandEntry<Scene>(
      "gi.band", ISOLUX_MEMBER(gi.band), "data units",
      "The isovalues of interest, low and high; auto is a twentieth of the volume's range about "
      "the isovalue."));
  add(choiceEntry<Scene>(
      "gi.texels", ISOLUX_MEMBER(gi.texels),
      "Where texels are lit: each on its own isosurface, so that light is there for every isovalue, or where "
      "the shown isosurface passes it, which is more exact and of one isovalue; auto is shown with "
      "gi.extent=view. Where several isosurfaces are shown, texels are lit on their own."));
  add(entry<Scene>("gi.samples", ISOLUX_MEMBER(gi.samples), {1, 1000000}, "paths per texel",
                   "More have less noise: four times as many halve it."));
  add(choiceEntry<Scene>(
      "gi.sequence", ISOLUX_MEMBER(gi.sequence),
      "The directions of a texel's paths: scrambled Sobol points, Roberts' R2 with a shift for each "
      "texel, or independent random numbers."));
  add(entry<Scene>("gi.bounces", ISOLUX_MEMBER(gi.bounces), {0, 1000}, "",
                   "Diffuse reflections on a light's way to a texel; 0 is direct light only."));
  add(entry<Scene>("gi.roulette_depth", ISOLUX_MEMBER(gi.rouletteDepth), {0, 1000}, "bounces",
                   "From this bounce on paths end at random, with the probability that light is absorbed."));
  add(entry<Scene>(
      "gi.environment_share", ISOLUX_MEMBER(gi.environmentShare), {0, 0.95}, "",
      "The part of the directions that is drawn from the environment instead of the surface; auto is 0.75 "
      "under a light probe, 0.5 with more than one bounce."));
  add(entry<Scene>("gi.lattice_scale", ISOLUX_MEMBER(gi.latticeScale), {0.125, 4},
                   "texels per voxel and axis", "How finely light is stored."));
  add(choiceEntry<Scene>(
      "gi.interpolation", ISOLUX_MEMBER(gi.interpolation),
      "How stored light is read between texels; weighted favours texels whose normal fits, and takes the "
      "noise out along their isosurfaces."));
  add(choiceEntry<Scene>(
      "gi.precision", ISOLUX_MEMBER(gi.precision),
      "Numbers in which irradiance is kept on the graphics card: 4 or 8 bytes per texel."));
  add(entry<Scene>("gi.sh_order", ISOLUX_MEMBER(gi.shOrder), {1, 8}, "",
                   "Bands of spherical harmonics of stored transfer; more follow sharper light."));
  add(entry<Scene>("gi.sh_window", ISOLUX_MEMBER(gi.shWindow), unitRange, "",
                   "Damps high bands of the environment against ringing."));
  add(entry<Scene>("gi.components", ISOLUX_MEMBER(gi.components), {4, 192}, "numbers per texel",
                   "Stored transfer is compressed to at most this many principal components."));
  add(entry<Scene>("gi.component_bits", ISOLUX_MEMBER(gi.componentBits), {1, 16}, "bits per number",
                   "On average: those that vary more get more. A texel's bits are rounded up to 32."));

  add(entry<Scene>("camera.eye", ISOLUX_MEMBER(camera.eye), positionRange, "mm",
                   "Where the viewer is; auto is by camera.frames."));
  add(entry<Scene>("camera.target", ISOLUX_MEMBER(camera.target), positionRange, "mm",
                   "The point looked at and turned about; auto is the centre of what is framed."));
  add(directionEntry<Scene>(
      "camera.up", ISOLUX_MEMBER(camera.up), "",
      "The direction that points up in the picture; auto is superior (y for meshes), or anterior "
      "(the front) when looking along it."));
  add(choiceEntry<Scene>("camera.frames", ISOLUX_MEMBER(camera.frames),
                         "What fills the picture of an automatic camera: the surface, a patient's from the "
                         "front, anything else's "
                         "from where most of it is seen; or the volume, from the front."));
  add(entry<Scene>(
      "camera.fov", ISOLUX_MEMBER(camera.fov), {1, 160}, "degrees",
      "Vertical field of view; an orthographic picture is as high as this at the target's distance."));
  add(choiceEntry<Scene>("camera.projection", ISOLUX_MEMBER(camera.projection),
                         "Whether distant things look smaller."));

  add(entry<Scene>("picture.supersampling", ISOLUX_MEMBER(picture.supersampling), {1, 4},
                   "rays per pixel and axis", "Anti-aliasing of a picture at rest."));
  add(choiceEntry<Scene>(
      "picture.rest_hits", ISOLUX_MEMBER(picture.restHits),
      "The reconstruction whose surface pictures at rest show where hit.field is trilinear: the same, or the "
      "B-spline that passes through the samples; auto takes that where more than a tenth of the visible "
      "surface "
      "lies over a tenth of a voxel beside it. Deferred images (--aov) and stored light keep hit.field."));
  add(entry<Scene>("picture.exposure", ISOLUX_MEMBER(picture.exposure), {-40, 40}, "stops",
                   "Brightness of pictures lit by global illumination; auto is by picture.metering."));
  add(choiceEntry<Scene>(
      "picture.metering", ISOLUX_MEMBER(picture.metering),
      "What an automatic exposure fits: the lit surface as it is seen from the front, whatever the view, "
      "or the lights, so that a white surface in the open is nearly white."));
  add(entry<Scene>(
      "picture.letters", ISOLUX_MEMBER(picture.letters), noRange, "",
      "Letters at the edges of the finished picture: which end of the patient's axes, or of the "
      "world's where the file states no orientation, lies there. The window always shows them."));
  add(entry<Scene>(
      "picture.scale_bar", ISOLUX_MEMBER(picture.scaleBar), noRange, "",
      "A bar of a round length on the finished picture; in perspective it is that of the depth of "
      "camera.target. The window always shows it."));
  add(entry<Scene>(
      "picture.isovalue", ISOLUX_MEMBER(picture.isovalue), noRange, "",
      "The isovalues of the surfaces that are shown, with their unit, on the finished picture."));
  add(entry<Scene>(
      "picture.caveats", ISOLUX_MEMBER(picture.caveats), noRange, "",
      "A line on the finished picture for each thing that it leaves out or that nobody measured: pieces that "
      "are hidden, missing slices that are interpolated. Without any, nothing is written."));
  add(entry<Scene>(
      "picture.transparent", ISOLUX_MEMBER(picture.transparent), noRange, "",
      "The finished picture has no background: its alpha is how much of each pixel is covered."));
  add(entry<Scene>(
      "picture.pixel_ratio", ISOLUX_MEMBER(picture.pixelRatio), {0.1, 32}, "pixels",
      "Pixels of the finished picture for each pixel that widths and lengths of lines and streaks "
      "are stated in: 2 in a picture twice as large, for the same look."));
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
