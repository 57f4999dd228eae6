// Bends the numbers that draw directions of a light probe, so that directions are drawn in proportion to what
// they give a surface: radiance times the cosine with its normal, instead of radiance alone.
//
// Environment::sample() maps [0, 1)^2 to directions so that equal areas hold equal light. That square is cut
// into kCells^2 cells, and for each of kFacings^2 normals, evenly spread over an octahedron (Cigolle et al.,
// JCGT 3(2), 2014), a cell's probability is the mean clamped cosine of the directions it holds: sampling by a
// warp of the primary samples (Clarberg et al., Wavelet Importance Sampling, 2005). Rows first, then columns,
// both in their order: well distributed numbers stay so. No cell is left out, so estimates stay unbiased for
// any normal. Immutable; any thread.
#pragma once

#include <array>
#include <functional>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace isolux::gi {

class FacingSky {
 public:
  static constexpr int kCells = 16, kFacings = 16;  // per axis

  FacingSky() = default;  // bends nothing
  // `directionAt`: Environment::sample() of a point of [0, 1)^2.
  explicit FacingSky(const std::function<glm::vec3(glm::vec2)>& directionAt);

  // Of one normal and those like it.
  struct Facing {
    std::array<float, kCells> rows;                         // where they begin, in [0, 1)
    std::array<std::array<float, kCells>, kCells> columns;  // of each row
    float inverseMean;  // 1 / mean clamped cosine over the probe's light; of a normal that sees little, less
  };
  // `normal`: unit, in the environment's frame. Valid as long as this.
  const Facing& of(glm::vec3 normal) const;

 private:
  std::vector<Facing> facings_;
};

// Numbers to draw a direction with, and how much denser they lie there than even ones.
struct BentPair {
  glm::vec2 u;
  float density;
};
BentPair bend(const FacingSky::Facing& facing, glm::vec2 u);

}  // namespace isolux::gi
