#include "volume/hit/cell_walk.h"

#include <algorithm>
#include <array>

#include "volume/hit/shown_cells.h"

namespace isolux::volume {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::optional<Side> sideOfField(const MinMaxBlocks& blocks, std::size_t block, const Grid& grid,
                                double isovalue) {
  const double a = static_cast<double>(blocks.minimum(block)), b = static_cast<double>(blocks.maximum(block));
  if (a > b) return Side::unknown;
  double low = grid.valueOfStored(a), high = grid.valueOfStored(b);
  if (grid.slope() < 0.0) std::swap(low, high);
  const bool gaps = grid.missingCount() > 0;
  if (high < isovalue) return gaps ? Side::unknown : Side::outside;
  if (low > isovalue || (low == isovalue && high == isovalue && !gaps))
    return gaps ? Side::unknown : Side::inside;
  return std::nullopt;
}

}  // namespace

bool Ray::valid() const {
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(origin[axis]) || !std::isfinite(direction[axis])) return false;
  return direction != glm::dvec3(0.0);
}

double CellWalk::Segment::t(double s) const {
  return std::clamp(tBegin + s * (tEnd - tBegin), tBegin, tEnd);
}

CellWalk::CellWalk(glm::ivec3 dims, const Ray& ray)
    : dims_(dims),
      origin_(ray.origin),
      direction_(ray.direction),
      inside_(clip(ray.tMinimum, ray.tMaximum)) {}

double CellWalk::planeT(int axis, int plane) const {
  return (static_cast<double>(plane) - origin_[axis]) / direction_[axis];
}

// The ray's coordinate at t; on a plane of voxels when rounding cannot tell it from that. So a ray through
// an edge or a corner of cells is not sent through slivers of cells beside it.
double CellWalk::coordinate(int axis, double t) const {
  const double along = t * direction_[axis], at = origin_[axis] + along, plane = std::round(at);
  const double rounding =
      4.0 * std::numeric_limits<double>::epsilon() * (std::abs(origin_[axis]) + std::abs(along));
  return std::abs(at - plane) <= rounding ? plane : at;
}

// The part of [tMinimum, tMaximum] inside the voxel domain, and its first cell.
bool CellWalk::clip(double tMinimum, double tMaximum) {
  t_ = tMinimum;
  tEnd_ = tMaximum;
  int entryAxis = -1;
  for (int axis = 0; axis < 3; ++axis) {
    const int last = dims_[axis] - 1;
    if (direction_[axis] == 0.0) {
      if (!(origin_[axis] >= 0.0 && origin_[axis] <= last)) return false;
      continue;
    }
    const bool forward = direction_[axis] > 0.0;
    const double in = planeT(axis, forward ? 0 : last), out = planeT(axis, forward ? last : 0);
    if (in > t_) {
      t_ = in;
      entryAxis = axis;
    }
    tEnd_ = std::min(tEnd_, out);
  }
  if (!(t_ < tEnd_) || !std::isfinite(t_)) return false;
  for (int axis = 0; axis < 3; ++axis) {
    const int last = dims_[axis] - 1;
    entry_[axis] = coordinate(axis, t_);  // in the domain: rounding is less than coordinate() allows for
    if (axis == entryAxis) entry_[axis] = direction_[axis] > 0.0 ? 0.0 : last;
    cell_[axis] = cellAt(axis, 0, last);
  }
  return true;
}

// The cell between the planes `low` and `high` that the ray goes into at entry_.
int CellWalk::cellAt(int axis, int low, int high) const {
  const double below = std::floor(entry_[axis]);
  const bool leavesDownward = direction_[axis] < 0.0 && below == entry_[axis];
  return std::clamp(static_cast<int>(below) - (leavesDownward ? 1 : 0), low, high - 1);
}

bool CellWalk::leave(glm::ivec3 low, glm::ivec3 high) {
  double exit = kInfinity;
  for (int axis = 0; axis < 3; ++axis)
    if (direction_[axis] != 0.0)
      exit = std::min(exit, planeT(axis, direction_[axis] > 0.0 ? high[axis] : low[axis]));
  if (!(exit < tEnd_)) return false;
  t_ = std::max(t_, exit);
  for (int axis = 0; axis < 3; ++axis) {
    const bool forward = direction_[axis] > 0.0;
    const int plane = forward ? high[axis] : low[axis];
    const bool moving = direction_[axis] != 0.0;
    if (moving && (planeT(axis, plane) <= exit || coordinate(axis, exit) == plane)) {
      entry_[axis] = plane;
      cell_[axis] = forward ? plane : plane - 1;
      if (cell_[axis] < 0 || cell_[axis] > dims_[axis] - 2) return false;
    } else {
      entry_[axis] =
          std::clamp(coordinate(axis, t_), static_cast<double>(low[axis]), static_cast<double>(high[axis]));
      cell_[axis] = cellAt(axis, low[axis], high[axis]);
    }
  }
  return true;
}

std::optional<CellWalk::Segment> CellWalk::segment() const {
  Segment segment{};
  segment.tBegin = t_;
  segment.tEnd = tEnd_;
  std::array<double, 3> at{kInfinity, kInfinity, kInfinity};
  for (int axis = 0; axis < 3; ++axis) {
    if (direction_[axis] == 0.0) continue;
    at[static_cast<std::size_t>(axis)] = planeT(axis, direction_[axis] > 0.0 ? cell_[axis] + 1 : cell_[axis]);
    segment.tEnd = std::min(segment.tEnd, at[static_cast<std::size_t>(axis)]);
  }
  if (!(segment.tEnd > t_)) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis) {
    segment.from[axis] = std::clamp(entry_[axis] - cell_[axis], 0.0, 1.0);
    segment.to[axis] = std::clamp(coordinate(axis, segment.tEnd) - cell_[axis], 0.0, 1.0);
    if (at[static_cast<std::size_t>(axis)] <= segment.tEnd)
      segment.to[axis] = direction_[axis] > 0.0 ? 1.0 : 0.0;
  }
  return segment;
}

std::optional<Side> sideOfBlock(const MinMaxBlocks& blocks, glm::ivec3 block, const Grid& grid,
                                double isovalue, const ShownCells* shown) {
  const std::optional<Side> side = sideOfField(blocks, blocks.index(block), grid, isovalue);
  // A block that is not crossed and lies inside is of one piece.
  if (!shown || !side || *side == Side::unknown || !shown->voxelHidden(block * blocks.blockCells()))
    return side;
  return *side == Side::inside ? Side::outside : Side::inside;
}

std::optional<double> firstShownChange(const ShownCells& shown, glm::ivec3 cell,
                                       const CellWalk::Segment& segment, Side& side) {
  const VisibilityIntervals way = shown.along(cell, segment.from, segment.to);
  const auto sideOf = [&](bool inside) {
    return inside == (shown.inside() == scene::Inside::above) ? Side::inside : Side::outside;
  };
  if (side == Side::unknown) side = sideOf(way.parts().front().inside);
  const VisibilityIntervals::Part* const other = way.firstOther(side == sideOf(true));
  if (!other) return std::nullopt;
  side = sideOf(other->inside);
  return other->begin;
}

}  // namespace isolux::volume
