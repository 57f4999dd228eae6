// Settings of the machine: set like the scene's, and carried by no session.
#include "scene/settings/host_settings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/settings.h"

namespace isolux::scene {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

TEST(HostSettings, AssignmentsAreThoseOfTheCommandLine) {
  HostSettings host;
  applyAssignment(host, "memory.gpu_budget_mb=512");
  applyAssignment(host, "memory.layout=bricks");
  applyAssignment(host, " gi.threads = 3 ");
  applyAssignment(host, "picture.adaptive=off");
  applyAssignment(host, "picture.executor=cpu");
  applyAssignment(host, "picture.motion_target=20.5");
  EXPECT_EQ(host, (HostSettings{{512, MemoryLayout::bricks}, 3, false, 20.5, Executor::cpu}));
  applyAssignment(host, "gi.threads=auto");
  EXPECT_FALSE(host.threads);
  for (const char* bad :
       {"memory.gpu_budget_mb=3", "memory.layout=tiles", "gi.threads=0", "picture.adaptive=7"})
    try {
      applyAssignment(host, bad);
      ADD_FAILURE() << bad;
    } catch (const base::Error& error) {
      EXPECT_THAT(error.what(), testing::AnyOf(HasSubstr("; must be "), HasSubstr("; choose "))) << bad;
    }
}

TEST(HostSettings, NoPathIsOfTheSceneAndOfTheMachine) {
  EXPECT_EQ(hostSettings().size(), 9u);
  for (const HostSetting& s : hostSettings()) {
    EXPECT_TRUE(isHostSetting(s.path + "=1"));
    EXPECT_THROW(setting(s.path), base::Error) << s.path;
  }
  for (const Setting& s : settings()) EXPECT_FALSE(isHostSetting(s.path)) << s.path;
}

TEST(HostSettings, ASlipOfItsPathIsAnsweredWithIt) {
  try {
    setting("memory.gpu_budget");
    ADD_FAILURE();
  } catch (const base::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("memory.gpu_budget_mb"));
  }
}

// Older sessions and recordings carry another user's hardware.
TEST(HostSettings, OlderFilesArePassedOver) {
  const Scene scene = fromJson(json::parse(R"({
    "memory": {"gpu_budget_mb": 64, "layout": "bricks"}, "gi": {"threads": 2, "samples": 7},
    "picture": {"adaptive": false, "motion_target": 100, "supersampling": 3}})"));
  EXPECT_EQ(scene.gi.samples, 7);
  EXPECT_EQ(scene.picture.supersampling, 3);
  Scene expected;
  expected.gi.samples = 7;
  expected.picture.supersampling = 3;
  EXPECT_TRUE(scene == expected);
  EXPECT_FALSE(toJson(scene).contains("memory"));
  EXPECT_FALSE(toJson(scene)["gi"].contains("threads"));

  const SceneDiff diff{"Old", {{"memory.layout", "whole"}, {"gi.threads", 2}, {"gi.samples", 9}}};
  EXPECT_EQ(applied(scene, diff).gi.samples, 9);
  EXPECT_THROW(fromJson(json::parse(R"({"memory": {"gpu_budgets": 64}})")), base::Error);
}

}  // namespace
}  // namespace isolux::scene
