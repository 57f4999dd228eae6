#include "volume/hit/exact_cubic_hit.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/rays.h"
#include "tests/support/test_data.h"
#include "tests/support/unwatched.h"
#include "volume/field/cubic_weights.h"
#include "volume/field/reconstruct.h"
#include "volume/parallel/parallel_loops.h"
#include "volume/read/reader.h"

namespace isolux::volume {
namespace {

using test::phantomGrid;

constexpr double kNever = std::numeric_limits<double>::infinity();

// A cubic field to hit: of the samples, or of the coefficients that interpolate them.
struct SplineCase {
  SplineCase(Grid samples, bool interpolating)
      : grid(std::move(samples)),
        coefficients(interpolating ? interpolatingCoefficients(grid) : Coefficients()),
        blocks(MinMaxBlocks::ofCubic(grid, interpolating ? &coefficients : nullptr, 8, progress)) {}

  CubicHit firstHit(double isovalue, const Ray& ray) const {
    return coefficients.empty() ? firstHitOfField(grid, scene::Field::cubic, nullptr, blocks, isovalue, ray)
                                : firstHitOfField(grid, scene::Field::cubic_interpolating, &coefficients,
                                                  blocks, isovalue, ray);
  }
  FieldSample sample(glm::dvec3 voxel) const {
    return coefficients.empty() ? sampleCubic(grid, voxel) : sampleCubic(coefficients, grid, voxel);
  }
  double coefficient(glm::ivec3 at) const {
    at = glm::clamp(at, glm::ivec3(0), grid.dims() - 1);
    return coefficients.empty()
               ? grid.value(at.x, at.y, at.z)
               : grid.valueOfStored(coefficients.offset +
                                    static_cast<double>(coefficients.values[grid.index(at.x, at.y, at.z)]));
  }

  base::Progress progress;
  Grid grid;
  Coefficients coefficients;
  MinMaxBlocks blocks;
};

// An independent search in extended precision: every plane crossing of the ray sorted, every segment between
// two of them sampled densely, and the extremum between samples found where three of them bend toward the
// isovalue. The weights are the truncated powers of the definition. No blocks, no blossoms.
class Oracle {
 public:
  using Real = long double;
  explicit Oracle(const SplineCase& field) : field_(field) {}

  std::optional<double> firstHit(double isovalue, const Ray& ray, double tMinimum = 0.0) const {
    Real begin = tMinimum, end = kNever;
    std::vector<Real> cuts;
    for (int axis = 0; axis < 3; ++axis) {
      const int last = field_.grid.dims()[axis] - 1;
      const Real o = ray.origin[axis], d = ray.direction[axis];
      if (d == 0.0L) {
        if (o < 0.0L || o > last) return std::nullopt;
        continue;
      }
      begin = std::max(begin, std::min((0.0L - o) / d, (last - o) / d));
      end = std::min(end, std::max((0.0L - o) / d, (last - o) / d));
      for (int plane = 0; plane <= last; ++plane) cuts.push_back((plane - o) / d);
    }
    if (!(begin < end)) return std::nullopt;
    cuts.push_back(begin);
    cuts.push_back(end);
    std::sort(cuts.begin(), cuts.end());
    int side = 0;  // -1 outside, 1 inside, 0 unknown
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] < begin || cuts[i + 1] > end || cuts[i + 1] - cuts[i] < 1e-13L) continue;
      if (const auto t = searchCell(isovalue, ray, cuts[i], cuts[i + 1], side))
        return static_cast<double>(*t);
    }
    return std::nullopt;
  }

 private:
  using Polynomial = std::vector<Real>;  // ascending powers of x in [-1, 1]

  static Real value(const Polynomial& p, Real x) {
    Real sum = 0;
    for (std::size_t i = p.size(); i-- > 0;) sum = sum * x + p[i];
    return sum;
  }
  static Polynomial derivative(const Polynomial& p) {
    Polynomial d;
    for (std::size_t i = 1; i < p.size(); ++i) d.push_back(static_cast<Real>(i) * p[i]);
    return d;
  }
  static Real bisect(const Polynomial& p, Real low, Real high) {
    const bool negative = value(p, low) < 0;
    for (int k = 0; k < 90; ++k) {
      const Real middle = 0.5L * (low + high);
      ((value(p, middle) < 0) == negative ? low : high) = middle;
    }
    return high;
  }
  // Where p changes sign in (-1, 1): between two neighbouring extrema it does so once or not at all.
  static std::vector<Real> signChanges(const Polynomial& p) {
    std::vector<Real> knots{-1.0L}, changes;
    if (p.size() > 2)
      for (const Real x : signChanges(derivative(p))) knots.push_back(x);
    knots.push_back(1.0L);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i)
      if ((value(p, knots[i]) < 0) != (value(p, knots[i + 1]) < 0))
        changes.push_back(bisect(p, knots[i], knots[i + 1]));
    return changes;
  }
  // The polynomial of degree 9 through ten Chebyshev points: Newton's divided differences, expanded.
  template <class Function>
  static Polynomial interpolate(const Function& f) {
    constexpr std::size_t n = 10;
    Real x[n], d[n];
    for (std::size_t i = 0; i < n; ++i) {
      x[i] = std::cos(std::numbers::pi_v<Real> * (static_cast<Real>(i) + 0.5L) / n);
      d[i] = f(x[i]);
    }
    for (std::size_t order = 1; order < n; ++order)
      for (std::size_t i = n - 1; i >= order; --i) d[i] = (d[i] - d[i - 1]) / (x[i] - x[i - order]);
    Polynomial p(n, 0.0L);
    p[0] = d[n - 1];
    for (std::size_t i = n - 1; i-- > 0;) {
      for (std::size_t k = n - 1; k > 0; --k) p[k] = p[k - 1] - x[i] * p[k];
      p[0] = d[i] - x[i] * p[0];
    }
    return p;
  }

  // The cardinal cubic B-spline as a sum of truncated powers.
  static Real bspline(Real x) {
    const auto cube = [](Real v) { return v > 0 ? v * v * v : 0.0L; };
    return (cube(x + 2) - 4 * cube(x + 1) + 6 * cube(x) - 4 * cube(x - 1) + cube(x - 2)) / 6;
  }

  std::optional<Real> searchCell(Real isovalue, const Ray& ray, Real t0, Real t1, int& side) const {
    glm::ivec3 cell;
    for (int axis = 0; axis < 3; ++axis)
      cell[axis] =
          std::clamp(static_cast<int>(std::floor(ray.origin[axis] + 0.5L * (t0 + t1) * ray.direction[axis])),
                     0, field_.grid.dims()[axis] - 2);
    Real c[64];
    bool below = false, above = false;
    for (int i = 0; i < 64; ++i) {
      c[i] = field_.coefficient(cell + glm::ivec3(i & 3, i >> 2 & 3, i >> 4) - 1) - isovalue;
      if (std::isnan(c[i])) {
        side = 0;
        return std::nullopt;
      }
      (c[i] < 0 ? below : above) = true;
    }
    const auto f = [&](Real t) {
      Real w[3][4];
      for (int axis = 0; axis < 3; ++axis)
        for (int k = 0; k < 4; ++k)
          w[axis][k] = bspline(ray.origin[axis] + t * ray.direction[axis] - (cell[axis] - 1 + k));
      Real sum = 0;
      for (int i = 0; i < 64; ++i) sum += c[i] * w[0][i & 3] * w[1][i >> 2 & 3] * w[2][i >> 4];
      return sum;
    };
    if (!(below && above)) {
      const int whole = above ? 1 : -1;
      const bool changed = side != 0 && side != whole;
      side = whole;
      return changed ? std::optional(t0) : std::nullopt;
    }
    const Polynomial p = interpolate([&](Real x) { return f(0.5L * (t0 + t1) + 0.5L * (t1 - t0) * x); });
    std::vector<Real> knots{-1.0L};
    for (const Real x : signChanges(derivative(p))) knots.push_back(x);
    knots.push_back(1.0L);
    const auto tOf = [&](Real x) { return 0.5L * (t0 + t1) + 0.5L * (t1 - t0) * x; };
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      // Just behind one knot and just before the next: touches at knots do not count.
      const Real a = knots[i], b = knots[i + 1], margin = 1e-12L * (b - a);
      const int first = value(p, a + margin) >= 0 ? 1 : -1, last = value(p, b - margin) >= 0 ? 1 : -1;
      if (side != 0 && side != first) return tOf(a);
      side = last;
      if (first != last) return tOf(bisect(p, a + margin, b - margin));
    }
    return std::nullopt;
  }
  const SplineCase& field_;
};

struct Tally {
  std::atomic<int> rays = 0, hits = 0, uncertain = 0, borderline = 0, wrong = 0;
};

// Where the two disagree, the earlier of the two hits must be a touch within rounding: a crossing proper
// would stay where it is, in the search started just before it, when the last digits of the isovalue change.
void compare(const SplineCase& field, double isovalue, const Ray& ray, Tally& tally) {
  const Oracle oracle(field);
  const CubicHit found = field.firstHit(isovalue, ray);
  const auto expected = oracle.firstHit(isovalue, ray);
  ++tally.rays;
  tally.hits += found.hit ? 1 : 0;
  tally.uncertain += found.certain ? 0 : 1;
  const double length = glm::length(ray.direction);
  const double mine = found.hit ? found.hit->t : kNever, theirs = expected.value_or(kNever);
  const double range = field.grid.maximum() - field.grid.minimum();
  if (mine != theirs && std::abs(mine - theirs) * length > 1e-6) {
    const double earlier = std::min(mine, theirs), begin = std::max(earlier - 1e-4 / length, 0.0);
    const double shift = 1e-11 * range;
    int seen = 0;
    for (const double other : {isovalue - shift, isovalue + shift}) {
      const auto t = oracle.firstHit(other, ray, begin);
      seen += t && std::abs(*t - earlier) * length < 1e-3 ? 1 : 0;
    }
    const bool touch = seen < 2 || earlier * length < 1e-6;
    ++(touch ? tally.borderline : tally.wrong);
  }
  if (!found.hit) return;
  const double scale = std::max(range, std::abs(isovalue));
  EXPECT_LE(found.hit->valueError, 1e-9 * scale);
  EXPECT_NEAR(field.sample(found.hit->voxel).value, isovalue, 1e-9 * scale);
  EXPECT_LT(glm::distance(found.hit->voxel, ray.origin + found.hit->t * ray.direction),
            1e-9 * (1.0 + glm::length(ray.origin)));
}

// Random rays of every kind, and for every surface point so found a tangent of it.
void compareRays(const SplineCase& field, double isovalue, std::uint64_t count, Tally& tally) {
  parallelRanges(count, 50, [&](const auto& range) {
    for (std::uint64_t i = range.begin(); i != range.end(); ++i) {
      const Ray ray = test::randomRay(i, field.grid.dims());
      compare(field, isovalue, ray, tally);
      const auto hit = field.firstHit(isovalue, ray).hit;
      const glm::dvec3 gradient = hit ? field.sample(hit->voxel).gradient : glm::dvec3(0.0);
      if (i % 2 == 0 && glm::length(gradient) > 0.0)
        compare(field, isovalue, test::grazingRay(i, hit->voxel, glm::normalize(gradient)), tally);
    }
  });
}

TEST(FirstHitCubic, AgreesWithAnIndependentSearchOnNoiseGyroidSheetAndTouchingBalls) {
  struct Case {
    const char* name;
    glm::ivec3 dims;
    double isovalue;
    std::uint64_t rays;
  };
  for (const Case& c : {Case{"noise", {20, 17, 26}, 0.0, 600}, Case{"noise", {20, 17, 26}, 0.6, 300},
                        Case{"gyroid", {25, 25, 25}, 0.0, 400}, Case{"sheet", {12, 13, 12}, 0.0, 300},
                        Case{"sheet", {12, 13, 12}, -0.35, 300}, Case{"two_balls", {24, 24, 24}, 0.0, 300}})
    for (const bool interpolating : {false, true}) {
      const SplineCase field(phantomGrid(c.name, c.dims), interpolating);
      Tally tally;
      compareRays(field, c.isovalue, c.rays, tally);
      EXPECT_EQ(tally.wrong, 0) << c.name;
      EXPECT_LE(tally.borderline, tally.rays / 100) << c.name;
      EXPECT_LE(tally.uncertain, tally.rays / 100) << c.name;
      // Smoothed, the sheet's maximum is below 0.
      const bool none = std::string(c.name) == "sheet" && c.isovalue == 0.0 && !interpolating;
      EXPECT_EQ(tally.hits > tally.rays / 20, !none) << c.name << ' ' << c.isovalue << ' ' << tally.hits;
    }
}

TEST(FirstHitCubic, AgreesOnAHeadAndOnIntegersWhereTheIsovalueIsThatOfManyVoxels) {
  const glm::ivec3 dims(14, 15, 16);
  const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
  std::vector<std::int8_t> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = static_cast<std::int8_t>(static_cast<int>(base::counterHash(3, i) % 5) - 2);
  for (const bool interpolating : {false, true}) {
    const SplineCase integers(Grid(geometry, voxels, 0.5, 1.0), interpolating);
    for (const double isovalue : {0.5, 1.0, 1.25}) {
      Tally tally;
      compareRays(integers, isovalue, 200, tally);
      EXPECT_EQ(tally.wrong, 0) << isovalue;
      EXPECT_GT(tally.hits, 30) << isovalue;
    }
    const SplineCase head(phantomGrid("head", 32), interpolating);
    Tally tally;
    compareRays(head, 300.0, 300, tally);
    EXPECT_EQ(tally.wrong, 0);
    EXPECT_GT(tally.hits, 100);
  }
}

TEST(FirstHitCubic, ALinearFieldIsExact) {
  // f = 2x - 3y + z / 2 + 1, far from the border, where repeated samples bend it.
  const glm::ivec3 dims(20, 20, 20);
  const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
  std::vector<float> voxels;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) voxels.push_back(2.0f * x - 3.0f * y + 0.5f * z + 1.0f);
  const SplineCase field(Grid(geometry, voxels), false);
  int hits = 0;
  for (std::uint64_t i = 0; i < 2000; ++i) {
    Ray ray;
    ray.origin = 4.0 + 11.0 * test::randomVector(i, 1);
    ray.direction = i % 3 == 0 ? glm::dvec3(i % 2 ? 1 : -1, 0, 0) : test::randomVector(i, 2) - 0.5;
    const double slope = glm::dot(ray.direction, glm::dvec3(2, -3, 0.5));
    const double start = glm::dot(ray.origin, glm::dvec3(2, -3, 0.5)) + 1.0;
    const double t = (-2.75 - start) / slope;
    const glm::dvec3 at = ray.origin + t * ray.direction;
    if (!(t > 0.0) || glm::any(glm::lessThan(at, glm::dvec3(2))) ||
        glm::any(glm::greaterThan(at, glm::dvec3(17))))
      continue;
    const CubicHit found = field.firstHit(-2.75, ray);
    ASSERT_TRUE(found.hit);
    EXPECT_NEAR(found.hit->t, t, 1e-12 * std::max(1.0, t) * std::max(1.0, 1.0 / std::abs(slope)));
    EXPECT_EQ(found.hit->entering, slope > 0.0);
    EXPECT_TRUE(found.certain);
    ++hits;
  }
  EXPECT_GT(hits, 500);
}

TEST(FirstHitCubic, AtATouchItSaysThatItCannotTell) {
  // The spline of the samples (x - 5.5)^2 is (x - 5.5)^2 + 1/3.
  std::vector<float> voxels;
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 12; ++x)
      voxels.push_back((static_cast<float>(x) - 5.5f) * (static_cast<float>(x) - 5.5f));
  const SplineCase field(Grid(GridGeometry::make({12, 2, 2}, glm::dvec3(1)), voxels), false);
  const Ray ray{{2.1, 0.3, 0.6}, {1.0, 0.0, 0.0}, 3.0};  // starts within the cell
  const CubicHit above = field.firstHit(1.0 / 3.0 + 1e-6, ray);
  ASSERT_TRUE(above.hit);
  EXPECT_TRUE(above.certain);
  EXPECT_NEAR(above.hit->voxel.x, 5.5 - 1e-3, 1e-9);
  const CubicHit below = field.firstHit(1.0 / 3.0 - 1e-6, ray);
  EXPECT_FALSE(below.hit);
  EXPECT_TRUE(below.certain);
  int uncertain = 0;
  for (int step = -40; step <= 40; ++step) {
    const CubicHit touch = field.firstHit(1.0 / 3.0 + step * 0x1p-54, ray);
    uncertain += touch.certain ? 0 : 1;
    if (!touch.certain) {
      EXPECT_NEAR(touch.tUncertain, 3.4, 1e-6);
    }
    if (touch.hit) {
      EXPECT_NEAR(touch.hit->voxel.x, 5.5, 1e-6);
    }
  }
  EXPECT_GT(uncertain, 0);
}

// Where a ray begins to run within the surface: x = 4 from y = 6 on, in cells with both sides.
TEST(FirstHitCubic, AStretchThatIsZeroThroughoutLiesInside) {
  const SplineCase field(
      test::gridOfVoxels(test::unitGeometry({9, 12, 4}),
                         [](glm::dvec3 p) { return p.x - 4.0 - std::max(0.0, 5.0 - p.y); }),
      false);
  const CubicHit found = field.firstHit(0.0, {{4.0, -3.0, 1.5}, {0.0, 1.0, 0.0}});
  ASSERT_TRUE(found.hit);
  EXPECT_EQ(found.hit->voxel.y, 6.0);
  EXPECT_TRUE(found.hit->entering);
  EXPECT_TRUE(found.certain);
  const SideChanges within =
      sideChangesOfCell(field.grid, nullptr, 0.0, {4, 7, 1}, {0.0, 0.0, 0.5}, {0.0, 1.0, 0.5});
  EXPECT_EQ(within.first, Side::inside);
  EXPECT_EQ(within.count, 0u);
}

// Nine steps of 2^-50 beside the isovalue are more than what rounding adds where samples are 1.5 from it: the
// side is known there, and at a step it is not.
TEST(FirstHitCubic, TheSideIsKnownBeyondRounding) {
  const SplineCase field(test::gridOfVoxels(test::unitGeometry({9, 9, 4}), [](glm::dvec3 p) { return p.x; }),
                         false);
  const auto sideAt = [&](double depth) {  // along y, x = 4.5
    return sideChangesOfCell(field.grid, nullptr, 4.5 - depth, {4, 4, 1}, {0.5, 0.0, 0.5}, {0.5, 1.0, 0.5});
  };
  for (const double sign : {1.0, -1.0}) {
    const SideChanges clear = sideAt(9.0 * sign * 0x1p-50);
    EXPECT_EQ(clear.first, sign > 0.0 ? Side::inside : Side::outside) << sign;
    EXPECT_EQ(clear.count, 0u) << sign;
    EXPECT_EQ(sideAt(sign * 0x1p-50).first, Side::unknown) << sign;
  }
}

// All samples of a cell are the isovalue: the side behind it, which the cells before only come near to.
TEST(FirstHitCubic, APlateauAtTheIsovalueLiesInside) {
  const SplineCase field(test::gridOfVoxels(test::unitGeometry({12, 4, 4}),
                                            [](glm::dvec3 p) { return std::min(0.0, p.x - 4.0); }),
                         false);
  const CubicHit found = field.firstHit(0.0, {{-3.0, 1.25, 1.5}, {1.0, 0.0, 0.0}});
  ASSERT_TRUE(found.hit);
  EXPECT_EQ(found.hit->voxel.x, 5.0);
  EXPECT_TRUE(found.hit->entering);
}

// A billionth of a voxel of a cell beside the ray's: what is all rounding there, because a sample near by is
// large, is no doubt where the next cell shows the crossing.
TEST(FirstHitCubic, ADoubtAtThePlaceOfTheHitIsNone) {
  const SplineCase field(test::gridOfVoxels(test::unitGeometry({12, 12, 4}),
                                            [](glm::dvec3 p) { return p.x > 6.0 ? 1e6 : p.x - 5.0; }),
                         false);
  const CubicHit found = field.firstHit(0.5e-9, {{2.0, 2.0 - 1e-9, 1.5}, {1.0, 1.0, 0.0}});
  ASSERT_TRUE(found.hit);
  EXPECT_NEAR(found.hit->voxel.x, 5.0, 2e-9);
  EXPECT_TRUE(found.certain);
}

TEST(FirstHitCubic, ThePolynomialAlongAStretchIsTheFieldAndItsHullHoldsIt) {
  std::array<double, 64> c;
  for (std::uint64_t round = 0; round < 200; ++round) {
    for (std::uint64_t i = 0; i < 64; ++i) c[i] = base::uniformNoise(round, i) - 0.5;
    const glm::dvec3 from = test::randomVector(round, 1);
    const glm::dvec3 to = round % 4 ? test::randomVector(round, 2) : glm::dvec3(from.x, from.y, 1.0);
    const Bernstein9 b = alongStretch(c, from, to);
    const auto [low, high] = std::minmax_element(b.begin(), b.end());
    const auto [least, most] = std::minmax_element(c.begin(), c.end());
    EXPECT_GE(*low, *least - 1e-15);
    EXPECT_LE(*high, *most + 1e-15);
    for (double s = 0.0; s <= 1.0; s += 0.125) {
      const glm::dvec3 p = from + s * (to - from);
      const CubicWeights x = cubicWeights(p.x), y = cubicWeights(p.y), z = cubicWeights(p.z);
      double expected = 0.0, value = 0.0;
      for (std::size_t i = 0; i < 64; ++i) expected += c[i] * x.w[i & 3] * y.w[i >> 2 & 3] * z.w[i >> 4];
      const double choose[10] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
      for (std::size_t m = 0; m < 10; ++m)
        value += b[m] * choose[m] * std::pow(s, static_cast<double>(m)) *
                 std::pow(1.0 - s, 9.0 - static_cast<double>(m));
      EXPECT_NEAR(value, expected, 1e-14);
    }
  }
}

TEST(FirstHitCubic, CellsWithMissingVoxelsHoldNoSurface) {
  const GridGeometry geometry = GridGeometry::make({18, 18, 18}, glm::dvec3(1));
  auto voxels = std::get<std::vector<float>>(phantomGrid("noise", geometry).voxels());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    if (base::uniformNoise(9, i) < 0.01) voxels[i] = std::numeric_limits<float>::quiet_NaN();
  for (const bool interpolating : {false, true}) {
    const SplineCase field(Grid(geometry, voxels), interpolating);
    int hits = 0;
    for (std::uint64_t i = 0; i < 4000; ++i) {
      const auto found = field.firstHit(0.0, test::randomRay(i, geometry.dims)).hit;
      if (!found) continue;
      ++hits;
      // Some cell that holds the point is whole.
      bool whole = false;
      for (int side = 0; side < 8; ++side) {
        const glm::dvec3 nudge = glm::dvec3(side & 1, side >> 1 & 1, side >> 2) * 2e-9 - 1e-9;
        const glm::ivec3 cell =
            glm::clamp(glm::ivec3(glm::floor(found->voxel + nudge)), glm::ivec3(0), geometry.dims - 2);
        bool missing = false;
        for (int tap = 0; tap < 64; ++tap) {
          const glm::ivec3 offset(tap & 3, tap >> 2 & 3, tap >> 4);
          if (interpolating && (glm::any(glm::lessThan(offset, glm::ivec3(1))) ||
                                glm::any(glm::greaterThan(offset, glm::ivec3(2)))))
            continue;
          const glm::ivec3 at = glm::clamp(cell - 1 + offset, glm::ivec3(0), geometry.dims - 1);
          missing = missing || std::isnan(field.grid.value(at.x, at.y, at.z));
        }
        whole = whole || !missing;
      }
      EXPECT_TRUE(whole) << found->voxel.x << ' ' << found->voxel.y << ' ' << found->voxel.z;
    }
    EXPECT_GT(hits, 500);
  }
}

TEST(FirstHitCubic, OddRaysAndVolumesEndWithoutAHit) {
  const SplineCase ball(phantomGrid("ball", glm::ivec3(16)), true);
  const double nan = std::nan("");
  for (const Ray& ray :
       {Ray{{8, 8, -20}, {0, 0, 0}}, Ray{{8, 8, -20}, {0, 0, nan}}, Ray{{nan, 8, -20}, {0, 0, 1}},
        Ray{{8, 8, -20}, {0, 0, kNever}}, Ray{{8, 8, -20}, {0, 0, -1}}, Ray{{8, 8, -20}, {0, 0, 1}, 5.0, 1.0},
        Ray{{100, 8, 8}, {0, 0, 1}}})
    EXPECT_FALSE(ball.firstHit(0.0, ray).hit);
  EXPECT_FALSE(ball.firstHit(nan, {{8, 8, -20}, {0, 0, 1}}).hit);
  EXPECT_TRUE(ball.firstHit(0.0, {{8, 8, -20}, {0, 0, 1}}).hit);
  EXPECT_FALSE(ball.firstHit(0.0, {{8, 8, -20}, {0, 0, 1}, 0.0, 5.0}).hit);
  const SplineCase constant(
      Grid(GridGeometry::make({9, 9, 9}, glm::dvec3(1)), std::vector<std::uint8_t>(729, 7)), false);
  for (const double isovalue : {6.5, 7.0, 7.5, -kNever, kNever})
    EXPECT_FALSE(constant.firstHit(isovalue, {{-3, 4, 4.5}, {1, 0.1, 0}}).hit);
  const SplineCase flat(Grid(GridGeometry::make({9, 1, 9}, glm::dvec3(1)), std::vector<float>(81, 1.0f)),
                        false);
  EXPECT_FALSE(flat.firstHit(1.0, {{-3, 0, 4.5}, {1, 0, 0}}).hit);
}

TEST(FirstHitCubic, TinyValuesAndSmallOnesOnAHugeOffset) {
  const GridGeometry geometry = GridGeometry::make({16, 16, 16}, glm::dvec3(1));
  const auto smooth = std::get<std::vector<float>>(phantomGrid("noise", geometry).voxels());
  std::vector<float> tiny, offset;
  for (const float v : smooth) {
    tiny.push_back(v * 1e-20f);
    offset.push_back(1e6f + 4.0f * v);
  }
  Tally tally;
  compareRays(SplineCase(Grid(geometry, tiny), false), 1e-21, 200, tally);
  compareRays(SplineCase(Grid(geometry, offset), true), 1e6 + 0.3, 200, tally);
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.hits, 200);
}

// How far hits lie from the true surface of a closed form, RMS in mm, trilinear against interpolating cubic.
struct OffSurface {
  double trilinearMm = 0.0, cubicMm = 0.0;
  int hits = 0;
};

OffSurface offSurface(const std::string& name, const GridGeometry& geometry) {
  const SplineCase field(phantomGrid(name, geometry), true);
  base::Progress progress;
  const MinMaxBlocks blocks(field.grid, 8, progress);
  const auto reference = test::analyticField(name, geometry);
  OffSurface sum;
  for (std::uint64_t i = 0; i < 4000; ++i) {
    const Ray ray = test::randomRay(8 * i, geometry.dims);
    const auto cubic = field.firstHit(0.0, ray).hit;
    const auto trilinear = firstHit(field.grid, blocks, 0.0, ray);
    if (!cubic || !trilinear) continue;
    const auto off = [&](glm::dvec3 voxel) {
      const double d = reference->at(glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0))).value;
      return d * d;
    };
    sum.cubicMm += off(cubic->voxel);
    sum.trilinearMm += off(trilinear->voxel);
    ++sum.hits;
  }
  sum.cubicMm = std::sqrt(sum.cubicMm / sum.hits);
  sum.trilinearMm = std::sqrt(sum.trilinearMm / sum.hits);
  std::printf("%-6s spacing %.1f %.1f %.1f mm: off the surface %.2g mm trilinear, %.2g mm cubic (%d hits)\n",
              name.c_str(), geometry.spacingMm().x, geometry.spacingMm().y, geometry.spacingMm().z,
              sum.trilinearMm, sum.cubicMm, sum.hits);
  return sum;
}

TEST(FirstHitCubic, InterpolatingHitsAreNearerToClosedFormsThanTrilinearOnes) {
  for (const char* name : {"ball", "torus"}) {
    const OffSurface unit = offSurface(name, test::isotropicGeometry(96));
    EXPECT_GT(unit.hits, 500);
    EXPECT_LT(unit.cubicMm, 0.01 * unit.trilinearMm) << name;
  }
  // Slices of 2.5 mm: a trilinear hit lies on chords between them.
  const OffSurface ball = offSurface("ball", test::anisotropicGeometry(128));
  EXPECT_LT(ball.cubicMm, 0.01 * ball.trilinearMm);
}

}  // namespace
}  // namespace isolux::volume
