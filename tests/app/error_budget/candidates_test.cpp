#include "app/error_budget/candidates.h"

#include <set>

#include <gtest/gtest.h>

#include "app/error_budget/work.h"
#include "scene/settings/settings.h"

namespace isolux::app {
namespace {

using scene::Field;
using scene::HitMethod;

std::set<HitMethod> methodsOf(const std::vector<Candidate>& list) {
  std::set<HitMethod> methods;
  for (const Candidate& candidate : list) methods.insert(applied(candidate, {}).hit.method);
  return methods;
}

TEST(Candidates, TheMostExactComesFirstThenThoseOfMoreAndMoreWork) {
  Turning turning;
  turning.derivatives = turning.turnDerivatives = true;
  const std::vector<Candidate> list = surfaceCandidates(turning);
  ASSERT_GT(list.size(), 20u);
  EXPECT_TRUE(list.front().assignments.empty()) << "of the default scene";
  EXPECT_TRUE(list.front().complete);
  std::set<std::vector<std::string>> different;
  for (std::size_t i = 0; i < list.size(); ++i) {
    different.insert(list[i].assignments);
    EXPECT_EQ(list[i].complete, applied(list[i], {}).hit.method == HitMethod::exact);
    if (i > 1) {
      EXPECT_GE(list[i].cost, list[i - 1].cost);
    }
  }
  EXPECT_EQ(different.size(), list.size());
}

TEST(Candidates, WhatIsFixedStays) {
  Turning turning;
  EXPECT_EQ(methodsOf(surfaceCandidates(turning)).size(), 2u);
  turning.fixed = {"hit.method"};
  EXPECT_EQ(methodsOf(surfaceCandidates(turning)), (std::set{HitMethod::exact}));
  turning.given.hit.method = HitMethod::sampled;
  turning.given.hit.rate = 3.0;
  turning.fixed = {"hit.method", "hit.rate"};
  for (const Candidate& candidate : surfaceCandidates(turning)) {
    const scene::Scene scene = applied(candidate, turning.given);
    EXPECT_EQ(scene.hit.method, HitMethod::sampled);
    EXPECT_EQ(scene.hit.rate, 3.0);
  }
  turning.fixed = {"gi.samples"};
  for (const Candidate& candidate : lightCandidates(turning, {}))
    EXPECT_EQ(applied(candidate, turning.given).gi.samples, turning.given.gi.samples);
}

// Where pictures at rest have the spline's hits, sampled ones must name that field, and trilinear ones must
// forbid it.
TEST(Candidates, EveryHitSaysWhichFieldItIsOfAtRest) {
  Turning turning;
  turning.drawnField = Field::cubic_interpolating;
  bool trilinear = false;
  for (const Candidate& candidate : surfaceCandidates(turning)) {
    const scene::Scene scene = applied(candidate, turning.given);
    if (scene.hit.method == HitMethod::sampled) {
      EXPECT_EQ(scene.hit.field, Field::cubic_interpolating);
    }
    if (scene.picture.restHits == scene::StillField::same) {
      trilinear = true;
      EXPECT_EQ(scene.hit.field, Field::trilinear);
    }
  }
  EXPECT_TRUE(trilinear);
  turning.given.hit.method = HitMethod::sampled;
  turning.drawnField = Field::trilinear;
  for (const Candidate& candidate : surfaceCandidates(turning)) {
    const scene::Scene scene = applied(candidate, turning.given);
    if (scene.hit.method == HitMethod::exact) {
      EXPECT_EQ(scene.picture.restHits, scene::StillField::same) << "or the picture would be of the spline";
    }
  }
}

TEST(Work, GrowsWithEveryKnob) {
  scene::Hit hit;
  hit.method = HitMethod::sampled;
  const double work = hitWork(hit, false);
  for (const auto& turn :
       {+[](scene::Hit& h) { h.rate *= 2.0; }, +[](scene::Hit& h) { h.nearFactor *= 2.0; },
        +[](scene::Hit& h) { ++h.refinements; }, +[](scene::Hit& h) { h.field = Field::cubic; }}) {
    scene::Hit more = hit;
    turn(more);
    EXPECT_GT(hitWork(more, false), work);
    EXPECT_EQ(hitWork(more, true), hitWork(more, false)) << "sampled hits are the shaders'";
  }
  scene::Derivatives cubic, trilinear;
  trilinear.field = Field::trilinear;
  for (const bool second : {false, true}) {
    EXPECT_GT(derivativeWork(cubic, second, false), derivativeWork(trilinear, second, false));
    EXPECT_GT(derivativeWork(cubic, second, false), derivativeWork(cubic, second, true));
  }
  scene::Gi gi;
  const double light = lightWork(gi);
  gi.latticeScale = 2.0;
  EXPECT_EQ(lightWork(gi), 4.0 * light);
}

}  // namespace
}  // namespace isolux::app
