#include "volume/edge/edge_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/analytic_fields.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/statistics/visible_points.h"

namespace isolux::volume {
namespace {

using scene::Field;

// A ball of value 1000 in nothing, blurred by a Gaussian of this deviation: in closed form.
struct BlurredBall {
  double radius, deviation;

  double value(double r) const {
    const double s = deviation, root = std::numbers::sqrt2 * s, R = radius;
    const double inner = std::exp(-(r - R) * (r - R) / (2 * s * s)),
                 outer = std::exp(-(r + R) * (r + R) / (2 * s * s));
    return 1000.0 * (0.5 * (std::erf((R + r) / root) + std::erf((R - r) / root)) -
                     s / (std::max(r, 1e-9) * std::sqrt(2.0 * std::numbers::pi)) * (inner - outer));
  }
  double steepness(double r) const { return (value(r - 1e-4) - value(r + 1e-4)) / 2e-4; }
  // Where it falls most steeply.
  double edge() const {
    double low = radius - 2.0 * deviation, high = radius + 2.0 * deviation;
    for (int i = 0; i < 200; ++i) {
      const double a = low + (high - low) / 3.0, b = high - (high - low) / 3.0;
      (steepness(a) < steepness(b) ? low : high) = steepness(a) < steepness(b) ? a : b;
    }
    return 0.5 * (low + high);
  }
};

glm::dvec3 edgeWorldOf(const GridGeometry& geometry, const glm::dvec3& voxel) {
  return glm::dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
}

// Of voxels along the direction, mm.
double voxelAlong(const GridGeometry& geometry, const glm::dvec3& direction) {
  const glm::dvec3 v = glm::dmat3(geometry.voxelFromWorld()) * direction;
  return 1.0 / std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

struct EdgeCase {
  GridGeometry geometry;
  BlurredBall ball;
  double scaleMm;
};

EdgeCase isotropic(double scaleMm) {
  return {test::isotropicGeometry(56), {17.3, 1.3}, scaleMm};
}
// 0.4 x 0.4 x 2.5 mm, oblique, left-handed.
EdgeCase oblique(double scaleMm) {
  return {GridGeometry::make({150, 150, 26}, {0.4, 0.4, 2.5}, {3.0, -7.0, 11.0},
                             test::obliqueLeftHandedGeometry(32).directions()),
          {17.3, 2.5},
          scaleMm};
}

struct EdgeErrors {
  std::size_t points = 0, missing = 0;
  double median = 0.0, within95 = 0.0, worst = 0.0;  // voxels along the normal
};

struct BallCase {
  EdgeCase of;
  glm::dvec3 middle;
  Grid grid;
  std::optional<ScaledField> scaled;

  explicit BallCase(const EdgeCase& c, double noise = 0.0)
      : of(c),
        middle(edgeWorldOf(c.geometry, 0.5 * glm::dvec3(c.geometry.dims - 1) + glm::dvec3(0.2, -0.3, 0.1))),
        grid(test::gridOfWorld(c.geometry,
                               [&](glm::dvec3 x) { return c.ball.value(glm::distance(x, middle)); })) {
    if (noise > 0.0) grid = test::withNoise(grid, noise, glm::dvec3(0.0), 7);
    base::Progress progress;
    if (c.scaleMm > 0.0) scaled.emplace(scaledField(grid, Field::cubic, c.scaleMm, progress));
  }
  EdgeFinder finder(double noise, double search = 8.0, double contrast = 5.0) const {
    return {grid,
            {Field::cubic, nullptr, scaled ? &*scaled : nullptr},
            {.searchMm = search, .contrast = contrast, .noise = noise}};
  }
};

// At the hits of an isovalue, against the closed form at each hit's own distance.
EdgeErrors errorsAt(const BallCase& setup, double isovalue, double noise) {
  base::Progress progress;
  const MinMaxBlocks blocks(setup.grid, kBlockCells, progress);
  const EdgeFinder finder = setup.finder(noise);
  const double edge = setup.of.ball.edge();
  std::vector<double> apart;
  EdgeErrors errors;
  for (const VisiblePoint& point : visiblePoints(setup.grid, blocks, isovalue, 1500)) {
    const glm::dvec3 out = edgeWorldOf(setup.of.geometry, point.voxel) - setup.middle;
    const double r = glm::length(out);
    const Edge found = finder.at(point.voxel);
    ++errors.points;
    if (!found.offsetMm) {
      ++errors.missing;
      continue;
    }
    apart.push_back((*found.offsetMm - (edge - r)) / voxelAlong(setup.of.geometry, out / r));
  }
  if (apart.empty()) return errors;
  std::sort(apart.begin(), apart.end());
  errors.median = apart[apart.size() / 2];
  for (double& e : apart) e = std::abs(e);
  std::sort(apart.begin(), apart.end());
  errors.worst = apart.back();
  errors.within95 = apart[apart.size() * 95 / 100];
  return errors;
}

std::string describe(const EdgeCase& c, double isovalue, const EdgeErrors& e) {
  std::ostringstream text;
  text << c.geometry.dims.x << " voxels, scale " << c.scaleMm << " mm, isovalue " << isovalue << ": "
       << e.points << " points, " << e.missing << " without; median " << e.median << ", 95 % within "
       << e.within95 << ", worst " << e.worst << " voxels";
  return text.str();
}

TEST(EdgeFinder, ABlurredBallThresholdedWrongHasItsKnownOffset) {
  for (const EdgeCase& c : {isotropic(0.0), isotropic(1.0), isotropic(2.0), oblique(1.0), oblique(2.5)}) {
    const BallCase setup(c);
    for (const double isovalue : {60.0, 250.0, 500.0, 800.0}) {
      const EdgeErrors e = errorsAt(setup, isovalue, 0.0);
      EXPECT_GT(e.points, 500u);
      EXPECT_EQ(e.missing, 0u);
      EXPECT_LT(e.worst, 0.05) << describe(c, isovalue, e);
    }
  }
}

TEST(EdgeFinder, WithFivePercentNoiseItIsWithinAFifthOfAVoxel) {
  for (const EdgeCase& c : {isotropic(1.5), isotropic(2.5), oblique(2.5)}) {
    const BallCase setup(c, 50.0);
    for (const double isovalue : {250.0, 500.0, 750.0}) {
      const EdgeErrors e = errorsAt(setup, isovalue, 50.0);
      EXPECT_EQ(e.missing, 0u);
      EXPECT_LT(std::abs(e.median), 0.05);
      EXPECT_LT(e.worst, 0.2) << describe(c, isovalue, e);
    }
  }
}

// The scale that is chosen where nobody gives one serves edges, too.
TEST(EdgeFinder, AtTheAutomaticScaleNoiseLeavesAFifthOfAVoxel) {
  for (EdgeCase c : {isotropic(0.0), oblique(0.0)}) {
    const BallCase noisy(c, 50.0);
    const auto grid = std::make_shared<const Grid>(noisy.grid);
    base::Progress progress;
    const auto blocks = std::make_shared<const MinMaxBlocks>(*grid, kBlockCells, progress);
    c.scaleMm = DerivativeChoices(grid, blocks).choose({.isovalue = 250.0}, progress).scaleMm;
    ASSERT_GT(c.scaleMm, 0.0);
    const EdgeErrors e = errorsAt(BallCase(c, 50.0), 250.0, 50.0);
    EXPECT_EQ(e.missing, 0u);
    EXPECT_LT(e.within95, 0.2) << describe(c, 250.0, e);
  }
}

Edge edgeOf(const Grid& grid, const glm::dvec3& voxel, const EdgeQuestion& question) {
  return EdgeFinder(grid, {}, question).at(voxel);
}

// A step from 1000 to 0 along x, blurred, at this place, and one from 0 up again behind it.
Grid stepsAt(double fall, double rise, double slope = 1.0) {
  const auto normal = [](double x) { return 0.5 * std::erfc(x / (1.5 * std::numbers::sqrt2)); };
  const Grid plain = test::gridOfVoxels(test::unitGeometry({40, 12, 12}), [&](glm::dvec3 p) {
    return (1000.0 * normal(p.x - fall) + 1000.0 * normal(rise - p.x)) / slope;
  });
  return Grid(plain.geometry(), plain.voxels(), slope, 0.0);
}

// At scale 0: second derivatives of the cubic spline are piecewise linear, which costs some 0.02 voxels.
TEST(EdgeFinder, OffsetsPointOutwardWhicheverSideIsInside) {
  for (const double slope : {1.0, -2.0}) {
    const Grid grid = stepsAt(15.3, 1e6, slope);
    for (const double hit : {14.0, 15.3, 16.2}) {
      const EdgeQuestion above{.searchMm = 6.0};
      EdgeQuestion below = above;
      below.outward = 1.0;
      EXPECT_NEAR(edgeOf(grid, {hit, 5.2, 6.1}, above).offsetMm.value_or(99), 15.3 - hit, 0.03);
      EXPECT_NEAR(edgeOf(grid, {hit, 5.2, 6.1}, below).offsetMm.value_or(99), hit - 15.3, 0.03);
    }
  }
}

TEST(EdgeFinder, TheOtherSideOfAGapIsNotTheEdge) {
  const Grid grid = stepsAt(12.0, 20.0);
  EXPECT_NEAR(edgeOf(grid, {14.5, 5, 5}, {.searchMm = 9.0}).offsetMm.value_or(99), -2.5, 0.02);
  EXPECT_FALSE(edgeOf(grid, {14.5, 5, 5}, {.searchMm = 2.0}).offsetMm);  // too far
}

TEST(EdgeFinder, RampsPlateausAndNoiseHaveNone) {
  const EdgeQuestion question{.searchMm = 5.0};
  const GridGeometry geometry = test::unitGeometry({24, 24, 24});
  const Grid ramp =
      test::gridOfVoxels(geometry, [](glm::dvec3 p) { return 3.1 * p.x - 1.7 * p.y + 0.3 * p.z; });
  const Grid flat = test::gridOfVoxels(geometry, [](glm::dvec3) { return 7.0; });
  const Grid noise = test::withNoise(flat, 1.0, glm::dvec3(0.0), 3);
  EdgeQuestion noisy = question;
  noisy.noise = 1.0;
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 at(6.0 + 0.05 * i, 14.0 - 0.03 * i, 9.3 + 0.01 * i);
    EXPECT_FALSE(edgeOf(ramp, at, question).offsetMm);
    EXPECT_FALSE(edgeOf(flat, at, question).offsetMm);
    EXPECT_LT(edgeOf(flat, at, question).strength, 1e-2);
    EXPECT_FALSE(edgeOf(noise, at, noisy).offsetMm);
  }
}

TEST(EdgeFinder, StrengthIsTheGradientInDeviationsOfItsNoise) {
  const GridGeometry geometry = test::obliqueLeftHandedGeometry(24);
  const Grid flat = test::gridOfVoxels(geometry, [](glm::dvec3) { return 0.0; });
  const Grid ramp = test::gridOfWorld(geometry, [](glm::dvec3 p) { return 40.0 * p.x + 3.0 * p.z; });
  const Grid noise = test::withNoise(flat, 2.0, glm::dvec3(0.0), 11);
  const glm::dvec3 along = glm::normalize(glm::dvec3(40.0, 0.0, 3.0));
  double squares = 0.0;
  int count = 0;
  for (double x = 3.1; x < 20.0; x += 0.83)
    for (double y = 3.2; y < 20.0; y += 0.71)
      for (double z = 3.3; z < 20.0; z += 0.77, ++count)
        squares +=
            std::pow(glm::dot(worldGradient(geometry, sampleCubic(noise, {x, y, z}).gradient), along), 2);
  const double measured = glm::length(glm::dvec3(40.0, 0.0, 3.0)) / std::sqrt(squares / count);
  EXPECT_NEAR(edgeOf(ramp, {11.2, 12.3, 10.9}, {.searchMm = 1.0, .noise = 2.0}).strength / measured, 1.0,
              0.05);
}

TEST(EdgeFinder, WalksEndAtTheBorderAndAtMissingVoxels) {
  const EdgeQuestion question{.searchMm = 6.0};
  EXPECT_FALSE(edgeOf(stepsAt(41.0, 1e6), {37.5, 5, 5}, question).offsetMm);
  const Grid step = stepsAt(15.0, 1e6);
  const Grid gap = test::gridOfVoxels(step.geometry(), [&](glm::dvec3 p) {
    return p.x == 17.0 ? std::numeric_limits<double>::quiet_NaN()
                       : step.value(static_cast<int>(p.x), static_cast<int>(p.y), static_cast<int>(p.z));
  });
  EXPECT_TRUE(edgeOf(step, {19.4, 5, 5}, question).offsetMm);
  EXPECT_FALSE(edgeOf(gap, {19.4, 5, 5}, question).offsetMm);
  const Edge none = edgeOf(gap, {17.2, 5, 5}, question);
  EXPECT_FALSE(none.offsetMm);
  EXPECT_EQ(none.strength, 0.0);
}

TEST(EdgeFinder, AnyScaleOfValues) {
  for (const double size : {1e-30, 1.0, 1e30}) {
    const Grid step = test::gridOfVoxels(test::unitGeometry({40, 8, 8}),
                                         [&](glm::dvec3 p) { return size * std::erfc((p.x - 15.3) / 2.0); });
    const Edge edge = edgeOf(step, {14.6, 3.5, 3.5}, {.searchMm = 4.0, .noise = 0.01 * size});
    ASSERT_TRUE(edge.offsetMm) << size;
    EXPECT_NEAR(*edge.offsetMm, 0.7, 0.03);
    EXPECT_TRUE(std::isfinite(edge.strength));
  }
}

}  // namespace
}  // namespace isolux::volume
