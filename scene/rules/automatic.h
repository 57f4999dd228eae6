// Fills in what a Scene leaves automatic: isovalue and camera, from facts about the volume.
#pragma once

#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/framing.h"
#include "scene/scene.h"
#include "scene/world_axes.h"

namespace isolux::scene {

// White matter of an MR scan, data units: its border to grey matter, and its mean.
struct WhiteMatter {
  double border = 0.0, mean = 0.0;
};

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
  double contrastIsovalue = 0.0;  // data units, volume::contrastIsovalue()
  // Points that the isosurface of suggestedIsovalue lies within the hull of, world mm: what a first picture
  // frames, seen from toEye (unit) with `up` at its top. Empty: not known, and the box is framed.
  std::vector<glm::dvec3> outlineMm{};
  glm::dvec3 toEye{0.0}, up{0.0};
  std::optional<WhiteMatter> whiteMatter{};  // of an MR scan of a head that tells it apart
};

// Every optional of the result has a value, but those that depend on the surface itself (ranges of colour
// maps, the ridge threshold; noise and scales of derivatives, which volume::DerivativeChoices fills in), the
// fog's colour and the exposure, which stay automatic for the renderer, those
// of the bake's own business (gi.environment_share), and the isovalue
// of a second volume that is not there. Further isosurfaces take the suggestion that is next outside
// the first, else next inside, and where all are taken a quarter of the way each to the innermost value. An
// explicit setting is never changed. An automatic camera frames what camera.frames says for pictures of any
// aspect ratio >= 1: the outline, or the box from the front (frontOf(): a patient faces the viewer, patient
// left at the right) and slightly above. Lamps stand by the front.
Scene resolve(Scene scene, const VolumeFacts& facts);

// Same direction and up, framing what camera.frames says as resolve() does.
Camera framed(const Camera& camera, const VolumeFacts& facts);

// A resolved camera that framed() has made, made for these rooms instead. Any other camera as it is: the user
// has chosen it.
Camera fittedTo(const Camera& camera, const VolumeFacts& facts, const Rooms& rooms);

}  // namespace isolux::scene
