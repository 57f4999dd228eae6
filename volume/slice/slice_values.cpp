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
  double low = 1e300, high = -1e300;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::dvec3 voxel =
        glm::dvec3(geometry.dims - 1) * glm::dvec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const glm::dvec3 world(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
    const double at = glm::dot(world - plane.originMm, normal);
    low = std::min(low, at);
    high = std::max(high, at);
  }
  const double from = std::max(-0.5 * mm, low), to = std::min(0.5 * mm, high);
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
  double sum = 0.0, weights = 0.0, least = 1e300, most = -1e300;
  for (int i = 0; i <= way.steps; ++i) {
    const double value = field.value(voxel + way.offset + static_cast<double>(i) * way.step);
    if (std::isnan(value)) continue;
    const double weight = i == 0 || i == way.steps ? 0.5 : 1.0;
    sum += weight * value;
    weights += weight;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  if (weights == 0.0) return kNan;
  if (mode == scene::SlabMode::mean) return sum / weights;
  return mode == scene::SlabMode::maximum ? most : least;
}

bool cornerMissing(const Grid& grid, glm::dvec3 voxel) {
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 up(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
    const glm::ivec3 at = glm::ivec3(glm::floor(voxel)) + up * glm::ivec3(glm::ceil(glm::fract(voxel)));
    if (std::isnan(grid.stored(at.x, at.y, at.z))) return true;
  }
  return false;
}

}  // namespace

double SliceField::value(glm::dvec3 voxel) const {
  const glm::dvec3 last(grid.dims() - 1);
  for (int axis = 0; axis < 3; ++axis)
    if (!(voxel[axis] >= -kBorderVoxels && voxel[axis] <= last[axis] + kBorderVoxels)) return kNan;
  voxel = glm::clamp(voxel, glm::dvec3(0.0), last);
  if (field == scene::Field::trilinear) return sampleTrilinear(grid, voxel).value;
  if (field == scene::Field::cubic) return sampleCubic(grid, voxel).value;
  if (grid.missingCount() > 0 && cornerMissing(grid, voxel)) return kNan;
  return sampleCubic(*coefficients, grid, voxel).value;
}

SliceValues sliceValues(const SliceField& field, const SlicePlane& plane, const Slab& slab,
                        base::Progress& progress) {
  const auto width = static_cast<std::size_t>(plane.size.x);
  const std::size_t count = width * static_cast<std::size_t>(plane.size.y);
  SliceValues slice;
  slice.size = plane.size;
  slice.held = base::machineMemory().reserve(count * sizeof(float), "the values of a slice",
                                             "a smaller image needs less");
  resizeStoppably(slice.values, count, progress);
  const GridGeometry& geometry = field.grid.geometry();
  const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
  const glm::dvec3 origin(voxelFromWorld * glm::dvec4(plane.originMm, 1.0));
  const glm::dvec3 right = glm::dmat3(voxelFromWorld) * plane.rightMm;
  const glm::dvec3 down = glm::dmat3(voxelFromWorld) * plane.downMm;
  const SlabWay way = slabWay(geometry, plane, slab.mm);
  const auto samples = static_cast<std::size_t>(way.steps) + 1;
  parallelPieces(count, std::max<std::size_t>(1, 8192 / samples), progress, {0.0, 1.0, "slicing"},
                 [&](std::size_t begin, std::size_t end) {
                   for (std::size_t i = begin; i < end; ++i) {
                     const glm::dvec3 voxel = origin + static_cast<double>(i % width) * right +
                                              static_cast<double>(i / width) * down;
                     slice.values[i] = static_cast<float>(slabValue(field, voxel, way, slab.mode));
                   }
                 });
  return slice;
}

}  // namespace isolux::volume
