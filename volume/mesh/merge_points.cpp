#include "volume/mesh/merge_points.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

using Cell = glm::i64vec3;

constexpr double kCellTolerances =
    4.0;  // width of a cell: few points need to look into a second one per axis

// A hash table of cells, each a chain of the points in it that stand for themselves.
class CellTable {
 public:
  CellTable(std::span<const glm::dvec3> points, double tolerance, const base::Progress& progress)
      : points_(points), tolerance_(tolerance), low_(std::numeric_limits<double>::infinity()) {
    for (const glm::dvec3& p : points) low_ = glm::min(low_, p);
    const std::size_t slots = std::bit_ceil(std::max<std::size_t>(points.size(), 2));
    shift_ = 64 - std::countr_zero(slots);
    resizeStoppably(first_, slots, progress);
    resizeStoppably(next_, points.size(), progress);
  }

  // The point that stands for this one; itself, which then does for others, where there is none yet.
  int representativeOf(int point) {
    const glm::dvec3& p = points_[static_cast<std::size_t>(point)];
    const Cell low = cellOf(p - tolerance_), high = cellOf(p + tolerance_);
    int found = point;
    for (std::int64_t z = low.z; z <= high.z; ++z)
      for (std::int64_t y = low.y; y <= high.y; ++y)
        for (std::int64_t x = low.x; x <= high.x; ++x)
          for (int other = first_[slotOf({x, y, z})] - 1; other >= 0;
               other = next_[static_cast<std::size_t>(other)] - 1)
            if (other < found && isNear(p, points_[static_cast<std::size_t>(other)])) found = other;
    if (found == point) {
      int& head = first_[slotOf(cellOf(p))];
      next_[static_cast<std::size_t>(point)] = head;
      head = point + 1;
    }
    return found;
  }

 private:
  Cell cellOf(const glm::dvec3& p) const {
    return Cell(glm::floor((p - low_) / (kCellTolerances * tolerance_)));
  }
  std::size_t slotOf(const Cell& cell) const {
    const std::uint64_t key = base::counterHash(
        static_cast<std::uint64_t>(cell.x),
        base::counterHash(static_cast<std::uint64_t>(cell.y), static_cast<std::uint64_t>(cell.z)));
    return static_cast<std::size_t>(key >> shift_);
  }
  bool isNear(const glm::dvec3& a, const glm::dvec3& b) const {
    return glm::dot(a - b, a - b) <= tolerance_ * tolerance_;
  }

  std::span<const glm::dvec3> points_;
  double tolerance_;
  glm::dvec3 low_;
  int shift_ = 0;
  std::vector<int> first_, next_;  // number of a point + 1; 0 ends a chain
};

}  // namespace

std::vector<int> mergedPoints(std::span<const glm::dvec3> points, double tolerance,
                              const base::Progress& progress) {
  CellTable table(points, tolerance, progress);
  std::vector<int> result;
  result.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i % 4096 == 0) progress.throwIfStopped();
    result.push_back(table.representativeOf(static_cast<int>(i)));
  }
  return result;
}

}  // namespace isolux::volume
