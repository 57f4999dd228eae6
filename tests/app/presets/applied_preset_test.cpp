#include "app/presets/applied_preset.h"

#include <gtest/gtest.h>

#include "app/presets/preset_list.h"
#include "app/presets/thumbnails.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

using app::appliedPreset;

// Every preset of the program, shifted by any amount, is known again from the scene.
TEST(AppliedPreset, IsToldFromTheSceneAlone) {
  const auto head = phantom("head", 24), ball = phantom("ball", 24);
  const auto presets = app::builtInPresets();
  int applied = 0;
  for (const auto& volume : {head, ball})
    for (std::size_t i = 0; i < presets.size(); ++i) {
      if (!whyNot(presets[i], *volume).empty()) continue;
      ++applied;
      for (const double shift : {0.0, 12.5, -37.0 / 3.0}) {
        SCOPED_TRACE(presets[i].name + " " + std::to_string(shift));
        scene::Scene scene = withPreset({}, presets[i], *volume, shift);
        scene.camera.fov = 41.0;  // no preset's business
        const auto found = appliedPreset(scene, presets, *volume);
        ASSERT_TRUE(found);
        EXPECT_EQ(presets[found->index].name, presets[i].name);
        EXPECT_NEAR(found->shift, shift, 1e-9);
        scene.look.fog = 0.5;
        EXPECT_FALSE(appliedPreset(scene, presets, *volume)) << "changed since";
      }
    }
  EXPECT_GE(applied, 7);
}

// CT skin and MR skin differ in their isovalues and needs alone.
TEST(AppliedPreset, IsNoneOfThoseThatDoNotApply) {
  auto changed = *phantom("head", 24);
  changed.volume.unit = "a.u.";
  changed.facts.axes = scene::WorldAxes::anatomical;
  const auto presets = app::builtInPresets();
  int applied = 0;
  for (std::size_t i = 0; i < presets.size(); ++i) {
    if (!whyNot(presets[i], changed).empty()) continue;
    ++applied;
    const auto found = appliedPreset(withPreset({}, presets[i], changed), presets, changed);
    ASSERT_TRUE(found) << presets[i].name;
    EXPECT_EQ(presets[found->index].name, presets[i].name);
    EXPECT_EQ(found->shift, 0.0) << presets[i].name;
  }
  EXPECT_GE(applied, 3);
}

TEST(AppliedPreset, OfPresetsWithOtherIsovaluesOnlyIsThatWhichNeedsTheLeastShift) {
  const auto head = phantom("head", 24);
  const std::vector<app::Preset> presets{
      {"low", "Low", "", {}, {{"isosurface.value", 100.0}, {"look.mode", "tone"}}},
      {"high", "High", "", {}, {{"isosurface.value", 400.0}, {"look.mode", "tone"}}}};
  const auto shown = [&](double value, std::optional<std::size_t> last = {}) {
    scene::Scene scene = withPreset({}, presets[0], *head);
    scene.surfaces.front().value = value;
    const auto found = appliedPreset(scene, presets, *head, last);
    EXPECT_TRUE(found);
    return found ? std::pair(presets[found->index].name, found->shift) : std::pair(std::string(), 0.0);
  };
  EXPECT_EQ(shown(100.0), std::pair(std::string("low"), 0.0));
  EXPECT_EQ(shown(400.0), std::pair(std::string("high"), 0.0)) << "not the first, shifted by 300";
  EXPECT_EQ(shown(400.0, 0), std::pair(std::string("high"), 0.0));
  EXPECT_EQ(shown(110.0), std::pair(std::string("low"), 10.0));
  EXPECT_EQ(shown(390.0), std::pair(std::string("high"), -10.0));
  EXPECT_EQ(shown(390.0, 0), std::pair(std::string("low"), 290.0)) << "it is being shifted";
}

TEST(Thumbnails, ShowPresetsThenLooksAndSayWhatDoesNotApply) {
  const auto ball = phantom("ball", 16);
  const auto presets = app::builtInPresets();
  scene::Scene scene;
  scene.surfaces.front().name = "Mine";
  const auto all = app::thumbnailsOf(scene, presets, *ball);
  ASSERT_GT(all.size(), presets.size() + 5);
  for (std::size_t i = 0; i < presets.size(); ++i) {
    EXPECT_EQ(all[i].name, presets[i].name);
    EXPECT_EQ(all[i].why, whyNot(presets[i], *ball));
    EXPECT_EQ(all[i].scene, all[i].why.empty() ? withPreset(scene, presets[i], *ball) : scene);
  }
  EXPECT_EQ(all.back().kind, app::Thumbnail::Kind::look);
  // What changes no picture does not enter: it is not drawn again.
  scene::Scene renamed = scene;
  renamed.surfaces.front().name = "Other";
  EXPECT_EQ(app::drawnThumbnail(app::thumbnailsOf(renamed, presets, *ball).back(), *ball),
            app::drawnThumbnail(all.back(), *ball));
}

}  // namespace
}  // namespace isolux::test
