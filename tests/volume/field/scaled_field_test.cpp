#include "volume/field/scaled_field.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "tests/support/memory_limit.h"
#include "tests/support/rays.h"
#include "tests/support/stop_latency.h"
#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"
#include "volume/field/reconstruct.h"
#include "volume/field/sheared_filter.h"

namespace isolux::volume {
namespace {

using glm::dmat3;
using glm::dvec3;
using scene::Field;
using test::gridOfVoxels;
using test::gridOfWorld;
using test::randomPoint;

ScaledField scaled(const Grid& grid, double scaleMm, Field field = Field::cubic_interpolating) {
  base::Progress progress;
  return scaledField(grid, field, scaleMm, progress);
}

struct WorldSample {
  double value;
  dvec3 gradient;
  dmat3 hessian;
};

WorldSample worldSample(const ScaledField& field, const Grid& grid, dvec3 voxel) {
  const FieldSample s = sampleScaled(field, grid, voxel);
  return {s.value, worldGradient(grid.geometry(), s.gradient), worldHessian(grid.geometry(), s.hessian)};
}

dvec3 worldOf(const GridGeometry& geometry, dvec3 voxel) {
  return dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
}

double largest(const dmat3& m) {
  double most = 0.0;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) most = std::max(most, std::abs(m[i][k]));
  return most;
}

dmat3 rotation() {
  return dmat3(glm::rotate(glm::rotate(glm::dmat4(1.0), 0.7, dvec3(0.3, -0.5, 0.8)), -0.4, dvec3(1, 0.2, 0)));
}

GridGeometry withColumns(glm::ivec3 dims, const dmat3& columns) {
  GridGeometry geometry;
  geometry.dims = dims;
  geometry.worldFromVoxel = glm::dmat4(columns);
  geometry.worldFromVoxel[3] = glm::dvec4(-7.0, 20.0, 3.0, 1.0);
  return geometry;
}

// exp(-r^2 / 2 deviation^2), and what smoothing by an isotropic Gaussian makes of it.
struct Blob {
  dvec3 center;
  double deviation;

  double operator()(dvec3 p) const {
    const dvec3 d = p - center;
    return std::exp(-0.5 * glm::dot(d, d) / (deviation * deviation));
  }
  WorldSample smoothed(dvec3 p, double scale) const {
    const double variance = deviation * deviation + scale * scale;
    const dvec3 d = p - center;
    const double v =
        std::pow(deviation * deviation / variance, 1.5) * std::exp(-0.5 * glm::dot(d, d) / variance);
    return {v, -v / variance * d, v / variance * (glm::outerProduct(d, d) / variance - dmat3(1.0))};
  }
};

struct Case {
  const char* name;
  GridGeometry geometry;
  double deviation;  // of the blob, mm
};

std::vector<Case> blobs() {
  const dmat3 turned = rotation();
  const dmat3 thick = turned * dmat3(0.4, 0, 0, 0, 0.4, 0, 0, 0, 2.5);
  dmat3 left = thick;
  left[0] = -left[0];
  return {{"1 x 1 x 1", GridGeometry::make(glm::ivec3(56), dvec3(1)), 4.0},
          {"turned 0.4 x 0.4 x 2.5", withColumns({210, 210, 56}, thick), 12.5},
          {"left-handed", withColumns({210, 210, 56}, left), 12.5}};
}

// Axes that are not orthogonal: the slices of a tilted gantry, and all three.
std::vector<Case> shearedBlobs() {
  const dmat3 turned = rotation();
  return {
      {"tilted gantry", withColumns({56, 56, 48}, turned * dmat3(1, 0, 0, 0, 1, 0, 0, 0.4, 1.2)), 5.0},
      {"all sheared", withColumns({48, 48, 48}, turned * dmat3(1, 0.1, 0, 0.2, 1, 0.1, 0.1, -0.2, 1)), 4.0}};
}

// The largest errors of gradient and Hessian, relative to the largest of the smoothed blob.
void expectBlob(const Case& c, double scale, Field field, double bound) {
  const dvec3 last = dvec3(c.geometry.dims - 1);
  const Blob blob{worldOf(c.geometry, 0.5 * last + dvec3(0.3, -0.2, 0.1)), c.deviation};
  const Grid grid = gridOfWorld(c.geometry, blob);
  const ScaledField field_ = scaled(grid, scale, field);
  double gradientOff = 0.0, hessianOff = 0.0, gradientMost = 0.0, hessianMost = 0.0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const dvec3 p = randomPoint(i, 0.3 * last, 0.7 * last);
    const WorldSample found = worldSample(field_, grid, p);
    const WorldSample expected = blob.smoothed(worldOf(c.geometry, p), scale);
    gradientOff = std::max(gradientOff, glm::distance(found.gradient, expected.gradient));
    hessianOff = std::max(hessianOff, largest(found.hessian - expected.hessian));
    gradientMost = std::max(gradientMost, glm::length(expected.gradient));
    hessianMost = std::max(hessianMost, largest(expected.hessian));
  }
  std::printf("%s at %.2f mm: gradient off by %.1e, Hessian by %.1e\n", c.name, scale,
              gradientOff / gradientMost, hessianOff / hessianMost);
  EXPECT_LT(gradientOff, bound * gradientMost) << c.name << ' ' << scale;
  EXPECT_LT(hessianOff, bound * hessianMost) << c.name << ' ' << scale;
}

TEST(ScaledField, DerivativesOfAGaussianBlobAreExact) {
  for (const Case& c : blobs()) {
    const dvec3 spacing = c.geometry.spacingMm();
    const double voxel = std::max({spacing.x, spacing.y, spacing.z});
    for (const double scale : {1.0, 1.37, 2.0})
      for (const Field field : {Field::cubic, Field::cubic_interpolating})
        expectBlob(c, scale * voxel, field, 1e-4);
  }
}

TEST(ScaledField, IsIsotropicInShearedGridsToo) {
  for (const Case& c : shearedBlobs()) expectBlob(c, 1.5, Field::cubic_interpolating, 1e-4);
}

// In steps that float32 keeps exactly, also beside 1e6.
double rampSteps(dvec3 voxel) {
  return glm::dot(voxel, dvec3(0.5, -0.25, 1.0 / 16.0));
}

TEST(ScaledField, ARampIsExactUpToTheBorders) {
  for (const double offset : {0.0, 1e6})
    for (const glm::ivec3& dims :
         {glm::ivec3(40, 30, 20), glm::ivec3(7, 4, 2), glm::ivec3(5, 1, 3), glm::ivec3(1)})
      for (const double scale : {0.05, 0.8, 2.5, 1e6}) {
        const Grid grid =
            gridOfVoxels(test::unitGeometry(dims), [&](dvec3 p) { return offset + rampSteps(p); });
        const ScaledField field = scaled(grid, scale);
        for (std::uint64_t i = 0; i < 300; ++i) {
          dvec3 p = randomPoint(i, dvec3(0), dvec3(dims - 1));
          if (i % 3 == 0) p = glm::round(p);
          if (i % 5 == 0) p.x = 0.0, p.y = dims.y - 1.0;
          const FieldSample s = sampleScaled(field, grid, p);
          const dvec3 slope = dvec3(0.5, -0.25, 1.0 / 16.0) * dvec3(glm::greaterThan(dims, glm::ivec3(1)));
          EXPECT_NEAR(s.value - offset, rampSteps(p), 1e-5);
          EXPECT_LT(glm::distance(s.gradient, slope), 1e-5);
          EXPECT_LT(largest(s.hessian), 1e-5);
        }
      }
}

TEST(ScaledField, ARampIsExactInShearedGrids) {
  for (const Case& c : shearedBlobs()) {
    GridGeometry geometry = c.geometry;
    geometry.dims = {9, 14, 5};
    const Grid grid = gridOfVoxels(geometry, rampSteps);
    const ScaledField field = scaled(grid, 2.0);
    for (std::uint64_t i = 0; i < 300; ++i) {
      const FieldSample s = sampleScaled(field, grid, randomPoint(i, dvec3(0), dvec3(geometry.dims - 1)));
      EXPECT_LT(glm::distance(s.gradient, dvec3(0.5, -0.25, 1.0 / 16.0)), 2e-6) << c.name;
      EXPECT_LT(largest(s.hessian), 2e-6) << c.name;
    }
  }
}

// Point reflections leave the corners and the ramps between them, whatever the Gaussian's size.
TEST(ScaledField, AHugeScaleLeavesTheRampsBetweenTheCorners) {
  const glm::ivec3 dims(12, 9, 10);
  const Grid grid = gridOfVoxels(test::unitGeometry(dims), [](dvec3 p) {
    return base::uniformNoise(7, static_cast<std::uint64_t>(p.x + 20 * p.y + 400 * p.z));
  });
  const ScaledField field = scaled(grid, 1e6);
  for (std::uint64_t i = 0; i < 200; ++i) {
    const dvec3 p = randomPoint(i, dvec3(0), dvec3(dims - 1)), t = p / dvec3(dims - 1);
    double expected = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
      const glm::ivec3 end(corner & 1, corner >> 1 & 1, corner >> 2);
      const dvec3 weight = glm::mix(1.0 - t, t, dvec3(end));
      expected += weight.x * weight.y * weight.z *
                  grid.value(end.x * (dims.x - 1), end.y * (dims.y - 1), end.z * (dims.z - 1));
    }
    EXPECT_NEAR(sampleScaled(field, grid, p).value, expected, 2e-6);
  }
}

double gyroid(dvec3 p) {
  const dvec3 q = p / 3.0;
  return std::sin(q.x) * std::cos(q.y) + std::sin(q.y) * std::cos(q.z) + std::sin(q.z) * std::cos(q.x);
}

TEST(ScaledField, OffsetsAndTinyValuesLoseNothing) {
  const auto steps = [](dvec3 p) { return std::round(16.0 * gyroid(p)) / 16.0; };
  const GridGeometry geometry = test::unitGeometry(glm::ivec3(24));
  const Grid plain = gridOfVoxels(geometry, steps);
  const Grid shifted = gridOfVoxels(geometry, [&](dvec3 p) { return 1e6 + steps(p); });
  const double factor = std::ldexp(1.0, -100);
  const Grid tiny = gridOfVoxels(geometry, [&](dvec3 p) { return factor * steps(p); });
  const ScaledField of[] = {scaled(plain, 1.2), scaled(shifted, 1.2), scaled(tiny, 1.2)};
  for (std::uint64_t i = 0; i < 300; ++i) {
    const dvec3 p = randomPoint(i, dvec3(0), dvec3(23));
    const FieldSample expected = sampleScaled(of[0], plain, p), far = sampleScaled(of[1], shifted, p),
                      small = sampleScaled(of[2], tiny, p);
    EXPECT_NEAR(far.value - 1e6, expected.value, 2e-6);
    EXPECT_LT(glm::distance(far.gradient, expected.gradient), 2e-6);
    EXPECT_LT(largest(far.hessian - expected.hessian), 5e-6);
    EXPECT_LT(glm::distance(small.gradient / factor, expected.gradient), 1e-6);
    EXPECT_LT(largest(small.hessian / factor - expected.hessian), 1e-6);
  }
}

struct Difference {
  double gradient = 0.0, hessian = 0.0;  // RMS, relative to the RMS of the first
};

template <class A, class B>
Difference differenceOf(const A& a, const B& b, dvec3 low, dvec3 high) {
  double gradients = 0.0, hessians = 0.0, gradient = 0.0, hessian = 0.0;
  const auto square = [](const dmat3& m) {
    return glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2]);
  };
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const dvec3 p = randomPoint(i, low, high);
    const FieldSample x = a(p), y = b(p);
    gradients += glm::dot(x.gradient, x.gradient);
    hessians += square(x.hessian);
    gradient += glm::dot(x.gradient - y.gradient, x.gradient - y.gradient);
    hessian += square(x.hessian - y.hessian);
  }
  return {std::sqrt(gradient / gradients), std::sqrt(hessian / hessians)};
}

TEST(ScaledField, IsAllButContinuousTowardScaleZeroAndBetweenScales) {
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(40)), gyroid);
  const Coefficients coefficients = interpolatingCoefficients(grid);
  const auto at = [&](Field field, double scale) {
    return [&grid, of = scaled(grid, scale, field)](dvec3 p) { return sampleScaled(of, grid, p); };
  };
  const auto cubic = [&](dvec3 p) { return sampleCubic(grid, p); };
  const auto interpolating = [&](dvec3 p) { return sampleCubic(coefficients, grid, p); };
  const dvec3 low(8), high(31);
  const Difference differences[] = {
      differenceOf(cubic, at(Field::cubic, 1e-3), low, high),
      differenceOf(interpolating, at(Field::cubic_interpolating, 1e-3), low, high),
      differenceOf(at(Field::cubic, 0.577), at(Field::cubic, 0.578), low, high),
      differenceOf(at(Field::cubic_interpolating, 0.30), at(Field::cubic_interpolating, 0.31), low, high)};
  for (const Difference& d : differences) {
    std::printf("gradients differ by %.4f, Hessians by %.4f\n", d.gradient, d.hessian);
    EXPECT_LT(d.gradient, 0.003);
    EXPECT_LT(d.hessian, 0.02);
  }
}

TEST(ScaledField, MissingVoxelsAreLeftOutAndMatterOnlyNearby) {
  const GridGeometry geometry = test::unitGeometry({64, 24, 24});
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto isGap = [](dvec3 p) {
    return p.x >= 6 && p.x < 14 && p.y >= 6 && p.y < 14 && p.z >= 6 && p.z < 14;
  };
  const Grid whole = gridOfVoxels(geometry, gyroid);
  const Grid gap = gridOfVoxels(geometry, [&](dvec3 p) { return isGap(p) ? nan : gyroid(p); });
  const Grid ramp = gridOfVoxels(geometry, [&](dvec3 p) { return isGap(p) ? nan : rampSteps(p); });
  const ScaledField ofWhole = scaled(whole, 1.5), ofGap = scaled(gap, 1.5), ofRamp = scaled(ramp, 1.5);
  for (const float c : ofGap.coefficients.values) ASSERT_TRUE(std::isfinite(c));
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const dvec3 p = randomPoint(i, dvec3(30, 0, 0), dvec3(63, 23, 23));
    const FieldSample a = sampleScaled(ofWhole, whole, p), b = sampleScaled(ofGap, gap, p);
    EXPECT_LT(glm::distance(a.gradient, b.gradient), 1e-5);
    EXPECT_LT(largest(a.hessian - b.hessian), 1e-5);
  }
  double worst = 0.0;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const dvec3 p = randomPoint(i, dvec3(2), dvec3(18));
    if (isGap(p + 0.999) || isGap(p)) continue;  // a corner of the cell is missing: no surface
    const dvec3 slope(0.5, -0.25, 1.0 / 16.0);
    worst =
        std::max(worst, glm::distance(sampleScaled(ofRamp, ramp, p).gradient, slope) / glm::length(slope));
  }
  std::printf("beside a gap the gradient of a ramp is off by %.3f at most\n", worst);
  EXPECT_LT(worst, 0.35);
}

TEST(ScaledField, VolumesWithHardlyAnyDataHaveNumbers) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const GridGeometry geometry = test::unitGeometry({40, 6, 5});
  const Grid nothing = gridOfVoxels(geometry, [&](dvec3) { return nan; });
  const Grid one = gridOfVoxels(geometry, [&](dvec3 p) { return p == dvec3(3, 2, 2) ? 5.0 : nan; });
  for (const float c : scaled(nothing, 1.0).coefficients.values) EXPECT_EQ(c, 0.0f);
  const ScaledField field = scaled(one, 1.0);
  for (const float c : field.coefficients.values) ASSERT_TRUE(std::isfinite(c));
  EXPECT_NEAR(sampleScaled(field, one, {3, 2, 2}).value, 5.0, 1e-5);
}

TEST(ScaledField, AStopLeavesMostOfTheRestUndone) {
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(160)), [](dvec3 p) {
    const double v = 40.0 - glm::distance(p, dvec3(79.5));
    return v < -20.0 ? std::numeric_limits<double>::quiet_NaN() : v;
  });
  test::expectStopsSoon([&](base::Progress& progress) { scaledField(grid, Field::cubic, 2.0, progress); }, 5);
}

TEST(ScaledField, SaysHowFarItIsAndNoFartherThanTheEnd) {
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(16)), rampSteps);
  base::Progress progress;
  scaledField(grid, Field::cubic, 1.0, progress);
  EXPECT_GT(progress.fraction(), 0.8);
  EXPECT_LE(progress.fraction(), 1.0);
}

// Of one thread, for steps of several may be told in another order. It is looked at from another one, which a
// busy machine may let look seldom: then once more.
TEST(ScaledField, ItsProgressDoesNotGoBack) {
  Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(128)), [](dvec3 p) {
    const double v = 40.0 - glm::distance(p, dvec3(63.5));
    return v < -30.0 ? std::numeric_limits<double>::quiet_NaN() : v;
  });
  const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
  int steps = 0;
  for (int tries = 0; tries < 10 && steps <= 10; ++tries) {
    base::Progress progress;
    std::atomic<bool> ended{false};
    std::jthread work([&] {
      scaledField(grid, Field::cubic, 2.0, progress);
      ended = true;
    });
    double last = 0.0;
    for (steps = 0; !ended; std::this_thread::yield()) {
      const double now = progress.fraction();
      EXPECT_GE(now, last);
      steps += now > last;
      last = now;
    }
  }
  EXPECT_GT(steps, 10);
}

TEST(ScaledField, AsksTheMemoryBudgetAndSaysWhatNeedsLess) {
  const Grid grid = gridOfVoxels(test::unitGeometry(glm::ivec3(16)), rampSteps);
  const std::size_t before = base::machineMemory().held();
  {
    const ScaledField made = scaled(grid, 1.0);
    EXPECT_EQ(base::machineMemory().held(), before + 4 * 16 * 16 * 16);
  }
  EXPECT_EQ(base::machineMemory().held(), before);
  const test::MemoryLimit limit(4 * 16 * 16 * 16 - 1);
  try {
    scaled(grid, 1.0);
    FAIL() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_NE(error.reason().find("derivatives.scale"), std::string::npos) << error.reason();
  }
}

// Of leaning and of thick slices, also where one axis stands alone.
TEST(LatticeLines, SumToTheCovariance) {
  const dmat3 leaning(1, 0.1, 0, 0.2, 1, 0.1, 0.1, -0.2, 1), thick(0.4, 0, 0, 0, 0.4, 0, 0, 1.1, 5.0);
  for (const dmat3& axes : {leaning, thick, dmat3(1), leaning * dmat3(1, 0.9, 0, 0, 1, 0.8, 0, 0, 1)})
    for (const bool singular : {false, true}) {
      dmat3 covariance = 4.0 * glm::inverse(glm::transpose(axes) * axes);
      if (singular)
        for (int i = 0; i < 3; ++i) covariance[i][0] = covariance[0][i] = 0.0;
      const std::vector<LatticeLine> lines = latticeLines(covariance);
      EXPECT_LE(lines.size(), 6u);
      dmat3 sum(0.0);
      for (const LatticeLine& line : lines) {
        EXPECT_GT(line.variance, 0.0);
        sum += line.variance * glm::outerProduct(dvec3(line.step), dvec3(line.step));
      }
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) EXPECT_NEAR(sum[i][j], covariance[i][j], 1e-7);
    }
}

}  // namespace
}  // namespace isolux::volume
