// The points of a plot of error against cost, and the quality settings that act in a scene.
#include "app/study/quality_points.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "scene/settings/scene_diff.h"
#include "scene/settings/settings.h"

namespace isolux::app {
namespace {

const QualitySetting& qualityNamed(const std::string& name) {
  static std::vector<QualitySetting> found;
  found = parseQualitySettings(name);
  return found.front();
}

std::vector<std::string> namesOf(const std::vector<QualitySetting>& list) {
  std::vector<std::string> names;
  for (const QualitySetting& quality : list) names.emplace_back(quality.name);
  return names;
}

bool has(const std::vector<QualitySetting>& list, const std::string& name) {
  for (const std::string& each : namesOf(list))
    if (each == name) return true;
  return false;
}

TEST(QualityPoints, TheFrontIsWhatNothingBeatsInBoth) {
  std::vector<QualityPoint> points = {{"dear and exact", 8.0, 0.0}, {"cheap", 1.0, 0.5},
                                      {"as dear, worse", 8.0, 0.1}, {"beaten", 3.0, 0.6},
                                      {"between", 2.0, 0.1},        {"twin", 2.0, 0.1}};
  markFront(points);
  const std::vector<bool> expected = {true, true, false, false, true, true};
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_EQ(points[i].onFront, expected[i]) << points[i].value;
}

TEST(QualityPoints, TellTheDefaultAndThePresentAndLeaveOutWhatHasNoError) {
  QualityStudy study{.quality = qualityNamed("derivatives_field"), .settings = {}, .plot = {}};
  const double errors[] = {3.0, 0.5, std::numeric_limits<double>::quiet_NaN()};
  for (std::size_t i = 0; i < 3; ++i) {
    StudySetting setting;
    setting.value = study.quality.values[i];
    setting.isDefault = setting.value == defaultValue(study.quality);
    setting.passMilliseconds["gradient"] = 1.0 + static_cast<double>(i);
    Errors judged;
    judged.normalDegrees.rms = errors[i];
    setting.fieldErrors = judged;
    study.settings.push_back(setting);
  }
  scene::Scene scene;
  scene.derivatives.field = scene::Field::trilinear;
  const std::vector<QualityPoint> points = pointsOf(study, scene, {});
  ASSERT_EQ(points.size(), 2u);
  EXPECT_EQ(points[0].value, "trilinear");
  EXPECT_TRUE(points[0].isPresent && !points[0].isDefault);
  EXPECT_EQ(points[0].error, 3.0);
  EXPECT_EQ(points[0].cost, 1.0);
  EXPECT_TRUE(points[1].isDefault && !points[1].isPresent);
}

TEST(QualityPoints, SamplingsKnobsActWhereHitsAreSampledAndLightsWhereLightIsRead) {
  scene::Scene scene;
  EXPECT_FALSE(has(actingQualitySettings(scene, {}), "rate"));
  EXPECT_FALSE(has(actingQualitySettings(scene, {}), "samples"));
  EXPECT_TRUE(has(actingQualitySettings(scene, {}), "method"));
  scene.hit.method = scene::HitMethod::sampled;
  EXPECT_TRUE(has(actingQualitySettings(scene, {}), "rate"));
  scene.look.mode = scene::LookMode::gi;
  EXPECT_TRUE(has(actingQualitySettings(scene, {}), "samples"));
}

TEST(QualityPoints, AKnobChangesItsSettingAloneAndItsDefaultStaysAutomatic) {
  const scene::Scene scene;
  for (const QualitySetting& quality : qualitySettings()) {
    EXPECT_EQ(withQualitySettingAt(quality, defaultValue(quality), scene, {}), scene) << quality.name;
    for (const std::string& value : quality.values) {
      const scene::Scene turnedOne = withQualitySettingAt(quality, value, scene, {});
      const scene::SceneDiff changed = scene::difference(scene, turnedOne, "");
      EXPECT_LE(changed.changes.size(), 1u) << quality.name << ' ' << value;
      for (const scene::SceneChange& change : changed.changes) EXPECT_EQ(change.path, quality.setting);
    }
  }
}

}  // namespace
}  // namespace isolux::app
