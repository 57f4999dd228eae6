// Light of one kind of arithmetic is the same bit for bit, whatever instructions computed it.
#include <cstdint>
#include <filesystem>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include "app/light/light_controller.h"
#include "base/progress.h"
#include "scene/rules/automatic.h"
#include "scene/settings/settings.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/app/same_picture/ways.h"
#include "tests/support/test_data.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::test {
namespace {

// The file of a whole bake, by the widest of these instruction sets.
std::string wholeBake(std::int64_t sets, const std::vector<std::string>& settings) {
  const InstructionSetsLeft left(sets);
  scene::Scene scene;
  scene.source.path = "phantom:head:28";
  scene.look.mode = scene::LookMode::gi;
  scene.gi.extent = scene::GiExtent::full;
  for (const std::string& setting : settings) scene::applyAssignment(scene, setting);
  base::Progress progress;
  const auto volume = volume::loadVolume(scene.source, progress);
  app::LightController light{app::LightController::Options{}};
  light.setScene(scene::resolve(scene, volume->facts), volume);
  EXPECT_TRUE(light.finish(progress, 240.0));
  const std::filesystem::path file = temporaryFolder() / "light.vti";
  light.save(file, progress);
  return contentOf(file);
}

TEST(SameBits, WholeBakesByAvx2AndAvx512) {
  if ((hwy::SupportedTargets() & HWY_AVX3) == 0) {
    std::cout << "this processor has no AVX-512\n";
    return;
  }
  const std::vector<std::string> kinds[] = {
      {"gi.samples=16", "light.environment.builtin=sunset", "gi.bounces=2"},
      {"gi.samples=16", "gi.mode=transfer"},
      {"gi.samples=16", "lamp1.shown=true", "lamp1.kind=sphere"}};
  for (const std::vector<std::string>& settings : kinds) {
    const std::string narrow = wholeBake(HWY_AVX2, settings), wide = wholeBake(HWY_AVX3, settings);
    EXPECT_GT(narrow.size(), 100'000u);
    EXPECT_TRUE(narrow == wide) << settings[1];
  }
}

}  // namespace
}  // namespace isolux::test
