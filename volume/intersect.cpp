#include "volume/intersect.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace isolux::volume {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Which side of the isosurface an open stretch of the ray lies on; unknown before the first cell and after
// cells that hold no field.
enum class Side { unknown, outside, inside };

// a at t = 0, b at t = 1, a when a == b, all exactly: what makes neighbouring cells agree on their face.
double mix(double a, double b, double t) {
  return t == 1.0 ? b : a + t * (b - a);
}

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

  // The root between `low` and `high`, where the cubic is monotone and its signs differ: regula falsi in the
  // Illinois form, with a bisection whenever it does not halve the bracket in two steps.
  double rootBetween(double low, double high, double atLow, double atHigh) const {
    double weightLow = atLow, weightHigh = atHigh;
    int side = 0;
    double reference = high - low;
    for (int step = 0; step < 200; ++step) {
      double s = low - weightLow * (high - low) / (weightHigh - weightLow);
      if (step % 3 == 2) {
        if (high - low > 0.5 * reference) s = 0.5 * (low + high);
        reference = high - low;
      }
      if (!(s > low && s < high)) s = 0.5 * (low + high);
      if (!(s > low && s < high)) break;  // neighbouring doubles
      const double value = (*this)(s);
      if (value == 0.0) return s;
      if ((value < 0.0) == (atLow < 0.0)) {
        low = s;
        weightLow = atLow = value;
        if (side == -1) weightHigh *= 0.5;
        side = -1;
      } else {
        high = s;
        weightHigh = atHigh = value;
        if (side == 1) weightLow *= 0.5;
        side = 1;
      }
    }
    return std::abs(atLow) < std::abs(atHigh) ? low : high;
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
      s = cubic.rootBetween(low, high, atLow, atHigh);
      side = atHigh > 0.0 ? Side::inside : Side::outside;
      return true;
    }
    low = high;
    atLow = atHigh;
  }
  return false;
}

// One ray through one grid. Nothing is accumulated: every t is computed from the origin, the direction and
// an integer plane.
template <class T>
class Walk {
 public:
  Walk(const Grid& grid, const std::vector<T>& voxels, const MinMaxBlocks& blocks, double isovalue,
       glm::dvec3 origin, glm::dvec3 direction)
      : grid_(grid),
        voxels_(voxels),
        blocks_(blocks),
        isovalue_(isovalue),
        origin_(origin),
        direction_(direction) {}

  std::optional<RayHit> firstHit(double tMinimum, double tMaximum) {
    if (!clip(tMinimum, tMaximum)) return std::nullopt;
    while (true) {
      const glm::ivec3 block = cell_ / blocks_.blockCells();
      const std::size_t index = blocks_.index(block);
      if (const auto skipped = sideOfBlock(index)) {
        side_ = *skipped;
        const glm::ivec3 low = block * blocks_.blockCells();
        if (!step(low, glm::min(low + blocks_.blockCells(), grid_.dims() - 1))) return std::nullopt;
        continue;
      }
      if (auto hit = crossCell()) return hit;
      if (!step(cell_, cell_ + 1)) return std::nullopt;
    }
  }

 private:
  double planeT(int axis, int plane) const {
    return (static_cast<double>(plane) - origin_[axis]) / direction_[axis];
  }

  // The ray's coordinate at t; on a plane of voxels when rounding cannot tell it from that. So a ray through
  // an edge or a corner of cells is not sent through slivers of cells beside it.
  double coordinate(int axis, double t) const {
    const double along = t * direction_[axis], at = origin_[axis] + along, plane = std::round(at);
    const double rounding =
        4.0 * std::numeric_limits<double>::epsilon() * (std::abs(origin_[axis]) + std::abs(along));
    return std::abs(at - plane) <= rounding ? plane : at;
  }

  // The part of [tMinimum, tMaximum] inside the voxel domain, and its first cell.
  bool clip(double tMinimum, double tMaximum) {
    t_ = tMinimum;
    tEnd_ = tMaximum;
    int entryAxis = -1;
    for (int axis = 0; axis < 3; ++axis) {
      const int last = grid_.dims()[axis] - 1;
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
      const int last = grid_.dims()[axis] - 1;
      entry_[axis] = std::clamp(coordinate(axis, t_), 0.0, static_cast<double>(last));
      if (axis == entryAxis) entry_[axis] = direction_[axis] > 0.0 ? 0.0 : last;
      cell_[axis] = cellAt(axis, 0, last);
    }
    return true;
  }

  // The cell between the planes `low` and `high` that the ray goes into at entry_.
  int cellAt(int axis, int low, int high) const {
    const double below = std::floor(entry_[axis]);
    const bool leavesDownward = direction_[axis] < 0.0 && below == entry_[axis];
    return std::clamp(static_cast<int>(below) - (leavesDownward ? 1 : 0), low, high - 1);
  }

  // The side of a block that cannot be crossed, empty where its cells must be looked at. Where voxels are
  // missing the ray may have come through a gap, so that nothing is known about the side before.
  std::optional<Side> sideOfBlock(std::size_t block) const {
    const double a = static_cast<double>(blocks_.minimum(block)),
                 b = static_cast<double>(blocks_.maximum(block));
    if (a > b) return Side::unknown;
    double low = grid_.valueOfStored(a), high = grid_.valueOfStored(b);
    if (grid_.slope() < 0.0) std::swap(low, high);
    const bool gaps = grid_.missingCount() > 0;
    if (high < isovalue_) return gaps ? Side::unknown : Side::outside;
    if (low > isovalue_ || (low == isovalue_ && high == isovalue_ && !gaps))
      return gaps ? Side::unknown : Side::inside;
    return std::nullopt;
  }

  // Moves to the cell behind the box of cells between the planes `low` and `high`; false at the end of the
  // ray.
  bool step(glm::ivec3 low, glm::ivec3 high) {
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
        if (cell_[axis] < 0 || cell_[axis] > grid_.dims()[axis] - 2) return false;
      } else {
        entry_[axis] =
            std::clamp(coordinate(axis, t_), static_cast<double>(low[axis]), static_cast<double>(high[axis]));
        cell_[axis] = cellAt(axis, low[axis], high[axis]);
      }
    }
    return true;
  }

  std::optional<RayHit> crossCell() {
    std::array<double, 8> corner;
    bool anyBelow = false, anyAbove = false, missing = false;
    for (std::size_t i = 0; i < 8; ++i) {
      const int x = cell_.x + static_cast<int>(i & 1), y = cell_.y + static_cast<int>(i >> 1 & 1),
                z = cell_.z + static_cast<int>(i >> 2);
      corner[i] = grid_.valueOfStored(static_cast<double>(voxels_[grid_.index(x, y, z)])) - isovalue_;
      missing = missing || std::isnan(corner[i]);
      anyBelow = anyBelow || corner[i] < 0.0;
      anyAbove = anyAbove || corner[i] >= 0.0;
    }
    if (missing) {
      side_ = Side::unknown;
      return std::nullopt;
    }
    // The stretch inside the cell, from entry_ to `exit`, both snapped to the planes they lie on.
    double tExit = tEnd_;
    std::array<double, 3> at{kInfinity, kInfinity, kInfinity};
    for (int axis = 0; axis < 3; ++axis) {
      if (direction_[axis] == 0.0) continue;
      at[static_cast<std::size_t>(axis)] =
          planeT(axis, direction_[axis] > 0.0 ? cell_[axis] + 1 : cell_[axis]);
      tExit = std::min(tExit, at[static_cast<std::size_t>(axis)]);
    }
    if (!(tExit > t_)) return std::nullopt;  // only touches the cell
    glm::dvec3 from, to;
    for (int axis = 0; axis < 3; ++axis) {
      from[axis] = std::clamp(entry_[axis] - cell_[axis], 0.0, 1.0);
      to[axis] = std::clamp(coordinate(axis, tExit) - cell_[axis], 0.0, 1.0);
      if (at[static_cast<std::size_t>(axis)] <= tExit) to[axis] = direction_[axis] > 0.0 ? 1.0 : 0.0;
    }

    Side before = side_;
    double s = 0.0;
    Cubic cubic{};
    if (anyBelow && anyAbove) {
      // Bernstein coefficients are the polar form of the trilinear function at the stretch's two ends.
      const double x[2] = {from.x, to.x}, y[2] = {from.y, to.y}, z[2] = {from.z, to.z};
      const auto f = [&](int i, int j, int k) { return trilinear(corner, x[i], y[j], z[k]); };
      cubic.b = {f(0, 0, 0), (f(1, 0, 0) + f(0, 1, 0) + f(0, 0, 1)) / 3.0,
                 (f(1, 1, 0) + f(1, 0, 1) + f(0, 1, 1)) / 3.0, f(1, 1, 1)};
      if (!firstChange(cubic, before, s)) {
        side_ = before;
        return std::nullopt;
      }
    } else {
      const Side whole = anyAbove ? Side::inside : Side::outside;
      const bool crossed = side_ != Side::unknown && side_ != whole;
      side_ = before = whole;
      if (!crossed) return std::nullopt;
    }
    RayHit hit;
    hit.t = std::clamp(t_ + s * (tExit - t_), t_, tExit);
    const glm::dvec3 local = from + s * (to - from);
    hit.voxel = glm::dvec3(cell_) + local;
    hit.valueError = std::abs(trilinear(corner, local.x, local.y, local.z));
    hit.entering = before == Side::inside;
    return hit;
  }

  const Grid& grid_;
  const std::vector<T>& voxels_;
  const MinMaxBlocks& blocks_;
  double isovalue_;
  glm::dvec3 origin_, direction_;
  double t_ = 0.0, tEnd_ = 0.0;
  glm::ivec3 cell_{0};
  glm::dvec3 entry_{0.0};  // where the ray enters cell_, voxel coordinates
  Side side_ = Side::unknown;
};

}  // namespace

std::optional<RayHit> firstHit(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                               glm::dvec3 origin, glm::dvec3 direction, double tMinimum, double tMaximum) {
  if (blocks.count() == 0 || std::isnan(isovalue) || direction == glm::dvec3(0.0)) return std::nullopt;
  for (int axis = 0; axis < 3; ++axis)
    if (!std::isfinite(origin[axis]) || !std::isfinite(direction[axis])) return std::nullopt;
  return std::visit(
      [&](const auto& voxels) {
        using T = typename std::decay_t<decltype(voxels)>::value_type;
        return Walk<T>(grid, voxels, blocks, isovalue, origin, direction).firstHit(tMinimum, tMaximum);
      },
      grid.voxels());
}

}  // namespace isolux::volume
