// What noise makes of normals at a scale, judged by the Gaussian's closed forms.
#include "app/study/scale_study.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace isolux::app {
namespace {

constexpr double kPi = std::numbers::pi;

// Points of the plane 2x + 3y + 6z = 0 well within the volume, world = voxel - middle.
std::vector<glm::dvec3> pointsOfPlane(int size) {
  const double middle = 0.5 * (size - 1);
  std::vector<glm::dvec3> points;
  for (int i = -9; i <= 9; ++i)
    for (int j = -9; j <= 9; ++j) {
      const double x = 1.1 * i, y = 1.3 * j;
      points.push_back(middle + glm::dvec3(x, y, -(2.0 * x + 3.0 * y) / 6.0));
    }
  return points;
}

struct Plane {
  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;
};

Plane planeOf(int size) {
  Plane plane;
  plane.scene.source.path = "phantom:plane:" + std::to_string(size);
  base::Progress progress;
  plane.volume = volume::loadVolume(plane.scene.source, progress);
  plane.scene.surfaces.front().value = 0.0;
  return plane;
}

double degrees(double radians) {
  return radians * 180.0 / kPi;
}

// A derivative of a Gaussian's convolution with white noise of variance 1 has the variance 1 / (16 pi^1.5
// s^5); two of them tilt a normal whose gradient is 1 mm per mm.
TEST(ScaleStudy, NormalsOfANoisyPlaneTiltAsTheGaussianLetsThem) {
  const Plane plane = planeOf(48);
  ScaleStudyRunner studio(plane.volume, plane.scene, pointsOfPlane(48), {});
  EXPECT_TRUE(studio.isPhantom());
  EXPECT_NEAR(studio.deviation(), kPhantomNoiseVoxels, 1e-6);
  base::Progress progress;
  double before = degrees(1.0);
  for (const double scale : {1.0, 1.5, 2.0}) {
    const double slope = studio.deviation() / std::sqrt(16.0 * std::pow(kPi, 1.5) * std::pow(scale, 5.0));
    const NoiseErrors errors = studio.at(scale, progress).errors;
    EXPECT_EQ(errors.normalDegrees.pixels, 19u * 19u * kNoiseSeeds);
    EXPECT_NEAR(errors.normalDegrees.rms, degrees(std::sqrt(2.0) * slope), 0.12 * degrees(slope)) << scale;
    EXPECT_LT(errors.normalDegrees.rms, before);
    before = errors.normalDegrees.rms;
  }
}

// Blurred by b before, at variance 1: b^3 / (2 S^5) with S^2 = s^2 + b^2.
TEST(ScaleStudy, AScanGetsNoiseLikeItsOwn) {
  Plane plane = planeOf(48);
  plane.scene.source.path = "scan.nii";
  scene::NoiseModel noise;
  noise.values = {0.0};
  noise.deviations = {0.2};
  noise.correlation = glm::dvec3(1.5);
  ScaleStudyRunner studio(plane.volume, plane.scene, pointsOfPlane(48), noise);
  EXPECT_FALSE(studio.isPhantom());
  EXPECT_EQ(studio.deviation(), 0.2);
  base::Progress progress;
  const double whole = std::sqrt(2.0 * 2.0 + 1.5 * 1.5);
  const double slope = 0.2 * std::sqrt(std::pow(1.5, 3.0) / (2.0 * std::pow(whole, 5.0)));
  EXPECT_NEAR(studio.at(2.0, progress).errors.normalDegrees.rms, degrees(std::sqrt(2.0) * slope),
              0.25 * degrees(slope));
}

TEST(ScaleStudy, OfAPhantomWhatSmoothingTakesCounts) {
  Plane torus;
  torus.scene.source.path = "phantom:torus:64";
  torus.scene.surfaces.front().value = 0.0;
  base::Progress progress;
  torus.volume = volume::loadVolume(torus.scene.source, progress);
  const double edge = 63.0, middle = 31.5;
  std::vector<glm::dvec3>
      points;  // the ring of least distance from the axis, where curvatures differ in sign
  for (int i = 0; i < 50; ++i) {
    const double angle = 2.0 * kPi * i / 50.0;
    points.push_back(middle + 0.15 * edge * glm::dvec3(std::cos(angle), std::sin(angle), 0.0));
  }
  ScaleStudyRunner studio(torus.volume, torus.scene, points, {});
  const double noisy = studio.at(0.0, progress).errors.curvature.median;
  const double best = studio.at(2.0, progress).errors.curvature.median;
  const double washed = studio.at(6.0, progress).errors.curvature.median;
  EXPECT_LT(best, 0.7 * noisy);
  EXPECT_LT(best, 0.7 * washed);
}

TEST(ScaleStudy, Stops) {
  const Plane plane = planeOf(48);
  ScaleStudyRunner studio(plane.volume, plane.scene, pointsOfPlane(48), {});
  base::Progress progress;
  progress.requestStop();
  EXPECT_THROW(studio.at(1.0, progress), base::Error);
}

}  // namespace
}  // namespace isolux::app
