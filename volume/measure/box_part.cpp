#include "volume/measure/box_part.h"

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace isolux::volume {

namespace {

constexpr double kFinestPart = 1.0 / 16.0;

bool axesOfWorld(const glm::dmat4& worldFromVoxel) {
  for (int axis = 0; axis < 3; ++axis) {
    int components = 0;
    for (int k = 0; k < 3; ++k) components += worldFromVoxel[axis][k] != 0.0;
    if (components != 1) return false;
  }
  return true;
}

}  // namespace

BoxWalls::BoxWalls(const GridGeometry& geometry, const WorldBox& box)
    : geometry_(geometry), box_(box), aligned_(axesOfWorld(geometry.worldFromVoxel)) {
  if (!aligned_) return;
  const glm::dvec3 a = geometry.voxelOf(box.lowMm), b = geometry.voxelOf(box.highMm);
  lowVoxel_ = glm::min(a, b);
  highVoxel_ = glm::max(a, b);
}

BoxWalls::Side BoxWalls::side(glm::dvec3 low, glm::dvec3 high) const {
  Bounds<glm::dvec3> world;
  for (const glm::dvec3& corner : geometry_.corners(low, high)) world.add(corner);
  if (glm::any(glm::lessThan(world.high, box_.lowMm)) || glm::any(glm::greaterThan(world.low, box_.highMm)))
    return Side::outside;
  const bool inside = glm::all(glm::greaterThanEqual(world.low, box_.lowMm)) &&
                      glm::all(glm::lessThanEqual(world.high, box_.highMm));
  return inside ? Side::inside : Side::cut;
}

BoxPart BoxWalls::measure(glm::ivec3 cell, const CellCorners& corners, const CellMetric& metric,
                          std::vector<CellPoint>& points) const {
  BoxPart part;
  if (aligned_) {
    const glm::dvec3 at(cell);
    part.measure = measureCellPart(corners, metric, glm::clamp(lowVoxel_ - at, 0.0, 1.0),
                                   glm::clamp(highVoxel_ - at, 0.0, 1.0), &points);
  } else {
    addPart(cell, corners, metric, glm::dvec3(0.0), 1.0, part, points);
  }
  return part;
}

void BoxWalls::addPart(glm::ivec3 cell, const CellCorners& corners, const CellMetric& metric, glm::dvec3 low,
                       double size, BoxPart& part, std::vector<CellPoint>& points) const {
  const glm::dvec3 begin = glm::dvec3(cell) + low;
  const Side where = side(begin, begin + size);
  if (where == Side::outside) return;
  if (where == Side::cut && size > kFinestPart) {
    for (int i = 0; i < 8; ++i)
      addPart(cell, corners, metric, low + 0.5 * size * glm::dvec3(cornerStep(i)), 0.5 * size, part, points);
    return;
  }
  const std::size_t before = points.size();
  const CellMeasure measure = measureCellPart(corners, metric, low, low + size, &points);
  if (where == Side::cut) {
    part.unsureVolume += 0.5 * measure.volume;
    part.unsureArea += 0.5 * measure.area;
    const glm::dvec3 middle = begin + 0.5 * size;
    if (side(middle, middle) == Side::outside) {
      points.resize(before);
      return;
    }
  }
  part.measure += measure;
}

}  // namespace isolux::volume
