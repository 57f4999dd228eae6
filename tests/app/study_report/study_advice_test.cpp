// What a table says to do, of rows made by hand.
#include "app/study_report/study_advice.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace isolux::app {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

struct Row {
  const char* value;
  double time, spread, error;
  std::size_t missed = 0;
};

// The default is the row of that value; exact hits are a comparison.
QualityStudy studyOf(const char* quality, const std::vector<Row>& rows, const std::string& byDefault) {
  QualityStudy study{.quality = parseQualitySettings(quality)[0], .settings = {}, .plot = {}};
  for (const Row& row : rows) {
    StudySetting setting;
    setting.value = row.value;
    setting.comparison = setting.value == kExactHits;
    setting.isDefault = setting.value == byDefault;
    setting.settingDefault = study.quality.sampled() && setting.value == "2";
    setting.frameMilliseconds = row.time;
    setting.frameTimes = {row.time - row.spread, row.time, row.time + row.spread};
    for (const char* pass : {"cast", "gradient"}) {
      setting.passMilliseconds[pass] = row.time;
      setting.passTimes[pass] = setting.frameTimes;
    }
    setting.errors.depthVoxels.rms = setting.errors.normalDegrees.rms = row.error;
    setting.errors.picture.edgeRms = setting.errors.picture.flip = row.error;
    setting.errors.missed = row.missed;
    study.settings.push_back(setting);
  }
  return study;
}

TEST(StudyAdvice, LeavesWhatNothingIsBetterThan) {
  const std::string advice = adviceOf(
      studyOf("supersampling",
              {{"1", 10, 1, 0.08}, {"2", 30, 1, 0.04}, {"3", 70, 1, 0.02}, {"4", 120, 1, 0.01}}, "2"));
  EXPECT_EQ(
      advice,
      "Leave `picture.supersampling` at `2`: `3` brings the error of edges from 4 % of the range to 2 % of "
      "the range, at 2.3 times the cost; `1` is cheaper (10 ms instead of 30 ms), with 8 % of the range.");
}

TEST(StudyAdvice, TakesWhatIsMoreAccurateForNoMore) {
  EXPECT_THAT(adviceOf(studyOf("fetch", {{"fast", 10, 1, 1.0}, {"exact", 10.5, 1, 0.001}}, "fast")),
              StartsWith("Set `derivatives.fetch` to `exact`: its normal error is 0.001° instead of 1°"));
  EXPECT_THAT(adviceOf(studyOf("fetch", {{"fast", 10, 1, 1.0}, {"exact", 14, 1, 0.001}}, "fast")),
              StartsWith("Leave `derivatives.fetch` at `fast`"))
      << "clearly dearer";
}

TEST(StudyAdvice, TakesWhatIsCheaperAndAsAccurate) {
  EXPECT_THAT(adviceOf(studyOf("method", {{"sampled", 5, 1, 0.01, 0}, {"exact", 10, 1, 0.01, 0}}, "exact")),
              StartsWith("Set `hit.method` to `sampled`: it is as accurate"));
  EXPECT_THAT(adviceOf(studyOf("method", {{"sampled", 5, 1, 0.01, 3}, {"exact", 10, 1, 0.01, 0}}, "exact")),
              StartsWith("Leave `hit.method` at `exact`"))
      << "it misses pixels";
}

TEST(StudyAdvice, ForSampledHitsSaysThatExactOnesAreTheDefault) {
  const std::string advice = adviceOf(studyOf(
      "rate", {{"1", 5, 1, 0.02, 9}, {"2", 10, 1, 0.01, 5}, {"exact hits", 11, 1, 3e-5, 0}}, kExactHits));
  EXPECT_THAT(advice, StartsWith("Leave `hit.method` at `exact`, for which `hit.rate` has no use: exact hits "
                                 "have 3e-05 voxels (0 missed) in 11 ms"));
  EXPECT_THAT(advice, HasSubstr("Where hits are sampled, leave `hit.rate` at `2`"));
}

TEST(StudyAdvice, SaysWhySampledRowsBecomeWorse) {
  QualityStudy study =
      studyOf("rate", {{"1", 5, 1, 0.02}, {"2", 10, 1, 0.03}, {"exact hits", 11, 1, 3e-5}}, kExactHits);
  EXPECT_THAT(noteOf(study), Not(HasSubstr("8-bit voxels")));
  study.eightBitVoxels = true;
  EXPECT_THAT(noteOf(study),
              HasSubstr("from 0.02 voxels (0 missed) at `1` to 0.03 voxels (0 missed) at `2`"));
  EXPECT_THAT(noteOf(study), HasSubstr("8-bit voxels with filter weights of about 8 bits"));
  EXPECT_EQ(noteOf(studyOf("rate", {{"1", 5, 1, 0.03}, {"2", 10, 1, 0.02}, {"exact hits", 11, 1, 3e-5}},
                           kExactHits)),
            "");
}

// A ratio of times that are hardly known would be taken for a finding.
TEST(StudyAdvice, HasNoRatioWhereTimesVaryTooMuch) {
  const auto field = [](double spread) {
    return adviceOf(studyOf("derivatives_field",
                            {{"cubic", 10, 1, 0.5}, {"cubic_interpolating", 40, spread, 0.0}}, "cubic"));
  };
  EXPECT_THAT(field(4), HasSubstr("has 4 times the cost"));
  EXPECT_THAT(field(20), HasSubstr("a cost that varies too much for a ratio (40 ms against 10 ms)"));
}

TEST(StudyAdvice, OfAFieldSaysTheScaleOfTheNormals) {
  QualityStudy study =
      studyOf("derivatives_field", {{"cubic", 10, 1, 0.0095}, {"cubic_interpolating", 10, 1, 0.0}}, "cubic");
  EXPECT_THAT(adviceOf(study), HasSubstr("take `cubic_interpolating` for clean data"));
  study.normalScaleMm = 1.0;
  EXPECT_EQ(
      adviceOf(study),
      "Leave `derivatives.field` at `cubic`: at the normals' scale of 1 mm `cubic_interpolating` has about "
      "the same cost, and the normals change by 0.0095° (RMS).");
}

TEST(StudyAdvice, OfAShadowTellsWhatItCosts) {
  EXPECT_THAT(adviceOf(studyOf("shadow", {{"0", 10, 1, 0.05}, {"1", 15, 1, 0.0}}, "0")),
              HasSubstr("a frame takes 15 ms instead of 10 ms, and the picture changes by 0.05"));
  EXPECT_THAT(adviceOf(studyOf("shadow", {{"0", 10, 1, 0.05}, {"1", 10.5, 1, 0.0}}, "0")),
              HasSubstr("no time that can be told"));
}

TEST(StudyAdvice, IsASentenceForEveryKnob) {
  for (const QualitySetting& quality : qualitySettings()) {
    if (quality.measure == Measure::light || quality.measure == Measure::scale) continue;
    std::vector<Row> rows;
    for (const std::string& value : quality.values) rows.push_back({value.c_str(), 10, 1, 0.5});
    EXPECT_THAT(adviceOf(studyOf(quality.name, rows, defaultValue(quality))), testing::EndsWith("."))
        << quality.name;
  }
}

}  // namespace
}  // namespace isolux::app
