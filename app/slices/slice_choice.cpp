#include "app/slices/slice_choice.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "app/slices/slice_content.h"

namespace isolux::app {

namespace {

using Kind = SliceChoice::Kind;

glm::dvec3 inBounds(glm::dvec3 world, const volume::GridGeometry& geometry) {
  const auto [low, high] = geometry.worldBounds();
  return glm::clamp(world, low, high);
}

// Towards the positive end of the axis that it is nearest to.
glm::dvec3 upward(glm::dvec3 normal) {
  const glm::dvec3 size = glm::abs(normal);
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  return normal[axis] < 0.0 ? -normal : normal;
}

bool isDirection(glm::dvec3 v) {
  return glm::dot(v, v) > 0.0 && std::isfinite(glm::dot(v, v));
}

}  // namespace

std::optional<ChosenPlane> chosenPlane(const SliceChoice& choice, const scene::Scene& resolved,
                                       const volume::GridGeometry& geometry, scene::WorldAxes axes) {
  const glm::dvec3 middle = slicePosition({}, geometry), crosshair = slicePosition(resolved, geometry);
  const scene::Convention convention = resolved.slice.convention;
  if (choice.kind == Kind::straight) {
    const int axis = volume::axisOf(choice.direction);
    glm::dvec3 point = middle;
    point[axis] = crosshair[axis];
    return ChosenPlane{point, volume::sliceFrame(choice.direction, axes, convention)};
  }
  const bool isCut = choice.kind == Kind::cut;
  if (isCut && choice.cut >= resolved.clip.planes.size()) return std::nullopt;
  const glm::dvec3 normal = isCut ? resolved.clip.planes[choice.cut].normal : choice.normal;
  if (!isDirection(normal)) return std::nullopt;
  ChosenPlane plane{{}, volume::sliceFrame(normal, axes, convention)};
  const glm::dvec3 point = isCut ? resolved.clip.planes[choice.cut].point : crosshair;
  plane.pointMm = middle + plane.normal() * glm::dot(point - middle, plane.normal());
  return plane;
}

glm::dvec3 crosshairAt(const SliceChoice& choice, const scene::Scene& resolved,
                       const volume::GridGeometry& geometry, glm::dvec3 worldMm) {
  if (choice.kind == Kind::straight) {
    const int axis = volume::axisOf(choice.direction);
    worldMm[axis] = slicePosition(resolved, geometry)[axis];
  }
  return inBounds(worldMm, geometry);
}

void stepPlane(scene::Scene& scene, const SliceChoice& choice, const scene::Scene& resolved,
               const volume::GridGeometry& geometry, scene::WorldAxes axes, double voxels) {
  const auto plane = chosenPlane(choice, resolved, geometry, axes);
  if (!plane) return;
  const glm::dvec3 normal = upward(plane->normal());
  const glm::dvec3 step = voxels * volume::voxelAlong(geometry, normal) * normal;
  if (choice.kind == Kind::cut) {
    scene.clip.planes = resolved.clip.planes;
    scene.clip.planes[choice.cut].point += step;
    return;
  }
  scene.slice.position = inBounds(slicePosition(resolved, geometry) + step, geometry);
}

std::optional<std::array<glm::dvec2, 2>> crossingLine(const volume::SlicePlane& picture,
                                                      const ChosenPlane& other) {
  // a x + b y + c = 0 in pixels.
  const glm::dvec3 normal = other.normal();
  const glm::dvec2 ab(glm::dot(normal, picture.rightMm), glm::dot(normal, picture.downMm));
  const double c = glm::dot(normal, picture.originMm - other.pointMm);
  constexpr double parallel = 1e-9;  // sine of the angle between the planes
  if (!(glm::length(ab) > parallel * picture.pixelMm())) return std::nullopt;
  const glm::dvec2 foot = -c * ab / glm::dot(ab, ab), way = glm::normalize(glm::dvec2(-ab.y, ab.x));
  const glm::dvec2 low(-0.5), high = glm::dvec2(picture.size) - 0.5;
  double begin = -1e300, end = 1e300;
  for (int i = 0; i < 2; ++i) {
    if (way[i] == 0.0) {
      if (foot[i] < low[i] || foot[i] > high[i]) return std::nullopt;
      continue;
    }
    const double p = (low[i] - foot[i]) / way[i], q = (high[i] - foot[i]) / way[i];
    begin = std::max(begin, std::min(p, q));
    end = std::min(end, std::max(p, q));
  }
  if (!(begin < end)) return std::nullopt;
  return std::array{foot + begin * way, foot + end * way};
}

}  // namespace isolux::app
