// Items of lists: paths, errors, sessions, what was before there were lists, and editing at random.
#include <algorithm>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/scene_list.h"
#include "tests/scene/random_scene.h"

namespace isolux::test {

namespace {

using nlohmann::json;
using scene::Scene;
using testing::HasSubstr;

std::vector<std::string> idsIn(const Scene& scene) {
  return scene::listOfPath("lamps.order")->ids(scene);
}

Scene assigned(std::initializer_list<const char*> assignments) {
  Scene scene;
  for (const char* assignment : assignments) scene::applyAssignment(scene, assignment);
  return scene;
}

std::string refusal(std::initializer_list<const char*> assignments) {
  Scene scene;
  std::string reason;
  for (const char* assignment : assignments) {
    const Scene before = scene;
    try {
      scene::applyAssignment(scene, assignment);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::usage);
      EXPECT_TRUE(scene == before) << assignment << " left something";
      reason = error.what();
    }
  }
  return reason;
}

}  // namespace

TEST(SceneList, AnItemIsMadeNamedByIdAndByPositionAndRemoved) {
  Scene scene = assigned({"lamps.key.kind=sphere", "lamps.key.intensity=2", "lamps.fill.kind=point"});
  ASSERT_EQ(idsIn(scene), (std::vector<std::string>{"key", "fill"}));
  EXPECT_TRUE(scene.lamps[0].shown) << "who makes a light source wants it";
  EXPECT_EQ(scene.lamps[0].kind, scene::LampKind::sphere);
  EXPECT_EQ(scene.lamps[0].intensity, 2.0);
  EXPECT_EQ(scene::setting("lamps.1.intensity").get(scene), 2.0);
  scene::applyAssignment(scene, "lamps.2.intensity=0.5");
  EXPECT_EQ(scene.lamps[1].intensity, 0.5);
  scene::applyAssignment(scene, "lamps.order=fill, key");
  EXPECT_EQ(idsIn(scene), (std::vector<std::string>{"fill", "key"}));
  EXPECT_EQ(scene::setting("lamps.1.intensity").get(scene), 0.5);
  const json whole = scene::setting("lamps.key").get(scene);
  scene::applyAssignment(scene, "lamps.key=none");
  EXPECT_EQ(idsIn(scene), (std::vector<std::string>{"fill"}));
  EXPECT_TRUE(scene::setting("lamps.key").get(scene).is_null());
  scene::setting("lamps.key").set(scene, whole);
  EXPECT_EQ(scene.lamps[1].intensity, 2.0);
}

TEST(SceneList, RefusesWithTheReasonAndChangesNothing) {
  EXPECT_THAT(refusal({"lamps.key.intensity=2"}), HasSubstr("lamps.key.intensity"));
  EXPECT_THAT(refusal({"lamps.key.intensity=2"}), HasSubstr("lamps.key.kind=... makes it"));
  EXPECT_THAT(refusal({"lamps.fill.kind=point", "lamps.fil.intensity=2"}), HasSubstr("did you mean fill"));
  EXPECT_THAT(refusal({"lamps.key.kind=bulb"}), HasSubstr("lamps.key.kind"));
  EXPECT_THAT(refusal({"lamps.key.kind=point", "lamps.key.intensty=2"}), HasSubstr("intensity"));
  EXPECT_THAT(refusal({"lamps.Key.kind=point"}), HasSubstr("an id has"));
  EXPECT_THAT(refusal({"lamps.3.intensity=2"}), HasSubstr("there is no light source 3"));
  EXPECT_THAT(refusal({"lamps.0.intensity=2"}), HasSubstr("an id has"));
  EXPECT_THAT(refusal({"lamps.key=none"}), HasSubstr("there is no light source key"));
  EXPECT_THAT(refusal({"lamps.key=7"}), HasSubstr("object"));
  EXPECT_THAT(refusal({"lamps.a.kind=point", "lamps.b.kind=point", "lamps.order=a"}), HasSubstr("each"));
  EXPECT_THAT(refusal({"lamps.a.kind=point", "lamps.order=a,a"}), HasSubstr("each"));
  EXPECT_THAT(
      refusal({"lamps.a.kind=point", "lamps.b.kind=point", "lamps.c.kind=point", "lamps.d.kind=point"}),
      HasSubstr("at most 3"));
  EXPECT_THAT(refusal({"lamp4.kind=sphere"}), HasSubstr("at most 3"));
  EXPECT_THAT(refusal({R"(lamps.key={"kind": "point", "radius": -1})"}), HasSubstr("lamps.key.radius"));
}

TEST(SceneList, ListsOfFilesAreRefusedWhereTheyAreWrong) {
  const auto reason = [](const char* lamps) -> std::string {
    try {
      scene::fromJson({{"lamps", json::parse(lamps)}});
    } catch (const base::Error& error) {
      return error.what();
    }
    return "accepted";
  };
  EXPECT_EQ(reason(R"([{"id": "a"}, {"id": "b", "kind": "sphere"}])"), "accepted");
  for (const char* bad : {R"({})", R"(7)", R"(["a"])", R"([{}])", R"([{"id": 7}])", R"([{"id": "A"}])",
                          R"([{"id": "a"}, {"id": "a"}])", R"([{"id": "a", "odd": 1}])",
                          R"([{"id": "a", "kind": "odd"}])", R"([{"id": "order"}])", R"([{"id": "1"}])",
                          R"([{"id": "a"}, {"id": "b"}, {"id": "c"}, {"id": "d"}])"})
    EXPECT_THAT(reason(bad), HasSubstr("lamps")) << bad;
}

// Scenes had three light sources, switched off, before they were a list.
TEST(SceneList, NumberedSettingsOfBeforeAreItemsByTheirPosition) {
  EXPECT_TRUE(assigned({"lamp2.kind=point", "lamp1.shown=false"}) == Scene{})
      << "saying nothing makes nothing";
  const Scene second = assigned({"lamp2.shown=true", "lamp2.color=1,0,0"});
  ASSERT_EQ(second.lamps.size(), 2u);
  EXPECT_FALSE(second.lamps[0].shown);
  EXPECT_TRUE(second.lamps[1].shown);
  EXPECT_EQ(second.lamps[1].color, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_EQ(scene::setting("lamp2.color").get(second), scene::setting("lamps.2.color").get(second));
  EXPECT_EQ(scene::setting("lamp3.shown").get(second), false);
  const Scene both = scene::fromJson(
      {{"lamp1", {{"shown", false}, {"kind", "sphere"}}}, {"lamp3", {{"shown", true}, {"intensity", 3.0}}}});
  ASSERT_EQ(both.lamps.size(), 3u);
  EXPECT_EQ(both.lamps[0].kind, scene::LampKind::sphere);
  EXPECT_EQ(both.lamps[2].intensity, 3.0);
  EXPECT_THROW(scene::fromJson({{"lamp1", {{"odd", 1}}}}), base::Error);
}

TEST(SceneList, TwoEditsOfTwoItemsDoNotTouchEachOther) {
  const Scene before = assigned({"lamps.a.kind=point", "lamps.b.kind=sphere"});
  Scene first = before, second = before;
  scene::applyAssignment(first, "lamps.a.intensity=3");
  scene::applyAssignment(second, "lamps.b=none");
  const Scene both = scene::applied(first, scene::difference(before, second, "Remove"));
  ASSERT_EQ(both.lamps.size(), 1u);
  EXPECT_EQ(both.lamps[0].intensity, 3.0);
}

// Adding, removing, renaming, reordering and changing items, with undo in between, ends where it began.
TEST(SceneList, TenThousandRandomEditsAreUndone) {
  std::mt19937_64 random(7);
  const Scene start = randomScene(random);
  Scene now = start;
  std::vector<scene::SceneDiff> back;
  const auto undo = [&] {
    now = scene::applied(std::move(now), back.back());
    back.pop_back();
  };
  for (int edit = 0; edit < 10000; ++edit) {
    Scene next = now;
    const scene::SceneList& list = scene::sceneLists()[random() % scene::sceneLists().size()];
    std::vector<std::string> ids = list.ids(now);
    const std::size_t kind = random() % 5;
    if (kind == 0 && ids.size() < list.most) {
      ids.insert(ids.begin() + static_cast<std::ptrdiff_t>(random() % (ids.size() + 1)),
                 scene::newId(list, now));
    } else if (kind == 1 && ids.size() > list.least) {
      ids.erase(ids.begin() + static_cast<std::ptrdiff_t>(random() % ids.size()));
    } else if (kind == 2) {
      std::ranges::shuffle(ids, random);
    } else if (kind == 3 && !back.empty()) {
      undo();
      continue;
    } else if (const std::vector<scene::Setting> all = scene::itemSettings(now); !all.empty()) {
      setRandomly(all[random() % all.size()], next, random);
    }
    list.arrange(next, ids);
    back.push_back(scene::difference(next, now, "Edit"));
    now = scene::applied(now, scene::difference(now, next, "Edit"));
    ASSERT_TRUE(now == next) << "edit " << edit;
    const bool stored = edit % 100 != 0 || scene::fromJson(scene::toJson(now)) == now;
    ASSERT_TRUE(stored) << "edit " << edit;
  }
  EXPECT_GT(back.size(), 4000U);
  while (!back.empty()) undo();
  EXPECT_TRUE(now == start);
}

// "surfaces.bone.value=300" on a new scene makes its one surface, not a second.
TEST(SceneList, ANewSceneHasOneSurfaceWhichTheFirstNameTakesOver) {
  Scene scene = assigned({"surfaces.bone.value=300"});
  ASSERT_EQ(scene.surfaces.size(), 1u);
  EXPECT_EQ(scene.surfaces[0].id, "bone");
  EXPECT_EQ(scene.surfaces[0].value, 300.0);
  scene::applyAssignment(scene, "surfaces.skin.value=-300");
  scene::applyAssignment(scene, "surfaces.skin.opacity=0.4");
  ASSERT_EQ(scene.surfaces.size(), 2u);
  EXPECT_EQ(scene.surfaces[1].opacity, 0.4);
  EXPECT_EQ(scene.surfaces[0].opacity, 1.0);
  EXPECT_NE(scene.surfaces[0].albedo, scene.surfaces[1].albedo);
  const scene::SceneDiff diff = scene::difference(Scene{}, scene, "Two");
  EXPECT_TRUE(scene::applied(Scene{}, diff) == scene);
  EXPECT_TRUE(scene::applied(scene, scene::difference(scene, Scene{}, "Back")) == Scene{});
  EXPECT_TRUE(scene::fromJson(scene::toJson(scene)) == scene);
  EXPECT_EQ(scene::canonicalPath(scene, "isosurface.value"), "surfaces.bone.value");
  EXPECT_EQ(scene::canonicalPath(scene, "isosurface2.opacity"), "surfaces.skin.opacity");
  EXPECT_EQ(assigned({"surfaces.main.opacity=0.5", "surfaces.bone.value=300"}).surfaces.size(), 2u)
      << "touched";
  EXPECT_THAT(refusal({"surfaces.main=none"}), HasSubstr("at least one surface"));
}

TEST(SceneList, FurtherSurfacesOfBeforeAreHalfTransparentAndOff) {
  EXPECT_TRUE(assigned({"isosurface2.shown=false", "isosurface2.opacity=0.5", "isosurface.opacity=1"}) ==
              Scene{});
  const Scene third = assigned({"isosurface.value=1", "isosurface3.shown=true"});
  ASSERT_EQ(third.surfaces.size(), 3u);
  EXPECT_EQ(third.surfaces[0].id, "main");
  EXPECT_FALSE(third.surfaces[1].shown);
  EXPECT_EQ(third.surfaces[2].opacity, 0.5);
  EXPECT_EQ(third.surfaces[2].albedo, glm::dvec3(0.30, 0.62, 0.35));
  EXPECT_THAT(refusal({"isosurface65.shown=true"}), HasSubstr("at most 64"));
  EXPECT_THAT(refusal({"isosurface1.shown=true"}), HasSubstr("unknown setting"));
  EXPECT_THAT(refusal({"isosurface.valu=1"}), HasSubstr("isosurface"));
}

// One after the other, as on a command line.
TEST(SceneList, AssignmentsMakeAnySceneFromANewOne) {
  std::mt19937_64 random(5);
  const auto made = [](const Scene& scene) {
    Scene result;
    for (const scene::SceneChange& change : scene::assignmentsOf(scene))
      scene::setting(change.path).set(result, change.value);
    return result == scene;
  };
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(made(randomScene(random)));
  EXPECT_TRUE(scene::assignmentsOf(Scene{}).empty());
  const Scene two = assigned({"surfaces.bone.value=300", "surfaces.skin.value=-300"});
  EXPECT_TRUE(made(two));
  EXPECT_EQ(scene::assignmentsOf(two).front().path, "surfaces.bone.value");
  Scene behind;  // the first is untouched: a name would take its place
  scene::setting("surfaces.skin").set(behind, {{"value", -300.0}});
  ASSERT_EQ(behind.surfaces.size(), 2u);
  EXPECT_TRUE(made(behind));
  Scene before = behind;
  scene::applyAssignment(before, "surfaces.order=skin,main");
  EXPECT_TRUE(made(before));
}

TEST(SceneList, IdsAreMadeFromNames) {
  const scene::SceneList& list = *scene::listOfPath("surfaces.order");
  Scene scene;
  EXPECT_EQ(scene::newId(list, scene), "surface2");
  EXPECT_EQ(scene::newId(list, scene, "Soft tissue"), "soft_tissue");
  EXPECT_EQ(scene::newId(list, scene, "Enamel, metal"), "enamel_metal");
  EXPECT_EQ(scene::newId(list, scene, "2 \u00e9"), "surface2");
  EXPECT_EQ(scene::newId(list, scene, "Main"), "main_2");
  EXPECT_EQ(scene::newId(list, scene, std::string(100, 'x')), std::string(28, 'x'));
}

}  // namespace isolux::test
