// Searches on small phantoms: need software GL.
#include "app/error_budget/target_search.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "scene/settings/host_settings.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

using namespace app;
using testing::HasSubstr;

class TargetSearchGlTest : public RenderGlTest {
 protected:
  TargetQuestion question(const char* phantomName, const std::vector<std::string>& assignments) {
    TargetQuestion question;
    question.volume = phantom(phantomName, 48);
    question.given = assigned(assignments);
    question.picture.size = {260, 200};  // more than kFewPixels
    for (const std::string& assignment : assignments)
      if (scene::isHostSetting(assignment)) scene::applyAssignment(question.host, assignment);
    question.processor = question.host.executor == scene::Executor::cpu;
    renderer_->setVolume(question.volume);
    return question;
  }
  TargetAnswer answer(const TargetQuestion& question, const std::string& target) {
    TargetSearch search(*renderer_, question);
    return search.keepErrors(parseErrorTarget(target), progress_).value();
  }
  // Of the chosen settings, on all pixels of the picture, against double precision.
  TargetErrors errorsOfPicture(const TargetQuestion& question, const TargetAnswer& answer) {
    TargetSearch other(*renderer_, question);
    other.candidates(false, progress_);
    return other.measure(answer.measured[answer.chosen].candidate, Measuring::picture, progress_);
  }
  base::Progress progress_;
};

TEST_F(TargetSearchGlTest, ShadersSampleAsCoarselyAsTheErrorAllows) {
  for (const char* name : {"gyroid", "torus"}) {
    TargetQuestion shaders = question(name, {"picture.executor=gpu", "hit.rate=1"});
    shaders.fixed = {"hit.rate", "hit.near_factor"};  // few combinations, quick
    double work = 0.0;
    for (const double most : {0.3, 0.02}) {
      const TargetAnswer found = answer(shaders, "missed=1%,depth=" + std::to_string(most) + "vox");
      const MeasuredCandidate& chosen = found.measured[found.chosen];
      EXPECT_GE(chosen.candidate.cost, work) << name << ": a smaller error never takes less";
      work = chosen.candidate.cost;
      for (const MeasuredCandidate& one : found.measured)
        if (keeps(one.errors, found.limits)) {
          EXPECT_GE(one.candidate.cost, work) << name;
        }
      const TargetErrors errors = errorsOfPicture(shaders, found);
      EXPECT_LE(errors[indexOf(Quantity::depthVoxels)].value, most) << name;
      EXPECT_LE(errors[indexOf(Quantity::missed)].value, 0.01) << name;
      EXPECT_GT(found.expectedMilliseconds, 0.0);
      EXPECT_FALSE(chosen.candidate.complete) << name << ": samples are enough";
    }
  }
}

TEST_F(TargetSearchGlTest, TheSameQuestionHasTheSameAnswer) {
  TargetQuestion asked = question("gyroid", {"picture.executor=gpu"});
  asked.fixed = {"hit.rate", "hit.near_factor"};
  const TargetAnswer one = answer(asked, "depth=0.05vox"), two = answer(asked, "depth=0.05vox");
  EXPECT_EQ(one.measured[one.chosen].candidate.assignments, two.measured[two.chosen].candidate.assignments);
  EXPECT_EQ(one.measured.size(), two.measured.size());
  ASSERT_EQ(one.limits.size(), 2u) << "missed pixels, too, which nobody asked about";
  EXPECT_EQ(one.asked, 1u);
  EXPECT_EQ(one.limits[1].quantity, Quantity::missed);
}

TEST_F(TargetSearchGlTest, TheProcessorHitsExactlyForTheLeastWork) {
  const TargetAnswer found = answer(question("gyroid", {"picture.executor=cpu"}), "depth=0.3vox");
  ASSERT_EQ(found.measured.size(), 1u);
  EXPECT_TRUE(found.measured.front().candidate.complete);
}

TEST_F(TargetSearchGlTest, PlainNormalsAreTakenWhereTheyAreNearEnough) {
  const TargetQuestion asked = question("gyroid", {"picture.executor=cpu", "derivatives.normal_scale=0"});
  const TargetAnswer rough = answer(asked, "normal=30deg"), fine = answer(asked, "normal=0.05deg");
  EXPECT_THAT(rough.measured[rough.chosen].candidate.assignments,
              testing::Contains("derivatives.field=trilinear"));
  EXPECT_THAT(fine.measured[fine.chosen].candidate.assignments, testing::IsEmpty());
}

TEST_F(TargetSearchGlTest, WhatDoesNotActIsSaidAndIgnored) {
  const TargetAnswer found = answer(question("gyroid", {}), "light=2%,curvature=5%");
  EXPECT_THAT(found.notes,
              testing::ElementsAre(HasSubstr("light is ignored"), HasSubstr("curvature is ignored")));
  EXPECT_TRUE(found.measured.empty()) << "nothing is drawn for it";
}

TEST_F(TargetSearchGlTest, WhatNothingReachesIsRefusedWithWhatIsNearest) {
  try {
    answer(question("gyroid", {"picture.executor=cpu"}), "depth=0.000000001mm");
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::usage);
    EXPECT_THAT(error.what(), HasSubstr("the smallest guaranteed error is depth "));
  }
}

TEST_F(TargetSearchGlTest, NothingIsChosenWhereNothingIsSeen) {
  TargetSearch search(*renderer_, question("gyroid", {"camera.eye=0,-900,0", "camera.target=0,-1000,0"}));
  EXPECT_FALSE(search.keepErrors(parseErrorTarget("depth=1mm"), progress_).has_value());
}

TEST_F(TargetSearchGlTest, AStopIsHeard) {
  TargetSearch search(*renderer_, question("gyroid", {}));
  progress_.requestStop();
  try {
    search.keepErrors(parseErrorTarget("depth=1mm"), progress_);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
  }
}

TEST_F(TargetSearchGlTest, LightTakesMorePathsForASmallerError) {
  const TargetQuestion asked =
      question("ball", {"look.mode=gi", "gi.bounces=0", "light.environment.constant=1,1,1"});
  const TargetAnswer rough = answer(asked, "light=30%"), fine = answer(asked, "light=6%");
  const auto workOf = [](const TargetAnswer& found) { return found.measured[found.chosen].candidate.cost; };
  EXPECT_LE(workOf(rough), workOf(fine));
  EXPECT_LE(fine.measured[fine.chosen].errors[indexOf(Quantity::light)].bound, 0.06);
}

TEST_F(TargetSearchGlTest, ALongTimeTakesTheMostExactAndAShortOneIsRefused) {
  const TargetQuestion asked = question("gyroid", {"picture.executor=cpu"});
  TargetSearch search(*renderer_, asked);
  const TargetAnswer found = search.keepTime(1e6, progress_).value();
  EXPECT_EQ(found.measured.size(), 1u);
  EXPECT_TRUE(found.measured[found.chosen].candidate.assignments.empty());
  try {
    search.keepTime(1e-6, progress_);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the fastest take about"));
  }
}

}  // namespace
}  // namespace isolux::test
