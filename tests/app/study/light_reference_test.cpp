// The path-traced truth of the study, against closed forms. Nothing here needs GL.
#include "app/study/light_reference.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "scene/rules/automatic.h"

namespace isolux::app {
namespace {

// Inside is below a plane through the middle that is tilted by this angle about x.
std::shared_ptr<const volume::PreparedVolume> tiltedPlane(double degrees) {
  const double angle = degrees * std::numbers::pi / 180.0;
  const glm::dvec3 normal(0.0, std::sin(angle), std::cos(angle));
  return test::prepared(test::gridOfVoxels(test::unitGeometry(glm::ivec3(16)),
                                           [&](glm::dvec3 voxel) { return -glm::dot(normal, voxel - 7.5); }));
}

struct Subject {
  scene::Scene scene;
  std::shared_ptr<const volume::PreparedVolume> volume;
  std::shared_ptr<const gi::LightScene> light;
};

Subject subjectOf(std::shared_ptr<const volume::PreparedVolume> volume,
                  std::shared_ptr<const gi::Environment> environment, scene::Scene scene = {}) {
  base::Progress progress;
  scene.look.mode = scene::LookMode::gi;
  scene.gi.mode = scene::GiMode::irradiance;
  scene.gi.sequence = scene::DirectionSequence::sobol_owen;
  scene.light.environment.constant = environment->mean();
  if (!environment->isConstant()) scene.light.environment.file = "of this test";
  scene = scene::resolve(scene, volume->facts);
  auto tracer = std::make_shared<const volume::IsosurfaceTracer>(volume->volume.grid, scene.isosurface.inside,
                                                                 progress);
  return {scene, volume, gi::makeLightScene(scene, volume, tracer, environment)};
}

LightReference referenceOf(const Subject& subject, std::size_t points, const LightReferenceOptions& options,
                           glm::dvec3 skyScale = glm::dvec3(1.0)) {
  base::Progress progress;
  const std::vector<glm::vec3> voxels(points, glm::vec3(7.5f));
  std::vector<std::size_t> pixels(points);
  for (std::size_t i = 0; i < points; ++i) pixels[i] = i;
  return lightReferenceAt(subject.light, skyScale, 0.0f, voxels, pixels, options, progress);
}

std::shared_ptr<const gi::Environment> brightAbove() {
  std::vector<glm::vec3> pixels(16, glm::vec3(0.0f));
  std::fill_n(pixels.begin(), 8, glm::vec3(1.0f));
  return std::make_shared<const gi::Environment>(8, 2, std::move(pixels));
}

// E = pi (1 + cos tilt) / 2 under a sky that is bright above the horizon: each of 300 points is an estimate
// of its own. Their errors are as large as their standard errors say, and not larger.
TEST(LightReference, AHalfBrightSkyOnATiltedPlaneIsMetWithinTheNoiseItTells) {
  scene::Scene scene;
  scene.gi.environmentShare = 0.0;  // otherwise there is no noise
  const Subject subject = subjectOf(tiltedPlane(40.0), brightAbove(), scene);
  const double expected = std::numbers::pi * (1.0 + std::cos(40.0 * std::numbers::pi / 180.0)) / 2.0;
  for (const std::uint32_t samples : {16u, 256u}) {
    const LightReference reference = referenceOf(subject, 300, {samples, samples, 0.0});
    ASSERT_EQ(reference.pixels.size(), 300u);
    EXPECT_EQ(reference.samples, std::uint64_t{samples} * kReplicates);
    EXPECT_EQ(reference.rays, 300 * reference.samples);
    const LightErrors errors =
        lightErrorsOf(std::vector<float>(900, static_cast<float>(expected)), reference);
    EXPECT_GT(errors.truthNoise, 0.0);
    EXPECT_LT(std::abs(errors.bias), 4.5 * errors.biasStandardError);
    const double upper = errors.rmse + errors.rmseStandardError;
    EXPECT_LE(errors.rmse * errors.rmse, 4.5 * (upper * upper - errors.rmse * errors.rmse))
        << "what is left beside the noise is none";
    // The other way round: the noise that was told is not too large.
    double square = 0.0, difference = 0.0, differences = 0.0;
    for (std::size_t i = 0; i < 300; ++i) {
      const double apart = reference.irradiance[i].x - expected;
      square = apart * apart - reference.variance[i].x;
      difference += square;
      differences += square * square;
    }
    EXPECT_GT(difference, -4.5 * std::sqrt(differences));
  }
}

TEST(LightReference, MorePathsAreTracedUntilTheNoiseIsSmallEnough) {
  scene::Scene scene;
  scene.gi.environmentShare = 0.0;
  const Subject subject = subjectOf(tiltedPlane(40.0), brightAbove(), scene);
  const LightReference rough = referenceOf(subject, 50, {16, 4096, 0.05});
  const LightReference fine = referenceOf(subject, 50, {16, 4096, 0.001});
  const std::vector<float> none(150, 0.0f);
  const LightErrors ofRough = lightErrorsOf(none, rough), ofFine = lightErrorsOf(none, fine);
  EXPECT_LE(ofRough.relative(ofRough.truthNoise), 0.05);
  EXPECT_LE(ofFine.relative(ofFine.truthNoise), 0.001);
  EXPECT_GT(fine.samples, rough.samples);
  EXPECT_LT(fine.samples, 4096u * kReplicates);
  EXPECT_EQ(referenceOf(subject, 50, {16, 64, 1e-9}).samples, 64u * kReplicates) << "but not for ever";
}

TEST(LightReference, AConstantSkyGivesPiTimesItsRadiance) {
  const auto sky = std::make_shared<const gi::Environment>(gi::Environment::constant(glm::dvec3(1.0)));
  const Subject subject = subjectOf(tiltedPlane(70.0), sky);
  const LightReference reference = referenceOf(subject, 3, {16, 16, 0.0}, {2.0, 1.0, 0.5});
  for (const glm::dvec3& e : reference.irradiance)
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(e[channel], (2.0 - 1.5 * (channel == 2) - (channel == 1)) * std::numbers::pi, 1e-5);
  for (const glm::dvec3& variance : reference.variance) EXPECT_LT(variance.x, 1e-12);
}

TEST(LightReference, PointsWithoutANormalAreLeftOut) {
  base::Progress progress;
  const auto sky = std::make_shared<const gi::Environment>(gi::Environment::constant(glm::dvec3(1.0)));
  const auto geometry = volume::GridGeometry::make(glm::ivec3(8), glm::dvec3(1.0), glm::dvec3(0.0));
  const Subject subject =
      subjectOf(test::prepared(volume::Grid(geometry, std::vector<float>(512, 1.0f))), sky);
  const std::vector<glm::vec3> voxels{glm::vec3(3.0f)};
  const std::vector<std::size_t> pixels{5};
  const LightReference reference =
      lightReferenceAt(subject.light, glm::dvec3(1.0), 1.0f, voxels, pixels, {16, 16, 0.0}, progress);
  EXPECT_TRUE(reference.pixels.empty() && reference.irradiance.empty() && reference.variance.empty());
}

TEST(LightReference, AStopEndsIt) {
  base::Progress progress;
  const Subject subject = subjectOf(tiltedPlane(40.0), brightAbove());
  progress.requestStop();
  const std::vector<glm::vec3> voxels{glm::vec3(7.5f)};
  const std::vector<std::size_t> pixels{0};
  EXPECT_THROW(lightReferenceAt(subject.light, glm::dvec3(1.0), 0.0f, voxels, pixels, {}, progress),
               base::Error);
}

TEST(ChosenPixels, AreHitsSpreadOverAllOfThem) {
  std::vector<bool> hit(10000, false);
  for (std::size_t i = 0; i < hit.size(); i += 2) hit[i] = true;
  const std::vector<std::size_t> chosen = chosenPixels(hit, 100);
  ASSERT_EQ(chosen.size(), 100u);
  for (std::size_t i = 0; i < chosen.size(); ++i) {
    EXPECT_TRUE(hit[chosen[i]]);
    EXPECT_EQ(chosen[i] / 100, i) << "one of each hundredth";
  }
  EXPECT_EQ(chosenPixels(hit, 6000).size(), 5000u);
  EXPECT_TRUE(chosenPixels(std::vector<bool>(9, false), 4).empty());
}

}  // namespace
}  // namespace isolux::app
