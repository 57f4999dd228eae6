// What parts of a surface have which curvature, against closed forms of balls, tori and planes.
#include "volume/measure/curvature_distribution.h"

#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include <gtest/gtest.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/support/volumes.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::test {
namespace {

using scene::LookMode;
using volume::CurvatureDistribution;
using volume::CurvatureHistogram;

constexpr double kPi = std::numbers::pi;

CurvatureDistribution distributionOf(volume::Grid grid, const volume::CurvaturePart& part = {},
                                     double noise = 0.0, double scaleMm = 0.0) {
  base::Progress progress;
  const auto volume = isolux::test::prepared(std::move(grid));
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.derivatives.noise = noise;
  scene.derivatives.scale = scaleMm;
  const auto pieces = volume->pieces->at(0.0, scene::Inside::above, progress);
  return curvatureDistribution(*volume, scene, *pieces, part, progress);
}

const CurvatureHistogram& of(const CurvatureDistribution& distribution, LookMode measure) {
  for (const CurvatureHistogram& histogram : distribution.measures)
    if (histogram.measure == measure) return histogram;
  throw std::logic_error("no such measure");
}

double sumOf(const CurvatureHistogram& histogram) {
  return std::accumulate(histogram.areasMm2.begin(), histogram.areasMm2.end(),
                         histogram.belowMm2 + histogram.aboveMm2);
}

volume::GridGeometry obliqueGeometry(glm::ivec3 dims) {
  volume::GridGeometry geometry = unitGeometry(dims);
  const glm::dvec3 x = 0.8 * glm::normalize(glm::dvec3(0.9, 0.3, 0.1)),
                   y = 1.1 * glm::normalize(glm::cross(glm::dvec3(0.0, 0.2, 1.0), x));
  const glm::dvec3 z = -1.3 * glm::normalize(glm::cross(x, y));  // left-handed
  geometry.worldFromVoxel = glm::dmat4(glm::dvec4(x, 0.0), glm::dvec4(y, 0.0), glm::dvec4(z, 0.0),
                                       glm::dvec4(3.0, -40.0, 7.0, 1.0));
  return geometry;
}

// f = R - |p - centre|, at the world's points.
volume::Grid ball(const volume::GridGeometry& geometry, double radius) {
  const glm::dvec3 centre(geometry.worldFromVoxel * glm::dvec4(0.5 * glm::dvec3(geometry.dims - 1), 1.0));
  return gridOfWorld(geometry, [&](glm::dvec3 world) { return radius - glm::length(world - centre); });
}

TEST(CurvatureDistributionTest, ABallHasOneCurvature) {
  constexpr double radius = 18.0;
  for (const volume::GridGeometry& geometry : {unitGeometry({56, 56, 56}), obliqueGeometry({64, 56, 48})}) {
    const CurvatureDistribution found = distributionOf(ball(geometry, radius));
    EXPECT_NEAR(found.areaMm2, 4.0 * kPi * radius * radius, 0.003 * found.areaMm2);
    EXPECT_EQ(found.unknownMm2, 0.0);
    EXPECT_EQ(found.clearMm2, found.areaMm2);
    EXPECT_NEAR(found.gaussianIntegral, 4.0 * kPi, 0.01 * 4.0 * kPi);
    EXPECT_NEAR(found.meanIntegralMm, 4.0 * kPi * radius, 0.005 * 4.0 * kPi * radius);
    for (const LookMode measure :
         {LookMode::kappa1, LookMode::kappa2, LookMode::mean_curvature, LookMode::curvedness}) {
      const CurvatureHistogram& histogram = of(found, measure);
      EXPECT_NEAR(histogram.median * radius, 1.0, 0.01);
      EXPECT_LT(histogram.deviation * radius, 0.02);
      EXPECT_NEAR(sumOf(histogram), found.areaMm2, 1e-9 * found.areaMm2);
    }
    EXPECT_GT(of(found, LookMode::shape_index).low5, 0.95);
  }
}

// Area of a torus by its angle t about the tube: (R + r cos t) r dt dp; kappa1 = 1 / r, kappa2 = cos t / (R +
// r cos t).
TEST(CurvatureDistributionTest, ATorusHasTheDistributionOfItsFormula) {
  constexpr double R = 20.0, r = 8.0;
  const CurvatureDistribution found =
      distributionOf(gridOfVoxels(unitGeometry({72, 72, 32}), [](glm::dvec3 voxel) {
        const glm::dvec3 p = voxel - glm::dvec3(35.3, 35.6, 15.4);
        return r - std::hypot(std::hypot(p.x, p.y) - R, p.z);
      }));
  EXPECT_NEAR(found.areaMm2, 4.0 * kPi * kPi * R * r, 0.005 * found.areaMm2);
  EXPECT_NEAR(found.gaussianIntegral, 0.0, 0.1);
  EXPECT_NEAR(of(found, LookMode::kappa1).median * r, 1.0, 0.02);
  // Which part of the area has kappa2 below a value: by the angle at which it has it.
  const CurvatureHistogram& kappa2 = of(found, LookMode::kappa2);
  for (const auto& [part, value] :
       {std::pair(0.05, kappa2.low5), std::pair(0.25, kappa2.low25), std::pair(0.5, kappa2.median),
        std::pair(0.75, kappa2.high75), std::pair(0.95, kappa2.high95)}) {
    const double cosine = value * R / (1.0 - value * r), t = std::acos(glm::clamp(cosine, -1.0, 1.0));
    const double below = ((kPi - t) * R - r * std::sin(t)) / (kPi * R);
    EXPECT_NEAR(below, part, 0.02);
  }
  double negative = 0.0;  // the inner half
  for (std::size_t bin = 0; bin < kappa2.areasMm2.size(); ++bin)
    if (kappa2.low + (static_cast<double>(bin) + 0.5) * kappa2.step < 0.0) negative += kappa2.areasMm2[bin];
  EXPECT_NEAR((negative + kappa2.belowMm2) / kappa2.areaMm2, 0.5 - r / (kPi * R), 0.03);
}

TEST(CurvatureDistributionTest, PartsAreWhatTheyAreOf) {
  const auto two = [] {
    return gridOfVoxels(unitGeometry({64, 32, 32}), [](glm::dvec3 p) {
      return std::max(6.0 - glm::length(p - glm::dvec3(11.2, 15.3, 15.1)),
                      12.0 - glm::length(p - glm::dvec3(45.1, 15.4, 15.6)));
    });
  };
  const CurvatureDistribution all = distributionOf(two()), small = distributionOf(two(), {{false, true}, {}}),
                              boxed = distributionOf(
                                  two(),
                                  {{}, volume::WorldBox{glm::dvec3(30.0, -1.0, -1.0), glm::dvec3(99.0)}});
  EXPECT_NEAR(of(small, LookMode::kappa1).median, 1.0 / 6.0, 0.01);
  EXPECT_NEAR(of(boxed, LookMode::kappa1).median, 1.0 / 12.0, 0.005);
  EXPECT_NEAR(small.areaMm2 + boxed.areaMm2, all.areaMm2, 1e-9 * all.areaMm2);
  EXPECT_NEAR(all.gaussianIntegral, 8.0 * kPi, 0.2);
}

// A plane under noise: all that is found is noise, and what is stated of it is what it is.
TEST(CurvatureDistributionTest, NoiseIsStatedAndFlatIsNotTakenForCurved) {
  constexpr double noise = 0.05, scaleMm = 1.5;
  std::mt19937 random(7);
  std::normal_distribution<double> normal(0.0, noise);
  const CurvatureDistribution found = distributionOf(
      gridOfVoxels(unitGeometry({48, 48, 24}), [&](glm::dvec3 p) { return p.z - 11.3 + normal(random); }), {},
      noise, scaleMm);
  EXPECT_LT(found.clearMm2, 0.1 * found.areaMm2);
  // The mean of both curvatures of white noise: sums of two second derivatives that hang together by a third.
  const double expected = found.noise * std::sqrt(2.0 / 3.0);
  EXPECT_NEAR(of(found, LookMode::mean_curvature).deviation, expected, 0.2 * expected);
  EXPECT_LT(of(found, LookMode::shape_index).areaMm2, 0.1 * found.areaMm2);
}

TEST(CurvatureDistributionTest, NoSurfaceHasNone) {
  const CurvatureDistribution found =
      distributionOf(gridOfVoxels(unitGeometry({8, 8, 8}), [](glm::dvec3) { return -1.0; }));
  EXPECT_EQ(found.areaMm2, 0.0);
  EXPECT_TRUE(of(found, LookMode::kappa1).areasMm2.empty());
}

}  // namespace
}  // namespace isolux::test
