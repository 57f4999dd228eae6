#include "app/error_budget/stages.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/error_budget/candidates.h"

namespace isolux::app {
namespace {

using testing::ElementsAre;

constexpr Limit kLimit{Quantity::light, 0.1};

// What is measured of candidates, by their assignments' text, and in which order.
class Bench {
 public:
  // value, and by how much it may be off on few, many and most pixels.
  void add(const std::string& name, double value, double few, double many, double most) {
    errors_[name] = {value, few, many, most};
  }
  MeasureCandidate measure() {
    return [this](const Candidate& candidate, Measuring measuring) {
      std::string name;
      for (const std::string& assignment : candidate.assignments) name += assignment;
      order.push_back(name + '/' + std::to_string(static_cast<int>(measuring)));
      const auto& known = errors_.at(name);
      const double off = known[1 + static_cast<std::size_t>(measuring)];
      TargetErrors errors;
      errors[indexOf(kLimit.quantity)] = {known[0], known[0] - off, known[0] + off};
      return errors;
    };
  }
  std::vector<std::string> order;

 private:
  std::map<std::string, std::array<double, 4>> errors_;
};

Candidate named(const std::string& name, double cost) {
  Candidate candidate;
  candidate.assignments = {name};
  candidate.cost = cost;
  return candidate;
}

const Report kUnheard = [](double) {};

TEST(Stages, OnlyWhatIsOpenIsMeasuredOnMorePixels) {
  Bench bench;
  bench.add("keeps", 0.05, 0.04, 0.0, 0.0);
  bench.add("fails", 0.2, 0.05, 0.0, 0.0);
  bench.add("near", 0.098, 0.01, 0.005, 0.001);
  const auto errors = [&](const char* name) {
    return measuredAsNeeded(named(name, 1.0), {&kLimit, 1}, bench.measure()).errors[indexOf(kLimit.quantity)];
  };
  EXPECT_DOUBLE_EQ(errors("keeps").bound, 0.09);
  EXPECT_DOUBLE_EQ(errors("fails").least, 0.15);
  EXPECT_DOUBLE_EQ(errors("near").bound, 0.099);
  EXPECT_THAT(bench.order, ElementsAre("keeps/0", "fails/0", "near/0", "near/1", "near/2"));
}

TEST(Stages, TheCheapestSurfaceThatHoldsIsFoundBesideTheLimit) {
  Bench bench;
  bench.add("exact", 0.0, 0.0, 0.0, 0.0);
  bench.add("a", 0.104, 0.01, 0.003, 0.001);  // no better than it seems
  bench.add("b", 0.099, 0.01, 0.003, 0.0);    // better
  const std::vector<Candidate> list{named("exact", 3.0), named("a", 1.0), named("b", 2.0), named("c", 2.5),
                                    named("d", 4.0)};
  std::vector<MeasuredCandidate> measured{{list.front(), bench.measure()(list.front(), Measuring::few)}};
  EXPECT_EQ(chooseSurface(list, {&kLimit, 1}, bench.measure(), kUnheard, measured), 2u);
  EXPECT_THAT(bench.order, ElementsAre("exact/0", "a/0", "a/1", "b/0", "b/1", "b/2"));
}

TEST(Stages, NoSurfaceIsFoundWhereNothingKeepsTheLimit) {
  Bench bench;
  for (const char* name : {"exact", "a"}) bench.add(name, 1.0, 0.1, 0.1, 0.1);
  const std::vector<Candidate> list{named("exact", 1.0), named("a", 2.0)};
  std::vector<MeasuredCandidate> measured{{list.front(), bench.measure()(list.front(), Measuring::few)}};
  EXPECT_EQ(chooseSurface(list, {&kLimit, 1}, bench.measure(), kUnheard, measured), std::nullopt);
  EXPECT_EQ(measured.size(), 2u) << "where the most exact one fails, dearer ones are tried, too";
}

// Paths on two lattices: one errs by its place, whatever the paths; noise falls with their root.
class StagesOfLight : public testing::Test {
 protected:
  void SetUp() override {
    for (const double scale : {0.5, 1.0})
      for (const int paths : {4, 16, 36, 100, 256})
        list_.push_back(lightOf(scale, paths, scale < 1.0 ? 0.2 : 0.0));
    std::stable_sort(list_.begin(), list_.end(),
                     [](const Candidate& a, const Candidate& b) { return a.cost < b.cost; });
  }
  Candidate lightOf(double scale, int paths, double place) {
    const std::vector<std::string> assignments{"gi.samples=" + std::to_string(paths),
                                               "gi.lattice_scale=" + std::to_string(scale)};
    const double value = std::sqrt(place * place + 0.81 / paths);
    bench_.add(assignments[0] + assignments[1], value, 0.1 * value, 0.02 * value, 0.02 * value);
    return {assignments, paths * scale * scale, false, 1};
  }
  std::optional<double> costFor(double most) {
    const Limit limit{Quantity::light, most};
    std::vector<MeasuredCandidate> measured;
    const auto chosen = chooseLight(list_, {}, limit, bench_.measure(), kUnheard, measured);
    return chosen ? std::optional(measured[*chosen].candidate.cost) : std::nullopt;
  }
  Bench bench_;
  std::vector<Candidate> list_;
};

TEST_F(StagesOfLight, TheCheapestThatHoldsIsTaken) {
  EXPECT_EQ(costFor(0.51), 1.0);      // 0.492, though it may be 0.541 as far as few pixels tell
  EXPECT_EQ(costFor(0.5), 4.0);       // 0.502 is possible even on most pixels
  EXPECT_EQ(costFor(0.0925), 100.0);  // 0.09 with 100 paths; the coarse lattice never
}

TEST_F(StagesOfLight, MorePathsAreNotTriedWhereTheLatticeErrsTooMuch) {
  costFor(0.0925);
  EXPECT_THAT(bench_.order, testing::Contains("gi.samples=36gi.lattice_scale=0.500000/0"));
  EXPECT_THAT(bench_.order, testing::Not(testing::Contains("gi.samples=100gi.lattice_scale=0.500000/0")));
  EXPECT_EQ(costFor(0.01), std::nullopt);
}

}  // namespace
}  // namespace isolux::app
