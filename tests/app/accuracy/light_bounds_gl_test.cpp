// Bounds of stored light, judged by path tracing at the exact hits of other pixels
// (app/study/light_reference.h, which knows nothing of them): they hold, and they are no larger than they
// need be.
#include "app/accuracy/light_bounds.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include <gtest/gtest.h>

#include "app/accuracy/accuracy.h"
#include "app/light/light_picture.h"
#include "app/ready/ready_fields.h"
#include "app/study/light_reference.h"
#include "app/study/surface_reference.h"
#include "base/number_text.h"
#include "base/quantiles.h"
#include "base/random.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

using scene::Scene;

struct JudgedLight {
  std::vector<double> errors, bounds;
  std::size_t held = 0, unbounded = 0;
  double meanIrradiance = 0.0;
  double share() const { return static_cast<double>(held) / static_cast<double>(errors.size()); }
  double ratio() const { return base::median(bounds) / base::median(errors); }
};

class LightBoundsGlTest : public test::RenderGlTest {
 protected:
  struct Lit {
    std::shared_ptr<const volume::PreparedVolume> volume;
    Scene scene;
    std::shared_ptr<const gi::PictureLight> light;
    std::vector<float> irradiance;
    PictureErrors errors;
  };

  Lit bound(std::shared_ptr<const volume::PreparedVolume> volume, const std::vector<std::string>& assignments,
            glm::ivec2 size) {
    Lit lit{std::move(volume), assigned(assignments), {}, {}, {}};
    lit.scene.look.mode = scene::LookMode::gi;
    lit.scene = scene::resolve(lit.scene, lit.volume->facts);
    completeFields(lit.scene, *lit.volume, true, progress_);
    renderer_->setVolume(lit.volume);
    render::FrameRequest request;
    request.size = size;
    request.color = false;
    request.aovs = std::vector{render::Aov::irradiance};
    LightController controller({.threads = 2});
    lightPicture(controller, *renderer_, lit.scene, request, lit.volume, progress_);
    lit.light = controller.light();
    lit.errors = measureErrors(*renderer_, {lit.volume, lit.scene, lit.light, size}, progress_);
    renderer_->render(lit.scene, request);
    lit.irradiance = renderer_->readAov(render::Aov::irradiance).values;
    return lit;
  }

  // `count` pixels of outer sides, traced with `replicate` paths kReplicates times.
  JudgedLight judge(const Lit& lit, std::size_t count, std::uint32_t replicate) {
    SurfaceReference surface(lit.volume, lit.scene, lit.errors.size);
    const std::vector<TrueHit> hits = surface.hitsOf(scene::Field::trilinear, progress_);
    Scene still = lit.scene;
    still.gi.mode = scene::GiMode::irradiance;
    still.light.environment.moves = false;
    still.gi.sequence = scene::DirectionSequence::sobol_owen;
    const auto environment = gi::loadEnvironment(still.light.environment);
    const auto light =
        gi::makeLightScene(still, lit.volume, gi::lightTracerOf(still, lit.volume, progress_), environment);
    const double exposure = std::exp2(still.light.environment.exposure);
    const glm::dvec3 sky = light->choice.unitSky ? exposure * environment->mean() : glm::dvec3(exposure);
    std::vector<std::size_t> seen, pixels;
    for (std::size_t i = 0; i < hits.size(); ++i)
      if (hits[i].hit && hits[i].fromOutside && lit.errors.certain[i]) seen.push_back(i);
    for (std::size_t i = 0; i < count; ++i)  // not those by which the bound was found
      pixels.push_back(seen[base::hash64(i + 12345) % seen.size()]);
    std::sort(pixels.begin(), pixels.end());
    pixels.erase(std::unique(pixels.begin(), pixels.end()), pixels.end());
    std::vector<glm::vec3> voxels;
    for (const std::size_t i : pixels) voxels.emplace_back(hits[i].voxel);
    const auto isovalue = lit.volume->grid().storedIsovalue(still.surfaces.front().value.value());
    const LightReference reference =
        lightReferenceAt(light, sky, isovalue, voxels, pixels,
                         {.firstSamples = replicate, .mostSamples = replicate}, progress_);
    JudgedLight judged;
    judged.meanIrradiance = lit.errors.meanIrradiance;
    for (std::size_t k = 0; k < reference.pixels.size(); ++k) {
      const std::size_t i = reference.pixels[k];
      if (!std::isfinite(lit.errors.light[i])) {
        ++judged.unbounded;
        continue;
      }
      double error = 0.0;
      for (int c = 0; c < 3; ++c)
        error = std::max(error,
                         std::abs(static_cast<double>(lit.irradiance[3 * i + static_cast<std::size_t>(c)]) -
                                  reference.irradiance[k][c]));
      judged.errors.push_back(error);
      judged.bounds.push_back(static_cast<double>(lit.errors.light[i]));
      judged.held += error <= judged.bounds.back();
    }
    return judged;
  }

  static std::string textOf(const std::string& name, const JudgedLight& judged) {
    return name + ": " + std::to_string(judged.errors.size()) + " pixels, held " +
           base::shortText(100.0 * judged.share(), 4) + " %, median error " +
           base::shortText(100.0 * base::median(judged.errors) / judged.meanIrradiance, 3) + " %, bound " +
           base::shortText(100.0 * base::median(judged.bounds) / judged.meanIrradiance, 3) +
           " % of mean E, ratio " + base::shortText(judged.ratio(), 3) + ", unbounded " +
           std::to_string(judged.unbounded);
  }

  base::Progress progress_;
};

const std::vector<std::string> kQuick{"gi.samples=16", "light.environment.builtin=studio"};

TEST_F(LightBoundsGlTest, HoldAndAreUseful) {
  for (const char* const name : {"gyroid", "head"}) {
    const Lit lit = bound(test::phantom(name, 40), kQuick, {112, 96});
    const JudgedLight judged = judge(lit, 150, 128);
    SCOPED_TRACE(textOf(name, judged));
    ASSERT_GT(judged.errors.size(), 100u);
    EXPECT_GE(judged.share(), kLightLevel);
    EXPECT_LE(judged.ratio(), 10.0);
    const auto within = static_cast<std::size_t>(std::count_if(
        judged.errors.begin(), judged.errors.end(), [&](double e) { return e <= lit.errors.lightWithin; }));
    EXPECT_GE(static_cast<double>(within), kLightLevel * static_cast<double>(judged.errors.size()));
  }
}

TEST_F(LightBoundsGlTest, HoldOfLampsAndOfTransfer) {
  std::vector<std::string> lamps = kQuick;
  lamps.insert(lamps.end(), {"lamp1.shown=true", "lamp1.kind=sphere"});
  std::vector<std::string> moving = kQuick;
  moving.emplace_back("light.environment.moves=true");
  for (const std::vector<std::string>& assignments : {lamps, moving}) {
    const JudgedLight judged = judge(bound(test::phantom("gyroid", 32), assignments, {96, 80}), 100, 128);
    SCOPED_TRACE(textOf(assignments.back(), judged));
    EXPECT_GE(judged.share(), kLightLevel);
    EXPECT_LE(judged.ratio(), 10.0);
  }
}

// Every point of a ball sees half of an even sky of radiance 1: E is pi, by any number of paths and any
// texels.
TEST_F(LightBoundsGlTest, OfABallUnderAnEvenSkyAreSmallAndHoldItsClosedForm) {
  const Lit lit =
      bound(test::phantom("ball", 40), {"light.environment.constant=1,1,1", "gi.bounces=0"}, {96, 80});
  std::size_t seen = 0, held = 0;
  for (std::size_t i = 0; i < lit.errors.light.size(); ++i) {
    if (!std::isfinite(lit.errors.light[i])) continue;
    ++seen;
    held += std::abs(lit.irradiance[3 * i] - std::numbers::pi_v<float>) <= lit.errors.light[i] + 1e-5f;
  }
  ASSERT_GT(seen, 1000u);
  EXPECT_GE(static_cast<double>(held), kLightLevel * static_cast<double>(seen));
  EXPECT_NEAR(lit.errors.meanIrradiance, std::numbers::pi, 0.03);
  EXPECT_LT(lit.errors.lightWithin, 0.02 * std::numbers::pi);
}

TEST_F(LightBoundsGlTest, LeaveTheRendererAsItWas) {
  const Lit lit = bound(test::phantom("torus", 32), kQuick, {64, 48});
  render::FrameRequest request;
  request.size = {64, 48};
  request.color = false;
  request.aovs = std::vector{render::Aov::irradiance};
  renderer_->setLight(lit.light);
  renderer_->invalidate();
  renderer_->render(lit.scene, request);
  const std::vector<float> fresh = renderer_->readAov(render::Aov::irradiance).values;
  for (std::size_t i = 0; i < fresh.size(); ++i)
    if (!std::isnan(fresh[i])) {
      EXPECT_EQ(fresh[i], lit.irradiance[i]) << i;
    }
}

TEST_F(LightBoundsGlTest, ThereAreNoneWithoutStoredLightOrOfTransparentSurfaces) {
  EXPECT_TRUE(bound(test::phantom("torus", 24), {"gi.mode=off"}, {48, 40}).errors.light.empty());
  std::vector<std::string> transparent = kQuick;
  transparent.emplace_back("isosurface.opacity=0.5");
  const Lit lit = bound(test::phantom("torus", 24), transparent, {48, 40});
  EXPECT_TRUE(lit.errors.light.empty());
  EXPECT_TRUE(std::isnan(accuracyOf(lit.errors).light.median));
}

// 65 536 paths at each of 200 pixels: minutes.
//   app_tests --gtest_also_run_disabled_tests --gtest_filter='LightBoundsGlTest.DISABLED*'
TEST_F(LightBoundsGlTest, DISABLED_HoldOnSixVolumes) {
  struct Subject {
    const char* name;
    int size;  // of a phantom; 0: a file
    const char* isovalue;
  };
  for (const auto& [name, size, isovalue] :
       {Subject{"gyroid", 64, nullptr}, Subject{"head", 96, nullptr}, Subject{"engine.nii.gz", 0, "80"},
        Subject{"heptane.nii.gz", 0, "60"}, Subject{"ct_head_pitch.nii.gz", 0, "200"},
        Subject{"mri_colin27.nii.gz", 0, "71.5"}}) {
    std::vector<std::string> assignments;
    if (isovalue) assignments.push_back(std::string("isosurface.value=") + isovalue);
    Scene source;
    source.source.path = (test::dataFolder() / "volumes" / name).string();
    const Lit lit = bound(size ? test::phantom(name, size) : volume::loadVolume(source.source, progress_),
                          assignments, {192, 160});
    const JudgedLight judged = judge(lit, 200, 4096);
    std::printf("%s\n", textOf(name, judged).c_str());
    std::fflush(stdout);
    EXPECT_GE(judged.share(), kLightLevel) << name;
    EXPECT_LE(judged.ratio(), 10.0) << name;
  }
}

}  // namespace
}  // namespace isolux::app
