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
  static Score score(const std::vector<Measured>& small, const std::vector<Measured>& many,
                     const std::vector<Measured>& large, Quantity quantity, std::mt19937& random) {
    const std::size_t q = indexOf(quantity);
    double least = INFINITY, most = 0.0;
    for (const Measured& one : small) {
      const double value = one.errors[q].value;
      if (!(value > 0.0)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    Score score;
    if (!(most > least)) return score;
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int i = 0; i < kTargets; ++i) {
      const Limit limit{quantity, least * std::pow(most / least, place(random))};
      std::vector<Measured> judged = small;
      const std::span<const Limit> limits(&limit, 1);
      for (const auto* const next : {&many, &large})
        for (std::size_t k = 0; k < many.size(); ++k)
          if (!keeps(judged[k].errors, limits) && mayKeep(judged[k].errors, limits)) judged[k] = (*next)[k];
      const auto chosen = cheapestThatKeeps(judged, std::span(&limit, 1));
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
  static void print(const Subject& subject, Quantity quantity, const Score& score) {
    std::printf("%-60s %-10s kept %2d, cheapest %2d of %2d\n", subject.path.c_str(), nameOf(quantity),
                score.kept, score.cheapest, score.targets);
    std::fflush(stdout);
  }
  static void expectKept(const Subject& subject, Quantity quantity, const Score& score) {
    EXPECT_GE(20 * score.kept, 19 * score.targets) << subject.path << ' ' << nameOf(quantity);
    EXPECT_GE(20 * score.cheapest, 18 * score.targets) << subject.path << ' ' << nameOf(quantity);
  }
  base::Progress progress_;
};

std::vector<Subject> subjects() {
  std::vector<Subject> list{{"phantom:gyroid:96", {}}, {"phantom:head:128", {}}};
  const std::pair<const char*, const char*> scans[] = {
      {"ct_head_skin_bone", "0.51"}, {"engine", "80"}, {"tooth", "620"}, {"mri_colin27", "71.5"}};
  if (!dataFolder().empty())
    for (const auto& [name, isovalue] : scans)
      list.push_back({(dataFolder() / "volumes" /
                       (std::string(name) + (std::string(name) == "tooth" ? ".mhd" : ".nii.gz")))
                          .string(),
                      {std::string("isosurface.value=") + isovalue}});
  return list;
}

TEST_F(TargetPromiseGlTest, DISABLED_SurfacesAreKept) {
  for (const Subject& subject : subjects()) {
    const TargetQuestion question = questionOf(subject, {"picture.executor=gpu", "look.mode=kappa1"});
    TargetSearch search(*renderer_, question);
    std::vector<Measured> few, many, picture;
    for (const Candidate& candidate : search.candidates(true, progress_)) {
      few.push_back({candidate, search.measure(candidate, Measuring::few, progress_)});
      many.push_back({candidate, search.measure(candidate, Measuring::many, progress_)});
      picture.push_back({candidate, search.measure(candidate, Measuring::picture, progress_)});
    }
    std::mt19937 random(7);
    for (const Quantity quantity :
         {Quantity::depthMm, Quantity::missed, Quantity::normal, Quantity::curvature}) {
      const Score found = score(few, many, picture, quantity, random);
      print(subject, quantity, found);
      expectKept(subject, quantity, found);
    }
  }
}

TEST_F(TargetPromiseGlTest, DISABLED_LightIsKept) {
  for (const Subject& subject : subjects()) {
    const TargetQuestion question = questionOf(subject, {"look.mode=gi"});
    TargetQuestion other = question;  // whose rays, and what they see of the lattice, are others
    other.picture.size = {219, 167};
    TargetSearch small(*renderer_, question), large(*renderer_, other);
    Turning turning;
    turning.given = question.given;
    std::vector<Measured> forChoice, inPicture;
    small.candidates(false, progress_);
    large.candidates(false, progress_);
    for (const Candidate& candidate : lightCandidates(turning, {})) {
      if (candidate.cost > 2.5 * 150) continue;
      forChoice.push_back({candidate, small.measureLight(candidate, progress_)});
      inPicture.push_back({candidate, large.measureLight(candidate, progress_)});
      std::printf("  %s: %.3f (at most %.3f), %.3f\n",
                  candidate.assignments.empty() ? "" : candidate.assignments.back().c_str(),
                  forChoice.back().errors[indexOf(Quantity::light)].value,
                  forChoice.back().errors[indexOf(Quantity::light)].bound,
                  inPicture.back().errors[indexOf(Quantity::light)].value);
    }
    std::mt19937 random(7);
    const Score found = score(forChoice, {}, inPicture, Quantity::light, random);
    print(subject, Quantity::light, found);
    expectKept(subject, Quantity::light, found);
  }
}

}  // namespace
}  // namespace isolux::test
