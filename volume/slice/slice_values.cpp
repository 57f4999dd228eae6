#include "volume/slice/slice_values.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/reconstruct.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

// Samples of a slab in voxel coordinates: offset, then `steps` steps.
struct SlabWay {
  glm::dvec3 offset{0.0}, step{0.0};
  int steps = 0;
};

// Of the slab what lies between the volume's ends.
SlabWay slabWay(const GridGeometry& geometry, const SlicePlane& plane, double mm) {
  if (!(mm > 0.0)) return {};
  const glm::dvec3 normal = plane.frame().normal();
  Bounds<double> ends;
  for (const glm::dvec3& corner : geometry.corners()) ends.add(glm::dot(corner - plane.originMm, normal));
  const double from = std::max(-0.5 * mm, ends.low), to = std::min(0.5 * mm, ends.high);
  if (!(from < to)) return {};  // beside the volume, or at most touching it
  const double steps = std::ceil((to - from) / (0.5 * voxelAlong(geometry, normal)) - 1e-9);
  SlabWay way;
  way.steps = static_cast<int>(std::clamp(steps, 2.0, static_cast<double>(kMostSlabSteps)));
  const glm::dmat3 toVoxels(geometry.voxelFromWorld());
  way.offset = toVoxels * (from * normal);
  way.step = toVoxels * ((to - from) * normal) / static_cast<double>(way.steps);
  return way;
}

double slabValue(const SliceField& field, glm::dvec3 voxel, const SlabWay& way, scene::SlabMode mode) {
  if (way.steps == 0) return field.value(voxel);
  double sum = 0.0, weights = 0.0;
  Bounds<double> values;
  for (int i = 0; i <= way.steps; ++i) {
    const double value = field.value(voxel + way.offset + static_cast<double>(i) * way.step);
    if (std::isnan(value)) continue;
    const double weight = i == 0 || i == way.steps ? 0.5 : 1.0;
    sum += weight * value;
    weights += weight;
    values.add(value);
  }
  if (weights == 0.0) return kNan;
  if (mode == scene::SlabMode::mean) return sum / weights;
  return mode == scene::SlabMode::maximum ? values.high : values.low;
}

bool cornerMissing(const Grid& grid, glm::dvec3 voxel) {
  const glm::ivec3 low(glm::floor(voxel)), between(glm::ceil(glm::fract(voxel)));
  for (int i = 0; i < 8; ++i)
    if (std::isnan(grid.stored(low + cornerStep(i) * between))) return true;
  return false;
}

// Of each pixel of the plane, valueAt(voxel) of its centre. `samples`: how many of them that reads.
template <class ValueAt>
SliceValues valuesOnPlane(const GridGeometry& geometry, const SlicePlane& plane, std::size_t samples,
                          base::Progress& progress, const ValueAt& valueAt) {
  const Extent2 extent{plane.size};
  const std::size_t count = extent.count();
  SliceValues slice;
  slice.size = plane.size;
  slice.held = base::machineMemory().reserve(count * sizeof(float), "the values of a slice",
                                             "a smaller image needs less");
  resizeStoppably(slice.values, count, progress);
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const glm::dvec3 origin(voxelFromWorld * glm::dvec4(plane.originMm, 1.0));
  const glm::dvec3 right = glm::dmat3(voxelFromWorld) * plane.rightMm;
  const glm::dvec3 down = glm::dmat3(voxelFromWorld) * plane.downMm;
  parallelPieces(count, std::max<std::size_t>(1, 8192 / samples), progress, {0.0, 1.0, "slicing"},
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const glm::dvec2 at(extent.at(i));
                     slice.values[i] = static_cast<float>(valueAt(origin + at.x * right + at.y * down));
                   }
                 });
  return slice;
}

}  // namespace

double SliceField::value(glm::dvec3 voxel) const {
  if (!grid.geometry().holds(voxel, kBorderVoxels)) return kNan;
  voxel = glm::clamp(voxel, glm::dvec3(0.0), glm::dvec3(grid.dims() - 1));
  const bool fromCoefficients = field == scene::Field::cubic_interpolating;
  if (fromCoefficients && grid.missingCount() > 0 && cornerMissing(grid, voxel)) return kNan;
  return sampleField(grid, field, fromCoefficients ? coefficients : nullptr, voxel).value;
}

SliceValues sliceValues(const SliceField& field, const SlicePlane& plane, const Slab& slab,
                        base::Progress& progress) {
  const SlabWay way = slabWay(field.grid.geometry(), plane, slab.mm);
  return valuesOnPlane(field.grid.geometry(), plane, static_cast<std::size_t>(way.steps) + 1, progress,
                       [&](const glm::dvec3& voxel) { return slabValue(field, voxel, way, slab.mode); });
}

SliceValues nearestValues(const Grid& grid, const SlicePlane& plane, base::Progress& progress) {
  return valuesOnPlane(grid.geometry(), plane, 1, progress, [&](const glm::dvec3& voxel) {
    if (!grid.geometry().holds(voxel, kBorderVoxels)) return kNan;
    return grid.value(glm::clamp(glm::ivec3(glm::round(voxel)), glm::ivec3(0), grid.dims() - 1));
  });
}

}  // namespace isolux::volume
