// Takes the noise out of stored irradiance: each texel becomes a weighted mean of itself and its 26
// neighbours, those that lie on nearly the same isosurface with nearly the same normal. No GL.
//
// The weight of a neighbour is its number of paths times a Gaussian of the distance between the places where
// both are lit (0.8 texels) times one of how far its isosurface passes from the texel (0.5 texels, by the
// isovalues' difference over the gradient; nothing where all texels are lit on one isosurface) times the 16th
// power of the normals' cosine: what lies on the other side of a thin wall, or on a wall at an angle, counts
// little or nothing. Irradiance that differs by clearly more than its noise does not count either, taking the
// standard error of n paths for 1 / sqrt(n) of their mean: the Gaussian is of three such errors, so that
// edges of shadow stay. A bilateral filter (Tomasi & Manduchi 1998) whose range is mostly the surface. The
// widths are those with the least error against path-traced pixels (docs/accuracy.md).
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

inline constexpr int kFilterTexels = gi::kBlockTexels + 2;  // per axis: a block and one texel around it

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

// `texels`: kFilterTexels^3, x fastest, the block from (1, 1, 1) on. Result: the block's 512, of which only
// light is set; texels without paths stay as they are.
std::vector<FilterTexel> filterBlock(const std::vector<FilterTexel>& texels);
// The same of transfer vectors of `components` numbers, side by side; 0 where a texel has no paths.
std::vector<float> filterTransfer(const std::vector<FilterTexel>& texels, std::size_t components);

}  // namespace isolux::render
