#include "volume/intersect.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/analytic_fields.h"
#include "tests/support/rays.h"
#include "volume/phantom.h"
#include "volume/phantom_noise.h"
#include "volume/reconstruct.h"

namespace isolux::volume {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// An independent search in extended precision: every plane crossing of the ray sorted, every stretch between
// two of them sampled densely and at the extrema of its cubic in the power basis. No blocks, no stepping.
class Oracle {
 public:
  using Real = long double;
  explicit Oracle(const Grid& grid) : grid_(grid) {}

  std::optional<double> firstHit(double isovalue, glm::dvec3 o, glm::dvec3 d, double tMinimum = 0.0,
                                 double tMaximum = kInfinity) const {
    Real begin = tMinimum, end = tMaximum;
    std::vector<Real> cuts;
    for (int axis = 0; axis < 3; ++axis) {
      const int last = grid_.dims()[axis] - 1;
      if (last < 1) return std::nullopt;
      if (d[axis] == 0.0) {
        if (o[axis] < 0.0 || o[axis] > last) return std::nullopt;
        continue;
      }
      const Real t0 = (0.0L - o[axis]) / d[axis], t1 = (last - static_cast<Real>(o[axis])) / d[axis];
      begin = std::max(begin, std::min(t0, t1));
      end = std::min(end, std::max(t0, t1));
      for (int plane = 0; plane <= last; ++plane)
        cuts.push_back((plane - static_cast<Real>(o[axis])) / d[axis]);
    }
    if (!(begin < end)) return std::nullopt;
    cuts.push_back(begin);
    cuts.push_back(end);
    std::sort(cuts.begin(), cuts.end());
    int side = 0;  // -1 outside, 1 inside, 0 unknown
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      if (cuts[i] < begin || cuts[i + 1] > end || cuts[i + 1] - cuts[i] < 1e-15L) continue;
      if (const auto t = searchCell(isovalue, o, d, cuts[i], cuts[i + 1], side))
        return static_cast<double>(*t);
    }
    return std::nullopt;
  }

 private:
  std::optional<Real> searchCell(Real isovalue, glm::dvec3 o, glm::dvec3 d, Real t0, Real t1,
                                 int& side) const {
    const Real middle = 0.5L * (t0 + t1);
    std::array<int, 3> cell;
    for (std::size_t a = 0; a < 3; ++a) {
      const int axis = static_cast<int>(a);
      cell[a] =
          std::clamp(static_cast<int>(std::floor(o[axis] + middle * d[axis])), 0, grid_.dims()[axis] - 2);
    }
    Real corner[8];
    bool below = false, above = false;
    for (int i = 0; i < 8; ++i) {
      corner[i] = grid_.value(cell[0] + (i & 1), cell[1] + (i >> 1 & 1), cell[2] + (i >> 2)) - isovalue;
      if (std::isnan(corner[i])) {
        side = 0;
        return std::nullopt;
      }
      (corner[i] < 0 ? below : above) = true;
    }
    const auto f = [&](Real t) {
      Real w[3];
      for (std::size_t a = 0; a < 3; ++a)
        w[a] = o[static_cast<int>(a)] + t * d[static_cast<int>(a)] - cell[a];
      Real sum = 0;
      for (int i = 0; i < 8; ++i)
        sum += corner[i] * (i & 1 ? w[0] : 1 - w[0]) * (i >> 1 & 1 ? w[1] : 1 - w[1]) *
               (i >> 2 ? w[2] : 1 - w[2]);
      return sum;
    };
    if (!(below && above)) {
      const int whole = above ? 1 : -1;
      const bool changed = side != 0 && side != whole;
      side = whole;
      return changed ? std::optional(t0) : std::nullopt;
    }
    // The cubic through four points of the stretch, its extrema, and 32 samples between.
    const auto at = [&](Real s) { return f(t0 + s * (t1 - t0)); };
    const Real y0 = at(0), y1 = at(1.0L / 3), y2 = at(2.0L / 3), y3 = at(1);
    const Real c3 = 4.5L * (y3 - 3 * y2 + 3 * y1 - y0), c2 = 4.5L * (2 * y0 - 5 * y1 + 4 * y2 - y3);
    const Real c1 = y3 - y0 - c2 - c3;
    std::vector<Real> knots;
    for (int i = 0; i <= 32; ++i) knots.push_back(i / 32.0L);
    const Real discriminant = c2 * c2 - 3 * c3 * c1;
    if (discriminant >= 0) {
      const Real q = -(c2 + std::copysign(std::sqrt(discriminant), c2));
      for (const Real s : {q / (3 * c3), c1 / q})
        if (s > 0 && s < 1) knots.push_back(s);
    }
    std::sort(knots.begin(), knots.end());
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
      // The sides just behind one knot and just before the next: touches at knots do not count.
      const Real a = knots[i], b = knots[i + 1], margin = 1e-14L * (b - a);
      if (b - a < 1e-15L) continue;
      const int first = at(a + margin) >= 0 ? 1 : -1, last = at(b - margin) >= 0 ? 1 : -1;
      if (side != 0 && side != first) {
        side = first;
        return t0 + a * (t1 - t0);
      }
      side = last;
      if (first == last) continue;
      Real low = a, high = b;
      for (int k = 0; k < 100; ++k) {
        const Real m = 0.5L * (low + high);
        ((at(m) >= 0 ? 1 : -1) == first ? low : high) = m;
      }
      return t0 + high * (t1 - t0);
    }
    return std::nullopt;
  }
  const Grid& grid_;
};

struct Tally {
  int rays = 0, hits = 0, borderline = 0, wrong = 0;
  double worst = 0.0;
};

// Where the two disagree, the earlier of the two hits must be a touch within rounding: a crossing proper
// would stay where it is, in the dense search started just before it, when the last digits of the isovalue
// change.
void compare(const Grid& grid, const MinMaxBlocks& blocks, double iso, glm::dvec3 o, glm::dvec3 d,
             Tally& tally) {
  const Oracle oracle(grid);
  const auto hit = firstHit(grid, blocks, iso, o, d);
  const auto expected = oracle.firstHit(iso, o, d);
  ++tally.rays;
  tally.hits += hit ? 1 : 0;
  const double length = glm::length(d);
  const double mine = hit ? hit->t : kInfinity, theirs = expected.value_or(kInfinity);
  const double error = mine == theirs ? 0.0 : std::abs(mine - theirs) * length;
  if (error <= 1e-6) {
    tally.worst = std::max(tally.worst, error);
  } else {
    const double earlier = std::min(mine, theirs), begin = std::max(earlier - 1e-5 / length, 0.0);
    const double shift = 1e-11 * std::max(grid.maximum() - grid.minimum(), 1e-4 * std::abs(iso));
    int seen = 0;
    for (const double other : {iso - shift, iso + shift}) {
      const auto t = oracle.firstHit(other, o, d, begin);
      seen += t && std::abs(*t - earlier) * length < 1e-4 ? 1 : 0;
    }
    // A ray that starts on the surface has nothing before its start to tell the sides apart.
    const bool touch = seen < 2 || earlier * length < 1e-6;
    ++(touch ? tally.borderline : tally.wrong);
  }
  if (!hit) return;
  const double scale = std::max({grid.maximum() - grid.minimum(), std::abs(iso)});
  EXPECT_LE(hit->valueError, 1e-9 * scale);
  EXPECT_LT(glm::distance(hit->voxel, o + hit->t * d), 1e-9 * (1.0 + glm::length(o)));
  EXPECT_NEAR(sampleTrilinear(grid, hit->voxel).value, iso, 1e-9 * scale);
}

Grid phantom(const std::string& name, std::optional<GridGeometry> geometry = {}, int size = 0) {
  scene::Progress progress;
  PhantomRequest request;
  request.name = name;
  request.size = size;
  request.geometry = geometry;
  return makePhantom(request, progress);
}

Tally compareRandomRays(const Grid& grid, double iso, std::uint64_t count, int blockCells) {
  scene::Progress progress;
  const MinMaxBlocks blocks(grid, blockCells, progress);
  Tally tally;
  for (std::uint64_t i = 0; i < count; ++i) {
    const Ray ray = test::randomRay(i, grid.dims());
    compare(grid, blocks, iso, ray.origin, ray.direction, tally);
  }
  return tally;
}

TEST(FirstHit, AgreesWithADenseSearchOnNoiseGyroidAndThinSheet) {
  struct Case {
    const char* name;
    glm::ivec3 dims;
    double iso;
    std::uint64_t rays;
    int blockCells;
  };
  const Case cases[] = {{"noise", {20, 17, 26}, 0.0, 30000, 4},  {"noise", {20, 17, 26}, 0.6, 10000, 8},
                        {"gyroid", {33, 33, 33}, 0.0, 30000, 8}, {"gyroid", {41, 60, 35}, 0.7, 10000, 4},
                        {"sheet", {16, 17, 18}, 0.0, 20000, 8},  {"two_balls", {30, 30, 30}, 0.0, 10000, 4}};
  for (const Case& c : cases) {
    const Grid grid = phantom(c.name, GridGeometry::make(c.dims, glm::dvec3(1)));
    const Tally tally = compareRandomRays(grid, c.iso, c.rays, c.blockCells);
    EXPECT_EQ(tally.wrong, 0) << c.name;
    EXPECT_LE(tally.borderline, tally.rays / 200) << c.name;
    EXPECT_GT(tally.hits, tally.rays / 20) << c.name;
    RecordProperty(std::string(c.name) + "_borderline", tally.borderline);
  }
}

TEST(FirstHit, AgreesOnWhiteNoiseOfIntegersWhereTheIsovalueIsThatOfManyVoxels) {
  const glm::ivec3 dims(14, 15, 16);
  const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(1));
  std::vector<std::int8_t> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = static_cast<std::int8_t>(static_cast<int>(counterHash(3, i) % 5) - 2);
  const Grid grid(geometry, voxels, 0.5, 1.0);
  for (const double iso : {0.0, 0.5, 1.0, 1.25, 2.0}) {  // minimum, voxel values, between, maximum
    const Tally tally = compareRandomRays(grid, iso, 8000, 4);
    EXPECT_EQ(tally.wrong, 0) << iso;
  }
  EXPECT_EQ(compareRandomRays(grid, -0.1, 500, 8).hits, 0);
  EXPECT_EQ(compareRandomRays(grid, 2.1, 500, 8).hits, 0);
}

TEST(FirstHit, AgreesWhereVoxelsAreMissing) {
  const GridGeometry geometry = GridGeometry::make({18, 18, 18}, glm::dvec3(1));
  std::vector<float> voxels = std::get<std::vector<float>>(phantom("noise", geometry).voxels());
  for (std::size_t i = 0; i < voxels.size(); ++i)
    if (uniformNoise(9, i) < 0.03) voxels[i] = std::numeric_limits<float>::quiet_NaN();
  const Grid grid(geometry, voxels);
  scene::Progress progress;
  const MinMaxBlocks blocks(grid, 4, progress);
  Tally tally;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    // On a plane between a cell with a missing corner and one without, either answer is right: only rays
    // that run inside the cells are compared.
    if (i % 8 > 3) continue;
    const Ray ray = test::randomRay(i, grid.dims());
    compare(grid, blocks, 0.0, ray.origin, ray.direction, tally);
  }
  EXPECT_EQ(tally.wrong, 0);
  EXPECT_GT(tally.hits, 1000);
}

TEST(FirstHit, AgreesOnTinyValuesAndSmallOnesOnAHugeOffset) {
  const GridGeometry geometry = GridGeometry::make({16, 16, 16}, glm::dvec3(1));
  const auto smooth = std::get<std::vector<float>>(phantom("noise", geometry).voxels());
  std::vector<float> tiny, offset;
  for (const float v : smooth) {
    tiny.push_back(v * 1e-20f);
    offset.push_back(1e6f + 4.0f * v);
  }
  EXPECT_EQ(compareRandomRays(Grid(geometry, tiny), 1e-21, 4000, 4).wrong, 0);
  EXPECT_EQ(compareRandomRays(Grid(geometry, offset), 1e6 + 0.3, 4000, 4).wrong, 0);
}

TEST(FirstHit, RampIsExactFromBothSides) {
  std::vector<float> voxels;
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 10; ++x) voxels.push_back(static_cast<float>(2 * x));
  const Grid grid(GridGeometry::make({10, 2, 2}, glm::dvec3(1)), voxels);
  scene::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const auto forward = firstHit(grid, blocks, 7.0, {-4, 0.3, 0.7}, {2, 0, 0});
  ASSERT_TRUE(forward);
  EXPECT_EQ(forward->voxel, glm::dvec3(3.5, 0.3, 0.7));
  EXPECT_EQ(forward->t, 3.75);
  EXPECT_TRUE(forward->entering);
  const auto backward = firstHit(grid, blocks, 7.0, {9, 0.5, 0.5}, {-1, 0, 0});
  ASSERT_TRUE(backward);
  EXPECT_EQ(backward->t, 5.5);
  EXPECT_FALSE(backward->entering);
  // The range of t.
  EXPECT_FALSE(firstHit(grid, blocks, 7.0, {-4, 0.3, 0.7}, {2, 0, 0}, 0.0, 3.7));
  EXPECT_TRUE(firstHit(grid, blocks, 7.0, {-4, 0.3, 0.7}, {2, 0, 0}, 3.7, 3.8));
  EXPECT_FALSE(firstHit(grid, blocks, 7.0, {-4, 0.3, 0.7}, {2, 0, 0}, 3.8));
  // At a voxel's value the surface lies on the plane of voxels.
  const auto onPlane = firstHit(grid, blocks, 8.0, {-4, 1.0, 0.0}, {1, 0, 0});
  ASSERT_TRUE(onPlane);
  EXPECT_EQ(onPlane->voxel.x, 4.0);
  EXPECT_EQ(onPlane->valueError, 0.0);
}

TEST(FirstHit, LeavingTheSurfaceIsNoHit) {
  std::vector<float> voxels;
  for (int i = 0; i < 4; ++i)
    for (int x = 0; x < 10; ++x) voxels.push_back(static_cast<float>(x));
  const Grid grid(GridGeometry::make({10, 2, 2}, glm::dvec3(1)), voxels);
  scene::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  for (const double iso : {3.0, 4.5})
    for (const double direction : {-1.0, 1.0})
      EXPECT_FALSE(firstHit(grid, blocks, iso, {iso, 0.5, 0.5}, {direction, 0, 0}))
          << iso << ' ' << direction;
}

TEST(FirstHit, ConstantVolumesAndThoseWithoutCellsHaveNoSurface) {
  scene::Progress progress;
  const Grid constant(GridGeometry::make({9, 9, 9}, glm::dvec3(1)), std::vector<std::uint8_t>(729, 7));
  const MinMaxBlocks blocks(constant, 4, progress);
  for (const double iso : {6.5, 7.0, 7.5, -kInfinity, kInfinity, std::nan("")})
    EXPECT_FALSE(firstHit(constant, blocks, iso, {-3, 4, 4.5}, {1, 0.1, 0}));
  const Grid flat(GridGeometry::make({9, 1, 9}, glm::dvec3(1)), std::vector<float>(81, 1.0f));
  const MinMaxBlocks none(flat, 8, progress);
  EXPECT_FALSE(firstHit(flat, none, 1.0, {-3, 0, 4.5}, {1, 0, 0}));
}

TEST(FirstHit, APlateauAtTheIsovalueIsEnteredAndATouchedPeakIsNot) {
  // 0 0 5 5 5 0 | 0 0 5 0 0 0 at isovalue 5, the maximum.
  const auto slab = [](std::vector<int> profile) {
    std::vector<std::uint8_t> voxels;
    for (int i = 0; i < 4; ++i)
      for (const int v : profile) voxels.push_back(static_cast<std::uint8_t>(v));
    return Grid(GridGeometry::make({static_cast<int>(profile.size()), 2, 2}, glm::dvec3(1)), voxels);
  };
  scene::Progress progress;
  const Grid plateau = slab({0, 0, 5, 5, 5, 0}), peak = slab({0, 0, 5, 0, 0, 0});
  const auto hit = firstHit(plateau, MinMaxBlocks(plateau, 4, progress), 5.0, {-2, 0.4, 0.6}, {1, 0, 0});
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit->voxel.x, 2.0);
  EXPECT_TRUE(hit->entering);
  const auto back = firstHit(plateau, MinMaxBlocks(plateau, 4, progress), 5.0, {9, 0.4, 0.6}, {-1, 0, 0});
  ASSERT_TRUE(back);
  EXPECT_EQ(back->voxel.x, 4.0);
  EXPECT_FALSE(firstHit(peak, MinMaxBlocks(peak, 4, progress), 5.0, {-2, 0.4, 0.6}, {1, 0, 0}));
  // Out of a plateau that fills whole blocks.
  const Grid wide = slab({5, 5, 5, 5, 5, 5, 5, 5, 5, 0, 0});
  const auto out = firstHit(wide, MinMaxBlocks(wide, 4, progress), 5.0, {-2, 0.4, 0.6}, {1, 0, 0});
  ASSERT_TRUE(out);
  EXPECT_EQ(out->voxel.x, 8.0);
  EXPECT_FALSE(out->entering);
}

TEST(FirstHit, OddRaysEndWithoutAHit) {
  const Grid grid = phantom("ball", {}, 16);
  scene::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  const double nan = std::nan("");
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {8, 8, -20}, {0, 0, 0}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {8, 8, -20}, {0, 0, nan}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {nan, 8, -20}, {0, 0, 1}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {8, 8, -20}, {0, 0, kInfinity}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {8, 8, -20}, {0, 0, -1}));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {8, 8, -20}, {1e-320, 0, 1}, 5.0, 1.0));
  EXPECT_FALSE(firstHit(grid, blocks, 0.0, {100, 8, 8}, {0, 0, 1}));
  const auto far = firstHit(grid, blocks, 0.0, {7.5, 7.5, -1e9}, {0, 0, 1});
  ASSERT_TRUE(far);
  EXPECT_NEAR(far->voxel.z, 7.5 - 0.35 * 15, 0.1);
}

TEST(FirstHit, GrazingRaysOnTheBallFollowTheClosedForm) {
  const GridGeometry geometry = test::isotropicGeometry(48);
  const Grid grid = phantom("ball", geometry);
  scene::Progress progress;
  const MinMaxBlocks blocks(grid, 8, progress);
  Tally tally;
  const double radius = 0.35 * 47.0;
  for (std::uint64_t i = 0; i < 20000; ++i) {
    const glm::dvec3 n = glm::normalize(test::randomVector(i, 1) - 0.5);
    const Ray ray = test::grazingRay(i, glm::dvec3(23.5) + n * radius, n);
    compare(grid, blocks, 0.0, ray.origin, ray.direction, tally);
  }
  EXPECT_EQ(tally.wrong, 0);
}

}  // namespace
}  // namespace isolux::volume
