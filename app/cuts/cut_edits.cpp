#include "app/cuts/cut_edits.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/vector_relational.hpp>

#include "volume/clip/clip_region.h"

namespace isolux::app {

namespace {

constexpr double boxShare = 0.75;  // of what there is to see

glm::dvec3 meanOf(const BoxCorners& box) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& corner : box) sum += corner;
  return sum / 8.0;
}

glm::dvec3 nearestAxis(const glm::dvec3& direction) {
  const glm::dvec3 size = glm::abs(direction);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  glm::dvec3 along(0.0);
  along[axis] = direction[axis] < 0.0 ? -1.0 : 1.0;
  return along;
}

// The centroid of a convex polygon; none where it has no area.
std::optional<glm::dvec3> centroidOf(const std::vector<glm::dvec3>& outline, const glm::dvec3& normal) {
  glm::dvec3 sum(0.0);
  double area = 0.0;  // twice, of the triangles about the first corner
  for (std::size_t i = 2; i < outline.size(); ++i) {
    const double part = glm::dot(normal, glm::cross(outline[i - 1] - outline[0], outline[i] - outline[0]));
    sum += part * (outline[0] + outline[i - 1] + outline[i]) / 3.0;
    area += part;
  }
  if (!(area > 0.0)) return std::nullopt;
  return sum / area;
}

// What of a convex polygon lies on the kept side of a face (Sutherland and Hodgman 1974).
std::vector<glm::dvec3> keptBy(const glm::dvec4& face, const std::vector<glm::dvec3>& outline) {
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec3 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    const double atP = glm::dot(face, glm::dvec4(p, 1.0)), atQ = glm::dot(face, glm::dvec4(q, 1.0));
    if (atP <= 0.0) kept.push_back(p);
    if ((atP <= 0.0) != (atQ <= 0.0)) kept.push_back(glm::mix(p, q, atP / (atP - atQ)));
  }
  return kept;
}

}  // namespace

glm::dvec3 cutPoint(const scene::Scene& resolved, const scene::VolumeFacts& facts) {
  const glm::dvec3 middle = 0.5 * (facts.boundsMinMm + facts.boundsMaxMm);
  const glm::dvec3 wanted = resolved.slice.position.value_or(resolved.camera.target.value_or(middle));
  return glm::clamp(wanted, facts.boundsMinMm, facts.boundsMaxMm);
}

scene::ClipPlane planeAcross(int axis, const glm::dvec3& point, const glm::dvec3& back) {
  glm::dvec3 normal(0.0);
  normal[axis] = back[axis] < 0.0 ? -1.0 : 1.0;
  return {point, normal};
}

scene::ClipPlane planeFacing(const glm::dvec3& back, const glm::dvec3& point) {
  return {point, back};
}

std::optional<scene::ClipPlane> planeThrough(std::span<const glm::dvec3, 3> points, const glm::dvec3& back) {
  const glm::dvec3 a = points[1] - points[0], b = points[2] - points[0];
  const glm::dvec3 across = glm::cross(a, b);
  const double length = glm::length(across), longest = std::max(glm::dot(a, a), glm::dot(b, b));
  if (!(length > 1e-6 * longest)) return std::nullopt;
  const glm::dvec3 normal = across / length;
  return scene::ClipPlane{(points[0] + points[1] + points[2]) / 3.0,
                          glm::dot(normal, back) < 0.0 ? -normal : normal};
}

std::vector<glm::dvec3> lastMarked(const std::vector<scene::Mark>& marks, std::size_t count) {
  std::vector<glm::dvec3> points;
  for (const scene::Mark& mark : marks) points.insert(points.end(), mark.points.begin(), mark.points.end());
  if (points.size() > count) points.erase(points.begin(), points.end() - static_cast<std::ptrdiff_t>(count));
  return points;
}

scene::ClipPlane flipped(scene::ClipPlane plane) {
  for (int i = 0; i < 3; ++i) plane.normal[i] = plane.normal[i] == 0.0 ? 0.0 : -plane.normal[i];
  return plane;
}

std::vector<glm::dvec3> outlineOf(const scene::ClipPlane& plane, const BoxCorners& box) {
  const glm::dvec3 normal = glm::normalize(plane.normal);
  std::array<double, 8> above;
  for (std::size_t i = 0; i < 8; ++i) above[i] = glm::dot(normal, box[i] - plane.point);
  std::vector<glm::dvec3> points;
  for (std::size_t i = 0; i < 8; ++i)
    for (const std::size_t bit : {1U, 2U, 4U}) {
      const std::size_t j = i | bit;
      if (j == i || (above[i] < 0.0) == (above[j] < 0.0)) continue;
      points.push_back(glm::mix(box[i], box[j], above[i] / (above[i] - above[j])));
    }
  if (points.size() < 3) return {};
  glm::dvec3 mean(0.0);
  for (const glm::dvec3& point : points) mean += point / static_cast<double>(points.size());
  const glm::dvec3 u =
      glm::normalize(glm::cross(normal, nearestAxis(glm::dvec3(normal.y, normal.z, normal.x))));
  const glm::dvec3 v = glm::cross(normal, u);
  const auto angle = [&](const glm::dvec3& p) {
    return std::atan2(glm::dot(p - mean, v), glm::dot(p - mean, u));
  };
  std::ranges::sort(points, [&](const glm::dvec3& p, const glm::dvec3& q) { return angle(p) < angle(q); });
  return points;
}

glm::dvec3 middleOf(const scene::ClipPlane& plane, const BoxCorners& box) {
  const glm::dvec3 normal = glm::normalize(plane.normal);
  if (const auto centroid = centroidOf(outlineOf(plane, box), normal)) return *centroid;
  const glm::dvec3 middle = meanOf(box);
  return middle - glm::dot(normal, middle - plane.point) * normal;
}

std::vector<glm::dvec3> faceOf(const scene::Clip& clip, std::size_t plane, const BoxCorners& box) {
  const std::vector<glm::dvec3> whole = outlineOf(clip.planes[plane], box);
  scene::Clip others = clip;
  others.planes.erase(others.planes.begin() + static_cast<std::ptrdiff_t>(plane));
  std::vector<glm::dvec3> face = whole;
  const volume::ClipRegion region(others);
  for (const glm::dvec4& other : region.faces()) face = keptBy(other, face);
  const bool left = centroidOf(face, glm::normalize(clip.planes[plane].normal)).has_value();
  return left ? face : whole;
}

glm::dvec3 middleOfFace(const scene::Clip& clip, std::size_t plane, const BoxCorners& box) {
  const auto centroid = centroidOf(faceOf(clip, plane, box), glm::normalize(clip.planes[plane].normal));
  return centroid ? *centroid : middleOf(clip.planes[plane], box);
}

scene::ClipPlane alignedToAxis(const scene::ClipPlane& plane, const BoxCorners& box) {
  return {middleOf(plane, box), nearestAxis(plane.normal)};
}

scene::ClipPlane alignedToViewer(const scene::ClipPlane& plane, const BoxCorners& box,
                                 const glm::dvec3& back) {
  return {middleOf(plane, box), back};
}

void addBox(scene::Clip& clip, const scene::VolumeFacts& facts) {
  const glm::dvec3 middle = 0.5 * (facts.boundsMinMm + facts.boundsMaxMm);
  const glm::dvec3 half = 0.5 * boxShare * (facts.boundsMaxMm - facts.boundsMinMm);
  clip.box = {middle - half, middle + half};
  clip.boxRotation = {1.0, 0.0, 0.0, 0.0};
}

void addCorner(scene::Clip& clip, const glm::dvec3& point, const glm::dvec3& back,
               const BoxCorners& corners) {
  volume::Bounds<glm::dvec3> bounds;
  for (const glm::dvec3& corner : corners) bounds.add(corner);
  const auto [low, high] = bounds;
  const double beyond = 0.1 * glm::distance(low, high);
  clip.removed.push_back(point);
  clip.removed.push_back(glm::mix(high + beyond, low - beyond, glm::lessThan(back, glm::dvec3(0.0))));
}

void removeCorner(scene::Clip& clip, std::size_t number) {
  if (2 * number + 1 >= clip.removed.size()) return;
  const auto first = clip.removed.begin() + 2 * static_cast<std::ptrdiff_t>(number);
  clip.removed.erase(first, first + 2);
}

TurnedBox turnedBox(const scene::Clip& clip, int number) {
  const glm::dvec3* const corners =
      number == 0 ? clip.box.data() : &clip.removed[2 * static_cast<std::size_t>(-number - 1)];
  TurnedBox box;
  box.middle = 0.5 * (corners[0] + corners[1]);
  box.half = 0.5 * glm::abs(corners[1] - corners[0]);
  if (number < 0) return box;
  const glm::dvec4& wxyz = clip.boxRotation;
  const double length = glm::length(wxyz);
  if (length > 0.0) box.axes = glm::mat3_cast(glm::dquat(wxyz.x, wxyz.y, wxyz.z, wxyz.w) * (1.0 / length));
  return box;
}

glm::dvec3 TurnedBox::corner(int index) const {
  const glm::dvec3 side(index & 1 ? 1.0 : -1.0, index & 2 ? 1.0 : -1.0, index & 4 ? 1.0 : -1.0);
  return middle + axes * (side * half);
}

}  // namespace isolux::app
