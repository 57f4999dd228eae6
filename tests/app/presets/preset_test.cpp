#include "app/presets/preset.h"

#include <cstdlib>
#include <fstream>
#include <set>

#include <gtest/gtest.h>

#include "app/presets/preset_list.h"
#include "app/presets/preset_value.h"
#include "base/error.h"
#include "scene/settings/settings.h"
#include "tests/support/surfaces.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;

// Values -1024, ..., 1023 once each, 16 x 16 x 8 voxels.
std::shared_ptr<const volume::PreparedVolume> ramp(const std::string& unit,
                                                   scene::WorldAxes axes = scene::WorldAxes::zUp) {
  std::vector<std::int16_t> values(16 * 16 * 8);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = static_cast<std::int16_t>(i) - 1024;
  volume::Volume made;
  made.grid = std::make_shared<volume::Grid>(volume::GridGeometry::make({16, 16, 8}, {1, 1, 1}),
                                             volume::VoxelArray(std::move(values)));
  made.unit = unit;
  made.axes = axes;
  base::Progress progress;
  return volume::prepareVolume(std::move(made), progress);
}

Preset presetWith(const std::string& set, const std::string& needs = "[]") {
  return parsePreset(R"({"isolux_preset": 1, "name": "p", "title": "P", "meaning": "m.", "needs": )" + needs +
                         R"(, "set": )" + set + "}",
                     "p.json");
}

TEST(Preset, ThoseOfTheProgramAreTheOnesPromised) {
  std::set<std::string> names;
  for (const Preset& preset : builtInPresets()) {
    EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
    EXPECT_EQ(preset.meaning.back(), '.') << preset.name;
    EXPECT_TRUE(preset.file.empty());
    EXPECT_FALSE(preset.settings.empty());
    for (const auto& [path, value] : preset.settings.items())
      EXPECT_TRUE(resetByPreset(path)) << preset.name << ": a later preset would leave " << path;
    // In the form of a file it is the same.
    const Preset again = parsePreset(presetText(preset), "x.json");
    EXPECT_EQ(again.settings, preset.settings);
    EXPECT_EQ(again.needs, preset.needs);
    EXPECT_EQ(again.title, preset.title);
  }
  for (const char* name : {"ct_bone", "ct_skin", "ct_lung", "ct_vessels", "ct_metal", "mr_skin", "mr_brain",
                           "mr_vessels", "simulation", "distance", "microscopy"})
    EXPECT_TRUE(names.count(name)) << name;
}

TEST(Preset, AppliesOrSaysWhyNot) {
  const auto ct = ramp("HU", scene::WorldAxes::anatomical), unknown = ramp("counts");
  const Preset bone = findPreset("ct_bone"), brain = findPreset("mr_brain");
  EXPECT_EQ(whyNot(bone, *ct), "");
  EXPECT_EQ(whyNot(bone, *unknown), "it is no CT, or its values do not tell Hounsfield units");
  EXPECT_EQ(whyNot(bone, *unknown, true), "") << "the isovalue is said";
  EXPECT_NE(whyNot(brain, *ct), "");
  EXPECT_EQ(whyNot(brain, *unknown), "it is no scan of a patient");
  const auto patient =
      std::make_shared<volume::PreparedVolume>(*ramp("counts", scene::WorldAxes::anatomical));
  patient->whiteMatter = std::make_shared<volume::KeptWhiteMatter>(volume::WhiteMatter{100.0, 120.0});
  EXPECT_EQ(whyNot(brain, *patient), "");
  patient->whiteMatter = std::make_shared<volume::KeptWhiteMatter>(std::nullopt);
  EXPECT_EQ(whyNot(findPreset("mr_skin"), *patient), "");
  EXPECT_EQ(whyNot(brain, *patient), "no white matter of a T1 scan is found in it");
  EXPECT_EQ(whyNot(brain, *patient, true), "") << "the isovalue is said";
  EXPECT_NE(whyNot(findPreset("distance"), *ct), "");
  EXPECT_EQ(whyNot(findPreset("distance"), *ramp("mm")), "");
  // Nobody says the unit, but only a CT has such values.
  EXPECT_EQ(whyNot(bone, *ramp("")), "");
}

TEST(Preset, ThoseOfAnotherKindDoNotApply) {
  using Kind = scene::DataKind;
  auto volume = std::make_shared<volume::PreparedVolume>(*ramp("counts"));
  const auto applies = [&](Kind kind, const char* preset) {
    volume->kind.kind = kind;
    return whyNot(findPreset(preset), *volume).empty();
  };
  EXPECT_TRUE(applies(Kind::microscopy, "microscopy"));
  EXPECT_FALSE(applies(Kind::microscopy, "simulation"));
  EXPECT_TRUE(applies(Kind::simulation, "simulation"));
  EXPECT_FALSE(applies(Kind::mr, "simulation"));
  EXPECT_TRUE(applies(Kind::mr, "mr_skin"));
  EXPECT_FALSE(applies(Kind::ct, "mr_skin"));
  EXPECT_FALSE(applies(Kind::ct, "ct_bone")) << "nothing tells Hounsfield units";
  for (const Kind kind : {Kind::distance, Kind::labels})
    for (const char* preset : {"microscopy", "simulation", "mr_skin", "ct_bone"})
      EXPECT_FALSE(applies(kind, preset)) << preset;
  EXPECT_TRUE(applies(Kind::other, "microscopy"));
  EXPECT_TRUE(applies(Kind::other, "simulation"));
}

TEST(Preset, HounsfieldUnitsMayBeToldByAirAndSoftTissue) {
  auto volume = std::make_shared<volume::PreparedVolume>(*ramp("counts"));
  volume->kind = {scene::DataKind::ct, "", glm::dvec2(0.35, 0.00035)};
  EXPECT_DOUBLE_EQ(valueInVolume({{"hu", 300}}, *volume), 0.35 + 300 * 0.00035);
  EXPECT_EQ(whyNot(findPreset("ct_bone"), *volume), "");
}

TEST(Preset, ValuesLieWhereTheirRulesSay) {
  const auto volume = ramp("HU");
  const auto at = [&](const char* rule) {
    return valueInVolume(nlohmann::ordered_json::parse(rule), *volume);
  };
  EXPECT_EQ(at(R"({"hu": 300})"), 300.0);
  EXPECT_NEAR(at(R"({"quantile": 0.5})"), 0.0, 2.5) << "a bin is 4 wide";
  EXPECT_NEAR(at(R"({"quantile": 0.9})"), -1024 + 0.9 * 2048, 2.5);
  EXPECT_NEAR(at(R"({"quantile": 1})"), 1023.0, 4.0);
  const double clearest = volume->facts.contrastIsovalue;
  EXPECT_DOUBLE_EQ(at(R"({"between": 0})"), clearest);
  EXPECT_DOUBLE_EQ(at(R"({"between": 0.25})"), clearest + 0.25 * (1023 - clearest));
  EXPECT_DOUBLE_EQ(at(R"({"between": -0.25})"), clearest - 0.25 * (clearest + 1024));
  EXPECT_DOUBLE_EQ(at(R"({"white_matter": 0.5})"), clearest) << "there is none";
  auto brain = std::make_shared<volume::PreparedVolume>(*volume);
  brain->whiteMatter = std::make_shared<volume::KeptWhiteMatter>(volume::WhiteMatter{100.0, 120.0});
  EXPECT_DOUBLE_EQ(valueInVolume({{"white_matter", 0.25}}, *brain), 105.0);
}

TEST(Preset, SetsWhatItSaysResetsTheLookAndLeavesTheRest) {
  const auto volume = ramp("HU");
  scene::Scene before;
  before.camera.eye = glm::dvec3(1, 2, 3);
  before.source.path = "/x.nii";
  before.pieces.hidden = {glm::dvec3(1, 1, 1)};
  before.look.fog = 0.5;
  test::surfaceAt(before, 3).shown = true;
  before.gi.bounces = 5;
  const Preset preset = presetWith(R"({"isosurface.value": {"hu": 200}, "look.mode": "gi"})");
  const scene::Scene after = withPreset(before, preset, *volume, -20.0);
  EXPECT_EQ(after.surfaces.front().value, 180.0);
  EXPECT_EQ(after.look.mode, scene::LookMode::gi);
  EXPECT_EQ(after.look.fog, scene::Look{}.fog);
  EXPECT_EQ(after.surfaces.size(), 1U);
  EXPECT_EQ(after.camera, before.camera);
  EXPECT_EQ(after.source, before.source);
  EXPECT_EQ(after.pieces.hidden, before.pieces.hidden);
  EXPECT_EQ(after.gi, before.gi);
  EXPECT_EQ(
      withPreset(scene::Scene{}, presetWith(R"({"look.fog": 0.5})"), *volume, 7.0).surfaces.front().value,
      volume->facts.suggestedIsovalue + 7.0);
  // From one preset to another is where one comes to from nowhere.
  const scene::Scene skin = withPreset({}, findPreset("ct_skin"), *volume);
  for (const Preset& other : builtInPresets())
    EXPECT_EQ(withPreset(withPreset({}, other, *volume), findPreset("ct_skin"), *volume), skin) << other.name;
}

TEST(Preset, FilesThatAreNoneAreRefusedWithThePlace) {
  const auto refused = [](const std::string& text) -> std::string {
    try {
      parsePreset(text, "p.json");
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::input);
      return error.what();
    }
    return "accepted";
  };
  EXPECT_NE(refused("").find("is no preset"), std::string::npos);
  EXPECT_NE(refused("[1]").find("is no preset"), std::string::npos);
  EXPECT_NE(refused(R"({"isolux_preset": 2})").find("another version"), std::string::npos);
  const auto set = [&](const std::string& members) {
    return refused(R"({"isolux_preset": 1, "name": "p", "title": "P", "meaning": "m.", "set": )" + members +
                   "}");
  };
  EXPECT_EQ(set("{}"), "accepted");
  for (const char* bad :
       {R"({"no.such": 1})", R"({"look.fog": 7})", R"({"look.mode": "nonsense"})",
        R"({"look.fog": {"hu": 1}})", R"({"isosurface.value": {"hu": "x"}})",
        R"({"isosurface.value": {"quantile": 2}})", R"({"isosurface.value": {}})",
        R"({"isosurface.value": {"odd": 1}})", R"({"source.path": "x"})", R"({"camera.eye": [1, 2, 3]})",
        R"({"light.environment.file": "/x.hdr"})", R"({"lamp1.position": [1, 2, 3]})",
        R"({"lamps.key": {"position": [1, 2, 3]}})", R"({"memory.gpu_budget_mb": 512})", "[]", "3"})
    EXPECT_EQ(set(bad).find("p.json: "), 0U) << bad << ": " << set(bad);
  EXPECT_NE(refused(R"({"isolux_preset": 1, "name": "P p", "title": "P", "meaning": "m.", "set": {}})"),
            "accepted");
}

// The user's folder is elsewhere while it lives.
class OwnPresets : public testing::Test {
 protected:
  OwnPresets() : folder_(test::temporaryFolder()) { ::setenv("XDG_CONFIG_HOME", folder_.c_str(), 1); }
  ~OwnPresets() override { ::unsetenv("XDG_CONFIG_HOME"); }
  fs::path folder_;
};

TEST_F(OwnPresets, AreKeptFoundAndGiveTheSameSceneAgain) {
  const auto volume = ramp("HU");
  scene::Scene scene;
  scene.surfaces.front().value = 250.0;
  scene.look.mode = scene::LookMode::kappa1;
  scene.look.rangeHigh = 0.125;
  scene.camera.eye = glm::dvec3(1, 2, 3);
  scene.source.path = "/secret/name.nii";
  scene.pieces.hidden = {glm::dvec3(1, 2, 3)};
  const fs::path file = savePreset(presetOf(scene, presetNameOf("My bone, 2"), "My bone, 2", volume.get()));
  EXPECT_EQ(file, folder_ / "isolux" / "presets" / "my_bone_2.isolux-preset.json");
  std::vector<std::string> warnings;
  const std::vector<Preset> own = ownPresets(warnings);
  ASSERT_EQ(own.size(), 1U);
  EXPECT_TRUE(warnings.empty());
  EXPECT_EQ(own[0].title, "My bone, 2");
  EXPECT_EQ(own[0].settings["isosurface.value"], nlohmann::ordered_json({{"hu", 250.0}}));
  EXPECT_FALSE(own[0].settings.contains("source.path"));
  for (const std::string& name : {std::string("my_bone_2"), file.string()}) {
    const scene::Scene again = withPreset({}, findPreset(name), *volume);
    EXPECT_EQ(again.isosurface, scene.isosurface);
    EXPECT_EQ(again.look, scene.look);
    EXPECT_FALSE(again.camera.eye);
    EXPECT_TRUE(again.pieces.hidden.empty());
  }
  std::ofstream(folder_ / "isolux" / "presets" / "broken.isolux-preset.json") << "{";
  EXPECT_EQ(ownPresets(warnings).size(), 1U);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("broken"), std::string::npos);
}

TEST(Preset, LeavesABackgroundThatTheUserHasChosen) {
  const auto volume = ramp("");
  scene::Scene white;
  white.look.backgroundTop = white.look.backgroundBottom = glm::dvec3(1.0);
  const scene::Scene shown = withPreset(white, presetWith(R"({"look.mode": "gi"})"), *volume);
  EXPECT_EQ(shown.look.backgroundTop, glm::dvec3(1.0));
  EXPECT_EQ(shown.look.backgroundBottom, glm::dvec3(1.0));
  const scene::Scene black = withPreset(white, findPreset("microscopy"), *volume);
  EXPECT_NE(black.look.backgroundTop, glm::dvec3(1.0)) << "unless it has one of its own";
  EXPECT_EQ(withPreset(black, findPreset("simulation"), *volume).look.backgroundTop,
            scene::Look{}.backgroundTop)
      << "which goes with it";
}

TEST_F(OwnPresets, AreReplacedWhereThatIsSaidOnly) {
  const fs::path file = savePreset(presetOf({}, presetNameOf("my bone"), "my bone", nullptr));
  EXPECT_EQ(presetNameOf("My  Bone!"), "my_bone") << "nearly the same name";
  try {
    savePreset(presetOf({}, "my_bone", "My Bone", nullptr));
    ADD_FAILURE() << "replaced";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    EXPECT_NE(std::string(error.what()).find("--overwrite"), std::string::npos);
  }
  EXPECT_EQ(findPreset("my_bone").title, "my bone");
  EXPECT_EQ(savePreset(presetOf({}, "my_bone", "My Bone", nullptr), true), file);
  EXPECT_EQ(findPreset("my_bone").title, "My Bone");
}

TEST_F(OwnPresets, TakeTheirFilesNameFromTitlesInAnyScript) {
  EXPECT_EQ(presetNameOf("骨"), "骨");
  EXPECT_EQ(presetNameOf("Köpfe, 2"), "köpfe_2");
  EXPECT_EQ(presetNameOf(" !"), "");
  for (const char* title : {"骨", "Köpfe", "кость"}) {
    savePreset(presetOf({}, presetNameOf(title), title, nullptr));
    EXPECT_EQ(findPreset(presetNameOf(title)).title, title);
  }
}

TEST_F(OwnPresets, DoNotTakeTheNamesOfTheProgram) {
  EXPECT_THROW(savePreset(presetOf({}, "ct_bone", "CT bone", nullptr)), base::Error);
  EXPECT_THROW(savePreset(presetOf({}, "", "!", nullptr)), base::Error);
  try {
    findPreset("ct_bon");
    ADD_FAILURE();
  } catch (const base::Error& error) {
    EXPECT_NE(std::string(error.what()).find("did you mean ct_bone?"), std::string::npos);
  }
}

}  // namespace
}  // namespace isolux::app
