// How often what was chosen keeps its promise, and how often less work would have: random targets on several
// volumes. Takes minutes, so that it is left out unless asked for:
//   app_tests --gtest_also_run_disabled_tests --gtest_filter='TargetPromiseGl*'
#include <cmath>
#include <cstdio>
#include <random>

#include <gtest/gtest.h>

#include "app/target/target_search.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using namespace app;

constexpr int kTargets = 20;
constexpr glm::ivec2 kPicture{480, 360};

struct Subject {
  std::string path;
  std::vector<std::string> assignments;
};

class TargetPromiseGlTest : public RenderGlTest {
 protected:
  TargetQuestion questionOf(const Subject& subject, const std::vector<std::string>& more) {
    std::vector<std::string> assignments = subject.assignments;
    assignments.insert(assignments.end(), more.begin(), more.end());
    TargetQuestion question;
    question.given = assigned(assignments);
    question.given.source.path = subject.path;
    question.volume = volume::loadVolume(question.given.source, progress_);
    question.picture.size = kPicture;
    renderer_->setVolume(question.volume);
    return question;
  }

  struct Score {
    int targets = 0, kept = 0, cheapest = 0;
  };
  // `small`, `large`: the same candidates, measured for the choice and in the picture itself.
  static Score score(const std::vector<Measured>& small, const std::vector<Measured>& large,
                     Quantity quantity, std::mt19937& random) {
    const std::size_t q = indexOf(quantity);
    double least = INFINITY, most = 0.0;
    for (const Measured& one : small) {
      const double bound = one.errors[q].bound;
      if (!(bound > 0.0)) continue;
      least = std::min(least, bound);
      most = std::max(most, bound);
    }
    Score score;
    if (!(most > least)) return score;
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int i = 0; i < kTargets; ++i) {
      const Limit limit{quantity, least * std::pow(most / least, place(random))};
      const auto chosen = cheapestThatKeeps(small, std::span(&limit, 1));
      if (!chosen) continue;
      ++score.targets;
      score.kept += large[*chosen].errors[q].value <= limit.most;
      bool cheaper = false;
      for (const Measured& one : large)
        cheaper = cheaper ||
                  (one.candidate.cost < large[*chosen].candidate.cost && one.errors[q].value <= limit.most);
      score.cheapest += !cheaper;
    }
    return score;
  }
  static void print(const Subject& subject, const char* where, Quantity quantity, const Score& score) {
    std::printf("%-60s %-6s %-10s kept %2d, cheapest %2d of %2d\n", subject.path.c_str(), where,
                nameOf(quantity), score.kept, score.cheapest, score.targets);
    std::fflush(stdout);
  }
  static void expectKept(const Subject& subject, Quantity quantity, const Score& score) {
    EXPECT_GE(20 * score.kept, 19 * score.targets) << subject.path << ' ' << nameOf(quantity);
    EXPECT_GE(20 * score.cheapest, 18 * score.targets) << subject.path << ' ' << nameOf(quantity);
  }
  base::Progress progress_;
};

std::vector<Subject> subjects() {
  std::vector<Subject> list{{"phantom:gyroid:96", {}}, {"phantom:head:128", {}}, {"phantom:torus:96", {}}};
  const std::pair<const char*, const char*> scans[] = {
      {"ct_head_skin_bone", "0.51"}, {"engine", "80"}, {"mri_colin27", "71.5"}};
  if (!dataFolder().empty())
    for (const auto& [name, isovalue] : scans)
      list.push_back({(dataFolder() / "volumes" / (std::string(name) + ".nii.gz")).string(),
                      {std::string("isosurface.value=") + isovalue}});
  return list;
}

TEST_F(TargetPromiseGlTest, DISABLED_SurfacesAreKept) {
  for (const Subject& subject : subjects()) {
    const TargetQuestion question = questionOf(subject, {"picture.executor=gpu", "look.mode=kappa1"});
    TargetQuestion turned = question;
    scene::Scene resolved = scene::resolve(question.given, question.volume->facts);
    turned.given.camera = resolved.camera;
    const glm::dvec3 away = *resolved.camera.eye - *resolved.camera.target;
    const double turn = 0.35;  // 20 degrees
    turned.given.camera.eye =
        *resolved.camera.target + glm::dvec3(std::cos(turn) * away.x - std::sin(turn) * away.y,
                                             std::sin(turn) * away.x + std::cos(turn) * away.y, away.z);
    TargetSearch small(*renderer_, question), large(*renderer_, question, 1 << 20),
        elsewhere(*renderer_, turned);
    std::vector<Measured> forChoice, inPicture, inView;
    const std::vector<Candidate> list = small.candidates(true, progress_);
    large.candidates(true, progress_);
    elsewhere.candidates(true, progress_);
    for (const Candidate& candidate : list) {
      forChoice.push_back({candidate, small.measure(candidate, progress_)});
      inPicture.push_back({candidate, large.measure(candidate, progress_)});
      inView.push_back({candidate, elsewhere.measure(candidate, progress_)});
    }
    std::mt19937 random(7);
    for (const Quantity quantity :
         {Quantity::depthMm, Quantity::missed, Quantity::normal, Quantity::curvature}) {
      const Score same = score(forChoice, inPicture, quantity, random);
      print(subject, "same", quantity, same);
      expectKept(subject, quantity, same);
      print(subject, "turned", quantity, score(forChoice, inView, quantity, random));
    }
  }
}

TEST_F(TargetPromiseGlTest, DISABLED_LightIsKept) {
  for (const Subject& subject : subjects()) {
    const TargetQuestion question = questionOf(subject, {"look.mode=gi"});
    TargetSearch small(*renderer_, question), large(*renderer_, question, 1 << 20);
    Turning turning;
    turning.given = question.given;
    std::vector<Measured> forChoice, inPicture;
    small.candidates(false, progress_);
    large.candidates(false, progress_);
    for (const Candidate& candidate : lightCandidates(turning, {})) {
      if (candidate.cost > 2.5 * 256) continue;
      forChoice.push_back({candidate, small.measureLight(candidate, progress_)});
      inPicture.push_back({candidate, large.measureLight(candidate, progress_)});
      std::printf("  %s: %.3f (at most %.3f), %.3f\n",
                  candidate.assignments.empty() ? "" : candidate.assignments.back().c_str(),
                  forChoice.back().errors[indexOf(Quantity::light)].value,
                  forChoice.back().errors[indexOf(Quantity::light)].bound,
                  inPicture.back().errors[indexOf(Quantity::light)].value);
    }
    std::mt19937 random(7);
    const Score same = score(forChoice, inPicture, Quantity::light, random);
    print(subject, "same", Quantity::light, same);
    expectKept(subject, Quantity::light, same);
  }
}

}  // namespace
}  // namespace isolux::test
