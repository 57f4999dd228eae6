// Fills in what a Scene leaves automatic: isovalue and camera, from facts about the volume.
#pragma once

#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "scene/world_axes.h"

namespace isolux::scene {

// What automatic settings may depend on.
struct VolumeFacts {
  glm::dvec3 boundsMinMm{0.0}, boundsMaxMm{0.0};  // world box of what there is to see
  double suggestedIsovalue = 0.0;                 // data units, volume::suggestIsovalue()
  // Ascending: those that each show something of its own, volume::suggestIsovalues().
  std::vector<double> suggestedIsovalues{};
  std::optional<double> csgIsovalue = std::nullopt;  // of the second volume, where there is one
  double minimum = 0.0, maximum = 0.0;               // data units
  // Data units: what neighbouring voxels differ by where they differ (90 % quantile).
  double typicalStep = 0.0;
  WorldAxes axes = WorldAxes::zUp;
  glm::dvec3 spacingMm{1.0};
};

// Every optional of the result has a value, but those that depend on the surface itself (ranges of colour
// maps, the ridge threshold; noise and scales of derivatives, which volume::DerivativeChoices fills in), the
// fog's colour and the exposure, which stay automatic for the renderer, those
// of the bake's own business (gi.environment_share), and the isovalue
// of a second volume that is not there. Further isosurfaces take the suggestion that is next outside
// the first, else next inside, and where all are taken a quarter of the way each to the innermost value. An
// explicit setting is never changed. An automatic camera looks from the front (frontOf(): a patient faces the
// viewer, patient left at the right) and slightly above, and the whole box fits the picture of any aspect
// ratio >= 1. Lamps stand by the same directions.
Scene resolve(Scene scene, const VolumeFacts& facts);

}  // namespace isolux::scene
