// The path-traced picture against closed forms, and that it does not depend on how it is made.
#include "gi/reference/reference.h"
#include "base/color.h"
#include "tests/support/cut_ball.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "gi/sampling/lamp_sampling.h"
#include "scene/rules/automatic.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/lamps.h"
#include "tests/support/surfaces.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;

using std::numbers::pi;

class ReferencePicture : public ::testing::Test {
 protected:
  void use(std::shared_ptr<const volume::PreparedVolume> volume, double isovalue = 0.0) {
    volume_ = std::move(volume);
    scene_.surfaces.front().value = isovalue;
    if (!scene_.light.environment.constant) scene_.light.environment.constant = glm::dvec3(1.0);
    scene_ = scene::resolve(scene_, volume_->facts);
  }
  Reference make(int threads = 2, glm::ivec2 size = {24, 20}) {
    const auto tracer =
        std::make_shared<volume::IsosurfaceTracer>(volume_->volume.grid, scene_.isosurface.inside, progress_);
    tracer->cut(volume::SurfaceCut(scene_, volume_->grid().geometry()));
    if (!environment_) environment_ = loadEnvironment(scene_.light.environment);
    return Reference(volume_, tracer, environment_, scene_, {size, threads}, progress_);
  }
  ReferenceImage draw(std::uint32_t samples, int threads = 2) {
    Reference reference = make(threads);
    EXPECT_TRUE(reference.refineTo(samples, progress_));
    return reference.image();
  }

  base::Progress progress_;
  scene::Scene scene_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
  std::shared_ptr<const Environment> environment_;
};

TEST_F(ReferencePicture, ABallUnderAnEvenSkyIsEvenlyLit) {
  scene_.light.environment.constant = glm::dvec3(0.5, 1.0, 2.0);
  scene_.light.environment.exposure = 1.0;
  scene_.surfaces.front().albedo = {0.8, 0.4, 0.2};
  scene_.picture.exposure = -2.0;
  use(test::phantom("ball", 40));
  const ReferenceImage image = draw(5);
  int hits = 0;
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    if (!image.hit[i]) {
      EXPECT_TRUE(std::isnan(image.irradiance[i].x) && std::isnan(image.color[i].y) &&
                  std::isnan(image.variance[i]));
      continue;
    }
    ++hits;
    EXPECT_EQ(image.samples[i], 5u);
    EXPECT_LT(image.variance[i], 1e-9f);
    for (int channel = 0; channel < 3; ++channel) {
      const double radiance = (*scene_.light.environment.constant)[channel] * 2.0;
      EXPECT_NEAR(image.irradiance[i][channel], pi * radiance, 1e-4);
      EXPECT_NEAR(image.color[i][channel], scene_.surfaces.front().albedo[channel] * radiance / 4.0, 1e-4);
    }
  }
  EXPECT_GT(hits, 50);
  EXPECT_EQ(image.cappedPaths, 0u);
}

// A lamp behind the viewer: what faces it has E = pi intensity cos of the ball's own normal.
TEST_F(ReferencePicture, ALampLightsByTheCosine) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::directional;
  test::lampAt(scene_, 0).direction = {0.2, -1.0, 0.3};
  test::lampAt(scene_, 0).intensity = 1.5;
  scene_.gi.bounces = 3;
  use(test::phantom("ball", 40));
  const ReferenceImage image = draw(4);
  const PrimaryHits hits(volume_, scene_, image.size, progress_);
  const glm::dvec3 toward = glm::normalize(test::lampAt(scene_, 0).direction);
  for (int y = 0; y < image.size.y; ++y) {
    for (int x = 0; x < image.size.x; ++x) {
      const auto hit = hits.at({x, y});
      const auto i = static_cast<std::size_t>(y * image.size.x + x);
      ASSERT_EQ(hit.has_value(), image.hit[i] != 0);
      if (!hit) continue;
      const glm::dvec3 out = glm::normalize(hit->voxel - 19.5);  // the ball phantom's middle
      EXPECT_NEAR(image.irradiance[i].x, pi * 1.5 * std::max(0.0, glm::dot(out, toward)), 0.02);
      EXPECT_EQ(image.variance[i], 0.0f);
    }
  }
}

// On a noisy ball the cosine is that of normals at derivatives.normal_scale.
TEST_F(ReferencePicture, NormalsAreAtTheScaleThatTheSceneNames) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::directional;
  test::lampAt(scene_, 0).direction = {0.2, -1.0, 0.3};
  scene_.gi.bounces = 0;
  use(test::prepared(test::withNoise(test::phantomGrid("ball", 40), 0.1, glm::dvec3(0.0), 4)));
  const glm::dvec3 toward = glm::normalize(test::lampAt(scene_, 0).direction);
  const auto squareError = [&](double normalScale) {
    scene_.derivatives.normalScale = normalScale;
    const ReferenceImage image = draw(1);
    const PrimaryHits hits(volume_, scene_, image.size, progress_);
    double sum = 0.0;
    int count = 0;
    for (int y = 0; y < image.size.y; ++y)
      for (int x = 0; x < image.size.x; ++x) {
        const auto hit = hits.at({x, y});
        const double cosine = hit ? glm::dot(glm::normalize(hit->voxel - 19.5), toward) : 0.0;
        const auto i = static_cast<std::size_t>(y * image.size.x + x);
        if (cosine < 0.5 || image.irradiance[i].x == 0.0f) continue;  // beside the light, or behind a bump
        sum += std::pow(image.irradiance[i].x / (pi * test::lampAt(scene_, 0).intensity) - cosine, 2);
        ++count;
      }
    EXPECT_GT(count, 30);
    return sum / count;
  };
  const double plain = squareError(0.0), scaled = squareError(2.0);
  EXPECT_LT(std::sqrt(scaled), 0.05);
  EXPECT_GT(plain, 4.0 * scaled);
}

TEST_F(ReferencePicture, ThreadsAndRoundsDoNotChangeIt) {
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::sphere;
  scene_.gi.bounces = 2;
  use(test::phantom("gyroid", 32));
  const ReferenceImage one = draw(12, 1), three = draw(12, 3);
  EXPECT_EQ(one.rays, three.rays);
  for (std::size_t i = 0; i < one.hit.size(); ++i) {
    if (!one.hit[i]) continue;
    EXPECT_EQ(one.irradiance[i], three.irradiance[i]);
    EXPECT_EQ(one.variance[i], three.variance[i]);
  }
  Reference rounds = make();
  for (const std::uint32_t samples : {1u, 4u, 5u, 12u}) ASSERT_TRUE(rounds.refineTo(samples, progress_));
  const ReferenceImage image = rounds.image();
  EXPECT_EQ(image.rays, one.rays);
  for (std::size_t i = 0; i < one.hit.size(); ++i) {
    if (!one.hit[i]) continue;
    EXPECT_EQ(image.samples[i], one.samples[i]);
    EXPECT_NEAR(image.irradiance[i].x, one.irradiance[i].x, 1e-5f * one.irradiance[i].x);
    EXPECT_NEAR(image.variance[i], one.variance[i], 1e-4f * one.variance[i] + 1e-12f);
  }
}

// Independent pictures differ by what their variances say: the sum of z^2 over pixels is that of chi^2.
TEST_F(ReferencePicture, VariancesAreThoseOfThePicture) {
  scene_.gi.sequence = scene::DirectionSequence::random;
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::sphere;
  environment_ = environmentOf(16, 8, [](glm::dvec3 d) { return d.z > 0.3 ? 2.0 : 0.5; });
  scene_.light.environment.file = "probe.hdr";
  use(test::phantom("gyroid", 32));
  const ReferenceImage noisy = draw(200), truth = draw(6000);
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < noisy.hit.size(); ++i) {
    if (!noisy.hit[i] || !(noisy.variance[i] > 0.0f)) continue;
    // The first 200 of the 6000 samples are the same: the difference varies by v (1 - 200 / 6000).
    const double apart = static_cast<double>(base::luminance(noisy.irradiance[i])) -
                         static_cast<double>(base::luminance(truth.irradiance[i]));
    sum += apart * apart / (static_cast<double>(noisy.variance[i]) * (1.0 - 200.0 / 6000.0));
    ++count;
  }
  ASSERT_GT(count, 100);
  EXPECT_NEAR(sum / count, 1.0, 4.5 * std::sqrt(2.0 / count) * 1.3);  // estimates of variances vary too
}

TEST_F(ReferencePicture, TheEnvironmentIsSeenBehindTheSurface) {
  environment_ = environmentOf(64, 32, [](glm::dvec3 d) { return 2.0 + d.x + d.z; });
  scene_.light.environment.file = "probe.hdr";
  scene_.light.environment.visible = true;
  scene_.picture.exposure = 1.0;
  use(test::phantom("ball", 24));
  const ReferenceImage image = draw(1);
  const PrimaryHits hits(volume_, scene_, image.size, progress_);
  int seen = 0;
  for (int y = 0; y < image.size.y; ++y) {
    for (int x = 0; x < image.size.x; ++x) {
      const auto i = static_cast<std::size_t>(y * image.size.x + x);
      if (image.hit[i]) continue;
      ++seen;
      const glm::vec3 d = hits.direction({x, y});
      EXPECT_NEAR(image.color[i].x, 2.0f * (2.0f + d.x + d.z), 0.3f);
      EXPECT_TRUE(std::isnan(image.irradiance[i].x));
    }
  }
  EXPECT_GT(seen, 50);
}

// From inside a closed ball: nothing of the sky is seen.
TEST_F(ReferencePicture, TheInnerSideOfAClosedBallIsDark) {
  use(test::phantom("ball", 40));
  scene_.camera.eye = volume_->facts.boundsMinMm * 0.5 + volume_->facts.boundsMaxMm * 0.5;
  scene_.camera.target = *scene_.camera.eye + glm::dvec3(0.0, 1.0, 0.0);
  const ReferenceImage image = draw(64);
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    ASSERT_EQ(image.hit[i], 1);
    EXPECT_EQ(image.samples[i], 64u);
    EXPECT_EQ(image.irradiance[i], glm::vec3(0.0f));
  }
}

// A lamp within it lights it all the same: E = pi intensity, less what the distance takes.
TEST_F(ReferencePicture, ALampInsideLightsTheInnerSide) {
  scene_.light.environment.constant = glm::dvec3(0.0);
  test::lampAt(scene_, 0).shown = true;
  test::lampAt(scene_, 0).kind = scene::LampKind::point;
  use(test::phantom("ball", 40));
  scene_.camera.eye = volume_->facts.boundsMinMm * 0.5 + volume_->facts.boundsMaxMm * 0.5;
  scene_.gi.bounces = 0;
  test::lampAt(scene_, 0).position = scene_.camera.eye;
  scene_.camera.target = *scene_.camera.eye + glm::dvec3(0.0, 1.0, 0.0);
  const LampLight lamp = lampsOf(scene_, volume_->grid().geometry()).front();
  const PrimaryHits hits(volume_, scene_, {24, 20}, progress_);
  const ReferenceImage image = draw(1);
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    const auto hit = hits.at({static_cast<int>(i) % 24, static_cast<int>(i) / 24});
    ASSERT_TRUE(hit && !hit->outer);
    const glm::dvec3 world(volume_->grid().geometry().worldFromVoxel * glm::dvec4(hit->voxel, 1.0));
    const glm::dvec3 way = world - lamp.positionMm;
    EXPECT_NEAR(image.irradiance[i].x / (lamp.power.x / glm::dot(way, way)), 1.0, 2e-3);
  }
}

// Cut open by the volume's border, whichever side is inside.
TEST_F(ReferencePicture, BothSidesOfACutBallHaveTheirClosedForms) {
  const CutBall ball;
  constexpr std::uint32_t samples = 1600;
  for (const scene::Inside inside : {scene::Inside::above, scene::Inside::below})
    for (const int bounces : {0, 1, 3}) {
      scene_ = {};
      scene_.isosurface.inside = inside;
      scene_.surfaces.front().albedo = glm::dvec3(0.6);
      scene_.look.innerTint = {1.0, 0.5, 0.25};
      scene_.gi.bounces = bounces;
      scene_.picture.exposure = 0.0;
      scene_.camera.eye = ball.middle + glm::dvec3(3.0, -2.0, 60.0);
      scene_.camera.target = ball.middle;
      scene_.camera.up = glm::dvec3(0.0, 1.0, 0.0);
      use(ball.volume(inside == scene::Inside::above ? 1.0 : -1.0));
      const ReferenceImage image = draw(samples);
      const PrimaryHits hits(volume_, scene_, image.size, progress_);
      double seen[2] = {}, sum[2] = {};
      for (std::size_t i = 0; i < image.hit.size(); ++i) {
        const auto hit = hits.at({static_cast<int>(i) % image.size.x, static_cast<int>(i) / image.size.x});
        if (!hit) continue;
        ASSERT_EQ(image.samples[i], samples);
        const double e = image.irradiance[i].x, expected = ball.innerIrradiance(0.6, bounces);
        ++seen[hit->outer ? 0 : 1];
        sum[hit->outer ? 0 : 1] += e;
        EXPECT_NEAR(e, hit->outer ? pi : expected, hit->outer ? 0.03 : 0.1 * pi) << i;
        const glm::dvec3 tint = hit->outer ? glm::dvec3(1.0) : scene_.look.innerTint;
        EXPECT_NEAR(image.color[i].z, 0.6 * tint.z * e / pi, 1e-5);
      }
      ASSERT_GT(seen[0], 10.0);
      ASSERT_GT(seen[1], 40.0);
      // Of all pixels, each with a pattern of its own, the noise is 0.3 %; rays start 0.1 mm off the surface.
      EXPECT_NEAR(sum[1] / seen[1] / ball.innerIrradiance(0.6, bounces), 1.0, 0.015) << bounces;
    }
}

// Cut open by a plane instead: the same closed forms, with the lid beyond it gone from light and picture.
TEST_F(ReferencePicture, ABallThatAPlaneCutsOpenHasTheSameClosedForms) {
  const CutBall ball;
  const auto whole = prepared(gridOfWorld(unitGeometry(glm::ivec3(37)), [&](glm::dvec3 p) {
    return glm::length(p - ball.middle) - ball.radius;
  }));
  constexpr std::uint32_t samples = 1600;
  for (const int bounces : {0, 2}) {
    scene_ = {};
    scene_.surfaces.front().albedo = glm::dvec3(0.6);
    scene_.gi.bounces = bounces;
    scene_.camera.eye = ball.middle + glm::dvec3(3.0, -2.0, 60.0);
    scene_.camera.target = ball.middle;
    scene_.camera.up = glm::dvec3(0.0, 1.0, 0.0);
    scene_.clip.planes = {{{0.0, 0.0, ball.dims.z - 1.0}, {0.0, 0.0, 1.0}}};
    scene_.clip.cap = scene::ClipCap::none;
    use(whole);
    const ReferenceImage image = draw(samples);
    const PrimaryHits hits(volume_, scene_, image.size, progress_);
    double seen = 0.0, sum = 0.0;
    const double expected = ball.innerIrradiance(0.6, bounces);
    for (std::size_t i = 0; i < image.hit.size(); ++i) {
      const auto hit = hits.at({static_cast<int>(i) % image.size.x, static_cast<int>(i) / image.size.x});
      if (!hit) continue;
      EXPECT_LE(hit->voxel.z, ball.dims.z - 1.0 + 1e-9);
      if (!hit->outer) {  // the ball's convex side, seen past the rim
        EXPECT_NEAR(image.irradiance[i].x, pi, 0.03) << i;
        continue;
      }
      EXPECT_NEAR(image.irradiance[i].x, expected, 0.1 * pi) << i;
      ++seen;
      sum += image.irradiance[i].x;
    }
    ASSERT_GT(seen, 40.0);
    EXPECT_NEAR(sum / seen / expected, 1.0, 0.015) << bounces;
  }
}

// The nearest of several surfaces, each with its own colour, on every hit field and in both projections.
TEST_F(ReferencePicture, TheNearestSurfaceHasItsOwnColour) {
  for (const scene::Field field :
       {scene::Field::trilinear, scene::Field::cubic, scene::Field::cubic_interpolating}) {
    for (const scene::Projection projection :
         {scene::Projection::perspective, scene::Projection::orthographic}) {
      scene_ = {};
      scene_.hit.field = field;
      scene_.camera.projection = projection;
      scene_.surfaces.front().albedo = glm::dvec3(0.25);
      test::surfaceAt(scene_, 1) = {.id = "second",
                                    .shown = true,
                                    .value = -4.0,
                                    .albedo = glm::dvec3(0.75),
                                    .opacity = 1.0};  // outside the first
      scene_.picture.exposure = 0.0;
      use(test::phantom("ball", 40));
      const ReferenceImage image = draw(16);
      int hits = 0;
      for (std::size_t i = 0; i < image.hit.size(); ++i) {
        if (!image.hit[i]) continue;
        ++hits;
        EXPECT_NEAR(image.color[i].x, 0.75f, 2e-4f);
      }
      EXPECT_GT(hits, 50);
    }
  }
}

TEST_F(ReferencePicture, TransparentSurfacesAreRefused) {
  test::surfaceAt(scene_, 1) = {
      .id = "second", .shown = true, .value = -4.0, .albedo = glm::dvec3(0.75), .opacity = 0.5};
  use(test::phantom("ball", 16));
  try {
    (void)make();
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
  }
}

TEST_F(ReferencePicture, WhatIsFinishedStaysWhenStopped) {
  use(test::phantom("ball", 24));
  Reference reference = make();
  ASSERT_TRUE(reference.refineTo(4, progress_));
  progress_.requestStop();
  EXPECT_FALSE(reference.refineTo(1000000, progress_));
  const ReferenceImage image = reference.image();
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    EXPECT_EQ(image.samples[i], image.hit[i] ? 4u : 0u);
  }
}

TEST(ReferenceRounds, EndWhereAsked) {
  EXPECT_EQ(referenceRounds(1), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(referenceRounds(100), (std::vector<std::uint32_t>{1, 4, 16, 64, 100}));
  EXPECT_EQ(referenceRounds(192), (std::vector<std::uint32_t>{1, 4, 16, 64, 128, 192}));
}

TEST_F(ReferencePicture, OfSomePixelsIsThatOfAll) {
  use(test::phantom("torus", 32));
  const ReferenceImage whole = draw(8);
  std::vector<std::uint32_t> pixels;
  for (std::uint32_t i = 0; i < whole.hit.size(); i += 3) pixels.push_back(i);
  const auto tracer =
      std::make_shared<volume::IsosurfaceTracer>(volume_->volume.grid, scene_.isosurface.inside, progress_);
  Reference some(volume_, tracer, environment_, scene_, {whole.size, 2, pixels}, progress_);
  EXPECT_TRUE(some.refineTo(8, progress_));
  const ReferenceImage image = some.image();
  int traced = 0;
  for (std::size_t i = 0; i < whole.hit.size(); ++i) {
    EXPECT_EQ(image.hit[i], i % 3 == 0 ? whole.hit[i] : 0);
    if (!image.hit[i]) continue;
    EXPECT_EQ(image.irradiance[i], whole.irradiance[i]);
    ++traced;
  }
  EXPECT_GT(traced, 10);
}

}  // namespace
}  // namespace isolux::gi
