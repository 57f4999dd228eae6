#include "volume/hit/shown_cells.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/common.hpp>

#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/hit/surface_voxel.h"

namespace isolux::volume {

namespace {

// The root of a cubic between two of its stops, over which it is monotone.
double rootBetween(const BernsteinCubic& cubic, double low, double high) {
  const double atLow = cubic(low), atHigh = cubic(high);
  if ((atLow >= 0.0) == (atHigh >= 0.0)) return std::abs(atLow) <= std::abs(atHigh) ? low : high;
  return bracketedRoot(cubic, low, high, atLow, atHigh, atLow < 0.0);
}

}  // namespace

const VisibilityIntervals::Part* VisibilityIntervals::firstOther(bool inside) const {
  for (const Part& part : parts())
    if (part.inside != inside) return &part;
  return nullptr;
}

// Every segment on one side holds an end or an extremum: what is seen at those is all that is seen.
VisibilityIntervals ShownCell::along(const glm::dvec3& from, const glm::dvec3& to) const {
  const BernsteinCubic cubic = BernsteinCubic::along(depths_, from, to);
  std::array<double, 2> extrema{};
  const int count = cubic.extrema(extrema);
  const auto stop = [&](int i) {
    return i == 0 ? 0.0 : i <= count ? extrema[static_cast<std::size_t>(i - 1)] : 1.0;
  };
  VisibilityIntervals way;
  bool before = false;
  for (int i = 0; i <= count + 1; ++i) {
    const double s = stop(i);
    double value = i == 0 ? cubic.b[0] : i <= count ? cubic(s) : cubic.b[3];
    if (i == 0 && value == 0.0) value = cubic(stop(1));  // a segment is open
    const bool now = value >= 0.0 && !hiddenAt(from + s * (to - from));
    if (i == 0 || now != before) way.add(i == 0 ? 0.0 : rootBetween(cubic, stop(i - 1), s), now);
    before = now;
  }
  return way;
}

ShownCells::ShownCells(const Grid& grid, const VoxelMask* hidden, double isovalue, scene::Inside inside,
                       scene::Field field, const Coefficients* coefficients)
    : grid_(grid),
      hidden_(hidden),
      isovalue_(isovalue),
      inside_(inside),
      level_(InsideLevel::of(grid, isovalue, inside)),
      field_(field),
      coefficients_(coefficients) {}

bool ShownCells::hides(glm::ivec3 cell) const {
  if (!hidden_) return false;
  const int apron = field_ == scene::Field::trilinear ? 0 : 1;
  const glm::ivec3 low = glm::max(cell - apron, glm::ivec3(0)),
                   high = glm::min(cell + 1 + apron, grid_.dims() - 1);
  bool any = false;
  forEachIn(low, high + 1, [&](glm::ivec3 at) { any = any || hidden_->at(at); });
  return any || (apron > 0 && hidden_->hidesStrays() &&
                 !insideAny(cell, glm::min(cell + 1, grid_.dims() - 1)) && !insideAny(low, high));
}

bool ShownCells::insideAny(glm::ivec3 low, glm::ivec3 high) const {
  bool any = false;
  forEachIn(low, high + 1, [&](glm::ivec3 at) { any = any || level_.depth(grid_.stored(at)) >= 0.0; });
  return any;
}

// Axis by axis: a bit for each voxel of a row that is hidden, then windows of six along it, of rows, of
// slices.
std::array<std::uint64_t, 8> ShownCells::aroundHidden(glm::ivec3 first) const {
  constexpr int kCells = 8, kApron = 2, kSamples = kCells + 1 + 2 * kApron, kWindow = kSamples - kCells + 1;
  std::array<std::uint64_t, kCells> words{};
  if (!hidden_) return words;
  const glm::ivec3 corner = first - kApron;
  const glm::ivec3 low = glm::max(corner, glm::ivec3(0)), high = glm::min(corner + kSamples, grid_.dims());
  for (int z = low.z; z < high.z; ++z)
    for (int y = low.y; y < high.y; ++y) {
      unsigned hidden = 0, cells = 0;
      for (int x = low.x; x < high.x; ++x) hidden |= unsigned{hidden_->at({x, y, z})} << (x - corner.x);
      for (int i = 0; i < kWindow; ++i) cells |= hidden >> i;
      std::uint64_t rows = 0;  // of cells whose windows have this row
      for (int row = std::max(0, y - corner.y - (kWindow - 1)); row <= std::min(y - corner.y, kCells - 1);
           ++row)
        rows |= std::uint64_t{cells & 0xff} << (kCells * row);
      for (int k = std::max(0, z - corner.z - (kWindow - 1)); k <= std::min(z - corner.z, kCells - 1); ++k)
        words[static_cast<std::size_t>(k)] |= rows;
    }
  return words;
}

ShownCell ShownCells::cellAt(glm::ivec3 cell) const {
  CellCorners depths;
  unsigned hidden = 0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 at = cell + cornerStep(i);
    depths[static_cast<std::size_t>(i)] = level_.depth(grid_.stored(at));
    if (voxelHidden(at)) hidden |= 1u << i;
  }
  return {depths, hidden};
}

VisibilityIntervals ShownCells::along(glm::ivec3 cell, const glm::dvec3& from, const glm::dvec3& to) const {
  return field_ == scene::Field::trilinear ? cellAt(cell).along(from, to) : alongCubic(cell, from, to);
}

bool ShownCells::hiddenAt(const glm::dvec3& voxel) const {
  const glm::ivec3 cell = grid_.geometry().cellOf(voxel);
  const glm::dvec3 local = glm::clamp(voxel - glm::dvec3(cell), 0.0, 1.0);
  return field_ == scene::Field::trilinear ? cellAt(cell).hiddenAt(local) : hiddenNear(cell, local);
}

bool ShownCells::hiddenNear(glm::ivec3 cell, const glm::dvec3& local) const {
  const std::optional<glm::ivec3> inside = surfaceVoxel(grid_, level_, cell, local);
  return inside ? voxelHidden(*inside) : hidden_ && hidden_->hidesStrays();
}

// Between its changes of side a segment is of one piece, which its middle tells.
VisibilityIntervals ShownCells::alongCubic(glm::ivec3 cell, const glm::dvec3& from,
                                           const glm::dvec3& to) const {
  const SideChanges changes = sideChangesOfCell(grid_, coefficients_, isovalue_, cell, from, to);
  bool inside = (changes.first == Side::inside) == (inside_ == scene::Inside::above);
  VisibilityIntervals way;
  for (std::size_t i = 0; i <= changes.count; ++i, inside = !inside) {
    const double begin = i == 0 ? 0.0 : changes.s[i - 1], end = i < changes.count ? changes.s[i] : 1.0;
    const glm::dvec3 middle = from + 0.5 * (begin + end) * (to - from);
    way.add(begin, inside && !hiddenNear(cell, middle));
  }
  return way;
}

}  // namespace isolux::volume
