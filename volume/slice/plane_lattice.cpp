#include "volume/slice/plane_lattice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <glm/matrix.hpp>

#include "volume/slice/slice_values.h"

namespace isolux::volume {

namespace {

constexpr double kLevelPlane = 1e-12;  // c changes so little per voxel that it is rounding

}  // namespace

PlaneLattice::PlaneLattice(const GridGeometry& geometry, const SlicePlane& plane) {
  const glm::dvec3 normal =
      glm::transpose(glm::dmat3(geometry.worldFromVoxel)) * plane.frame().normal();  // per voxel
  for (int axis = 1; axis >= 0; --axis)
    if (std::abs(normal[axis]) > std::abs(normal[c_]) + 1e-12) c_ = axis;
  a_ = (c_ + 1) % 3;
  b_ = (c_ + 2) % 3;
  const glm::dvec3 origin = geometry.voxelOf(plane.originMm);
  cA_ = -normal[a_] / normal[c_];
  cB_ = -normal[b_] / normal[c_];
  if (std::abs(cA_) < kLevelPlane) cA_ = 0.0;
  if (std::abs(cB_) < kLevelPlane) cB_ = 0.0;
  c0_ = origin[c_] - cA_ * origin[a_] - cB_ * origin[b_];
  lastC_ = geometry.dims[c_] - 1;
  if (cA_ == 0.0 && cB_ == 0.0 && c0_ > -kBorderVoxels && c0_ < lastC_ + kBorderVoxels)
    c0_ = std::clamp(c0_, 0.0, static_cast<double>(lastC_));
  squares_ = {geometry.dims[a_] - 1, geometry.dims[b_] - 1};
}

glm::dvec3 PlaneLattice::voxel(glm::dvec2 ab) const {
  glm::dvec3 voxel;
  voxel[a_] = ab.x;
  voxel[b_] = ab.y;
  voxel[c_] = c(ab);
  return voxel;
}

glm::ivec3 PlaneLattice::voxelIndex(int a, int b, int c) const {
  glm::ivec3 voxel;
  voxel[a_] = a;
  voxel[b_] = b;
  voxel[c_] = std::min(c, lastC_);
  return voxel;
}

PlaneLattice::Cells PlaneLattice::cellsAbove(glm::ivec2 square) const {
  Bounds<double> cells;
  for (int corner = 0; corner < 4; ++corner)
    cells.add(c(glm::dvec2(square + glm::ivec2(corner & 1, corner >> 1))));
  const auto [low, high] = cells;
  if (high < 0.0 || low > lastC_) return {};
  const double lastCell = std::max(lastC_ - 1, 0);
  return {static_cast<int>(std::clamp(std::floor(low), 0.0, lastCell)),
          static_cast<int>(std::clamp(std::floor(high), 0.0, lastCell))};
}

glm::dvec2 PlaneLattice::crossing(glm::dvec2 p, glm::dvec2 q, double level) const {
  if (comesFirst(q, p)) std::swap(p, q);
  const double from = c(p), to = c(q);
  return p + (level - from) / (to - from) * (q - p);
}

void PlaneLattice::part(glm::ivec2 square, int k, std::vector<glm::dvec2>& corners) const {
  constexpr std::array<glm::ivec2, 5> way{{{0, 0}, {1, 0}, {1, 1}, {0, 1}, {0, 0}}};
  corners.clear();
  for (std::size_t edge = 0; edge < 4; ++edge) {
    const glm::dvec2 p(square + way[edge]), q(square + way[edge + 1]);
    const double from = c(p), to = c(q);
    if (from >= k && from <= k + 1) corners.push_back(p);
    std::array<double, 2> levels{static_cast<double>(k), k + 1.0};
    if (to < from) std::swap(levels[0], levels[1]);
    for (const double level : levels)
      if ((from < level && level < to) || (to < level && level < from))
        corners.push_back(crossing(p, q, level));
  }
}

}  // namespace isolux::volume
