#include "app/documents/unsaved_work.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "scene/settings/settings.h"

namespace isolux::app {
namespace {

using scene::Scene;

// The same scene with one setting changed.
Scene with(Scene scene, const char* assignment) {
  scene::applyAssignment(scene, assignment);
  return scene;
}

TEST(UnsavedWork, AnUnchangedSceneHoldsNone) {
  EXPECT_EQ(unsavedWork(Scene{}, Scene{}), UnsavedWork::none);
  EXPECT_FALSE(asksBeforeDiscarding(UnsavedWork::none, true));
  EXPECT_FALSE(asksBeforeDiscarding(UnsavedWork::none, false));
}

TEST(UnsavedWork, ATurnedViewCountsOnlyForAScenesOwnFile) {
  for (const char* view : {"camera.eye=0,-400,0", "camera.fov=40", "flow.time=3", "picture.letters=true",
                           "picture.scale_bar=true", "picture.isovalue=true", "picture.transparent=true"})
    EXPECT_EQ(unsavedWork(Scene{}, with({}, view)), UnsavedWork::view) << view;
  EXPECT_FALSE(asksBeforeDiscarding(UnsavedWork::view, false));
  EXPECT_TRUE(asksBeforeDiscarding(UnsavedWork::view, true));
}

TEST(UnsavedWork, EveryOtherSettingIsWork) {
  for (const scene::Setting& setting : scene::settings()) {
    if (setting.path.starts_with("camera.") || setting.path == "flow.time") continue;
    if (setting.path.starts_with("picture.") && setting.path != "picture.rest_hits") continue;  // words on it
    Scene saved;
    if (setting.type == scene::SettingType::toggle) {
      setting.set(saved, !setting.get(saved).get<bool>());
    } else if (setting.type == scene::SettingType::text) {
      setting.set(saved, "phantom:torus");
    } else {
      continue;
    }
    EXPECT_EQ(unsavedWork(saved, Scene{}), UnsavedWork::work) << setting.path;
  }
  for (const char* work : {"isosurface.value=300", "look.mode=normal", "light.environment.constant=1,0,0"})
    EXPECT_EQ(unsavedWork(Scene{}, with({}, work)), UnsavedWork::work) << work;
  EXPECT_EQ(unsavedWork(Scene{}, with(with({}, "camera.fov=40"), "isosurface.value=300")), UnsavedWork::work);
  for (const bool hasFile : {false, true}) EXPECT_TRUE(asksBeforeDiscarding(UnsavedWork::work, hasFile));
}

}  // namespace
}  // namespace isolux::app
