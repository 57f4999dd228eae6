#include "tests/properties/searched_ray.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/reconstruct.h"

namespace isolux::test {

DoubleField::DoubleField(const volume::Grid& grid, scene::Field field)
    : grid_(grid.geometry(), grid.voxels()),
      field_(field),
      least_(grid.storedMinimum()),
      most_(grid.storedMaximum()) {
  if (field != scene::Field::cubic_interpolating) return;
  base::Progress progress;
  coefficients_ = volume::interpolatingCoefficients(grid, progress);
  least_ = coefficients_->offset + static_cast<double>(coefficients_->least);
  most_ = coefficients_->offset + static_cast<double>(coefficients_->most);
}

double DoubleField::operator()(const glm::dvec3& voxel) const {
  if (field_ == scene::Field::trilinear) return volume::sampleTrilinear(grid_, voxel).value;
  return coefficients_ ? volume::sampleCubic(*coefficients_, grid_, voxel).value
                       : volume::sampleCubic(grid_, voxel).value;
}

double DoubleField::rangeAt(const glm::dvec3& voxel) const {
  const glm::ivec3 last = grid_.dims() - 1;
  const glm::ivec3 low = glm::clamp(glm::ivec3(glm::floor(voxel)) - 2, glm::ivec3(0), last);
  const glm::ivec3 high = glm::clamp(glm::ivec3(glm::floor(voxel)) + 3, glm::ivec3(0), last);
  double least = HUGE_VAL, most = -HUGE_VAL;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) {
        const double f = coefficients_ ? static_cast<double>(coefficients_->values[grid_.index(x, y, z)])
                                       : grid_.stored(x, y, z);
        if (f < least) least = f;
        if (f > most) most = f;
      }
  return most > least ? most - least : 0.0;
}

bool DoubleField::missingBetween(const glm::dvec3& a, const glm::dvec3& b, double slack) const {
  if (grid_.missingCount() == 0) return false;
  const int apron = field_ == scene::Field::trilinear ? 0 : 1;
  const glm::ivec3 last = grid_.dims() - 1;
  const glm::ivec3 low = glm::max(glm::ivec3(glm::floor(glm::min(a, b) - slack)) - apron, glm::ivec3(0));
  const glm::ivec3 high = glm::min(glm::ivec3(glm::ceil(glm::max(a, b) + slack)) + apron, last);
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x)
        if (std::isnan(grid_.stored(x, y, z))) return true;
  return false;
}

std::optional<ClearCrossing> firstClearCrossing(const DoubleField& field, double storedIsovalue,
                                                double margin, double slack, const volume::Ray& ray,
                                                std::optional<bool> rising) {
  const volume::Grid& grid = field.grid();
  double begin = ray.tMinimum, end = ray.tMaximum;
  // Well within the volume: at its border the finder's ray may lie outside.
  for (int axis = 0; axis < 3; ++axis) {
    const double low = slack, high = grid.dims()[axis] - 1 - slack, o = ray.origin[axis],
                 d = ray.direction[axis];
    if (d == 0.0) {
      if (o < low || o > high) return std::nullopt;
      continue;
    }
    begin = std::max(begin, std::min((low - o) / d, (high - o) / d));
    end = std::min(end, std::max((low - o) / d, (high - o) / d));
  }
  if (!(begin < end)) return std::nullopt;
  const auto steps = static_cast<int>(std::ceil(16.0 * (end - begin) * glm::length(ray.direction)));
  int side = 0;
  glm::dvec3 before = ray.origin + begin * ray.direction;
  for (int k = 0; k <= steps; ++k) {
    const double t = k == steps ? end : begin + (end - begin) * k / steps;
    const glm::dvec3 at = ray.origin + t * ray.direction;
    const double f = field(at) - storedIsovalue;
    const bool gap = std::isnan(f) || field.missingBetween(before, at, slack);
    before = at;
    if (gap) {
      side = 0;
      continue;
    }
    const int now = f > margin ? 1 : f < -margin ? -1 : 0;
    if (now == 0) continue;
    if (side != 0 && now != side && rising.value_or(now > 0) == (now > 0)) return ClearCrossing{t, now > 0};
    side = now;
  }
  return std::nullopt;
}

}  // namespace isolux::test
