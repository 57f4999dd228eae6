#include "volume/clip/clip_region.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>

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

ClipRegion::Segment ClipRegion::Removed::segmentOf(const glm::dvec3& origin, const glm::dvec3& direction,
                                                   bool closed) const {
  Segment within;
  for (int axis = 0; axis < 3; ++axis) {
    const double o = origin[axis], d = direction[axis];
    if (d == 0.0) {
      const bool inside = o >= low[axis] && (o < high[axis] || (closed && o == high[axis]));
      if (!inside) within.end = -std::numeric_limits<double>::infinity();
      continue;
    }
    within.begin = std::max(within.begin, ((d > 0.0 ? low : high)[axis] - o) / d);
    within.end = std::min(within.end, ((d > 0.0 ? high : low)[axis] - o) / d);
  }
  return within;
}

bool ClipRegion::RaySegments::hold(double t) const {
  return std::any_of(begin(), end(), [t](const Segment& segment) { return segment.holds(t); });
}

ClipRegion::ClipRegion(const scene::Clip& clip) {
  for (const scene::ClipPlane& plane : clip.planes) add(plane.point, plane.normal);
  for (std::size_t i = 1; i < clip.removed.size() && removedCount_ < kMostRemoved; i += 2)
    removed_[removedCount_++] = {glm::min(clip.removed[i - 1], clip.removed[i]),
                                 glm::max(clip.removed[i - 1], clip.removed[i])};
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
  const glm::dvec3 voxel0(geometry.worldFromVoxel[3]);  // floats keep more digits near their origin
  for (std::size_t i = 0; i < removedCount_; ++i)
    region.removed_[i] = {removed_[i].low - voxel0, removed_[i].high - voxel0};
  region.axes_ = glm::dmat3(geometry.worldFromVoxel);
  return region;
}

bool ClipRegion::contains(const glm::dvec3& p) const {
  const bool between = std::ranges::all_of(
      faces(), [&](const glm::dvec4& face) { return glm::dot(face, glm::dvec4(p, 1.0)) <= 0.0; });
  const glm::dvec3 at = axes_ * p;
  return between && std::ranges::none_of(removed(), [&](const Removed& box) {
           return glm::all(glm::greaterThanEqual(at, box.low)) && glm::all(glm::lessThan(at, box.high));
         });
}

ClipRegion::Segment ClipRegion::betweenFaces(const glm::dvec3& origin, const glm::dvec3& direction,
                                             Segment whole) const {
  for (const glm::dvec4& face : faces()) {
    const double at = glm::dot(face, glm::dvec4(origin, 1.0)), per = glm::dot(glm::dvec3(face), direction);
    if (per > 0.0)
      whole.end = std::min(whole.end, -at / per);
    else if (per < 0.0)
      whole.begin = std::max(whole.begin, -at / per);
    else if (at > 0.0)
      return {std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  }
  return whole;
}

ClipRegion::RaySegments ClipRegion::segmentsOf(const glm::dvec3& origin, const glm::dvec3& direction,
                                               Segment whole) const {
  RaySegments kept;
  whole = betweenFaces(origin, direction, whole);
  if (whole.empty()) return kept;
  std::array<Segment, kMostRemoved> gone;  // by where they begin
  std::size_t count = 0;
  const glm::dvec3 from = axes_ * origin, along = axes_ * direction;
  for (const Removed& box : removed()) {
    const Segment within = box.segmentOf(from, along, false);
    if (!(within.begin < within.end)) continue;
    std::size_t at = count++;
    for (; at > 0 && gone[at - 1].begin > within.begin; --at) gone[at] = gone[at - 1];
    gone[at] = within;
  }
  double t = whole.begin;
  for (std::size_t i = 0; i < count && gone[i].begin < whole.end; ++i) {
    if (gone[i].begin > t) kept.add({t, gone[i].begin});
    t = std::max(t, gone[i].end);
  }
  // Of a box that ends at a plane nothing is left behind it.
  if (t < whole.end || t == whole.begin) kept.add({t, whole.end});
  return kept;
}

std::uint64_t ClipRegion::key() const {
  if (!cuts()) return 0;
  base::Hasher hash;
  const auto add = [&](double number) { hash.add(number == 0.0 ? 0.0 : number); };  // -0 is 0
  for (const glm::dvec4& face : faces())
    for (int i = 0; i < 4; ++i) add(face[i]);
  for (const Removed& box : removed())
    for (int i = 0; i < 3; ++i) add(box.low[i]), add(box.high[i]);
  if (removedCount_ > 0)
    for (int i = 0; i < 9; ++i) add(axes_[i / 3][i % 3]);
  return hash;
}

}  // namespace isolux::volume
