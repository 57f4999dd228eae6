// How often what was chosen keeps its promise, and how often less work would have: random targets on several
// volumes. Takes minutes of a volume, of light up to an hour, so that it is left out unless asked for:
//   app_tests --gtest_also_run_disabled_tests --gtest_filter='*TargetPromiseGl*Light*engine'
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <ostream>
#include <random>

#include <gtest/gtest.h>

#include "app/error_budget/stages.h"
#include "app/error_budget/target_search.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using namespace app;

constexpr int kTargets = 20;
constexpr glm::ivec2 kPicture{480, 360};

struct Subject {
  std::string name, path;
  std::vector<std::string> assignments;
};

void PrintTo(const Subject& subject, std::ostream* out) {
  *out << subject.name;
}

class TargetPromiseGlTest : public RenderGlTest, public testing::WithParamInterface<Subject> {
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
  // A combination, measured on few, many and most pixels for the choice, and in the picture.
  struct Table {
    Candidate candidate;
    std::array<TargetErrors, 4> errors;
    double inPicture(Quantity quantity) const { return errors[3][indexOf(quantity)].value; }
  };
  // `choose(limit, measure)`: the search's own way, with what was measured already.
  template <class Choose>
  static Score score(const std::vector<Table>& tables, Quantity quantity, std::mt19937& random,
                     const Choose& choose) {
    double least = INFINITY, most = 0.0;
    for (const Table& one : tables) {
      const double value = one.errors[0][indexOf(quantity)].value;
      if (!(value > 0.0)) continue;
      least = std::min(least, value);
      most = std::max(most, value);
    }
    Score score;
    if (!(most > least)) return score;
    const auto tableOf = [&](const Candidate& candidate) -> const Table& {
      return *std::find_if(tables.begin(), tables.end(), [&](const Table& one) {
        return one.candidate.assignments == candidate.assignments;
      });
    };
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int i = 0; i < kTargets; ++i) {
      const Limit limit{quantity, least * std::pow(most / least, place(random))};
      const std::optional<Candidate> chosen =
          choose(limit, [&](const Candidate& candidate, Measuring measuring) {
            return tableOf(candidate).errors[static_cast<std::size_t>(measuring)];
          });
      if (!chosen) continue;
      ++score.targets;
      score.kept += tableOf(*chosen).inPicture(quantity) <= limit.most;
      score.cheapest += std::none_of(tables.begin(), tables.end(), [&](const Table& one) {
        return one.candidate.cost < chosen->cost && one.inPicture(quantity) <= limit.most;
      });
    }
    return score;
  }
  static void print(const Subject& subject, Quantity quantity, const Score& score) {
    std::printf("%-20s %-10s kept %2d, cheapest %2d of %2d\n", subject.name.c_str(), nameOf(quantity),
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
  std::vector<Subject> list{{"gyroid", "phantom:gyroid:96", {}}, {"head", "phantom:head:128", {}}};
  const std::pair<const char*, const char*> scans[] = {
      {"ct_head_skin_bone", "0.51"}, {"engine", "80"}, {"tooth", "620"}, {"mri_colin27", "71.5"}};
  if (!dataFolder().empty())
    for (const auto& [name, isovalue] : scans)
      list.push_back({name,
                      (dataFolder() / "volumes" /
                       (std::string(name) + (std::string(name) == "tooth" ? ".mhd" : ".nii.gz")))
                          .string(),
                      {std::string("isosurface.value=") + isovalue}});
  return list;
}

TEST_P(TargetPromiseGlTest, DISABLED_SurfacesAreKept) {
  const Subject& subject = GetParam();
  const TargetQuestion question = questionOf(subject, {"picture.executor=gpu", "look.mode=kappa1"});
  TargetSearch search(*renderer_, question);
  const std::vector<Candidate> list = search.candidates(true, progress_);
  std::vector<Table> tables;
  for (const Candidate& candidate : list) {
    const auto on = [&](Measuring measuring) { return search.measure(candidate, measuring, progress_); };
    const TargetErrors picture = on(Measuring::picture);  // smaller than kMostPixels
    tables.push_back({candidate, {on(Measuring::few), on(Measuring::many), picture, picture}});
  }
  std::mt19937 random(7);
  for (const Quantity quantity :
       {Quantity::depthMm, Quantity::missed, Quantity::normal, Quantity::curvature}) {
    const auto choose = [&](const Limit& limit, const MeasureCandidate& measure) -> std::optional<Candidate> {
      std::vector<MeasuredCandidate> measured{{list.front(), measure(list.front(), Measuring::few)}};
      const auto chosen = chooseSurface(
          list, {&limit, 1}, measure, [](double) {}, measured);
      if (!chosen) return std::nullopt;
      return measured[*chosen].candidate;
    };
    const Score found = score(tables, quantity, random, choose);
    print(subject, quantity, found);
    expectKept(subject, quantity, found);
  }
}

// Judged at other pixels of the picture than those that choose.
TEST_P(TargetPromiseGlTest, DISABLED_LightIsKept) {
  const Subject& subject = GetParam();
  const TargetQuestion question = questionOf(subject, {"look.mode=gi"});
  TargetSearch search(*renderer_, question);
  search.candidates(false, progress_);
  Turning turning;
  turning.given = question.given;
  std::vector<Candidate> list;
  std::vector<Table> tables;
  for (const Candidate& candidate : lightCandidates(turning, {})) {
    if (candidate.cost > 2.5 * 150) continue;
    const auto on = [&](Measuring measuring) { return search.measureLight(candidate, measuring, progress_); };
    list.push_back(candidate);
    tables.push_back(
        {candidate, {on(Measuring::few), on(Measuring::many), on(Measuring::most), on(Measuring::picture)}});
    std::printf(" ");
    for (const std::string& assignment : candidate.assignments) std::printf(" %s", assignment.c_str());
    std::printf(": work %.4g", candidate.cost);
    for (const TargetErrors& errors : tables.back().errors)
      std::printf(", %.5f (%.5f to %.5f)", errors[indexOf(Quantity::light)].value,
                  errors[indexOf(Quantity::light)].least, errors[indexOf(Quantity::light)].bound);
    std::printf("\n");
    std::fflush(stdout);
  }
  std::mt19937 random(7);
  const auto choose = [&](const Limit& limit, const MeasureCandidate& measure) -> std::optional<Candidate> {
    std::vector<MeasuredCandidate> measured;
    const auto chosen = chooseLight(
        list, question.given, limit, measure, [](double) {}, measured);
    if (!chosen) return std::nullopt;
    return measured[*chosen].candidate;
  };
  const Score found = score(tables, Quantity::light, random, choose);
  print(subject, Quantity::light, found);
  expectKept(subject, Quantity::light, found);
}

INSTANTIATE_TEST_SUITE_P(Volumes, TargetPromiseGlTest, testing::ValuesIn(subjects()),
                         [](const testing::TestParamInfo<Subject>& of) { return of.param.name; });

}  // namespace
}  // namespace isolux::test
