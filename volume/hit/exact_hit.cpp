#include "volume/hit/exact_hit.h"

#include <array>
#include <cmath>
#include <utility>

#include "volume/hit/cell_walk.h"

namespace isolux::volume {

namespace {

double trilinear(const std::array<double, 8>& c, double x, double y, double z) {
  return mix(mix(mix(c[0], c[1], x), mix(c[2], c[3], x), y), mix(mix(c[4], c[5], x), mix(c[6], c[7], x), y),
             z);
}

// The field minus the isovalue along the ray's stretch through a cell, s in [0, 1], in Bernstein form.
struct Cubic {
  std::array<double, 4> b;

  double operator()(double s) const {  // de Casteljau
    const double b01 = mix(b[0], b[1], s), b12 = mix(b[1], b[2], s), b23 = mix(b[2], b[3], s);
    return mix(mix(b01, b12, s), mix(b12, b23, s), s);
  }

  // Extrema in (0, 1), ascending: the roots of c0 (1-s)^2 + 2 c1 s (1-s) + c2 s^2.
  int criticalPoints(std::array<double, 2>& s) const {
    const double c0 = b[1] - b[0], c1 = b[2] - b[1], c2 = b[3] - b[2];
    const double a = (c0 - c1) + (c2 - c1), h = c1 - c0;  // a s^2 + 2 h s + c0
    const double discriminant = h * h - a * c0;
    if (!(discriminant >= 0.0)) return 0;
    const double q = -(h + std::copysign(std::sqrt(discriminant), h));
    int count = 0;
    for (const double root : {a != 0.0 ? q / a : -1.0, q != 0.0 ? c0 / q : -1.0})
      if (root > 0.0 && root < 1.0) s[static_cast<std::size_t>(count++)] = root;
    if (count == 2 && s[0] > s[1]) std::swap(s[0], s[1]);
    return count;
  }
};

// Goes through one cell's stretch with the side the ray came from. Returns true and sets `s` and `side` (the
// side behind the crossing) at the first change of side; else leaves the last side in `side`.
bool firstChange(const Cubic& cubic, Side& side, double& s) {
  std::array<double, 2> critical{};
  const int count = cubic.criticalPoints(critical);
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
                                const CellWalk& walk, Side& side) {
  const glm::ivec3 cell = walk.cell();
  std::array<double, 8> corner;
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
  const Side whole = anyAbove ? Side::inside : Side::outside;
  if (uniform && side == whole) return std::nullopt;  // most cells: the ray stays on its side
  const auto stretch = walk.stretch();
  if (!stretch) return std::nullopt;
  double s = 0.0;
  if (!uniform) {
    // Bernstein coefficients are the polar form of the trilinear function at the stretch's two ends.
    const glm::dvec3 end[2] = {stretch->from, stretch->to};
    const auto f = [&](int i, int j, int k) { return trilinear(corner, end[i].x, end[j].y, end[k].z); };
    const Cubic cubic{{f(0, 0, 0), (f(1, 0, 0) + f(0, 1, 0) + f(0, 0, 1)) / 3.0,
                       (f(1, 1, 0) + f(1, 0, 1) + f(0, 1, 1)) / 3.0, f(1, 1, 1)}};
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
  hit.valueError = std::abs(trilinear(corner, local.x, local.y, local.z));
  hit.entering = side == Side::inside;
  return hit;
}

}  // namespace

std::optional<RayHit> firstHit(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                               glm::dvec3 origin, glm::dvec3 direction, double tMinimum, double tMaximum) {
  return std::visit(
      [&](const auto& voxels) {
        return firstCrossing<RayHit>(
            grid, blocks, isovalue, Ray{origin, direction, tMinimum, tMaximum},
            [&](const CellWalk& walk, Side& side) { return crossCell(grid, voxels, isovalue, walk, side); });
      },
      grid.voxels());
}

}  // namespace isolux::volume
