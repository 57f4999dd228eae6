#include "volume/clip/clip_region.h"

#include <algorithm>

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>

#include "base/hash.h"

namespace isolux::volume {

namespace {

glm::dmat3 axesOf(const glm::dvec4& wxyz) {
  const double length = glm::length(wxyz);
  if (!(length > 0.0)) return glm::dmat3(1.0);
  const glm::dvec4 q = wxyz / length;
  return glm::mat3_cast(glm::dquat(q.x, q.y, q.z, q.w));
}

}  // namespace

ClipRegion::ClipRegion(const scene::Clip& clip) {
  for (const scene::ClipPlane& plane : clip.planes) add(plane.point, plane.normal);
  if (clip.box.size() != 2) return;
  const glm::dvec3 centre = 0.5 * (clip.box[0] + clip.box[1]);
  const glm::dvec3 half = 0.5 * glm::abs(clip.box[1] - clip.box[0]);
  const glm::dmat3 axes = axesOf(clip.boxRotation);
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) add(centre + side * half[axis] * axes[axis], side * axes[axis]);
}

void ClipRegion::add(const glm::dvec3& point, const glm::dvec3& normal) {
  const double length = glm::length(normal);
  if (!(length > 0.0) || count_ == kMostFaces) return;
  const glm::dvec3 unit = normal / length;
  faces_[count_++] = {unit, -glm::dot(unit, point)};
}

ClipRegion ClipRegion::inVoxels(const GridGeometry& geometry) const {
  ClipRegion region = *this;
  const glm::dmat4 ofPlanes = glm::transpose(geometry.worldFromVoxel);
  for (std::size_t i = 0; i < count_; ++i) region.faces_[i] = ofPlanes * faces_[i];
  return region;
}

bool ClipRegion::contains(const glm::dvec3& p) const {
  return std::all_of(faces_.begin(), faces_.begin() + static_cast<std::ptrdiff_t>(count_),
                     [&](const glm::dvec4& face) { return glm::dot(face, glm::dvec4(p, 1.0)) <= 0.0; });
}

ClipRegion::Stretch ClipRegion::stretchOf(const glm::dvec3& origin, const glm::dvec3& direction) const {
  Stretch kept;
  for (const glm::dvec4& face : faces()) {
    const double at = glm::dot(face, glm::dvec4(origin, 1.0)), per = glm::dot(glm::dvec3(face), direction);
    if (per > 0.0)
      kept.end = std::min(kept.end, -at / per);
    else if (per < 0.0)
      kept.begin = std::max(kept.begin, -at / per);
    else if (at > 0.0)
      return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  }
  return kept;
}

std::uint64_t ClipRegion::key() const {
  if (count_ == 0) return 0;
  base::Hasher hash;
  for (const glm::dvec4& face : faces())
    for (int i = 0; i < 4; ++i) hash.add(face[i] == 0.0 ? 0.0 : face[i]);  // -0 is 0
  return hash;
}

}  // namespace isolux::volume
