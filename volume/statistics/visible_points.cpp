#include "volume/statistics/visible_points.h"

#include <cmath>
#include <numbers>
#include <optional>

#include <glm/geometric.hpp>

#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kDirections = 10;

// A spiral from pole to pole: even on the sphere, and along no axis.
glm::dvec3 spiralDirection(std::size_t i) {
  const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / kDirections, r = std::sqrt(1.0 - z * z);
  const double angle = static_cast<double>(i) * std::numbers::pi * (3.0 - std::sqrt(5.0)) + 0.3;
  return {r * std::cos(angle), r * std::sin(angle), z};
}

// Evenly spread in the unit square for any count: the R2 sequence (Roberts 2018).
glm::dvec2 spreadPoint(std::size_t i) {
  constexpr double plastic = 1.32471795724474602596;
  const double x = 0.5 + static_cast<double>(i) / plastic,
               y = 0.5 + static_cast<double>(i) / (plastic * plastic);
  return {x - std::floor(x), y - std::floor(y)};
}

// Parallel rays toward all of a box of voxels.
class Beam {
 public:
  Beam(const GridGeometry& geometry, glm::dvec3 low, glm::dvec3 high, glm::dvec3 direction)
      : voxelFromWorld_(geometry.voxelFromWorld()), direction_(direction) {
    right_ = glm::normalize(
        glm::cross(direction, std::abs(direction.z) < 0.7 ? glm::dvec3(0, 0, 1) : glm::dvec3(1, 0, 0)));
    up_ = glm::cross(right_, direction);
    for (const glm::dvec3& corner : geometry.corners(low, high))
      along_.add({glm::dot(corner, right_), glm::dot(corner, up_), glm::dot(corner, direction)});
  }
  Ray ray(glm::dvec2 part) const {
    const glm::dvec2 at = glm::dvec2(along_.low) + part * glm::dvec2(along_.size());
    const double before = along_.low.z - 0.01 * along_.size().z;
    Ray ray;
    ray.origin =
        glm::dvec3(voxelFromWorld_ * glm::dvec4(at.x * right_ + at.y * up_ + before * direction_, 1.0));
    ray.direction = glm::dvec3(voxelFromWorld_ * glm::dvec4(direction_, 0.0));
    return ray;
  }
  glm::dvec3 direction() const { return direction_; }

 private:
  glm::dmat4 voxelFromWorld_;
  glm::dvec3 direction_, right_{0.0}, up_{0.0};
  Bounds<glm::dvec3> along_;  // the box, along right, up and direction, mm
};

Bounds<glm::dvec3> boxOfSurface(const Grid& grid, const MinMaxBlocks& blocks, double isovalue) {
  Bounds<glm::dvec3> box;
  const float stored = grid.storedIsovalue(isovalue);
  forEachIn(glm::ivec3(0), blocks.dims(), [&](glm::ivec3 block) {
    if (!blocks.active(blocks.index(block), stored)) return;
    box.add({glm::dvec3(block), glm::dvec3(block + 1)});
  });
  const double cells = blocks.blockCells();
  return {box.low * cells, glm::min(box.high * cells, glm::dvec3(grid.dims() - 1))};
}

}  // namespace

std::vector<VisiblePoint> visiblePoints(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                        std::size_t wanted, const HiddenPieces& hidden) {
  std::vector<VisiblePoint> points;
  const Bounds<glm::dvec3> box = boxOfSurface(grid, blocks, isovalue);
  if (!(box.low.x <= box.high.x) || !std::isfinite(isovalue)) return points;
  std::vector<Beam> beams;
  for (std::size_t i = 0; i < kDirections; ++i)
    beams.emplace_back(grid.geometry(), box.low, box.high, spiralDirection(i));
  const std::size_t batch = (wanted / kDirections + 1) * kDirections;
  std::vector<std::optional<RayHit>> hits(batch);
  constexpr std::size_t mostBatches = 16;
  for (std::size_t first = 0; first < mostBatches * batch && points.size() < wanted; first += batch) {
    parallelEach(batch, [&](std::size_t i) {
      const Ray ray = beams[i % kDirections].ray(spreadPoint((first + i) / kDirections));
      hits[i] = firstHit(grid, blocks, isovalue, ray, hidden);
    });
    for (std::size_t i = 0; i < batch && points.size() < wanted; ++i)
      if (hits[i]) points.push_back({hits[i]->voxel, beams[i % kDirections].direction()});
  }
  return points;
}

}  // namespace isolux::volume
