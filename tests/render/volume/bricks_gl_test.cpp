// A volume in bricks against the same volume as one texture: the same pictures, whatever the budget.
#include <cmath>
#include <functional>
#include <random>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "render/gl/gl.h"
#include "render/passes/pass_declarations.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/surfaces.h"
#include "tests/support/volumes.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

using render::Aov;
using scene::Field;
using scene::MemoryLayout;
using VolumePointer = std::shared_ptr<const volume::PreparedVolume>;

// Float voxels; what one brick needs of the budget is 35^3 * 4 bytes, so that a MiB holds 6.
VolumePointer field(glm::ivec3 dims, const std::function<float(glm::vec3)>& value) {
  return prepared(gridOfVoxels(volume::GridGeometry::make(dims, {1.0, 0.8, 1.3}),
                               [&](glm::dvec3 voxel) { return value(glm::vec3(voxel)); }));
}

VolumePointer noise(glm::ivec3 dims, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  return field(dims, [&](glm::vec3) { return uniform(random); });
}

class BricksGlTest : public RenderGlTest {
 protected:
  struct Drawn {
    render::ColorImage color;
    std::vector<render::AovImage> images;
    render::FrameReport report;
  };
  Drawn draw(const VolumePointer& volume, scene::Scene scene, MemoryLayout layout, int budgetMb = 2048,
             glm::ivec2 size = {96, 72}, scene::Executor executor = scene::Executor::gpu) {
    renderer_->setHostSettings({.memory = {budgetMb, layout}, .executor = executor});
    scene = scene::resolve(scene, volume->facts);
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = size;
    for (const render::AovInfo& info : render::aovs()) request.aovs.push_back(info.aov);
    Drawn drawn;
    drawn.report = renderer_->render(scene, request);
    drawn.color = renderer_->readColor();
    for (const Aov aov : request.aovs) drawn.images.push_back(renderer_->readAov(aov));
    return drawn;
  }

  static int colorDifference(const render::ColorImage& a, const render::ColorImage& b) {
    int most = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) most = std::max(most, std::abs(a.rgba[i] - b.rgba[i]));
    return most;
  }
  // Values that are not the same, NaN equal to NaN. Hits are equal bit by bit; derivatives to within
  // rounding, which a compiler may order differently in two programs.
  static std::size_t unequal(const render::AovImage& a, const render::AovImage& b) {
    float largest = 0.0f;
    for (const float v : a.values)
      if (std::isfinite(v)) largest = std::max(largest, std::fabs(v));
    const bool exact =
        a.aov == Aov::hit || a.aov == Aov::voxel || a.aov == Aov::position || a.aov == Aov::depth;
    const float tolerance = exact ? 0.0f : 1e-5f * largest;
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.values.size(); ++i)
      if (!(std::fabs(a.values[i] - b.values[i]) <= tolerance) &&
          !(std::isnan(a.values[i]) && std::isnan(b.values[i])))
        ++count;
    return count;
  }
  static std::size_t hits(const Drawn& drawn) {
    std::size_t count = 0;
    for (const render::AovImage& image : drawn.images)
      if (image.aov == Aov::hit)
        for (const float v : image.values) count += v == 1.0f ? 1 : 0;
    return count;
  }
  static bool isOfEdge(Aov aov) { return aov == Aov::edge_offset || aov == Aov::edge_strength; }
  // Curvature images only where curvature is: on flat or round surfaces they are made of rounding.
  static void expectEqual(const Drawn& whole, const Drawn& bricks, const std::string& what,
                          bool curvature = true) {
    EXPECT_FALSE(whole.report.bricks.inUse) << what;
    EXPECT_TRUE(bricks.report.bricks.inUse) << what;
    EXPECT_EQ(bricks.report.bricks.missing, 0.0) << what;
    EXPECT_EQ(colorDifference(whole.color, bricks.color), 0) << what;
    for (std::size_t i = 0; i < whole.images.size(); ++i) {
      render::FrameRequest alone;
      alone.color = false;
      alone.aovs = {whole.images[i].aov};
      if (!curvature && render::readsHessian({}, alone)) continue;
      if (isOfEdge(whole.images[i].aov)) continue;  // in bricks the processor looks for them
      EXPECT_EQ(unequal(whole.images[i], bricks.images[i]), 0u)
          << what << ", " << render::aovs()[static_cast<std::size_t>(whole.images[i].aov)].name;
    }
  }
};

scene::Scene lookingFrom(const VolumePointer& volume, glm::dvec3 direction) {
  scene::Scene scene;
  const glm::dvec3 low = volume->facts.boundsMinMm, high = volume->facts.boundsMaxMm;
  scene.camera.target = 0.5 * (low + high);
  scene.camera.eye = *scene.camera.target + glm::normalize(direction) * glm::length(high - low) * 1.2;
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  return scene;
}

TEST_F(BricksGlTest, EveryFieldIsTheSameWithExactFetches) {
  const auto volume = phantom("gyroid", 70);  // not a multiple of 32
  for (const Field hit : {Field::trilinear, Field::cubic, Field::cubic_interpolating})
    for (const Field derivatives : {Field::trilinear, Field::cubic, Field::cubic_interpolating}) {
      scene::Scene scene;
      scene.hit.field = hit;
      scene.derivatives.field = derivatives;
      scene.derivatives.fetch = scene::Fetch::exact;
      const Drawn whole = draw(volume, scene, MemoryLayout::whole);
      ASSERT_GT(hits(whole), 1000u);
      expectEqual(whole, draw(volume, scene, MemoryLayout::bricks),
                  "hit " + std::to_string(static_cast<int>(hit)) + ", derivatives " +
                      std::to_string(static_cast<int>(derivatives)));
    }
}

// Rays that begin at a cut ask for the bricks that they need there; faces are the same, few slots or many.
TEST_F(BricksGlTest, CutSurfacesAndTheirFacesAreTheSame) {
  const auto volume = phantom("gyroid", 70);
  const glm::dvec3 middle = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
  for (const scene::ClipCap cap : {scene::ClipCap::none, scene::ClipCap::inside, scene::ClipCap::whole}) {
    scene::Scene scene;
    scene.clip.planes = {{middle, {0.3, -1.0, 0.4}}};
    scene.clip.cap = cap;
    const Drawn whole = draw(volume, scene, MemoryLayout::whole);
    if (cap != scene::ClipCap::whole) {
      ASSERT_GT(hits(whole), 500u);
    }
    expectEqual(whole, draw(volume, scene, MemoryLayout::bricks), "cut");
    expectEqual(whole, draw(volume, scene, MemoryLayout::bricks, 2), "cut, few slots");
  }
}

// Lookups of a field at a scale are wider, and have textures of their own: up to three beside the samples.
TEST_F(BricksGlTest, FieldsAtScalesAreTheSame) {
  const auto volume = phantom("gyroid", 70);
  const double spacing = volume->grid().geometry().spacingMm().x;
  for (const Field field : {Field::cubic, Field::cubic_interpolating})
    for (const double normalScale : {0.0, 0.7, 1.5}) {
      scene::Scene scene;
      scene.hit.field = Field::cubic_interpolating;
      scene.derivatives.field = field;
      scene.derivatives.scale = 1.5 * spacing;
      scene.derivatives.normalScale = normalScale * spacing;
      const Drawn whole = draw(volume, scene, MemoryLayout::whole);
      ASSERT_GT(hits(whole), 1000u);
      expectEqual(whole, draw(volume, scene, MemoryLayout::bricks),
                  "normals at " + std::to_string(normalScale));
      if (field != Field::cubic || normalScale != 0.7) continue;
      const Drawn few = draw(volume, scene, MemoryLayout::bricks, 8);
      EXPECT_LT(few.report.bricks.slots, few.report.bricks.total);
      expectEqual(whole, few, "few slots");
    }
}

// Without a scaled field bricks are as they were.
TEST_F(BricksGlTest, OnlyFieldsAtScalesNeedWiderBricks) {
  const auto volume = noise(glm::ivec3(100), 3);
  scene::Scene scene;
  scene.surfaces.front().value = 0.9;
  scene.derivatives.scale = scene.derivatives.normalScale = 0.0;
  const std::size_t slots = draw(volume, scene, MemoryLayout::bricks, 2).report.bricks.slots;
  EXPECT_EQ(slots, (std::size_t{2} << 20) / (35 * 35 * 35 * sizeof(float)));
  scene.derivatives.scale = scene.derivatives.normalScale = 1.0;
  const std::size_t wider = draw(volume, scene, MemoryLayout::bricks, 4).report.bricks.slots;
  EXPECT_EQ(wider, (std::size_t{4} << 20) / (2 * 37 * 37 * 37 * sizeof(float)));
}

// A pass that shaders must draw at the hits (fast fetches) would miss bricks that no ray has asked for.
TEST_F(BricksGlTest, WhereShadersReadBricksTheProcessorCastsNoRays) {
  const auto volume = phantom("gyroid", 70);
  scene::Scene scene;
  scene.derivatives.fetch = scene::Fetch::fast;
  const Drawn shaders = draw(volume, scene, MemoryLayout::bricks);
  renderer_ = std::make_unique<render::Renderer>(context_->gl());  // nothing is resident
  const Drawn processor = draw(volume, scene, MemoryLayout::bricks, 2048, {96, 72}, scene::Executor::cpu);
  EXPECT_TRUE(processor.report.bricks.inUse);
  EXPECT_EQ(processor.report.bricks.missing, 0.0);
  EXPECT_EQ(colorDifference(shaders.color, processor.color), 0);
  for (std::size_t i = 0; i < shaders.images.size(); ++i)
    EXPECT_EQ(unequal(shaders.images[i], processor.images[i]), 0u) << i;
}

// Filters weigh by a coordinate, which is another one in the cache: rounding may differ.
TEST_F(BricksGlTest, FastFetchesAndSampledHitsAreTheSameWithinOneLevel) {
  for (const char* name : {"gyroid", "torus"}) {
    const auto volume = phantom(name, 70);
    for (const Field field : {Field::trilinear, Field::cubic, Field::cubic_interpolating})
      for (const auto method : {scene::HitMethod::exact, scene::HitMethod::sampled}) {
        scene::Scene scene;
        scene.hit.method = method;
        scene.derivatives.field = field;
        scene.derivatives.fetch = scene::Fetch::fast;
        const Drawn whole = draw(volume, scene, MemoryLayout::whole);
        const Drawn bricks = draw(volume, scene, MemoryLayout::bricks);
        EXPECT_EQ(bricks.report.bricks.missing, 0.0);
        EXPECT_EQ(hits(whole), hits(bricks));
        EXPECT_LE(colorDifference(whole.color, bricks.color), 1) << name << static_cast<int>(field);
      }
  }
}

TEST_F(BricksGlTest, HardCases) {
  const auto ball = [](glm::vec3 p) { return 20.0f - glm::length(p - glm::vec3(32.0f)); };
  struct Case {
    const char* name;
    VolumePointer volume;
  };
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Case> cases = {
      {"two voxels along x", field({2, 70, 40}, [](glm::vec3 p) { return p.y + 2.0f * p.x - 30.3f; })},
      {"two voxels along z", field({66, 34, 2}, [](glm::vec3 p) { return p.x + p.z - 32.0f; })},
      {"one voxel along y", field({66, 1, 34}, [](glm::vec3 p) { return p.x - 32.0f; })},
      {"33 voxels", field({33, 33, 33}, [](glm::vec3 p) { return p.x + p.y - 31.5f; })},
      {"surface on the brick border", field({65, 65, 65}, [](glm::vec3 p) { return p.x - 32.0f; })},
      {"surface on the last voxel", field({65, 65, 65}, [](glm::vec3 p) { return p.z - 63.99f; })},
      {"noise", noise({67, 45, 66}, 3)},
      {"missing voxels", field({70, 66, 65},
                               [&](glm::vec3 p) {
                                 return glm::length(p - glm::vec3(33.0f, 30.0f, 14.0f)) < 6.0f ? nan
                                                                                               : ball(p);
                               })},
      {"tiny values", field({66, 66, 66}, [&](glm::vec3 p) { return 1e-20f * ball(p); })},
  };
  for (const Case& test : cases)
    for (const Field hit : {Field::trilinear, Field::cubic_interpolating})
      for (const glm::dvec3& direction : {glm::dvec3(0.3, -1.0, 0.4), glm::dvec3(0.0, 1.0, 0.0)}) {
        scene::Scene scene = lookingFrom(test.volume, direction);
        scene.surfaces.front().value = 0.0;
        scene.hit.field = hit;
        scene.derivatives.field = hit;
        scene.derivatives.fetch = scene::Fetch::exact;
        const Drawn whole = draw(test.volume, scene, MemoryLayout::whole);
        const Drawn bricks = draw(test.volume, scene, MemoryLayout::bricks);
        if (std::string(test.name) == "one voxel along y") {
          EXPECT_EQ(hits(bricks), 0u);
          continue;
        }
        expectEqual(whole, bricks, test.name, false);
      }
}

TEST_F(BricksGlTest, EyeInsideAndTransparentSurfacesAreTheSame) {
  const auto volume = phantom("gyroid", 70);
  scene::Scene inside;
  inside.camera.eye = 0.3 * volume->facts.boundsMinMm + 0.7 * volume->facts.boundsMaxMm;
  inside.camera.target = volume->facts.boundsMinMm;
  inside.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  inside.derivatives.fetch = scene::Fetch::exact;
  expectEqual(draw(volume, inside, MemoryLayout::whole), draw(volume, inside, MemoryLayout::bricks),
              "eye inside");
  scene::Scene layered;
  layered.derivatives.fetch = scene::Fetch::exact;
  layered.surfaces.front().opacity = 0.4;
  test::surfaceAt(layered, 1).shown = true;
  test::surfaceAt(layered, 1).value = 0.3;
  expectEqual(draw(volume, layered, MemoryLayout::whole), draw(volume, layered, MemoryLayout::bricks),
              "layers");
}

// Shadow rays ask for bricks that no camera ray came to.
TEST_F(BricksGlTest, ShadowsAreTheSame) {
  const auto volume = phantom("torus", 100);
  scene::Scene scene;
  scene.look.shadow = 1.0;
  scene.light.direction = {1.0, 0.2, 0.1};
  scene.derivatives.fetch = scene::Fetch::exact;
  const Drawn whole = draw(volume, scene, MemoryLayout::whole);
  const Drawn bricks = draw(volume, scene, MemoryLayout::bricks);
  expectEqual(whole, bricks, "shadow");
  scene.look.shadow = 0.0;
  EXPECT_GT(colorDifference(whole.color, draw(volume, scene, MemoryLayout::whole).color), 20);
}

// The way to an edge may lead through bricks that no ray came to, so the processor goes it.
TEST_F(BricksGlTest, EdgesAreThoseOfTheProcessor) {
  const auto volume = phantom("head", 96);
  scene::Scene scene;
  scene.look.mode = scene::LookMode::edge_offset;
  scene.surfaces.front().value = -300.0;
  scene.derivatives.scale = 3.0;
  const Drawn whole = draw(volume, scene, MemoryLayout::whole, 2048, {96, 72}, scene::Executor::cpu);
  const Drawn bricks = draw(volume, scene, MemoryLayout::bricks, 6);
  ASSERT_TRUE(bricks.report.bricks.inUse);
  EXPECT_EQ(bricks.report.bricks.missing, 0.0);
  for (std::size_t i = 0; i < whole.images.size(); ++i) {
    if (!isOfEdge(whole.images[i].aov)) continue;
    const std::vector<float>&a = whole.images[i].values, &b = bricks.images[i].values;
    std::size_t known = 0, far = 0;
    for (std::size_t k = 0; k < a.size(); ++k) {
      if (!std::isfinite(a[k])) continue;
      ++known;
      far += std::fabs(a[k] - b[k]) <= 1e-3f * std::max(std::fabs(a[k]), 1.0f) ? 0 : 1;
    }
    EXPECT_GT(known, 200u);
    EXPECT_LE(far, known / 50) << render::aovs()[static_cast<std::size_t>(whole.images[i].aov)].name;
  }
}

TEST_F(BricksGlTest, AQuarterOfTheBytesIsEnoughForTheWholePicture) {
  const auto volume = phantom("ball", 128);  // 8 MiB, 64 bricks
  scene::Scene scene;
  scene.derivatives.fetch = scene::Fetch::exact;
  const Drawn whole = draw(volume, scene, MemoryLayout::whole);
  const Drawn bricks = draw(volume, scene, MemoryLayout::automatic, 2);
  EXPECT_LE(bricks.report.bricks.slots, 12u);
  EXPECT_LE(bricks.report.gpuBytes, whole.report.gpuBytes);
  expectEqual(whole, bricks, "2 MiB");
}

// Eight slots for a surface through all 64 bricks: the rays that wait take turns.
TEST_F(BricksGlTest, ABudgetTooSmallForAllRaysAtOnceStillDrawsThePicture) {
  const auto volume = phantom("gyroid", 128);
  for (const auto method : {scene::HitMethod::exact, scene::HitMethod::sampled}) {
    scene::Scene scene;
    scene.hit.method = method;
    scene.derivatives.field = Field::cubic;
    scene.derivatives.fetch = scene::Fetch::exact;
    const Drawn whole = draw(volume, scene, MemoryLayout::whole);
    const Drawn bricks = draw(volume, scene, MemoryLayout::automatic, 2);
    EXPECT_GT(bricks.report.bricks.evicted, 0u);
    EXPECT_EQ(bricks.report.bricks.missing, 0.0);
    if (method == scene::HitMethod::exact)
      expectEqual(whole, bricks, "turns");
    else
      EXPECT_LE(colorDifference(whole.color, bricks.color), 1);
  }
}

TEST_F(BricksGlTest, AVolumeBeyondTheTextureLimitIsDrawnFromBricks) {
  const auto volume = phantom("torus", 100);
  scene::Scene scene;
  scene.derivatives.fetch = scene::Fetch::exact;
  const Drawn whole = draw(volume, scene, MemoryLayout::whole);
  auto limited = std::make_shared<render::Gl>(*context_->gl());
  limited->max3dTexture = 96;
  renderer_ = std::make_unique<render::Renderer>(limited);
  const Drawn bricks = draw(volume, scene, MemoryLayout::automatic);
  EXPECT_EQ(bricks.report.bricks.slots, 8u);
  expectEqual(whole, bricks, "limit 96");
  EXPECT_THROW(draw(volume, scene, MemoryLayout::whole), base::Error);
}

TEST_F(BricksGlTest, TooFewBricksAreRefusedAsMemory) {
  const auto volume = phantom("torus", 100);
  auto limited = std::make_shared<render::Gl>(*context_->gl());
  limited->max3dTexture = 64;  // one slot per axis
  renderer_ = std::make_unique<render::Renderer>(limited);
  try {
    draw(volume, {}, MemoryLayout::automatic);
    FAIL() << "one brick cannot hold a picture";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
  }
}

class StreamingGlTest : public BricksGlTest {
 protected:
  // As the window draws: a bounded upload for each frame.
  const render::FrameReport& frame(const VolumePointer& volume, const scene::Scene& scene, int budgetMb,
                                   std::size_t bytes) {
    renderer_->setHostSettings(
        {.memory = {budgetMb, MemoryLayout::bricks}, .executor = scene::Executor::gpu});
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = {96, 72};
    request.brickUploadBytes = bytes;
    return renderer_->render(scene::resolve(scene, volume->facts), request);
  }
  static render::PassState stateOf(const render::FrameReport& report, const std::string& name) {
    for (const render::PassReport& pass : report.passes)
      if (pass.name == name) return pass.state;
    ADD_FAILURE() << "no pass " << name;
    return render::PassState::skipped;
  }
};

TEST_F(StreamingGlTest, BricksArrivingOverFramesConvergeToTheSamePicture) {
  const auto volume = phantom("gyroid", 70);
  scene::Scene scene;
  scene.derivatives.fetch = scene::Fetch::exact;
  const Drawn whole = draw(volume, scene, MemoryLayout::whole);
  constexpr std::size_t brick = 35 * 35 * 35 * 4;
  std::size_t uploaded = 0;
  int frames = 0;
  double before = 1.0;
  for (;; ++frames) {
    ASSERT_LT(frames, 60);
    const render::FrameReport report = frame(volume, scene, 64, 2 * brick);
    EXPECT_LE(report.bricks.uploaded, 2u);
    EXPECT_LE(report.bricks.missing, before + 1e-9);
    before = report.bricks.missing;
    uploaded += report.bricks.uploaded;
    if (report.bricks.missing > 0.0) {
      EXPECT_TRUE(report.bricks.pending);
      EXPECT_GT(colorDifference(whole.color, renderer_->readColor()),
                1);  // it is seen that something is missing
    }
    if (!report.bricks.pending) break;
  }
  EXPECT_GT(frames, 3);
  EXPECT_EQ(before, 0.0);
  EXPECT_EQ(colorDifference(whole.color, renderer_->readColor()), 0);
  const render::FrameReport still = frame(volume, scene, 64, 2 * brick);  // a still picture costs nothing
  EXPECT_EQ(still.bricks.uploaded, 0u);
  for (const render::PassReport& pass : still.passes)
    EXPECT_NE(pass.state, render::PassState::ran) << pass.name;
  EXPECT_EQ(uploaded, still.bricks.resident);
}

// Pixels whose rays wait are hatched grey, and no others: neither those that hit nor those that hit nothing.
TEST_F(StreamingGlTest, WhatWaitsIsHatchedWhateverTheMethod) {
  const auto grey = [](const render::ColorImage& color) {
    double count = 0.0;
    for (std::size_t i = 0; i < color.rgba.size(); i += 4)
      count += std::abs(color.rgba[i] - color.rgba[i + 1]) <= 3 &&
               std::abs(color.rgba[i] - color.rgba[i + 2]) <= 3;
    return 4.0 * count / static_cast<double>(color.rgba.size());
  };
  for (const char* method : {"hit.method=exact", "hit.method=sampled"}) {
    const auto volume = phantom("ball", 100);  // none of whose bricks is there
    scene::Scene scene = assigned({method, "look.mode=lambert"}, lookingFrom(volume, {1.0, 0.4, 0.3}));
    scene.surfaces.front().albedo = {1.0, 0.1, 0.05};
    scene.look.backgroundTop = scene.look.backgroundBottom = {0.1, 0.2, 0.9};
    const double missing = frame(volume, scene, 64, 2 * 35 * 35 * 35 * 4).bricks.missing;
    EXPECT_GT(missing, 0.05) << method;
    EXPECT_LT(missing, 0.9) << method;
    EXPECT_NEAR(grey(renderer_->readColor()), missing, 0.02) << method;
    EXPECT_EQ(frame(volume, scene, 64, 0).bricks.missing, 0.0);
    EXPECT_LT(grey(renderer_->readColor()), 0.01) << method;
  }
}

TEST_F(StreamingGlTest, ABudgetTooSmallForTheWindowIsSaidAndComesToRest) {
  const auto volume = phantom("gyroid", 128);
  scene::Scene scene;
  render::FrameReport report;
  for (int i = 0; i < 40; ++i) {
    report = frame(volume, scene, 2, 1 << 20);
    if (!report.bricks.pending) break;
  }
  EXPECT_FALSE(report.bricks.pending);
  EXPECT_GT(report.bricks.missing, 0.05);
  report = frame(volume, scene, 2, 1 << 20);
  EXPECT_EQ(stateOf(report, "cast"), render::PassState::cached);
  EXPECT_GT(report.bricks.missing, 0.05);
  // A picture that may take its time is complete.
  EXPECT_EQ(frame(volume, scene, 2, 0).bricks.missing, 0.0);
  EXPECT_EQ(stateOf(frame(volume, scene, 2, 0), "cast"), render::PassState::cached);
}

TEST_F(StreamingGlTest, AnOrbitNeverThrashes) {
  const auto volume = phantom("ball", 128);
  std::size_t laps[2] = {0, 0}, most = 0;
  for (std::size_t& lap : laps)
    for (int i = 0; i < 36; ++i) {
      const double angle = 2.0 * M_PI * i / 36.0;
      const render::FrameReport& report =
          frame(volume, lookingFrom(volume, {std::cos(angle), std::sin(angle), 0.3}), 12, 0);
      EXPECT_EQ(report.bricks.missing, 0.0);
      lap += report.bricks.uploaded;
      most = std::max(most, report.bricks.resident);
    }
  EXPECT_EQ(laps[0], most);  // each brick once
  EXPECT_EQ(laps[1], 0u);
}

}  // namespace
}  // namespace isolux::test
