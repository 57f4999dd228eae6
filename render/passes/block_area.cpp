#include "render/passes/block_area.h"

#include <optional>

#include <glm/common.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "render/passes/frame_state.h"

namespace isolux::render {

namespace {

// Where a point of the volume is seen, in rays; none: beside or behind the eye.
std::optional<glm::dvec2> seenAt(const FrameState& frame, const glm::dmat3& cameraFromVoxel,
                                 const glm::dvec3& voxel) {
  constexpr double nearest = 1e-6;  // mm
  const ViewUniforms& view = *frame.view;
  const glm::dvec3 camera = cameraFromVoxel * (voxel - view.eyeVoxel);
  const double distance = view.orthographic ? 1.0 : camera.z + view.startDepth;
  if (!(distance > nearest)) return std::nullopt;
  const glm::dvec2 rays(frame.request.size * frame.request.supersampling);
  const glm::dvec2 origin(frame.tileOrigin() * frame.request.supersampling);
  return 0.5 * rays * (glm::dvec2(camera) / distance / view.halfExtent + 1.0) - origin;
}

}  // namespace

volume::PictureArea blockArea(const FrameState& frame) {
  const glm::ivec2 size = frame.raySize();
  const GpuVolume::Bounds bounds = frame.volume->activeBounds();
  if (glm::any(glm::greaterThan(bounds.low, bounds.high))) return volume::PictureArea(size);
  const ViewUniforms& view = *frame.view;
  const glm::dmat3 cameraFromVoxel =
      glm::inverse(glm::dmat3(view.rightVoxel, view.upVoxel, view.forwardVoxel));
  glm::dvec2 least(size), most(0.0);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::bvec3 high(corner & 1, corner & 2, corner & 4);
    const std::optional<glm::dvec2> at =
        seenAt(frame, cameraFromVoxel, glm::mix(glm::dvec3(bounds.low), glm::dvec3(bounds.high), high));
    if (!at) return volume::PictureArea::whole(size);
    least = glm::min(least, *at);
    most = glm::max(most, *at);
  }
  // A ray more on each side: floats round.
  const glm::ivec2 low(glm::clamp(glm::floor(least) - 1.0, glm::dvec2(0.0), glm::dvec2(size))),
      high(glm::clamp(glm::ceil(most) + 1.0, glm::dvec2(0.0), glm::dvec2(size)));
  return volume::PictureArea::of(size, {low, glm::max(high - low, glm::ivec2(0))});
}

}  // namespace isolux::render
