// Every setting of the list comes back as it was from a session, from --set, from undo and from a recording.
#include <array>
#include <random>

#include <gtest/gtest.h>

#include "app/documents/command_text.h"
#include "app/documents/history.h"
#include "app/documents/recording.h"
#include "app/documents/session.h"
#include "scene/settings/scene_diff.h"
#include "tests/scene/random_scene.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

using scene::Scene;

constexpr int kScenes = 12;

// Sessions name files by where they lie.
Scene withPlaces(Scene scene) {
  const std::filesystem::path folder = test::temporaryFolder();
  scene.source.path = (folder / "volume.nii").string();
  scene.source.csgPath = (folder / "second.nii").string();
  scene.light.environment.file = (folder / "light.hdr").string();
  scene.color.volume = (folder / "colours.nii").string();
  scene.source.labelNames = (folder / "names.tsv").string();
  return scene;
}

// Each setting in turn is the only one that differs from the default.
class EverySetting : public testing::Test {
 protected:
  template <class Check>
  void forEach(const Check& check) {
    std::mt19937_64 random(11);
    for (int i = 0; i < kScenes; ++i) {
      const Scene values = withPlaces(test::randomScene(random));
      for (const scene::Setting& setting : scene::settings()) {
        Scene scene;
        setting.set(scene, setting.get(values));
        check(setting, scene);
      }
      for (const scene::Setting& setting : scene::itemSettings(values)) {
        Scene scene;  // with the items and this setting
        for (const scene::SceneList& list : scene::sceneLists()) list.arrange(scene, list.ids(values));
        if (scene::positionOf(scene, setting.path)) setting.set(scene, setting.get(values));
        check(setting, scene);
      }
    }
  }
};

TEST_F(EverySetting, ComesBackFromASession) {
  const std::filesystem::path file = test::temporaryFolder() / "one.isolux";
  forEach([&](const scene::Setting& setting, const Scene& scene) {
    const Scene back =
        parseSession(sessionText(scene, file.parent_path()), file.string(), {file.parent_path()});
    EXPECT_TRUE(back == scene) << setting.path << ": " << setting.get(back) << ", was " << setting.get(scene);
  });
}

TEST_F(EverySetting, ComesBackFromTheCommandLine) {
  forEach([&](const scene::Setting& setting, const Scene& scene) {
    Scene back;
    std::string text;
    for (const scene::SceneChange& change : scene::assignmentsOf(scene)) {
      text = assignmentText(change.path, change.value);
      scene::applyAssignment(back, text);
    }
    EXPECT_TRUE(back == scene) << text << ": " << setting.get(back);
  });
}

TEST_F(EverySetting, IsUndoneAndDoneAgain) {
  forEach([&](const scene::Setting& setting, const Scene& scene) {
    History history;
    history.edit(scene, "Change");
    if (scene == Scene{}) return;  // the random value is the default
    history.undo();
    EXPECT_TRUE(history.scene() == Scene{}) << setting.path;
    history.redo();
    EXPECT_TRUE(history.scene() == scene) << setting.path;
  });
}

TEST_F(EverySetting, ComesBackFromARecording) {
  const std::filesystem::path file = test::temporaryFolder() / "all.jsonl";
  std::vector<Scene> scenes{Scene{}};
  {
    Recorder recorder(file, scenes.front());
    forEach([&](const scene::Setting&, const Scene& scene) {
      recorder.add(scene::difference(scenes.back(), scene, "Change"), static_cast<double>(scenes.size()));
      scenes.push_back(scene);
    });
  }
  const Recording recording = loadRecording(file);
  Scene now = recording.start;
  std::size_t step = 0;
  for (std::size_t i = 1; i < scenes.size(); ++i) {
    if (step < recording.steps.size() && recording.steps[step].seconds == static_cast<double>(i))
      now = scene::applied(std::move(now), recording.steps[step++].diff);
    ASSERT_TRUE(now == scenes[i]) << "step " << i;
  }
  EXPECT_EQ(step, recording.steps.size());
}

}  // namespace
}  // namespace isolux::app
