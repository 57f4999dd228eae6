// The metrics of a study on images made by hand, and its lists. Nothing here needs GL.
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/study/study.h"
#include "app/study_report/study_plot.h"
#include "base/error.h"
#include "scene/settings/scene_diff.h"
#include "scene/settings/settings.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/poll.h"
#include "tests/support/surfaces.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

using testing::HasSubstr;

constexpr float noNumber = std::numeric_limits<float>::quiet_NaN();

// One pixel after the other: what the reference sees, and what was drawn.
struct View {
  std::vector<TrueHit> hits;
  std::vector<TrueShape> shapes;
  DrawnImages drawn;
  std::vector<bool> hangs;  // on a rounding

  void add(const TrueHit& hit, float depthMm, bool undecided = false) {
    hits.push_back(hit);
    shapes.push_back({hit.hit, hit.hit, {0.0, 0.0, 1.0}, 0.5, -0.25});
    const bool found = !std::isnan(depthMm);
    drawn.hit.push_back(found ? 1.0f : 0.0f);
    drawn.depthMm.push_back(depthMm);
    drawn.normal.insert(drawn.normal.end(), {0.0f, found ? 0.0f : noNumber, found ? 1.0f : noNumber});
    drawn.kappa.insert(drawn.kappa.end(), {found ? 0.5f : noNumber, found ? -0.25f : noNumber});
    hangs.push_back(undecided);
  }
  Errors errors(double flat = 0.01) const {
    return errorsOf(drawn, {hits, shapes, flat}, [this](std::size_t pixel) { return hangs[pixel]; });
  }
};

// A hit at 100 mm, half a voxel per mm, the next crossing at 103 mm.
const TrueHit surface{true, 100.0, 103.0, 0.5, {}};
const TrueHit background{};

TEST(StudyErrors, MissedAndInventedPixelsAreTold) {
  View view;
  view.add(background, noNumber);
  view.add(surface, 100.0f);
  view.add(surface, noNumber);        // missed
  view.add(surface, 103.0f);          // the crossing behind: missed
  view.add(surface, 101.6f);          // nearer to the one behind: missed
  view.add(surface, 101.4f);          // the first, badly
  view.add(surface, 95.0f);           // 2.5 voxels in front: invented
  view.add(background, 50.0f);        // invented
  view.add(surface, noNumber, true);  // undecided
  view.add(background, 1.0f, true);
  const Errors errors = view.errors();
  EXPECT_EQ(errors.pixels, 10u);
  EXPECT_EQ(errors.surface, 7u);
  EXPECT_EQ(errors.missed, 3u);
  EXPECT_EQ(errors.invented, 2u);
  EXPECT_EQ(errors.undecided, 2u);
  EXPECT_EQ(errors.depthMm.pixels, 2u);
  EXPECT_DOUBLE_EQ(errors.missedPpm(), 3e5);
}

TEST(StudyErrors, WithoutACrossingBehindAHitMayBeOneLongestStepOff) {
  TrueHit alone = surface;
  alone.nextMm = std::numeric_limits<double>::infinity();
  View view;
  view.add(alone, 103.9f);  // 1.95 voxels
  view.add(alone, 104.1f);
  EXPECT_EQ(view.errors().missed, 1u);
}

TEST(StudyErrors, DepthIsMeasuredAlongTheRayInBothUnits) {
  View view;
  view.add(surface, 100.5f);
  view.add(surface, 99.5f);
  view.add(surface, 101.0f);
  const Errors errors = view.errors();
  EXPECT_DOUBLE_EQ(errors.depthMm.median, 0.5);
  EXPECT_DOUBLE_EQ(errors.depthMm.maximum, 1.0);
  EXPECT_DOUBLE_EQ(errors.depthMm.rms, std::sqrt(1.5 / 3.0));
  EXPECT_DOUBLE_EQ(errors.depthVoxels.rms, 0.5 * std::sqrt(1.5 / 3.0));
}

TEST(StudyErrors, NormalsAreMeasuredInDegreesAndCurvaturesByTheLarger) {
  View view;
  view.add(surface, 100.0f);
  const double angle = 1e-3;
  view.drawn.normal = {static_cast<float>(std::sin(angle)), 0.0f, static_cast<float>(std::cos(angle))};
  view.drawn.kappa = {0.5f, -0.20f};
  Errors errors = view.errors();
  EXPECT_NEAR(errors.normalDegrees.maximum, angle * 180.0 / M_PI, 1e-6);
  EXPECT_NEAR(errors.curvature.maximum, 0.1, 1e-6) << "0.05 of 0.5";
  errors = view.errors(5.0);
  EXPECT_NEAR(errors.curvature.maximum, 0.01, 1e-7) << "0.05 of the flat curvature";
  view.shapes[0].hasCurvature = false;
  EXPECT_EQ(view.errors().curvature.pixels, 0u);
  view.shapes[0].hasNormal = false;
  EXPECT_EQ(view.errors().normalDegrees.pixels, 0u);
}

TEST(StudyErrors, SpreadIsOfTheWholeDistribution) {
  std::vector<double> errors;
  for (int i = 1000; i >= 0; --i) errors.push_back(i);
  const Spread spread = spreadOf(errors);
  EXPECT_EQ(spread.median, 500.0);
  EXPECT_EQ(spread.most99, 990.0);
  EXPECT_EQ(spread.maximum, 1000.0);
  EXPECT_NEAR(spread.rms, std::sqrt(1000.0 * 2001.0 / 6.0), 1e-9);
  EXPECT_TRUE(std::isnan(spreadOf({}).rms)) << "no pixel is no error of 0";
}

TEST(QualitySettings, EachHasItsDefaultAmongItsValues) {
  for (const QualitySetting& quality : qualitySettings()) {
    EXPECT_NE(defaultValue(quality), "") << quality.name;
    EXPECT_NO_THROW(scene::setting(quality.setting)) << quality.name;
  }
}

TEST(QualitySettings, PicturesAreComparedWithOneOfTheRows) {
  for (const QualitySetting& quality : qualitySettings()) {
    const std::string reference = quality.reference;
    if (quality.measure == Measure::edges)
      EXPECT_EQ(reference, "") << "a picture of its own";
    else if (quality.sampled())
      EXPECT_EQ(reference, kExactHits);
    else
      EXPECT_THAT(quality.values, testing::Contains(testing::StrEq(reference))) << quality.name;
  }
}

TEST(QualitySettings, ATurnedSceneDiffersInThatSettingAlone) {
  const scene::VolumeFacts facts{.boundsMaxMm = glm::dvec3(9.0), .maximum = 5.0, .typicalStep = 8.0};
  scene::Scene scene;
  scene.hit.method = scene::HitMethod::sampled;
  test::surfaceAt(scene, 1).shown = true;
  const scene::Scene plain = turned(parseQualitySettings("rate")[0], "2", scene, facts);
  EXPECT_EQ(plain.surfaces.size(), 1U);
  EXPECT_EQ(plain.hit.nearThreshold, 4.0);

  scene::Scene expected = plain;
  expected.hit.rate = 4.0;
  expected.hit.nearThreshold = 2.0;  // automatic: it follows the rate
  EXPECT_EQ(turned(parseQualitySettings("rate")[0], "4", scene, facts), expected);
  expected = plain;
  expected.hit.nearThreshold = 1.0;
  EXPECT_EQ(turned(parseQualitySettings("near_threshold")[0], "0.25", scene, facts), expected);
  EXPECT_EQ(plain.derivatives.scale, std::nullopt) << "automatic, as the scene has it";
  EXPECT_EQ(plain.derivatives.normalScale, std::nullopt);
  expected = plain;
  expected.derivatives.field = scene::Field::trilinear;
  EXPECT_EQ(turned(parseQualitySettings("derivatives_field")[0], "trilinear", scene, facts), expected);
  scene.hit.method = scene::HitMethod::exact;
  EXPECT_EQ(turned(parseQualitySettings("refinements")[0], "4", scene, facts), plain)
      << "sampled, to have an effect";
}

TEST(QualitySettings, AListIsCheckedWithASuggestion) {
  EXPECT_EQ(parseQualitySettings("").size(), qualitySettings().size());
  EXPECT_STREQ(parseQualitySettings("fetch,rate")[1].name, "rate");
  try {
    parseQualitySettings("rate,near_factr");
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("did you mean near_factor?"));
  }
  EXPECT_THROW(parseQualitySettings("rate,,method"), base::Error);
}

scene::Scene underAProbe() {
  scene::Scene scene;
  scene.light.environment.file = "probe.hdr";
  return scene;
}

TEST(QualitySettings, LightIsLitByAllThereIsWhateverTheLook) {
  const scene::VolumeFacts facts{.boundsMaxMm = glm::dvec3(9.0), .maximum = 5.0, .typicalStep = 8.0};
  scene::Scene scene = underAProbe();
  scene.look.mode = scene::LookMode::kappa1;
  scene.hit.field = scene::Field::cubic;
  scene.gi.extent = scene::GiExtent::full;
  const scene::Scene lit = turned(parseQualitySettings("samples")[0], "16", scene, facts);
  EXPECT_EQ(lit.look.mode, scene::LookMode::gi);
  EXPECT_EQ(lit.hit.field, scene::Field::trilinear);
  EXPECT_EQ(lit.gi.extent, scene::GiExtent::view);
  EXPECT_EQ(lit.gi.samples, 16);
  EXPECT_FALSE(lit.light.environment.moves);
  const scene::Scene moving = turned(parseQualitySettings("sh_order")[0], "3", scene, facts);
  EXPECT_TRUE(moving.light.environment.moves);
  EXPECT_EQ(moving.gi.shOrder, 3);
  EXPECT_EQ(turned(parseQualitySettings("environment_share")[0], "auto", scene, facts).gi.environmentShare,
            std::nullopt);
}

TEST(QualitySettings, KnobsWithoutEffectSayWhy) {
  const auto why = [](const char* quality, const scene::Scene& scene) {
    return whyWithoutEffect(parseQualitySettings(quality)[0], scene);
  };
  scene::Scene plain, probe = underAProbe();
  plain.light.environment.constant = glm::dvec3(1.0);
  for (const QualitySetting& quality : qualitySettings())
    EXPECT_EQ(whyWithoutEffect(quality, probe), "") << quality.name;
  for (const char* quality : {"samples", "sequence", "bounces", "interpolation", "precision"})
    EXPECT_EQ(why(quality, plain), "") << quality;
  for (const char* quality : {"environment_share", "sh_order", "sh_window", "components", "component_bits"})
    EXPECT_THAT(why(quality, plain), HasSubstr("constant")) << quality;
  EXPECT_EQ(why("rate", plain), "");
  scene::Scene scaled;
  EXPECT_EQ(why("fetch", scaled), "");
  scaled.derivatives.scale = scaled.derivatives.normalScale = 1.0;
  EXPECT_THAT(why("fetch", scaled), HasSubstr("at a scale"));
  EXPECT_EQ(why("derivatives_field", scaled), "");
  EXPECT_EQ(why("shadow", plain), "");
  EXPECT_EQ(why("supersampling", plain), "");
  plain.light.intensity = 0.0;
  EXPECT_THAT(why("shadow", plain), HasSubstr("key light"));
  probe.gi.mode = scene::GiMode::off;
  for (const char* quality : {"samples", "bounces", "interpolation", "sh_order", "precision"})
    EXPECT_THAT(why(quality, probe), HasSubstr("baked")) << quality;
  plain.light.environment.constant = glm::dvec3(0.0);
  EXPECT_THAT(why("samples", plain), HasSubstr("no light is baked"));
}

QualityStudy madeStudy() {
  QualityStudy study{.quality = parseQualitySettings("rate")[0], .settings = {}, .plot = {}};
  const auto add = [&](const char* value, double time, double rms, bool comparison) {
    StudySetting setting;
    setting.value = value;
    setting.isDefault = comparison;
    setting.settingDefault = setting.value == "2";
    setting.comparison = comparison;
    setting.passMilliseconds = {{"cast", time}, {"refine", 1.0}};
    setting.passTimes = {{"cast", {time - 0.1, time, time + 0.1, time + 0.2}},
                         {"refine", {1.0, 1.0, 1.0, 1.0}}};
    setting.errors.pixels = 100;
    setting.errors.depthVoxels.rms = rms;
    study.settings.push_back(setting);
  };
  add("1", 2.0, 0.2, false);
  add("2", 4.0, 0.05, false);
  add("4", 3.0, 0.005, false);
  add("exact hits", 1.0, 0.0, true);
  return study;
}

TEST(StudyReach, IsTheCheapestOfAllRows) {
  QualityStudy study = madeStudy();
  EXPECT_EQ(cheapest(study, 0.5)->value, "exact hits") << "cheaper than every rate";
  EXPECT_EQ(cheapest(study, 1e-9)->value, "exact hits");
  study.settings.pop_back();
  EXPECT_EQ(cheapest(study, 0.5)->value, "1");
  EXPECT_EQ(cheapest(study, 0.1)->value, "4") << "cheaper than the less accurate 2, by these times";
  EXPECT_EQ(cheapest(study, 0.001), nullptr);
  EXPECT_DOUBLE_EQ(costOf(study.quality, study.settings[0], panelsOf(study.quality)[0]), 3.0);
}

TEST(StudyReach, OfTimesThatTheirSpreadDoesNotTellApartTheMoreAccurateWins) {
  QualityStudy study = madeStudy();
  study.settings.pop_back();
  // Medians 3 and 4 ms; quartiles 2.9 to 4.1 of the first, 4 to 4.1 of the last.
  study.settings[0].passTimes["refine"] = std::vector<double>(5, 1.0);
  study.settings[0].passTimes["cast"] = {1.9, 1.9, 2.0, 3.1, 3.1};
  EXPECT_EQ(cheapest(study, 0.5)->value, "4");
  study.settings[0].passTimes["cast"] = {1.9, 1.9, 2.0, 2.1, 2.1};
  EXPECT_EQ(cheapest(study, 0.5)->value, "1");
}

TEST(StudyTimes, SpreadIsOfThePassesOfAFrameTogether) {
  StudySetting setting;
  setting.passMilliseconds = {{"cast", 2.0}, {"refine", 5.0}};
  setting.passTimes = {{"cast", {1.0, 2.0, 3.0}}, {"refine", {6.0, 5.0, 4.0}}, {"other", {9.0, 9.0, 99.0}}};
  const QualitySetting quality = parseQualitySettings("rate")[0];
  const TimeSpread spread = costSpread(quality, setting, panelsOf(quality)[0]);
  EXPECT_EQ(spread.low, 7.0);
  EXPECT_EQ(spread.high, 7.0);
  const TimeSpread alone = spreadOfTimes({8.0, 1.0, 2.0, 3.0, 4.0});
  EXPECT_EQ(alone.median, 3.0);
  EXPECT_EQ(alone.low, 2.0);
  EXPECT_EQ(alone.high, 4.0);
  const TimeSpread three = spreadOfTimes({2.0, 1.0, 3.0});
  EXPECT_EQ(three.low, 1.0) << "no quartile is the median itself";
  EXPECT_EQ(three.high, 3.0);
  EXPECT_FALSE(sameTime({1.0, 0.9, 1.1}, {1.3, 1.2, 1.4}));
  EXPECT_TRUE(sameTime({1.0, 0.9, 1.25}, {1.3, 1.2, 1.4}));
}

// Of three times each of two equal settings, in every order: as often apart as chance has it, 2 of 20.
TEST(StudyTimes, EqualSettingsAreSeldomToldApart) {
  int apart = 0, orders = 0;
  for (unsigned chosen = 0; chosen < 64; ++chosen) {
    std::vector<double> a, b;
    for (unsigned i = 0; i < 6; ++i) ((chosen >> i & 1u) != 0 ? a : b).push_back(i);
    if (a.size() != 3) continue;
    ++orders;
    apart += !sameTime(spreadOfTimes(a), spreadOfTimes(b));
  }
  EXPECT_EQ(orders, 20);
  EXPECT_EQ(apart, 2);
}

TEST(StudyTimes, ABusyMachineIsSeenByTheProcessorsTime) {
  QualityStudy study = madeStudy();
  EXPECT_TRUE(std::isnan(timesAsLong({study}))) << "a GPU drew";
  for (StudySetting& setting : study.settings) {
    setting.frameTimes = {50.0, 150.0};
    setting.processorTimes = {20.0, 20.0};
  }
  EXPECT_DOUBLE_EQ(timesAsLong({study, study}), 5.0);
  const double before = processorMilliseconds();
  EXPECT_TRUE(test::pollUntil([&] { return processorMilliseconds() > before; }));
}

TEST(StudyPlot, HasEveryPointAndMarksTheDefault) {
  const std::string script = plotScript(madeStudy(), "it's", ".part");
  EXPECT_THAT(script, HasSubstr("title = 'Sampling rate, samples per voxel: it''s'"));
  EXPECT_THAT(script, HasSubstr("\n1\t0\t3\t2.9\t3.2\t0.2\t3\t"));
  EXPECT_THAT(script, HasSubstr("\n2\t0\t5\t4.9\t5.2\t0.05\t5\t")) << "what is not done by default";
  EXPECT_THAT(script, HasSubstr("\n\n\nexact hits\t1\t2\t1.9\t2.2\t0\t")) << "in a block of its own";
  EXPECT_THAT(script, HasSubstr("zeros = 1"));
  EXPECT_THAT(script, HasSubstr("bottoms[2] = [0.001, 0.01]")) << "below the least error that is not 0";
  EXPECT_THAT(script, HasSubstr("tops[2] = [1, 1]"));
}

QualityStudy madeLightStudy(const char* quality) {
  QualityStudy study{.quality = parseQualitySettings(quality)[0], .settings = {}, .plot = {}};
  const auto add = [&](const char* value, double seconds, double milliseconds, std::uint64_t bytes,
                       double rmse) {
    StudySetting setting;
    setting.value = value;
    setting.light = LightCost{.bakeSeconds = seconds, .lookupMilliseconds = milliseconds, .gpuBytes = bytes};
    setting.errors.light.mean = 2.0;
    setting.errors.light.rmse = rmse;
    setting.errors.light.rmseStandardError = 0.02;
    setting.errors.light.most99 = 3.0 * rmse;
    study.settings.push_back(setting);
  };
  add("a", 8.0, 1.0, std::uint64_t{4} << 20u, 0.09);
  add("b", 4.0, 2.0, std::uint64_t{3} << 20u, 0.03);
  add("c", 6.0, 0.5, std::uint64_t{9} << 20u, 0.03);
  return study;
}

TEST(StudyReach, OfLightIsByWhatTheKnobCosts) {
  EXPECT_EQ(cheapest(madeLightStudy("samples"), 0.05)->value, "b") << "seconds of bake";
  EXPECT_EQ(cheapest(madeLightStudy("interpolation"), 0.05)->value, "c") << "milliseconds of the lookup";
  EXPECT_EQ(cheapest(madeLightStudy("precision"), 0.05)->value, "b") << "bytes";
  EXPECT_EQ(cheapest(madeLightStudy("samples"), 0.01), nullptr);
  EXPECT_EQ(errorsToReach(Measure::light)[0], 0.05);
}

TEST(StudyPlot, OfLightHasItsCostAndStandardError) {
  std::string script = plotScript(madeLightStudy("samples"), "ct", ".part");
  EXPECT_THAT(script, HasSubstr("bars = 1"));
  EXPECT_THAT(script, HasSubstr("joined = 1"));
  EXPECT_THAT(script, HasSubstr("a\t0\t8\t8\t8\t0.045\t8\t8\t8\t0.135\t0.01\n"));
  EXPECT_THAT(script, HasSubstr("bake time of the visible part, s"));
  script = plotScript(madeLightStudy("component_bits"), "ct", ".part");
  EXPECT_THAT(script, HasSubstr("a\t0\t4\t4\t4\t0.045\t4\t"));
  EXPECT_THAT(script, HasSubstr("MiB"));
}

TEST(StudyCommand, WrongUseIsExit2) {
  const auto failure = [](std::vector<std::string> arguments) {
    const auto folder = test::temporaryFolder();
    arguments.insert(arguments.begin(), {"study", "phantom:ball:8"});
    const test::RunResult result = test::callIsolux(arguments, folder);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(test::filesIn(folder), testing::IsEmpty());
    return result.err;
  };
  EXPECT_THAT(failure({}), HasSubstr("--out"));
  EXPECT_THAT(failure({"--out", "d", "--knobs", "methd"}), HasSubstr("did you mean method?"));
  EXPECT_THAT(failure({"--out", "d", "--settings", "methd"}), HasSubstr("did you mean method?"));
  EXPECT_THAT(failure({"--out", "d", "--size", "0x4"}), HasSubstr("--size"));
  failure({"--out", "d", "--repeat", "0"});
}

}  // namespace
}  // namespace isolux::app
