// How draws are cut for graphics cards: by times that are given, without a card.
#include "render/gl/draw_parts.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace isolux::test {
namespace {

using render::DrawParts;
using render::PartCutter;
using volume::Rectangle;

struct CutDraw {
  int parts = 0;
  double longest = 0.0;  // ms
};

// A draw over `rays` rays on a card that takes `nanoseconds` for each.
CutDraw drawCut(DrawParts& parts, int rays, double nanoseconds) {
  CutDraw drawn;
  for (int left = rays; left > 0;) {
    const int now = std::min(parts.rays(), left);
    const double milliseconds = now * nanoseconds * 1e-6;
    parts.add(now, milliseconds);
    drawn.longest = std::max(drawn.longest, milliseconds);
    ++drawn.parts;
    left -= now;
  }
  parts.endDraw();
  return drawn;
}

TEST(DrawPartsTest, NoPartTakesTenMillisecondsOnAnyCard) {
  constexpr int rays = 4096 * 4096;
  // From what llvmpipe takes for a costly ray to what large cards take for a background.
  for (double nanoseconds = 500.0; nanoseconds > 0.01; nanoseconds /= 3.0) {
    DrawParts parts;
    for (int frame = 0; frame < 20; ++frame) {
      const CutDraw drawn = drawCut(parts, rays, nanoseconds);
      EXPECT_LT(drawn.longest, 10.0) << nanoseconds << " ns in frame " << frame;
      // Nor are there more parts than that needs.
      const double milliseconds = rays * nanoseconds * 1e-6;
      if (frame > 15) {
        EXPECT_LE(drawn.parts, 1.0 + milliseconds / (DrawParts::kShort / 2.0)) << nanoseconds;
      }
    }
  }
}

TEST(DrawPartsTest, AFastCardDrawsAPictureAtOnceAfterAFewFrames) {
  constexpr int rays = 1920 * 1080;
  DrawParts parts;
  EXPECT_LE(drawCut(parts, rays, 0.1).parts, 16);
  for (int frame = 0; frame < 4; ++frame) drawCut(parts, rays, 0.1);
  EXPECT_EQ(drawCut(parts, rays, 0.1).parts, 1);
}

TEST(DrawPartsTest, WhatIsCheapAtFirstIsNotTakenForAllOfAPicture) {
  // Half of the rays see the background.
  DrawParts parts;
  for (int ray = 0; ray < 1 << 21; ray += parts.rays()) parts.add(parts.rays(), 0.01);
  EXPECT_LE(parts.rays(), DrawParts::kMostOfFirstDraw);
  // Parts of the object are not short: one that was keeps the size, however many others are.
  parts.add(parts.rays(), 5.0);
  const int before = parts.rays();
  parts.add(parts.rays(), 0.01);
  parts.endDraw();
  EXPECT_EQ(parts.rays(), before);
}

TEST(DrawPartsTest, ALongPartHalvesUntilItWouldNotBe) {
  DrawParts parts;
  drawCut(parts, 1 << 22, 0.1);
  drawCut(parts, 1 << 22, 0.1);
  const int before = parts.rays();
  parts.add(before, 100.0);
  EXPECT_EQ(parts.rays(), before / 16);
  // A time that comes late is judged by the size that is now.
  parts.add(before, 100.0);
  EXPECT_EQ(parts.rays(), before / 16);
}

TEST(DrawPartsTest, SmallDrawsSayNothingOfLargeOnes) {
  DrawParts parts;
  for (int frame = 0; frame < 10; ++frame) drawCut(parts, 256, 0.1);
  EXPECT_FALSE(parts.known());
  EXPECT_EQ(parts.rays(), DrawParts::kFirstRays);
  drawCut(parts, 1 << 20, 0.1);
  EXPECT_TRUE(parts.known());
}

TEST(DrawPartsTest, EndsAtTheFewestRays) {
  DrawParts parts;
  for (int i = 0; i < 100; ++i) parts.add(parts.rays(), 1e6);
  EXPECT_EQ(parts.rays(), DrawParts::kFewestRays);
}

// Every pixel of the rectangles, and no other, is in one part.
void expectCut(const PartCutter::Rectangles& rectangles, int rays) {
  constexpr int size = 2100;
  std::vector<std::uint8_t> wanted(size * size, 0), cut(size * size, 0);
  const auto fill = [](std::vector<std::uint8_t>& into, const Rectangle& one) {
    for (int y = one.low.y; y < one.low.y + one.size.y; ++y)
      for (int x = one.low.x; x < one.low.x + one.size.x; ++x) ++into[static_cast<std::size_t>(y) * size + x];
  };
  for (const Rectangle& one : rectangles) fill(wanted, one);
  PartCutter cutter(rectangles);
  while (!cutter.done()) {
    const PartCutter::Rectangles part = cutter.next(rays);
    ASSERT_FALSE(part.empty());
    EXPECT_LE(render::raysOf(part), std::max(rays, DrawParts::kFewestRays));
    for (const Rectangle& one : part) fill(cut, one);
  }
  EXPECT_TRUE(cutter.next(rays).empty());
  EXPECT_EQ(wanted, cut) << rays;
}

TEST(PartCutterTest, EachRayIsInOnePart) {
  const PartCutter::Rectangles whole{{{0, 0}, {2000, 1001}}};
  const PartCutter::Rectangles strips{{{3, 0}, {0, 16}},      {{7, 16}, {333, 16}}, {{0, 32}, {2099, 16}},
                                      {{500, 48}, {1, 16}},   {{16, 64}, {16, 5}},  {{9, 69}, {777, 300}},
                                      {{100, 400}, {90, 90}}, {{0, 500}, {7, 0}}};
  for (const int rays : {1, 256, 1000, 4096, 16384, 100000, 1 << 24}) {
    expectCut(whole, rays);
    expectCut(strips, rays);
  }
  expectCut({}, 256);
}

TEST(PartCutterTest, LargePartsTakeEverything) {
  PartCutter cutter({{{0, 0}, {2000, 1001}}, {{5, 1200}, {40, 3}}});
  EXPECT_EQ(cutter.next(1 << 24).size(), 2u);
  EXPECT_TRUE(cutter.done());
}

TEST(PartCutterTest, PartsAreNearlyAsLargeAsAllowed) {
  PartCutter cutter({{{0, 0}, {1000, 1000}}});
  int parts = 0;
  for (; !cutter.done(); ++parts) cutter.next(16384);
  EXPECT_LE(parts, 1000 * 1000 / 16384 + 2);
}

}  // namespace
}  // namespace isolux::test
