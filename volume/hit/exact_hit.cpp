#include "volume/hit/exact_hit.h"

#include <array>
#include <cmath>

#include "volume/hit/bernstein_cubic.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/shown_cells.h"

namespace isolux::volume {

namespace {

// Goes through one cell's stretch with the side the ray came from. Returns true and sets `s` and `side` (the
// side behind the crossing) at the first change of side; else leaves the last side in `side`.
bool firstChange(const BernsteinCubic& cubic, Side& side, double& s) {
  std::array<double, 2> critical{};
  const int count = cubic.extrema(critical);
  double low = 0.0, atLow = cubic.b[0];
  for (int i = 0; i <= count; ++i) {
    const double high = i < count ? critical[static_cast<std::size_t>(i)] : 1.0;
    const double atHigh = i < count ? cubic(high) : cubic.b[3];
    // On an open monotone piece, f >= isovalue unless a negative end says otherwise.
    const Side first = atLow < 0.0 || (atLow == 0.0 && atHigh < 0.0) ? Side::outside : Side::inside;
    if (side != Side::unknown && side != first) {
      s = low;
      side = first;
      return true;
    }
    side = first;
    if ((atLow < 0.0 && atHigh > 0.0) || (atLow > 0.0 && atHigh < 0.0)) {
      s = bracketedRoot(cubic, low, high, atLow, atHigh, atLow < 0.0);
      side = atHigh > 0.0 ? Side::inside : Side::outside;
      return true;
    }
    low = high;
    atLow = atHigh;
  }
  return false;
}

// One cell on the ray's way: the first change of side in it.
template <class T>
std::optional<RayHit> crossCell(const Grid& grid, const std::vector<T>& voxels, double isovalue,
                                const CellWalk& walk, const ShownCells* shown, Side& side) {
  const glm::ivec3 cell = walk.cell();
  CellCorners corner;
  bool anyBelow = false, anyAbove = false, missing = false;
  for (std::size_t i = 0; i < 8; ++i) {
    const int x = cell.x + static_cast<int>(i & 1), y = cell.y + static_cast<int>(i >> 1 & 1),
              z = cell.z + static_cast<int>(i >> 2);
    corner[i] = grid.valueOfStored(static_cast<double>(voxels[grid.index(x, y, z)])) - isovalue;
    missing = missing || std::isnan(corner[i]);
    anyBelow = anyBelow || corner[i] < 0.0;
    anyAbove = anyAbove || corner[i] >= 0.0;
  }
  if (missing) {
    side = Side::unknown;
    return std::nullopt;
  }
  const bool uniform = !(anyBelow && anyAbove);
  const bool hides = shown && shown->hides(cell);
  const Side whole = anyAbove ? Side::inside : Side::outside;
  if (uniform && side == whole && !hides) return std::nullopt;  // most cells: the ray stays on its side
  const auto stretch = walk.stretch();
  if (!stretch) return std::nullopt;
  double s = 0.0;
  if (hides) {
    const std::optional<double> change = firstShownChange(*shown, cell, *stretch, side);
    if (!change) return std::nullopt;
    s = *change;
  } else if (!uniform) {
    const BernsteinCubic cubic = BernsteinCubic::along(corner, stretch->from, stretch->to);
    if (!firstChange(cubic, side, s)) return std::nullopt;
  } else {
    const bool crossed = side != Side::unknown;
    side = whole;
    if (!crossed) return std::nullopt;
  }
  const glm::dvec3 local = stretch->local(s);
  RayHit hit;
  hit.t = stretch->t(s);
  hit.voxel = glm::dvec3(cell) + local;
  hit.valueError = std::abs(trilinear(corner, local));
  hit.entering = side == Side::inside;
  return hit;
}

}  // namespace

std::optional<RayHit> firstHit(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                               glm::dvec3 origin, glm::dvec3 direction, double tMinimum, double tMaximum,
                               const HiddenPieces& hidden) {
  std::optional<ShownCells> cells;
  if (hidden.voxels) cells.emplace(grid, hidden.voxels, isovalue, hidden.inside);
  const ShownCells* const shown = cells ? &*cells : nullptr;
  return std::visit(
      [&](const auto& voxels) {
        return firstCrossing<RayHit>(grid, blocks, isovalue, Ray{origin, direction, tMinimum, tMaximum},
                                     shown, [&](const CellWalk& walk, Side& side) {
                                       return crossCell(grid, voxels, isovalue, walk, shown, side);
                                     });
      },
      grid.voxels());
}

}  // namespace isolux::volume
