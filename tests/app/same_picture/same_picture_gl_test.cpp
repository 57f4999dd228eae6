// The same picture, whatever draws it: contexts, executors, instruction sets, threads, bricks, sessions.
// docs/explanation/numerics.md, "Bit-identical images", has the bounds and what was measured.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "app/documents/session.h"
#include "scene/rules/needs.h"
#include "tests/app/same_picture/distance.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using render::ContextChoice;
using render::OffscreenContext;
using scene::Executor;
using scene::MemoryLayout;

class SamePictureGlTest : public testing::TestWithParam<PictureScene> {
 protected:
  static void SetUpTestSuite() { context_ = OffscreenContext::create(ContextChoice::software); }
  static void TearDownTestSuite() { context_.reset(); }
  void SetUp() override {
    if (GetParam().voxels == 0) ISOLUX_NEEDS_DATA();
  }
  static DrawnWay draw(const Way& way = {}) { return drawWay(*context_, GetParam(), way); }

  // The figures of docs/explanation/numerics.md are what this prints.
  static void expectKept(const char* pair, const DrawnWay& a, const DrawnWay& b, const WayBound& bound) {
    const WayDistance distance = distanceOf(a, b);
    std::cout << GetParam().name << ", " << pair << ": " << distance << '\n';
    EXPECT_GT(a.hits, 1000) << "hardly anything is seen";
    EXPECT_EQ(a.volume->grid().hash(), b.volume->grid().hash()) << pair << ": another volume";
    EXPECT_TRUE(keeps(distance, bound)) << pair << ": " << distance;
  }
  static void expectIdentical(const char* pair, const DrawnWay& a, const DrawnWay& b) {
    EXPECT_GT(a.hits, 1000) << "hardly anything is seen";
    EXPECT_TRUE(isIdentical(a, b)) << pair << ": " << distanceOf(a, b);
  }

  static inline std::unique_ptr<OffscreenContext> context_;
};

TEST_P(SamePictureGlTest, OfShadersAndTheProcessor) {
  const DrawnWay processor = draw(), shaders = draw({.executor = Executor::gpu});
  expectKept("shaders", processor, shaders, kOtherOrder);
  EXPECT_FALSE(shaders.castOnProcessor);
  if (processor.castOnProcessor) return;
  expectIdentical("what only shaders do", processor, shaders);
}

TEST_P(SamePictureGlTest, OfSoftwareEgl) {
  if (context_->description().kind != "OSMesa") {
    std::cout << "no OSMesa: all other pictures here are those of software EGL\n";
    return;
  }
  const auto egl = OffscreenContext::create(ContextChoice::egl);
  if (!egl->description().software) {
    std::cout << "EGL is the graphics card's here\n";
    return;
  }
  const DrawnWay a = draw({.executor = Executor::gpu}),
                 b = drawWay(*egl, GetParam(), {.executor = Executor::gpu});
  if (egl->description().renderer == context_->description().renderer &&
      egl->description().version == context_->description().version)
    expectIdentical("the same driver", a, b);
  else
    expectKept("software EGL", a, b, kOtherDriver);
}

TEST_P(SamePictureGlTest, OfAGraphicsCard) {
  const auto card = OffscreenContext::create(ContextChoice::automatic);
  if (card->description().software) {
    std::cout << "no graphics card: EGL has " << card->description().renderer << " alone\n";
    return;
  }
  const DrawnWay reference = draw();
  expectKept("graphics card", reference, drawWay(*card, GetParam(), {.executor = Executor::gpu}),
             kOtherDriver);
  expectKept("its light and colours alone", reference, drawWay(*card, GetParam()), kOtherDriver);
}

TEST_P(SamePictureGlTest, OfEveryInstructionSet) {
  struct InstructionSet {
    const char* name;
    std::int64_t set;
  };
  const DrawnWay reference = draw();
  const std::int64_t supported = hwy::SupportedTargets();
  for (const InstructionSet& one :
       {InstructionSet{"AVX-512", HWY_AVX3}, {"AVX2", HWY_AVX2}, {"SSE4", HWY_SSE4}}) {
    if ((supported & one.set) == 0)
      std::cout << "this processor has no " << one.name << '\n';
    else
      expectKept(one.name, reference, draw({.setsLeft = one.set}), kOtherOrder);
  }
}

// Without any that rays are cast by: shaders cast, and light is traced ray by ray.
TEST_P(SamePictureGlTest, OfNoInstructionSet) {
  const DrawnWay scalar = draw({.setsLeft = HWY_STATIC_TARGET});
  EXPECT_FALSE(scalar.castOnProcessor);
  expectKept("scalar", draw(), scalar, kOtherOrder);
}

TEST_P(SamePictureGlTest, OfOneAndTwoThreads) {
  expectIdentical("threads", draw({.threads = 1}), draw({.threads = 2}));
}

TEST_P(SamePictureGlTest, OfBricksAndTheWhole) {
  const DrawnWay whole = draw({.executor = Executor::gpu});
  const DrawnWay bricks = draw({.executor = Executor::gpu, .layout = MemoryLayout::bricks});
  // A texture unit finds its texels by coordinates in parts of the texture, which are rounded.
  if (scene::fetchesFast(whole.scene))
    expectKept("bricks by the texture unit", whole, bricks, kOtherOrder);
  else
    expectIdentical("bricks", whole, bricks);
}

// As it was set up, and as it was drawn, with all that was automatic filled in.
TEST_P(SamePictureGlTest, OfASavedSession) {
  const DrawnWay drawn = draw();
  const auto reopened = [](const scene::Scene& scene) {
    return app::parseSession(app::sessionText(scene, "/"), "a.isolux", {"/"});
  };
  const scene::Scene scene = sceneOf(GetParam());
  EXPECT_TRUE(reopened(scene) == scene);
  expectIdentical("as it was drawn", drawn, drawWay(*context_, GetParam(), reopened(drawn.scene)));
}

INSTANTIATE_TEST_SUITE_P(Scenes, SamePictureGlTest, testing::ValuesIn(pictureScenes()),
                         [](const auto& one) { return std::string(one.param.name); });

std::vector<PictureScene> scenesNamed(const std::vector<std::string>& names) {
  std::vector<PictureScene> scenes;
  for (const PictureScene& scene : pictureScenes())
    if (std::find(names.begin(), names.end(), scene.name) != names.end()) scenes.push_back(scene);
  return scenes;
}

class SameHitsGlTest : public SamePictureGlTest {};

// What each pixel says of its own error (docs/explanation/accuracy.md, "Bounds of hits, normals and
// curvature") is what two ways differ by.
TEST_P(SameHitsGlTest, DifferByWhatPixelsSayAtMost) {
  const DrawnWay processor = draw(), shaders = draw({.executor = Executor::gpu});
  base::Progress progress;
  const auto errorsOf = [&](const DrawnWay& way) {
    return app::pictureErrors(*way.volume, way.scene, way.drawnHits, progress);
  };
  const app::PictureErrors a = errorsOf(processor), b = errorsOf(shaders);
  std::size_t judged = 0, beyond = 0, one = 0;
  for (std::size_t i = 0; i < a.certain.size(); ++i) {
    if (!a.certain[i] || !b.certain[i]) continue;
    const double depth = static_cast<double>(processor.drawnHits.depthMm[i]),
                 other = static_cast<double>(shaders.drawnHits.depthMm[i]);
    one += std::isnan(depth) != std::isnan(other);
    if (std::isnan(depth) || std::isnan(other)) continue;
    ++judged;
    beyond += std::abs(depth - other) > static_cast<double>(a.depthMm[i]) + static_cast<double>(b.depthMm[i]);
  }
  std::cout << GetParam().name << ": " << judged << " certain pixels, " << beyond << " beyond their bounds\n";
  EXPECT_GT(judged, 1000u);
  EXPECT_LE(1000 * beyond, judged);
  EXPECT_EQ(one, 0u) << "certain, and a hit in one picture alone";
}

INSTANTIATE_TEST_SUITE_P(Scenes, SameHitsGlTest,
                         testing::ValuesIn(scenesNamed({"ct", "cubic", "interpolating", "pieces"})),
                         [](const auto& one) { return std::string(one.param.name); });

// The bounds tell what no rounding makes: a thousandth of the isovalue.
TEST(SameBoundsGlTest, ASmallChangeIsAnotherPicture) {
  const auto context = OffscreenContext::create(ContextChoice::software);
  const PictureScene lit = scenesNamed({"light"}).front();
  scene::Scene changed = sceneOf(lit);
  *changed.surfaces.front().value *= 1.001;
  const WayDistance distance = distanceOf(drawWay(*context, lit), drawWay(*context, lit, changed));
  EXPECT_FALSE(keeps(distance, kOtherOrder)) << distance;
  EXPECT_GT(distance.voxels, kOtherOrder.voxels);
}

}  // namespace
}  // namespace isolux::test
