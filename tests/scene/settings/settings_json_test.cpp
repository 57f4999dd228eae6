#include <cmath>
#include <iterator>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/settings.h"
#include "tests/scene/random_scene.h"

namespace isolux::scene {
namespace {

using nlohmann::json;
using test::randomScene;
using testing::HasSubstr;

template <class Body>
std::string errorOf(Body body) {
  try {
    body();
  } catch (const base::Error& error) {
    return error.what();
  }
  ADD_FAILURE() << "no base::Error was thrown";
  return {};
}

TEST(SceneJson, DefaultsRoundTrip) {
  const json stored = toJson(Scene{});
  EXPECT_TRUE(fromJson(stored) == Scene{});
  EXPECT_EQ(stored["surfaces"].size(), 1U);
  EXPECT_EQ(stored["surfaces"][0]["id"], "main");
  EXPECT_EQ(stored["surfaces"][0]["value"], "auto");
  EXPECT_EQ(stored["lamps"], json::array());
  EXPECT_EQ(stored["look"]["mode"], "blinn_phong");
  EXPECT_EQ(stored["source"]["time_step"], 0);
}

TEST(SceneJson, RandomScenesRoundTripExactlyThroughText) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 200; ++i) {
    const Scene scene = randomScene(random);
    EXPECT_TRUE(fromJson(json::parse(toJson(scene).dump())) == scene);
  }
}

TEST(SceneJson, NumbersRoundTripToTheLastBit) {
  for (const double value : {0.1, 1.0 / 3.0, 1e-20, 5e-324, 2.2250738585072014e-308, 123456789.123456789,
                             -0.0, std::nextafter(1.0, 2.0), 300.0, 1e38}) {
    Scene scene;
    scene.surfaces.front().value = value;
    const Scene back = fromJson(json::parse(toJson(scene).dump()));
    ASSERT_TRUE(back.surfaces.front().value);
    EXPECT_EQ(std::signbit(*back.surfaces.front().value), std::signbit(value));
    EXPECT_EQ(*back.surfaces.front().value, value);
  }
}

TEST(SceneJson, MissingKeysTakeDefaults) {
  EXPECT_TRUE(fromJson(json::object()) == Scene{});
  Scene expected;
  expected.camera.fov = 40;
  EXPECT_TRUE(fromJson(json::parse(R"({"camera": {"fov": 40}, "look": {}})")) == expected);
}

TEST(SceneJson, UnknownKeysFailWithTheirPath) {
  EXPECT_THAT(errorOf([] { fromJson(json::parse(R"({"camera": {"fow": 40}})")); }), HasSubstr("camera.fow"));
  EXPECT_THAT(errorOf([] { fromJson(json::parse(R"({"camera": {"fow": 40}})")); }), HasSubstr("camera.fov?"));
  EXPECT_THAT(errorOf([] { fromJson(json::parse(R"({"kamera": {}})")); }), HasSubstr("did you mean camera?"));
  EXPECT_THAT(errorOf([] { fromJson(json::parse(R"({"camera.fov": 40})")); }),
              HasSubstr("camera.fov: unknown"));
  EXPECT_THAT(errorOf([] { fromJson(json::parse(R"({"": {}})")); }), HasSubstr("unknown"));
  EXPECT_THAT(errorOf([] { fromJson(json::parse(R"({"camera": 3})")); }), HasSubstr("camera: must be"));
  EXPECT_THAT(errorOf([] { fromJson(json::parse("[]")); }), HasSubstr("object"));
}

TEST(SceneJson, DeepValuesAreRefusedWithoutRecursion) {
  const std::string deep = std::string(200000, '[') + std::string(200000, ']');
  const json scene = json::parse(R"({"isosurface": {"value": )" + deep + "}}");
  EXPECT_THAT(errorOf([&] { fromJson(scene); }), HasSubstr("a list of 1"));
}

TEST(SceneDiff, NamesExactlyWhatDiffersAndInverts) {
  std::mt19937_64 random(11);
  for (int i = 0; i < 100; ++i) {
    const Scene from = randomScene(random), to = randomScene(random);
    EXPECT_TRUE(applied(from, difference(from, to, "there")) == to);
    EXPECT_TRUE(applied(to, difference(to, from, "back")) == from);
  }
  Scene changed;
  changed.look.mode = LookMode::depth;
  const SceneDiff diff = difference(Scene{}, changed, "Change look");
  EXPECT_EQ(diff, (SceneDiff{"Change look", {{"look.mode", "depth"}}}));
  EXPECT_TRUE(difference(changed, changed, "").changes.empty());
}

TEST(SceneDiff, RefusesWhatIsNotAllowed) {
  EXPECT_THROW(applied(Scene{}, {"", {{"camera.fov", 1000}}}), base::Error);
  EXPECT_THROW(applied(Scene{}, {"", {{"camera.nothing", 1}}}), base::Error);
}

}  // namespace
}  // namespace isolux::scene
