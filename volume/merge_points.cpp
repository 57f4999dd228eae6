#include "volume/merge_points.h"

#include <array>
#include <bit>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

using Cell = std::array<std::int64_t, 3>;

// The points that are kept, in cells of several tolerances: kept points are farther apart than one, so that a
// cell holds a bounded number of them, and most points look into their own cell only.
class KeptPoints {
 public:
  KeptPoints(const std::vector<glm::dvec3>& points, double tolerance)
      : points_(points),
        tolerance_(tolerance),
        low_(points.front()),
        firstInCell_(std::bit_ceil(2 * points.size() + 1), -1),
        nextInCell_(points.size(), -1) {
    glm::dvec3 high = low_;
    for (const glm::dvec3& p : points) {
      low_ = glm::min(low_, p);
      high = glm::max(high, p);
    }
    // Never so small that the numbers of cells leave the range of doubles' whole numbers.
    const double extent = glm::length(high - low_);
    cellSize_ = std::max(4.0 * tolerance, extent * 0x1p-40);
    if (!(cellSize_ > 0.0)) cellSize_ = 1.0;
  }

  // The first kept point within the tolerance of this one; -1: none.
  int nearest(std::size_t point) const {
    const glm::dvec3& p = points_[point];
    const Cell low = cellOf(p - tolerance_), high = cellOf(p + tolerance_);
    int found = -1;
    for (std::int64_t z = low[2]; z <= high[2]; ++z)
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
        for (std::int64_t x = low[0]; x <= high[0]; ++x)
          for (int i = firstInCell_[slotOf({x, y, z})]; i >= 0; i = nextInCell_[static_cast<std::size_t>(i)])
            if ((found < 0 || i < found) && near(p, points_[static_cast<std::size_t>(i)])) found = i;
    return found;
  }

  void keep(std::size_t point) {
    int& first = firstInCell_[slotOf(cellOf(points_[point]))];
    nextInCell_[point] = first;
    first = static_cast<int>(point);
  }

 private:
  bool near(const glm::dvec3& a, const glm::dvec3& b) const {
    const glm::dvec3 d = a - b;
    return d.x * d.x + d.y * d.y + d.z * d.z <= tolerance_ * tolerance_;
  }

  Cell cellOf(const glm::dvec3& p) const {
    const glm::dvec3 cell = glm::floor((p - low_) / cellSize_);
    return {static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
            static_cast<std::int64_t>(cell.z)};
  }

  // Cells share the slots of a table; points of other cells are told apart by their distance.
  std::size_t slotOf(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (const std::int64_t axis : cell) {
      hash = (hash ^ static_cast<std::uint64_t>(axis)) * 0x9e3779b97f4a7c15u;
      hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash) & (firstInCell_.size() - 1);
  }

  const std::vector<glm::dvec3>& points_;
  double tolerance_, cellSize_ = 1.0;
  glm::dvec3 low_;
  std::vector<int> firstInCell_, nextInCell_;
};

}  // namespace

std::vector<int> mergedPoints(const std::vector<glm::dvec3>& points, double tolerance,
                              const scene::Progress& progress) {
  std::vector<int> mergedTo(points.size());
  if (points.empty()) return mergedTo;
  KeptPoints kept(points, tolerance);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 65536 == 0) progress.throwIfStopped();
    const int found = kept.nearest(i);
    mergedTo[i] = found >= 0 ? found : static_cast<int>(i);
    if (found < 0) kept.keep(i);
  }
  return mergedTo;
}

}  // namespace isolux::volume
