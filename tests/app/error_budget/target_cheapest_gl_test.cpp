// What a search chooses keeps what was asked for in the picture itself, and nothing of less work does: on
// small phantoms, of every combination there is. Needs software GL. Random targets on scans, which take
// minutes, are in target_promise_gl_test.cpp.
#include <algorithm>

#include <gtest/gtest.h>

#include "app/error_budget/target_search.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

using namespace app;

class TargetCheapestGlTest : public RenderGlTest {
 protected:
  TargetQuestion question(const char* phantomName, int voxels, glm::ivec2 size,
                          const std::vector<std::string>& assignments) {
    TargetQuestion question;
    question.volume = phantom(phantomName, voxels);
    question.given = assigned(assignments);
    question.picture.size = size;
    renderer_->setVolume(question.volume);
    return question;
  }

  // A limit just above what each combination measures in the picture: it is kept, and by nothing of less
  // work.
  void expectCheapest(TargetSearch& search, Quantity quantity,
                      const std::vector<MeasuredCandidate>& inPicture) {
    const std::size_t q = indexOf(quantity);
    int asked = 0;
    for (std::size_t i = 0; i < inPicture.size(); i += 2) {  // each other one: a search takes a second
      const MeasuredCandidate& target = inPicture[i];
      const Limit limit{quantity, 1.01 * target.errors[q].value};
      if (!(target.errors[q].value > 0.0)) continue;
      ++asked;
      SCOPED_TRACE(limitsText({&limit, 1}));
      const TargetAnswer answer = search.keepErrors({limit}, progress_).value();
      const auto chosen = std::find_if(inPicture.begin(), inPicture.end(), [&](const MeasuredCandidate& one) {
        return one.candidate.assignments == answer.measured[answer.chosen].candidate.assignments;
      });
      ASSERT_NE(chosen, inPicture.end());
      EXPECT_LE(chosen->errors[q].value, limit.most) << "kept";
      for (const MeasuredCandidate& one : inPicture) {
        if (one.candidate.cost >= chosen->candidate.cost) continue;
        EXPECT_GT(one.errors[q].value, limit.most) << "not by less work: " << one.candidate.cost;
      }
    }
    EXPECT_GE(asked, 3);
  }
  base::Progress progress_;
};

TEST_F(TargetCheapestGlTest, MissedPixelsAreKeptByTheLeastWork) {
  TargetQuestion asked = question("head", 64, {260, 200}, {"picture.executor=gpu", "picture.rest_hits=same"});
  asked.fixed = {"hit.refinements", "picture.rest_hits"};
  TargetSearch search(*renderer_, asked);
  std::vector<MeasuredCandidate> inPicture;
  for (const Candidate& candidate : search.candidates(false, progress_))
    inPicture.push_back({candidate, search.measure(candidate, Measuring::picture, progress_)});
  // Depth is kept as well though nobody asked; here it is not what decides.
  std::erase_if(inPicture, [](const MeasuredCandidate& one) {
    return one.errors[indexOf(Quantity::depthVoxels)].value > 0.05;
  });
  expectCheapest(search, Quantity::missed, inPicture);
}

TEST_F(TargetCheapestGlTest, LightIsKeptByTheLeastWork) {
  TargetQuestion asked = question("gyroid", 32, {80, 60}, {"look.mode=gi"});
  TargetSearch search(*renderer_, asked);
  search.candidates(false, progress_);
  Turning turning;
  turning.given = asked.given;
  std::vector<MeasuredCandidate> inPicture;
  for (const Candidate& candidate : lightCandidates(turning, {}))
    if (candidate.cost <= 2.5 * 40)
      inPicture.push_back({candidate, search.measureLight(candidate, Measuring::picture, progress_)});
  TargetSearch other(*renderer_, asked);
  expectCheapest(other, Quantity::light, inPicture);
}

}  // namespace
}  // namespace isolux::test
