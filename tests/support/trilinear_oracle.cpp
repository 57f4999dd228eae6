#include "tests/support/trilinear_oracle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace isolux::test {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The planes of one axis in the order the ray crosses them.
struct Planes {
  long double origin = 0, direction = 0, t = 0;
  int plane = 0, step = 0;

  void aim() { t = (plane - origin) / direction; }
  void next() {
    plane += step;
    aim();
  }
};

}  // namespace

TrilinearOracle::TrilinearOracle(const volume::Grid& grid)
    : grid_(&grid),
      dims_(grid.dims()),
      stored_(
          std::visit([](const auto& v) { return std::vector<float>(v.begin(), v.end()); }, grid.voxels())) {}

TrilinearOracle::TrilinearOracle(glm::ivec3 dims, Value value) : dims_(dims), value_(std::move(value)) {}

double TrilinearOracle::cornerOf(glm::ivec3 voxel) const {
  if (value_) return value_(voxel);
  return grid_->valueOfStored(static_cast<double>(stored_[grid_->index(voxel.x, voxel.y, voxel.z)]));
}

std::optional<double> TrilinearOracle::firstHit(double isovalue, const volume::Ray& ray) const {
  Real begin = ray.tMinimum, end = ray.tMaximum;
  std::array<Planes, 3> planes;
  for (std::size_t a = 0; a < 3; ++a) {
    const int axis = static_cast<int>(a), last = dims_[axis] - 1;
    Planes& p = planes[a];
    p.origin = ray.origin[axis];
    p.direction = ray.direction[axis];
    if (last < 1) return std::nullopt;
    if (p.direction == 0) {
      if (p.origin < 0 || p.origin > last) return std::nullopt;
      p.t = kInfinity;
      continue;
    }
    p.step = p.direction > 0 ? 1 : -1;
    p.plane = p.direction > 0 ? 0 : last;
    p.aim();
    begin = std::max(begin, p.t);
    end = std::min(end, ((p.direction > 0 ? last : 0) - p.origin) / p.direction);
  }
  if (!(begin < end)) return std::nullopt;
  for (Planes& p : planes) {
    if (p.step == 0) continue;
    // The first plane behind the beginning.
    const Real at = p.origin + begin * p.direction;
    p.plane = static_cast<int>(p.step > 0 ? std::floor(at) : std::ceil(at)) - p.step;
    p.aim();
    while (p.t <= begin) p.next();
  }
  int side = 0;  // -1 outside, 1 inside, 0 unknown
  for (Real t = begin; t < end;) {
    Planes& nearest = *std::min_element(planes.begin(), planes.end(),
                                        [](const Planes& a, const Planes& b) { return a.t < b.t; });
    const Real to = std::min(nearest.t, end);
    if (to - t >= 1e-15L)
      if (const auto hit = searchCell(isovalue, ray, t, to, side)) return static_cast<double>(*hit);
    t = to;
    if (nearest.t <= to) nearest.next();
  }
  return std::nullopt;
}

std::optional<long double> TrilinearOracle::searchCell(Real isovalue, const volume::Ray& ray, Real t0,
                                                       Real t1, int& side) const {
  const Real middle = 0.5L * (t0 + t1);
  glm::ivec3 cell;
  for (int axis = 0; axis < 3; ++axis)
    cell[axis] = std::clamp(static_cast<int>(std::floor(ray.origin[axis] + middle * ray.direction[axis])), 0,
                            dims_[axis] - 2);
  std::array<double, 8> corner;
  bool below = false, above = false;
  for (std::size_t i = 0; i < 8; ++i) {
    const int corners = static_cast<int>(i);
    corner[i] = cornerOf(cell + glm::ivec3(corners & 1, corners >> 1 & 1, corners >> 2));
    if (std::isnan(corner[i])) {
      side = 0;
      return std::nullopt;
    }
    (corner[i] < static_cast<double>(isovalue) ? below : above) = true;
  }
  if (!(below && above)) {
    const int whole = above ? 1 : -1;
    const bool changed = side != 0 && side != whole;
    side = whole;
    return changed ? std::optional(t0) : std::nullopt;
  }
  const auto f = [&](Real t) {
    Real w[3];
    for (int axis = 0; axis < 3; ++axis) w[axis] = ray.origin[axis] + t * ray.direction[axis] - cell[axis];
    Real sum = 0;
    for (std::size_t i = 0; i < 8; ++i)
      sum += (corner[i] - isovalue) * (i & 1 ? w[0] : 1 - w[0]) * (i >> 1 & 1 ? w[1] : 1 - w[1]) *
             (i >> 2 ? w[2] : 1 - w[2]);
    return sum;
  };
  // The cubic through four points of the segment, and its extrema.
  const auto at = [&](Real s) { return f(t0 + s * (t1 - t0)); };
  const Real y0 = at(0), y1 = at(1.0L / 3), y2 = at(2.0L / 3), y3 = at(1);
  const Real c3 = 4.5L * (y3 - 3 * y2 + 3 * y1 - y0), c2 = 4.5L * (2 * y0 - 5 * y1 + 4 * y2 - y3);
  const Real c1 = y3 - y0 - c2 - c3;
  std::array<Real, 4> knots{0, 1, 1, 1};
  std::size_t count = 1;
  const Real discriminant = c2 * c2 - 3 * c3 * c1;
  if (discriminant >= 0) {
    const Real q = -(c2 + std::copysign(std::sqrt(discriminant), c2));
    for (const Real s : {q / (3 * c3), c1 / q})
      if (s > 0 && s < 1) knots[count++] = s;
    if (count == 3 && knots[1] > knots[2]) std::swap(knots[1], knots[2]);
  }
  knots[count] = 1;
  for (std::size_t i = 0; i < count; ++i) {
    // The sides just behind one knot and just before the next: touches at knots do not count.
    const Real a = knots[i], b = knots[i + 1], margin = 3e-16L * (b - a);
    if (b - a < 1e-15L) continue;
    const int first = at(a + margin) >= 0 ? 1 : -1, last = at(b - margin) >= 0 ? 1 : -1;
    if (side != 0 && side != first) {
      side = first;
      return t0 + a * (t1 - t0);
    }
    side = last;
    if (first == last) continue;
    Real low = a, high = b;
    for (int k = 0; k < 70; ++k) {
      const Real m = 0.5L * (low + high);
      ((at(m) >= 0 ? 1 : -1) == first ? low : high) = m;
    }
    return t0 + high * (t1 - t0);
  }
  return std::nullopt;
}

void HitTally::add(const HitTally& other) {
  rays += other.rays;
  hits += other.hits;
  misses += other.misses;
  inventions += other.inventions;
  borderline += other.borderline;
  worstVoxels = std::max(worstVoxels, other.worstVoxels);
}

void compareHit(const TrilinearOracle& oracle, double isovalue, const volume::Ray& ray,
                const std::optional<volume::RayHit>& found, HitTally& tally) {
  const volume::Grid& grid = oracle.grid();
  const auto expected = oracle.firstHit(isovalue, ray);
  ++tally.rays;
  tally.hits += found ? 1 : 0;
  const double length = glm::length(ray.direction), range = grid.maximum() - grid.minimum();
  const double mine = found ? found->t : kInfinity, theirs = expected.value_or(kInfinity);
  const double error = mine == theirs ? 0.0 : std::abs(mine - theirs) * length;
  if (error <= 1e-6) {
    tally.worstVoxels = std::max(tally.worstVoxels, error);
    return;
  }
  // A crossing proper would stay where it is, in the search started just before it, when the last digits of
  // the isovalue change. And a ray that starts on the surface has nothing before its start to tell the sides
  // apart.
  const double earlier = std::min(mine, theirs);
  volume::Ray close = ray;
  close.tMinimum = std::max(earlier - 1e-5 / length, ray.tMinimum);
  const double shift = 1e-11 * std::max(range, 1e-4 * std::abs(isovalue));
  int seen = 0;
  for (const double other : {isovalue - shift, isovalue + shift}) {
    const auto t = oracle.firstHit(other, close);
    seen += t && std::abs(*t - earlier) * length < 1e-4 ? 1 : 0;
  }
  const bool touch = seen < 2 || (earlier - ray.tMinimum) * length < 1e-6;
  if (mine < theirs && found->valueError > 1e-9 * std::max(range, std::abs(isovalue)))
    ++tally.inventions;
  else if (touch)
    ++tally.borderline;
  else
    ++(mine < theirs ? tally.inventions : tally.misses);
}

}  // namespace isolux::test
