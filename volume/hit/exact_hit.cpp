#include "volume/hit/exact_hit.h"

#include <array>

#include "volume/hit/bernstein_cubic.h"
#include "volume/hit/cross_cell.h"

namespace isolux::volume {

namespace {

// Goes through one cell's segment with the side the ray came from. Returns where it changes first, and sets
// `side` to that behind the crossing; else leaves the last side in `side`.
std::optional<double> firstChange(const BernsteinCubic& cubic, Side& side) {
  std::array<double, 2> critical{};
  const int count = cubic.extrema(critical);
  double low = 0.0, atLow = cubic.b[0];
  for (int i = 0; i <= count; ++i) {
    const double high = i < count ? critical[static_cast<std::size_t>(i)] : 1.0;
    const double atHigh = i < count ? cubic(high) : cubic.b[3];
    // On an open monotone piece, f >= isovalue unless a negative end says otherwise.
    const Side first = atLow < 0.0 || (atLow == 0.0 && atHigh < 0.0) ? Side::outside : Side::inside;
    if (side != Side::unknown && side != first) {
      side = first;
      return low;
    }
    side = first;
    if ((atLow < 0.0 && atHigh > 0.0) || (atLow > 0.0 && atHigh < 0.0)) {
      side = atHigh > 0.0 ? Side::inside : Side::outside;
      return bracketedRoot(cubic, low, high, atLow, atHigh, atLow < 0.0);
    }
    low = high;
    atLow = atHigh;
  }
  return std::nullopt;
}

// A cell's corners minus the isovalue.
struct CornerValues {
  CellCorners corner;
  CellSigns signs;

  template <class T>
  CornerValues(const Grid& grid, const std::vector<T>& voxels, double isovalue, glm::ivec3 cell) {
    for (std::size_t i = 0; i < 8; ++i) {
      const std::size_t voxel = grid.index(cell + cornerStep(i));
      corner[i] = grid.valueOfStored(static_cast<double>(voxels[voxel])) - isovalue;
      signs.add(corner[i]);
    }
  }

  double valueAt(const glm::dvec3& local) const { return trilinear(corner, local); }
};

}  // namespace

std::optional<RayHit> firstHit(const Grid& grid, const MinMaxBlocks& blocks, double isovalue, const Ray& ray,
                               const HiddenPieces& hidden) {
  const ShownCells cells(grid, hidden.voxels, isovalue, hidden.inside);
  const ShownCells* const shown = hidden.voxels ? &cells : nullptr;
  return grid.visit([&](const auto& voxels) {
    const auto cross = [&](const CellWalk& walk, Side& side) {
      const CornerValues cell(grid, voxels, isovalue, walk.cell());
      return crossCell(cell, walk, shown, side, [&](const CellWalk::Segment& segment) {
        const BernsteinCubic cubic = BernsteinCubic::along(cell.corner, segment.from, segment.to);
        return firstChange(cubic, side);
      });
    };
    return firstCrossing<RayHit>(grid, blocks, isovalue, ray, shown, cross);
  });
}

}  // namespace isolux::volume
