// Denoises baked irradiance. Each texel becomes a weighted mean of itself and of those of its 26 neighbours
// with nearly the same isosurface and normal. Then compensates for the blur of lookups between texels. No GL.
//
// The weight of a neighbour is the product of
//   - its number of paths;
//   - a Gaussian of the distance between the positions where both are lit (1.6 texels);
//   - a Gaussian of the distance of its isosurface from the texel (0.5 texels), which is the isovalues'
//     difference over the gradient; omitted if all texels are lit on one isosurface;
//   - the 16th power of the normals' cosine;
//   - an edge factor.
// A texel on the other side of a thin wall, or on a wall at an angle, therefore has little or no weight. The
// edge factor averages varying light along the lines of equal light, not across them. A plane is fitted to
// the luminance of the 27 texels by weighted least squares and predicts the difference of luminance at the
// neighbour's position. The factor is a Gaussian of this difference. Its width is half a standard error of
// the difference of two estimates of n paths, each error taken as 1 / sqrt(n) of their mean. Shadow edges are
// preserved. This is a steering kernel (Takeda, Farsiu & Milanfar 2007). The widths minimise the error
// against path-traced pixels (docs/explanation/accuracy.md).
//
// A lookup at the position where a texel is lit reads eight texels that are lit elsewhere, and does not
// reproduce its light. The difference is added to the texel (one step of Van Cittert's iteration, 1931).
// Light that varies within a texel, in a narrow gap or at a rim, is then not blurred.
//
// At the edge of a plateau or in the middle of a thin wall, trilinear interpolation makes a texel's own
// isosurface bumpy. The light of such a texel is wrong, whatever the number of paths. The weight is therefore
// also multiplied by the steepness of the field there over 1 + (kink / 0.7)^4. `kink` is the relative change
// of the steepness from one texel to the next. It is 1 / 3 on an isosurface of a parabola three texels from
// its peak.
#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "gi/lattice/lattice_geometry.h"

namespace isolux::render {

inline constexpr int kFilterBorder = 2;  // texels around a block that its own texels depend on
inline constexpr int kFilterTexels = gi::kBlockTexels + 2 * kFilterBorder;  // per axis

// Shape of the field at a texel.
struct FieldShape {
  float steepness = 0.0f;  // in the isovalue's unit per texel
  float kink = 0.0f;       // second difference along the gradient over the steepness
};
// Computes the shape from `own` and the isovalues one texel before and behind it on each axis; NaN if
// missing.
FieldShape fieldShape(float own, glm::vec3 before, glm::vec3 behind);

struct FilterTexel {
  glm::vec3 normal{0.0f};  // unit; 0: neither lit nor used
  glm::vec3 place{0.0f};   // where it is lit, in texels
  float isovalue = 0.0f;   // any unit; at `place`
  FieldShape shape{};      // equal for all texels if they are lit on one isosurface
  float skyPaths = 0.0f, lampsPaths = 0.0f;
  glm::vec3 sky{0.0f}, lamps{0.0f};  // E, or any fraction of it
  const float* transfer = nullptr;   // of the sky, if stored
};

// Filters a block. `texels`: kFilterTexels^3, x fastest, where the block begins at kFilterBorder on each
// axis. `first`: lattice coordinates of the first one. Returns the block's 512 texels, of which only light is
// set; texels without paths are unchanged.
std::vector<FilterTexel> filterBlock(const std::vector<FilterTexel>& texels, glm::ivec3 first);
// Filters transfer vectors of `components` numbers, stored one after the other; 0 for a texel without paths.
// They are only averaged: Gaussians of 0.8 texels, in all directions.
std::vector<float> filterTransfer(const std::vector<FilterTexel>& texels, std::size_t components);

}  // namespace isolux::render
