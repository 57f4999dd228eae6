// Fills in the automatic settings of a Scene, such as isovalue and camera, from facts about the volume.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/framing.h"
#include "scene/scene.h"
#include "scene/world_axes.h"

namespace isolux::scene {

// Facts about the volume that automatic settings may depend on.
struct VolumeFacts {
  glm::dvec3 boundsMinMm{0.0}, boundsMaxMm{0.0};  // world box of the visible part
  double suggestedIsovalue = 0.0;                 // data units, volume::suggestIsovalue()
  // Ascending: each shows a different structure, volume::suggestIsovalues().
  std::vector<double> suggestedIsovalues{};
  std::optional<double> csgIsovalue = std::nullopt;  // of the second volume, if any
  double minimum = 0.0, maximum = 0.0;               // data units
  // Data units: the 90 % quantile of the differences of neighbouring voxels that differ.
  double typicalStep = 0.0;
  WorldAxes axes = WorldAxes::zUp;
  glm::dvec3 spacingMm{1.0};
  double contrastIsovalue = 0.0;  // data units, volume::contrastIsovalue()
  // Points whose hull contains the isosurface of suggestedIsovalue, world mm; a first image frames them, seen
  // from toEye (unit) with `up` at its top. Empty: unknown, and the box is framed.
  std::vector<glm::dvec3> outlineMm{};
  glm::dvec3 toEye{0.0}, up{0.0};
  // A label map whose labels are shown has the mean of their colours, linear RGB; its one surface is at 0.
  std::optional<glm::dvec3> labelAlbedo = std::nullopt;
};

// Fills in every optional, with these exceptions:
//   - those that depend on the surface itself: ranges of colour maps, the ridge threshold; noise and scales
//     of derivatives, which volume::DerivativeChoices fills in;
//   - the fog's colour and the exposure, which the renderer chooses;
//   - gi.environment_share, which the bake chooses;
//   - the isovalue of a second volume if there is none.
// Further isosurfaces use the next suggestion outside the first, else the next inside. If all are in use,
// each moves a quarter of the way to the innermost value. An explicit setting is never changed. An automatic
// camera frames the outline or the box, as camera.frames states, for images of any aspect ratio >= 1. It
// shows the box from the front (frontOf(): a patient faces the viewer, patient left at the right) and
// slightly above. Light sources are placed relative to the front.
Scene resolve(Scene scene, const VolumeFacts& facts);

// Returns the camera with the same direction and up that frames the object of camera.frames, as in resolve().
Camera framed(const Camera& camera, const VolumeFacts& facts);

// Returns a resolved camera of framed(), adapted to these free rectangles. Returns any other camera
// unchanged, because the user has chosen its view; `rooms`, which take long to find, are not asked for then.
Camera fittedTo(const Camera& camera, const VolumeFacts& facts, const std::function<Rooms()>& rooms);

}  // namespace isolux::scene
