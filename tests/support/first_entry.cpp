#include "tests/support/first_entry.h"

#include <array>
#include <cmath>
#include <utility>

namespace isolux::volume {

namespace {

double trilinear(const std::array<double, 8>& c, double x, double y, double z) {
  return mix(mix(mix(c[0], c[1], x), mix(c[2], c[3], x), y), mix(mix(c[4], c[5], x), mix(c[6], c[7], x), y),
             z);
}

// How far inside the field is along the ray's stretch through a cell, s in [0, 1], in Bernstein form.
struct Cubic {
  std::array<double, 4> b;

  double operator()(double s) const {  // de Casteljau
    const double b01 = mix(b[0], b[1], s), b12 = mix(b[1], b[2], s), b23 = mix(b[2], b[3], s);
    return mix(mix(b01, b12, s), mix(b12, b23, s), s);
  }

  // Ends of the monotone pieces: 0, the extrema in (0, 1), 1, ascending.
  int pieces(std::array<double, 4>& ends) const {
    const double c0 = b[1] - b[0], c1 = b[2] - b[1], c2 = b[3] - b[2];
    const double a = (c0 - c1) + (c2 - c1), h = c1 - c0;  // f' ~ a s^2 + 2 h s + c0
    const double discriminant = h * h - a * c0;
    std::size_t count = 1;
    ends[0] = 0.0;
    if (discriminant >= 0.0) {
      const double q = -(h + std::copysign(std::sqrt(discriminant), h));
      for (const double root : {q / a, c0 / q})
        if (root > 0.0 && root < 1.0) ends[count++] = root;
      if (count == 3 && ends[1] > ends[2]) std::swap(ends[1], ends[2]);
    }
    ends[count] = 1.0;
    return static_cast<int>(count);
  }
};

// Goes through the pieces of one cell's stretch; s of the first entry. `outside` is the side before and then
// behind; false: inside or unknown.
std::optional<double> entryOf(const Cubic& cubic, bool& outside) {
  std::array<double, 4> ends{};
  const int count = cubic.pieces(ends);
  double atLow = cubic.b[0];
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i) {
    const double low = ends[i], high = ends[i + 1];
    const double atHigh = high == 1.0 ? cubic.b[3] : cubic(high);
    const bool beginsOutside = atLow < 0.0 || (atLow == 0.0 && atHigh < 0.0);
    if (outside && !beginsOutside) return low;
    if (atLow < 0.0 && atHigh > 0.0) return bracketedRoot(cubic, low, high, atLow, atHigh, true);
    outside = beginsOutside || atHigh < 0.0;
    atLow = atHigh;
  }
  return std::nullopt;
}

}  // namespace

std::optional<double> firstEntry(const Grid& grid, scene::Inside inside, double storedIsovalue,
                                 const Ray& ray) {
  const glm::ivec3 dims = grid.dims();
  if (dims.x < 2 || dims.y < 2 || dims.z < 2 || std::isnan(storedIsovalue) || !ray.valid())
    return std::nullopt;
  const double sign = (inside == scene::Inside::above) == (grid.slope() > 0.0) ? 1.0 : -1.0;
  CellWalk walk(dims, ray);
  bool outside = false;
  for (bool more = walk.inside(); more; more = walk.next()) {
    const auto stretch = walk.stretch();
    if (!stretch) continue;
    const glm::ivec3 cell = walk.cell();
    std::array<double, 8> corner;
    int below = 0;
    bool missing = false;
    for (std::size_t i = 0; i < 8; ++i) {
      const int x = cell.x + static_cast<int>(i & 1), y = cell.y + static_cast<int>(i >> 1 & 1),
                z = cell.z + static_cast<int>(i >> 2);
      corner[i] = sign * (grid.stored(x, y, z) - storedIsovalue);
      missing = missing || std::isnan(corner[i]);
      below += corner[i] < 0.0 ? 1 : 0;
    }
    if (missing) {
      outside = false;
      continue;
    }
    if (below == 8) {
      outside = true;
      continue;
    }
    if (below == 0) {
      if (outside) return stretch->t(0.0);
      continue;
    }
    // Bernstein coefficients are the polar form of the trilinear function at the stretch's two ends.
    const glm::dvec3 end[2] = {stretch->from, stretch->to};
    const auto f = [&](int i, int j, int k) { return trilinear(corner, end[i].x, end[j].y, end[k].z); };
    const Cubic cubic{{f(0, 0, 0), (f(1, 0, 0) + f(0, 1, 0) + f(0, 0, 1)) / 3.0,
                       (f(1, 1, 0) + f(1, 0, 1) + f(0, 1, 1)) / 3.0, f(1, 1, 1)}};
    if (const auto s = entryOf(cubic, outside)) return stretch->t(*s);
  }
  return std::nullopt;
}

}  // namespace isolux::volume
