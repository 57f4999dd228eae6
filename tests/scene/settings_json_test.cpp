#include <cmath>
#include <limits>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/settings.h"

namespace isolux::scene {
namespace {

using nlohmann::json;
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

double randomIn(double low, double high, std::mt19937_64& random) {
  return std::uniform_real_distribution<double>(low, high)(random);
}

// A scene with every setting at random.
Scene randomScene(std::mt19937_64& random) {
  Scene scene;
  for (const Setting& s : settings()) {
    const auto number = [&] { return randomIn(s.minimum, s.maximum, random); };
    switch (s.type) {
      case SettingType::number:
        s.set(scene, number());
        break;
      case SettingType::integer:
        s.set(scene, std::floor(number()));
        break;
      case SettingType::text:
        s.set(scene, "text \"with\" ünïcode \\ " + std::to_string(random() % 1000));
        break;
      case SettingType::choice:
        s.set(scene, s.choices[random() % s.choices.size()]);
        break;
      case SettingType::pair: {
        const double a = number(), b = number();
        s.set(scene, {std::min(a, b), std::max(a, b)});
        break;
      }
      case SettingType::vector:
        s.set(scene, {number(), number(), number()});
        break;
      case SettingType::quaternion:
        s.set(scene, {number(), number(), number(), number()});
        break;
      case SettingType::toggle:
        s.set(scene, random() % 2 == 0);
        break;
      case SettingType::positions:
        s.set(scene, json::array({{number(), number(), number()}, {number(), number(), number()}}));
        break;
      case SettingType::planes:
        s.set(scene, json::array({{number(), number(), number(), 1.0, number(), number()}}));
        break;
      case SettingType::marks:
        s.set(scene, json::array({{{"kind", "angle"},
                                   {"name", "b"},
                                   {"points", {{number(), number(), number()}}},
                                   {"color", {0.25, 0.5, 1.0}},
                                   {"shown", true}}}));
        break;
      case SettingType::points:
        s.set(scene, json::array({{number(), number(), 0.25, 0.5, 1.0}, {-1, 1, 0, 0, std::abs(number())}}));
        break;
    }
    if (s.mayBeAutomatic && random() % 4 == 0) s.set(scene, "auto");
  }
  return scene;
}

TEST(SceneJson, DefaultsRoundTrip) {
  const json stored = toJson(Scene{});
  EXPECT_TRUE(fromJson(stored) == Scene{});
  EXPECT_EQ(stored["isosurface"]["value"], "auto");
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
    scene.isosurface.value = value;
    const Scene back = fromJson(json::parse(toJson(scene).dump()));
    ASSERT_TRUE(back.isosurface.value);
    EXPECT_EQ(std::signbit(*back.isosurface.value), std::signbit(value));
    EXPECT_EQ(*back.isosurface.value, value);
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

TEST(SceneDiff, DescribesChanges) {
  Scene next;
  EXPECT_EQ(describeChange(Scene{}, next), "");
  next.look.mode = LookMode::lambert;
  EXPECT_EQ(describeChange(Scene{}, next), "Change look.mode");
  next.look.ambient = 0.5;
  EXPECT_EQ(describeChange(Scene{}, next), "Change look");
  next.camera.fov = 50;
  EXPECT_EQ(describeChange(Scene{}, next), "Change 3 settings");
}

}  // namespace
}  // namespace isolux::scene
