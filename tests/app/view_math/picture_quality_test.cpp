// How fine pictures in motion are, against simulated machines.
#include "app/view_math/picture_quality.h"

#include <algorithm>
#include <random>
#include <vector>

#include <gtest/gtest.h>

namespace isolux::app {

namespace {

constexpr glm::ivec2 windowPixels{800, 600};

double raysOf(const render::FrameRequest& request) {
  return static_cast<double>(request.size.x) * request.size.y * request.supersampling * request.supersampling;
}

// A machine: a fixed time per picture and a time per million rays, milliseconds; `noise` in parts.
struct HostSettings {
  double fixed, perMillion, noise = 0.0;
  std::mt19937 random{3};

  double time(const render::FrameRequest& request) {
    const double factor = 1.0 + noise * std::uniform_real_distribution<double>(-1.0, 1.0)(random);
    return factor * (fixed + perMillion * raysOf(request) * 1e-6);
  }
};

// The rays of each of `count` pictures of one gesture.
std::vector<double> gesture(PictureQuality& quality, HostSettings& host, Motion motion, int count) {
  std::vector<double> rays;
  for (int i = 0; i < count; ++i) {
    quality.changed(motion);
    const render::FrameRequest request = quality.request(windowPixels);
    rays.push_back(raysOf(request));
    quality.measured(host.time(request), motion);
  }
  return rays;
}

void set(PictureQuality& quality, int supersampling, double target = 50.0, bool adaptive = true) {
  quality.setSupersampling(supersampling);
  quality.setHostSettings({.adaptive = adaptive, .motionTarget = target});
}

}  // namespace

// The full picture was ordered while its machine seemed fast, and turns out slow when the user rests already:
// what follows it unasked, as more of the stored light comes in, is no draft.
TEST(PictureQuality, WhatFollowsASlowFullPictureAtRestIsNoDraft) {
  for (const bool light : {false, true}) {
    PictureQuality quality;
    set(quality, 2);
    quality.changed(Motion::rays);
    for (int i = 0; i < 10; ++i) quality.measured(1.0, Motion::rays);
    ASSERT_TRUE(quality.complete());
    quality.setLightChanging(light);
    EXPECT_FALSE(quality.refine());  // it rests
    quality.measured(900.0, Motion::rays);
    EXPECT_EQ(quality.request(windowPixels).size, windowPixels);
    EXPECT_EQ(quality.request(windowPixels).supersampling, light ? 1 : 2);
    quality.changed(Motion::rays);
    quality.measured(900.0, Motion::rays);
    EXPECT_LT(quality.request(windowPixels).size.x, windowPixels.x);  // moving, it is slow now
  }
}

TEST(PictureQuality, IsQuickWhileMovingThenSharpThenFull) {
  PictureQuality quality;
  set(quality, 2);
  EXPECT_EQ(quality.request(windowPixels).supersampling, 1);
  quality.measured(400.0, Motion::rays);
  EXPECT_LT(quality.request(windowPixels).size.x, 400);
  EXPECT_TRUE(quality.refine());
  EXPECT_EQ(quality.request(windowPixels).size, windowPixels);
  EXPECT_EQ(quality.request(windowPixels).supersampling, 1);
  EXPECT_FALSE(quality.complete());
  quality.measured(300.0, Motion::rays);
  EXPECT_DOUBLE_EQ(quality.pauseMilliseconds(), 600.0);  // half of what the last step will take
  EXPECT_TRUE(quality.refine());
  EXPECT_EQ(quality.request(windowPixels).size, windowPixels);
  EXPECT_EQ(quality.request(windowPixels).supersampling, 2);
  EXPECT_TRUE(quality.complete());
  EXPECT_FALSE(quality.refine());
  quality.changed(Motion::rays);
  EXPECT_FALSE(quality.complete());
}

TEST(PictureQuality, ConvergesToTheTargetWithinAFewPicturesAndStays) {
  for (const double fixed : {0.0, 5.0, 20.0}) {
    for (const double perMillion : {2.0, 20.0, 60.0, 150.0, 500.0, 1500.0}) {
      for (const double target : {25.0, 50.0, 200.0}) {
        PictureQuality quality;
        set(quality, 2, target);
        HostSettings host{fixed, perMillion};
        const std::vector<double> rays = gesture(quality, host, Motion::rays, 60);
        const std::string where = "fixed " + std::to_string(fixed) + ", per million " +
                                  std::to_string(perMillion) + ", target " + std::to_string(target);
        EXPECT_TRUE(std::all_of(rays.begin() + 5, rays.end(), [&](double r) { return r == rays.back(); }))
            << where;
        const double settled = fixed + perMillion * rays.back() * 1e-6;
        const bool smallest = rays.back() < 0.07 * windowPixels.x * windowPixels.y;
        EXPECT_TRUE(settled <= target || smallest) << where << ": " << settled;
        // Nor coarser than needed: four times the rays, in proportion, are too many, or all are cast already.
        const bool all = rays.back() == 4.0 * windowPixels.x * windowPixels.y;
        EXPECT_TRUE(all || 4.0 * settled > 0.7 * target) << where << ": " << settled;
      }
    }
  }
}

TEST(PictureQuality, DoesNotOscillateUnderNoise) {
  for (const double perMillion : {30.0, 45.0, 80.0, 120.0, 180.0, 300.0}) {
    PictureQuality quality;
    set(quality, 2);
    HostSettings host{3.0, perMillion, 0.1};
    const std::vector<double> rays = gesture(quality, host, Motion::rays, 300);
    int changes = 0;
    for (std::size_t i = 6; i < rays.size(); ++i) changes += rays[i] != rays[i - 1] ? 1 : 0;
    EXPECT_LE(changes, 1) << perMillion;
  }
}

TEST(PictureQuality, FollowsAMachineThatBecomesSlowerOrQuicker) {
  PictureQuality quality;
  set(quality, 2);
  HostSettings host{1.0, 5.0};
  EXPECT_EQ(gesture(quality, host, Motion::rays, 5).back(), 4.0 * windowPixels.x * windowPixels.y);
  host.perMillion = 400.0;
  const double slow = gesture(quality, host, Motion::rays, 5).back();
  EXPECT_LE(1.0 + 400e-6 * slow, 50.0);
  host.perMillion = 5.0;
  EXPECT_EQ(gesture(quality, host, Motion::rays, 5).back(), 4.0 * windowPixels.x * windowPixels.y);
}

TEST(PictureQuality, TheFullPictureFollowsAtRestFromAnyLevel) {
  for (const double milliseconds : {1.0, 60.0, 300.0, 5000.0}) {
    for (const int supersampling : {1, 2, 4}) {
      for (const Motion motion : {Motion::rays, Motion::look}) {
        PictureQuality quality(true);
        set(quality, supersampling);
        quality.changed(motion);
        quality.measured(milliseconds, motion);
        int steps = 0;
        while (quality.refine()) ++steps;
        EXPECT_LE(steps, 2);
        EXPECT_TRUE(quality.complete());
        EXPECT_EQ(quality.request(windowPixels).size, windowPixels);
        EXPECT_EQ(quality.request(windowPixels).supersampling, supersampling);
      }
    }
  }
}

TEST(PictureQuality, OffMeansEveryPictureIsTheFullOne) {
  PictureQuality quality(true);
  set(quality, 3, 50.0, false);
  HostSettings host{10.0, 3000.0};
  for (const Motion motion : {Motion::rays, Motion::look})
    for (const double rays : gesture(quality, host, motion, 20))
      EXPECT_EQ(rays, 9.0 * windowPixels.x * windowPixels.y);
  EXPECT_TRUE(quality.complete());
  EXPECT_FALSE(quality.refine());
}

TEST(PictureQuality, AQuickLookKeepsTheSizeThatIsOnScreen) {
  PictureQuality quality(true);
  set(quality, 2);
  HostSettings host{2.0, 400.0}, shading{1.0, 10.0};
  const double moving = gesture(quality, host, Motion::rays, 10).back();
  // A larger picture would cast rays again: it waits for the rest.
  EXPECT_EQ(gesture(quality, shading, Motion::look, 10).back(), moving);
  while (quality.refine()) {
  }
  EXPECT_EQ(gesture(quality, shading, Motion::look, 10).back(), 4.0 * windowPixels.x * windowPixels.y);
  EXPECT_TRUE(quality.complete());
  EXPECT_EQ(gesture(quality, host, Motion::rays, 1).back(),
            moving);  // what rays can afford is not forgotten
}

TEST(PictureQuality, AnAnimationIsAsFineAsTheTargetAllowsAndWaitsForNothing) {
  PictureQuality quality;
  set(quality, 2);
  HostSettings rays{2.0, 400.0}, slowShading{1.0, 60.0};
  gesture(quality, rays, Motion::rays, 10);
  quality.animated();
  EXPECT_EQ(quality.stage(), PictureQuality::Stage::moving);
  EXPECT_TRUE(quality.refine());  // the finer picture still follows
  quality.animated();
  EXPECT_EQ(quality.stage(), PictureQuality::Stage::sharp);
  EXPECT_TRUE(quality.refine());
  quality.animated();
  for (int i = 0; i < 5; ++i) {
    quality.measured(slowShading.time(quality.request(windowPixels)), Motion::look);
    quality.animated();
  }
  EXPECT_LE(slowShading.time(quality.request(windowPixels)), 50.0);
  EXPECT_EQ(quality.request(windowPixels).size, windowPixels);
  EXPECT_EQ(quality.request(windowPixels).supersampling, 1);
}

TEST(PictureQuality, WhileLightComesInPicturesStaySharpAndTheFullOneFollows) {
  PictureQuality quality;
  set(quality, 3);
  quality.changed(Motion::look);
  quality.setLightChanging(true);
  while (quality.refine()) {
  }
  EXPECT_FALSE(quality.complete());
  EXPECT_EQ(quality.scale(), 1.0);
  EXPECT_EQ(quality.supersampling(), 1);
  quality.setLightChanging(false);
  EXPECT_TRUE(quality.refine());
  EXPECT_TRUE(quality.complete());
  quality.setLightChanging(true);  // a further view is lit
  EXPECT_EQ(quality.supersampling(), 1);
}

}  // namespace isolux::app
