// The light controller: what a change of the scene keeps and drops, failing, pausing and cancelling.
#include "app/light/light_controller.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/destroy_in_background.h"
#include "gi/file/bake_file.h"
#include "gi/lattice/lattice_geometry.h"
#include "gi/trace/exposure_meter.h"
#include "scene/rules/automatic.h"
#include "tests/support/lamps.h"
#include "tests/support/light.h"
#include "tests/support/memory_limit.h"
#include "tests/support/own_waits.h"
#include "tests/support/poll.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using Phase = app::LightState::Phase;

class LightControllerTest : public ::testing::Test {
 protected:
  LightControllerTest() {
    scene::Source source;
    source.path = "phantom:ball:32";
    base::Progress progress;
    volume = volume::loadVolume(source, progress);
    scene.look.mode = scene::LookMode::gi;
    scene.gi.samples = 16;
    scene.gi.bounces = 1;
    scene.light.environment.constant = glm::dvec3(1.0);
  }

  scene::Scene resolved() const { return scene::resolve(scene, volume->facts); }

  // Points on the surface, all around, in voxel coordinates.
  std::vector<glm::vec3> surface() const {
    const volume::Grid& grid = volume->grid();
    const double isovalue = *resolved().surfaces.front().value;
    std::vector<glm::vec3> points;
    const glm::ivec3 dims = grid.dims();
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x + 1 < dims.x; ++x) {
          const double a = grid.value(x, y, z), b = grid.value(x + 1, y, z);
          if ((a < isovalue) != (b < isovalue))
            points.emplace_back(x + static_cast<float>((isovalue - a) / (b - a)), y, z);
        }
    return points;
  }

  void light() {
    controller.setScene(resolved(), volume);
    controller.setVisible({surface()});
    base::Progress progress;
    ASSERT_TRUE(controller.finish(progress, 120.0));
  }

  // Threads end what they are at; the limit only guards against waiting for ever.
  bool comesTo(Phase phase) const {
    return test::pollUntil([&] { return controller.state().phase == phase; });
  }

  std::shared_ptr<const volume::PreparedVolume> volume;
  scene::Scene scene;
  app::LightController controller{app::LightController::Options{}};
};

// The luminance of what is stored, averaged over the lit texels.
double meanStored(const gi::LightLattice& lattice) {
  double sum = 0.0, count = 0.0;
  for (std::uint32_t b = 0; b < lattice.geometry().blockCount(); ++b) {
    const auto block = lattice.at(b);
    if (!block) continue;
    const auto components = static_cast<std::size_t>(lattice.content().components());
    for (std::size_t i = 0; i < block->samples.size(); ++i)
      if (block->samples[i] > 0) {
        sum += static_cast<double>(block->means[i * components]);
        ++count;
      }
  }
  return count > 0.0 ? sum / count : 0.0;
}

TEST_F(LightControllerTest, AWindowsLightStopsAtTheMemoryBudgetAndStays) {
  app::LightController window{app::LightController::Options{.background = true}};
  scene.gi.mode = scene::GiMode::transfer;
  scene.gi.extent = scene::GiExtent::full;
  // The tables, and some of the 64 blocks of 32 x 32 x 32 texels.
  const test::MemoryLimit limit(std::size_t{3} << 20);
  window.setScene(resolved(), volume);
  window.setVisible({surface()});
  ASSERT_TRUE(test::pollUntil([&] { return window.state().phase == Phase::failed; }));
  const app::LightState state = window.state();
  ASSERT_EQ(state.phase, Phase::failed);
  EXPECT_EQ(state.error->kind(), base::ErrorKind::memory);
  EXPECT_NE(state.error->reason().find("gi.lattice_scale"), std::string::npos) << state.error->reason();
  ASSERT_TRUE(window.light()) << "what is lit is still shown";
  EXPECT_GT(window.light()->sky->bakedTexels(), 0u);
}

TEST_F(LightControllerTest, ACommandsWholeLatticeIsRefusedBeforeItBegins) {
  scene.gi.mode = scene::GiMode::transfer;
  scene.gi.extent = scene::GiExtent::full;
  const test::MemoryLimit limit(std::size_t{3} << 20);
  controller.setScene(resolved(), volume);
  base::Progress progress;
  try {
    controller.finish(progress, 120.0);
    FAIL() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_NE(error.reason().find("32 x 32 x 32 texels"), std::string::npos) << error.reason();
  }
}

}  // namespace

TEST_F(LightControllerTest, WhatIsStoppedBeforeItIsPlannedWritesNoFile) {
  base::Progress progress;
  const std::filesystem::path file = test::temporaryFolder() / "early.vti";
  app::LightController fresh{app::LightController::Options{}};
  fresh.save(file, progress);
  EXPECT_FALSE(std::filesystem::exists(file));
  scene.look.mode = scene::LookMode::gi;
  fresh.setScene(scene, volume);
  fresh.save(file, progress);  // planned by now or not
  EXPECT_TRUE(!std::filesystem::exists(file) || gi::looksLikeBakeFile(file));
}

TEST_F(LightControllerTest, ABallUnderAWhiteSkyIsLitByPi) {
  scene.picture.metering = scene::Metering::lights;
  light();
  const auto picture = controller.light();
  ASSERT_TRUE(picture && picture->sky);
  EXPECT_FALSE(picture->lamps);
  EXPECT_GT(picture->sky->bakedTexels(), 1000u);
  EXPECT_NEAR(meanStored(*picture->sky), std::numbers::pi, 1e-3);
  EXPECT_EQ(controller.state().phase, Phase::finished);
  EXPECT_EQ(controller.state().mode, "irradiance");
  EXPECT_GT(controller.state().counters.rays, 0u);
  EXPECT_NEAR(picture->automaticExposure, 0.0f, 1e-6f) << "white in the open is white";
}

TEST_F(LightControllerTest, WhatAChangeKeepsAndWhatItDrops) {
  test::lampAt(scene, 0).shown = true;
  scene.gi.texels = scene::GiTexels::own;
  light();
  const auto before = controller.light();
  ASSERT_TRUE(before && before->sky && before->lamps);
  const auto change = [&](const auto& edit) {
    edit(scene);
    controller.setScene(resolved(), volume);
    EXPECT_TRUE(controller.settle(120.0));
    return controller.light();
  };
  auto now = change([](scene::Scene& s) {
    s.camera.eye = glm::dvec3(10.0, -300.0, 40.0);
    s.picture.supersampling = 3;
  });
  EXPECT_EQ(now, before) << "turning the view plans nothing anew";
  now = change([](scene::Scene& s) {
    s.surfaces.front().value = 0.5 * *s.surfaces.front().value + 0.01;
    s.camera.fov = 20.0;
    s.look.fog = 0.5;
    s.light.environment.exposure = 2.0;
    s.light.environment.constant = glm::dvec3(0.2, 0.4, 0.9);
    s.picture.exposure = 1.0;
  });
  EXPECT_EQ(now->sky, before->sky);
  EXPECT_EQ(now->lamps, before->lamps);
  EXPECT_NEAR(now->skyScale.y, 4.0f * 0.4f, 1e-5f) << "the colour of the sky is laid on in the picture";
  now = change([](scene::Scene& s) { test::lampAt(s, 0).color = glm::dvec3(1.0, 0.5, 0.2); });
  EXPECT_EQ(now->sky, before->sky) << "a lamp drops the lamps' light only";
  EXPECT_NE(now->lamps, before->lamps);
  now = change([](scene::Scene& s) { s.look.mode = scene::LookMode::blinn_phong; });
  EXPECT_EQ(now, nullptr) << "no look reads light";
  EXPECT_EQ(controller.state().phase, Phase::off);
  now = change([](scene::Scene& s) { s.look.mode = scene::LookMode::gi; });
  EXPECT_EQ(now->sky, before->sky) << "light outlasts another look";
  now = change([](scene::Scene& s) { s.surfaces.front().albedo = glm::dvec3(0.1); });
  EXPECT_NE(now->sky, before->sky) << "light is reflected";
}

// Light of the shown isosurface is baked anew for another isovalue; what was there stands in meanwhile.
TEST_F(LightControllerTest, AnotherIsovalueLeavesItsLightToStandIn) {
  light();
  const auto before = controller.light();
  ASSERT_TRUE(before->sky->geometry().isovalue);
  EXPECT_EQ(before->skyBefore, nullptr);
  const auto show = [&](double isovalue) {
    scene.surfaces.front().value = isovalue;
    controller.setScene(resolved(), volume);
    EXPECT_TRUE(controller.settle(120.0));
    return controller.light();
  };
  controller.setPaused(true);
  const auto next = show(0.3);
  EXPECT_NE(next->sky, before->sky);
  EXPECT_EQ(next->skyBefore, before->sky);
  EXPECT_EQ(show(0.6)->skyBefore, before->sky) << "no light came between";
  scene.surfaces.front().albedo = glm::dvec3(0.1);
  EXPECT_EQ(show(0.9)->skyBefore, nullptr) << "another light";
}

// A file of all isovalues serves a view, and one of a view all isovalues' extent.
TEST_F(LightControllerTest, AFileSaysWhereItsTexelsAreLit) {
  const auto file = temporaryFolder() / "light.vti";
  base::Progress progress;
  scene.gi.extent = scene::GiExtent::full;
  light();
  EXPECT_FALSE(controller.light()->sky->geometry().isovalue);
  controller.save(file, progress);
  scene.gi.extent = scene::GiExtent::view;
  light();
  EXPECT_TRUE(controller.light()->sky->geometry().isovalue);
  controller.load(file, progress);
  EXPECT_FALSE(controller.light()->sky->geometry().isovalue);
  EXPECT_GT(controller.light()->sky->bakedTexels(), 30000u);
  scene.gi.texels = scene::GiTexels::shown;
  controller.setScene(resolved(), volume);
  ASSERT_TRUE(controller.settle(120.0));
  EXPECT_THROW(controller.load(file, progress), base::Error);
}

TEST_F(LightControllerTest, ExposureIsBySurfaceAndLightAndFrozenWhileTheViewTurns) {
  scene.light.environment.constant.reset();
  const auto exposure = [&](const auto& edit) {
    edit(scene);
    controller.setScene(resolved(), volume);
    EXPECT_TRUE(controller.settle(120.0));
    return controller.light()->automaticExposure;
  };
  const float studio = exposure([](scene::Scene&) {});
  ASSERT_TRUE(controller.light()->seen);
  EXPECT_EQ(studio, static_cast<float>(gi::exposureOf(*controller.light()->seen)));
  EXPECT_EQ(exposure([](scene::Scene& s) {
              s.camera.eye = glm::dvec3(10.0, 300.0, 40.0);
              s.picture.supersampling = 4;
              s.gi.samples = 32;
              s.light.environment.moves = true;
            }),
            studio);
  controller.setVisible({surface()});
  EXPECT_EQ(exposure([](scene::Scene&) {}), studio) << "what is seen and stored so far does not matter";
  EXPECT_NE(exposure([](scene::Scene& s) { s.light.environment.builtIn = scene::BuiltInLight::sunset; }),
            studio);
  EXPECT_NEAR(exposure([](scene::Scene& s) {
                s.light.environment.builtIn = scene::BuiltInLight::studio;
                s.light.environment.exposure = 3.0;
              }),
              studio - 3.0f, 1e-5f);
  EXPECT_GT(exposure([](scene::Scene& s) { s.light.environment.azimuth = 180.0; }), studio - 3.0f)
      << "lit from behind";
  exposure([](scene::Scene& s) { s.picture.metering = scene::Metering::lights; });
  EXPECT_FALSE(controller.light()->seen);
}

TEST_F(LightControllerTest, AWindowsExposureWaitsUntilADraggedIsovalueRests) {
  app::LightController window{app::LightController::Options{.background = true}};
  test::lampAt(scene, 0).shown = true;  // nearer to a larger ball
  window.setScene(resolved(), volume);
  ASSERT_TRUE(window.settle(120.0));
  const float before = window.light()->automaticExposure;
  const auto begin = std::chrono::steady_clock::now();
  scene.surfaces.front().value = -3.0;  // a larger ball
  window.setScene(resolved(), volume);
  ASSERT_TRUE(window.settle(120.0));
  const float during = window.light()->automaticExposure;
  const bool quick = std::chrono::steady_clock::now() - begin < std::chrono::milliseconds(250);
  EXPECT_TRUE(!quick || during == before) << during << ' ' << before;
  EXPECT_TRUE(test::pollUntil([&] { return window.light()->automaticExposure != before; }));
  controller.setScene(resolved(), volume);  // a command's is at once the same
  ASSERT_TRUE(controller.settle(120.0));
  EXPECT_EQ(controller.light()->automaticExposure, window.light()->automaticExposure);
}

TEST_F(LightControllerTest, AMissingProbeIsSaidAndAnotherWorks) {
  scene.light.environment.file = "no_such_probe.hdr";
  controller.setScene(resolved(), volume);
  ASSERT_TRUE(controller.settle(120.0));
  EXPECT_EQ(controller.state().phase, Phase::failed);
  ASSERT_TRUE(controller.state().error.has_value());
  EXPECT_EQ(controller.state().error->kind(), base::ErrorKind::input);
  EXPECT_EQ(controller.light(), nullptr);
  base::Progress progress;
  EXPECT_THROW(controller.finish(progress, 10.0), base::Error);
  scene.light.environment.file.clear();
  light();
  EXPECT_EQ(controller.state().phase, Phase::finished);
  EXPECT_FALSE(controller.state().error.has_value());
}

TEST_F(LightControllerTest, PauseCancelAndGoOn) {
  scene.gi.samples = 1000000;  // for ever
  controller.setScene(resolved(), volume);
  controller.setVisible({surface()});
  ASSERT_TRUE(controller.settle(120.0));
  controller.setPaused(true);
  EXPECT_EQ(controller.state().phase, Phase::paused);
  controller.setPaused(false);
  EXPECT_TRUE(comesTo(Phase::baking));
  controller.cancel();
  ASSERT_TRUE(controller.settle(120.0));
  EXPECT_TRUE(comesTo(Phase::finished)) << "nothing is wanted any more";
  scene.gi.samples = 16;
  light();
  EXPECT_TRUE(comesTo(Phase::finished));
}

TEST_F(LightControllerTest, TransferIsCompressedWhenItIsFinished) {
  scene.light.environment.file = "";
  scene.gi.mode = scene::GiMode::transfer;
  scene.gi.shOrder = 3;
  light();
  const auto picture = controller.light();
  ASSERT_TRUE(picture && picture->sky && picture->basis);
  EXPECT_EQ(picture->environment.size(), 9u);
  const gi::TransferBasis::Lighting lighting = picture->basis->under(picture->environment);
  EXPECT_EQ(lighting.factors.size(), picture->basis->fields().size());
  // Turning a sky of one colour changes nothing but the version.
  scene.light.environment.rotation = {0.0, 0.0, 0.0, 1.0};
  controller.setScene(resolved(), volume);
  ASSERT_TRUE(controller.settle(120.0));
  EXPECT_EQ(controller.light()->sky, picture->sky);
  EXPECT_NEAR(controller.light()->environment[0].x, picture->environment[0].x, 1e-5f);
}

// Else two pictures of the same scene differ, by which texels there were when the last thread was still at
// work.
TEST_F(LightControllerTest, TransferOfAFinishedPictureIsCompressedFromAllItsTexels) {
  scene.gi.mode = scene::GiMode::transfer;
  scene.gi.shOrder = 3;
  scene.gi.samples = 1024;  // long enough for a first basis while light is traced
  const std::vector<glm::vec3> seen = surface();
  for (int i = 0; i < 4; ++i) {
    app::LightController fresh{{.threads = 2}};
    fresh.setScene(resolved(), volume);
    fresh.setVisible({seen});
    base::Progress progress;
    ASSERT_TRUE(fresh.finish(progress, 120.0));
    const auto picture = fresh.light();
    ASSERT_TRUE(picture && picture->sky && picture->basis);
    const auto expected =
        test::basisOf(*picture->sky, scene.gi.components, scene.gi.components * scene.gi.componentBits);
    ASSERT_EQ(picture->basis->fields(), expected->fields()) << "round " << i;
  }
}

// The planner looks every 100 ms whether to compress, and at each new plan: load() meets it at work.
TEST_F(LightControllerTest, LoadsWhileThePlannerCompresses) {
  scene.gi.mode = scene::GiMode::transfer;
  scene.gi.shOrder = 3;
  light();
  const auto file = temporaryFolder() / "light.vti";
  base::Progress progress;
  controller.save(file, progress);
  const std::uint64_t lit = controller.light()->sky->bakedTexels();
  for (int i = 0; i < 10; ++i) {
    controller.load(file, progress);
    const auto loaded = controller.light();
    ASSERT_TRUE(loaded && loaded->sky);
    EXPECT_EQ(loaded->sky->bakedTexels(), lit);
  }
  ASSERT_TRUE(controller.finish(progress, 120.0));
  EXPECT_TRUE(controller.light()->basis) << "what was loaded is compressed";
}

// Nothing is traced or kept of inner sides before one is seen; from then on both are baked.
TEST_F(LightControllerTest, InnerSidesAreBakedOnceTheyAreSeen) {
  scene.gi.texels = scene::GiTexels::shown;
  test::lampAt(scene, 0).shown = true;
  light();
  const auto without = controller.light();
  const gi::BakeCounters before = controller.state().counters;
  EXPECT_EQ(without->inner, gi::StoredSide());
  base::Progress progress;
  controller.setVisible({surface(), {surface().front()}});
  ASSERT_TRUE(controller.finish(progress, 120.0));
  const auto with = controller.light();
  ASSERT_TRUE(with->inner.sky && with->inner.lamps);
  EXPECT_EQ(with->sky, without->sky);
  EXPECT_EQ(with->inner.sky->bakedTexels(), 8u);
  EXPECT_EQ(controller.state().counters.texelsLit, before.texelsLit + 16u);
  // Seen no longer: it stays as long as it is right.
  controller.setVisible({surface()});
  ASSERT_TRUE(controller.finish(progress, 120.0));
  EXPECT_EQ(controller.light()->inner, with->inner);
  scene.look.mode = scene::LookMode::normal;
  light();
  scene.look.mode = scene::LookMode::gi;
  light();
  EXPECT_EQ(controller.light()->inner.sky, with->inner.sky);
  scene.surfaces.front().value = *resolved().surfaces.front().value + 0.25;
  light();
  EXPECT_EQ(controller.light()->inner, gi::StoredSide());
}

TEST_F(LightControllerTest, LightOfInnerSidesFollowsTheIsovalue) {
  scene.gi.texels = scene::GiTexels::shown;
  const auto show = [&](double isovalue) {
    scene.surfaces.front().value = isovalue;
    controller.setScene(resolved(), volume);
    controller.setVisible({surface(), surface()});
    base::Progress progress;
    EXPECT_TRUE(controller.finish(progress, 120.0));
    return controller.light();
  };
  const auto first = show(0.5), second = show(0.75);
  EXPECT_NE(second->inner.sky, first->inner.sky);
  EXPECT_EQ(second->inner.skyBefore, first->inner.sky);
}

// One isosurface, its two sides exchanged: the same paths, bit for bit.
TEST_F(LightControllerTest, TheInnerSideIsTheOuterSideOfTheOtherInside) {
  const auto lit = [&](scene::Inside inside, gi::VisiblePointSet seen) {
    scene.isosurface.inside = inside;
    app::LightController fresh{{}};
    fresh.setScene(resolved(), volume);
    fresh.setVisible(std::move(seen));
    base::Progress progress;
    EXPECT_TRUE(fresh.finish(progress, 120.0));
    return fresh.light();
  };
  const auto inner = lit(scene::Inside::above, {{}, surface()})->inner.sky;
  const auto outer = lit(scene::Inside::below, {surface()})->sky;
  EXPECT_EQ(inner->key(), outer->key());
  ASSERT_EQ(inner->bakedTexels(), outer->bakedTexels());
  for (std::uint32_t block = 0; block < outer->geometry().blockCount(); ++block) {
    const auto a = outer->at(block), b = inner->at(block);
    if (!a) continue;
    ASSERT_TRUE(b);
    EXPECT_EQ(a->samples, b->samples);
    EXPECT_EQ(a->normals, b->normals);
    EXPECT_EQ(a->means, b->means);
  }
}

// Through a transparent surface its own far side is seen.
TEST_F(LightControllerTest, InnerSidesThatAreSeenAreLit) {
  scene.surfaces.front().opacity = 0.9;
  controller.setScene(resolved(), volume);
  controller.setVisible({surface(), surface()});
  base::Progress done;
  ASSERT_TRUE(controller.finish(done, 120.0));
  const auto both = controller.light();
  ASSERT_TRUE(both->inner.sky);
  EXPECT_EQ(both->inner.sky->bakedTexels(), both->sky->bakedTexels());
  app::LightController outerOnly{{.innerSides = false}};
  outerOnly.setScene(resolved(), volume);
  outerOnly.setVisible({surface(), surface()});
  base::Progress progress;
  ASSERT_TRUE(outerOnly.finish(progress, 120.0));
  EXPECT_EQ(outerOnly.light()->inner, gi::StoredSide());
}

// Compressed in one basis with the outer side's: it is fitted to the texels of both.
TEST_F(LightControllerTest, TransferOfBothSidesIsCompressedTogether) {
  scene.gi.mode = scene::GiMode::transfer;
  scene.gi.shOrder = 3;
  controller.setScene(resolved(), volume);
  controller.setVisible({surface(), surface()});
  base::Progress progress;
  ASSERT_TRUE(controller.finish(progress, 120.0));
  const auto picture = controller.light();
  ASSERT_TRUE(picture->inner.sky && picture->basis);
  const std::vector<const gi::LightLattice*> both = {picture->sky.get(), picture->inner.sky.get()};
  const auto expected =
      gi::TransferBasis::fit(both, scene.gi.components, scene.gi.components * scene.gi.componentBits);
  EXPECT_EQ(picture->basis->fields(), expected->fields());
}

TEST_F(LightControllerTest, AWindowThatClosesDoesNotWaitForTheBake) {
  scene.gi.samples = 1000000;  // for ever
  long fewest = std::numeric_limits<long>::max();
  for (int i = 0; i < 5; ++i) {
    auto ofWindow = std::make_unique<app::LightController>(app::LightController::Options{.background = true});
    ofWindow->setScene(resolved(), volume);
    ofWindow->setVisible({surface()});
    ASSERT_TRUE(test::pollUntil([&] { return ofWindow->state().counters.rays > 0; }));
    fewest = std::min(fewest, ownWaits([&] { ofWindow.reset(); }));
  }
  EXPECT_EQ(fewest, 0) << "who waited for the bake would give up the processor each time";
  EXPECT_TRUE(base::awaitDestroyed(600.0));
}

TEST_F(LightControllerTest, TheLeastChangeOfAConstantSkyIsAChange) {
  scene.gi.mode = scene::GiMode::transfer;  // whose environment is projected, and named
  scene.gi.shOrder = 2;
  scene.light.environment.constant = glm::dvec3(1e-7);
  light();
  const float before = controller.light()->environment[0].x;
  scene.light.environment.constant = glm::dvec3(3e-7);
  controller.setScene(resolved(), volume);
  ASSERT_TRUE(controller.settle(120.0));
  EXPECT_NEAR(controller.light()->environment[0].x / before, 3.0f, 1e-3f);
}

}  // namespace isolux::test
