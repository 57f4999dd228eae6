// Takes the noise out of stored irradiance: each texel becomes a weighted mean of itself and its 26
// neighbours, those that lie on nearly the same isosurface with nearly the same normal; and then makes up for
// what lookups between texels will blur. No GL.
//
// The weight of a neighbour is its number of paths times a Gaussian of the distance between the places where
// both are lit (1.6 texels) times one of how far its isosurface passes from the texel (0.5 texels, by the
// isovalues' difference over the gradient; nothing where all texels are lit on one isosurface) times the 16th
// power of the normals' cosine: what lies on the other side of a thin wall, or on a wall at an angle, counts
// little or nothing. Light that changes from place to place is averaged along the lines where it is the same,
// not across: a plane fitted to the luminance of the 27 by least squares, with these weights, says how far
// that of the neighbour's place is off, and a Gaussian of it (half a standard error of the difference of two
// estimates of n paths, each taken for 1 / sqrt(n) of their mean) is a factor, too. So edges of shadow stay.
// A steering kernel (Takeda, Farsiu & Milanfar 2007). The widths are those with the least error against
// path-traced pixels (docs/explanation/accuracy.md).
//
// A lookup at the place where a texel is lit reads eight texels that are lit elsewhere, and would not give
// its light back. What it would miss is added to the texel (one step of Van Cittert's iteration, 1931): light
// that bends within a texel, in a narrow gap or at a rim, is not blurred.
//
// A texel of its own isosurface, at the edge of a plateau or in the middle of a thin wall, lies where
// trilinear interpolation makes that isosurface bumpy: its light is wrong, whatever the number of paths. So
// the weight is also the steepness of the field there over 1 + (kink / 0.7)^4, where kink is how much the
// steepness changes from one texel to the next, in parts of itself (1 / 3 on an isosurface of a parabola
// three texels from its peak).
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/lattice/lattice_geometry.h"

namespace isolux::render {

inline constexpr int kFilterBorder = 2;  // texels around a block that its own depend on
inline constexpr int kFilterTexels = gi::kBlockTexels + 2 * kFilterBorder;  // per axis

// Of the field at a texel.
struct FieldShape {
  float steepness = 0.0f;  // in the isovalue's unit per texel
  float kink = 0.0f;       // second difference along the gradient over the steepness
};
// `own` and the isovalues one texel before and behind it on each axis; NaN where there is none.
FieldShape fieldShape(float own, glm::vec3 before, glm::vec3 behind);

struct FilterTexel {
  glm::vec3 normal{0.0f};  // unit; 0: neither lit nor to be used
  glm::vec3 place{0.0f};   // where it is lit, texels
  float isovalue = 0.0f;   // any unit; of the place
  FieldShape shape{};      // the same of all where they are lit on one isosurface
  float skyPaths = 0.0f, lampsPaths = 0.0f;
  glm::vec3 sky{0.0f}, lamps{0.0f};  // E, or any part of it
  const float* transfer = nullptr;   // of the sky, where that is stored
};

// `texels`: kFilterTexels^3, x fastest, the block from kFilterBorder on each axis on; `first`: which of the
// lattice the first one is. Result: the block's 512, of which only light is set; texels without paths stay as
// they are.
std::vector<FilterTexel> filterBlock(const std::vector<FilterTexel>& texels, glm::ivec3 first);
// Transfer vectors of `components` numbers, side by side; 0 where a texel has no paths. They are averaged
// only: Gaussians of 0.8 texels, in all directions.
std::vector<float> filterTransfer(const std::vector<FilterTexel>& texels, std::size_t components);

}  // namespace isolux::render
