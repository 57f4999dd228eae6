// How far what one way draws is from what another draws, and what a pair of ways promises.
#pragma once

#include <ostream>

#include "tests/app/same_picture/ways.h"

namespace isolux::test {

struct WayDistance {
  double elsewhere = 0.0;  // part of the pixels: a hit in one picture alone, or hits over 0.01 voxels apart
  double voxels = 0.0;     // how far the hits of all others are apart at most
  double degrees = 0.0;    // between their normals
  double differing = 0.0;  // part of the pixels whose colours are not the same
  double visible = 0.0;    // part that differ by more than kVisibleSteps (tests/render/picture_difference.h)
  int steps = 0;           // of 255, what a channel differs by at most
  double flip = 0.0;       // mean FLIP
};
WayDistance distanceOf(const DrawnWay& a, const DrawnWay& b);

// What a pair of ways promises of every scene: no more than this. Steps have no bound: where a ray just meets
// or just misses, a pixel may show anything; such pixels are among the visible.
struct WayBound {
  double elsewhere, voxels, degrees, differing, visible, flip;
};
// The same program and the same arithmetic, in another order of operations.
inline constexpr WayBound kOtherOrder{2e-4, 5e-3, 0.2, 5e-3, 2e-4, 5e-4};
// Another driver: its divisions, square roots and texture units, too.
inline constexpr WayBound kOtherDriver{1e-3, 1e-2, 0.5, 0.05, 5e-3, 2e-3};
bool keeps(const WayDistance& distance, const WayBound& bound);

// Of finished pictures alone; the others are 0.
WayDistance distanceOf(const render::ColorImage& a, const render::ColorImage& b);

// No byte of colours, hits and normals differs.
bool isIdentical(const DrawnWay& a, const DrawnWay& b);

std::ostream& operator<<(std::ostream& out, const WayDistance& distance);

}  // namespace isolux::test
