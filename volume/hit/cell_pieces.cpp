#include "volume/hit/cell_pieces.h"

#include <algorithm>
#include <cstddef>

#include "volume/hit/cell_walk.h"

namespace isolux::volume {

namespace {

// The values along one of the four edges of the sweep.
struct SweptEdge {
  double near, far;  // at t = 0 and t = 1
  bool inside() const { return near >= 0.0 || far >= 0.0; }
  double at(double t) const { return mix(near, far, t); }
  // Where it is inside: from 0, to 1, or between.
  double begin() const { return near >= 0.0 ? 0.0 : near / (near - far); }
  double end() const { return far >= 0.0 ? 1.0 : near / (near - far); }
};

// The face between two neighbouring edges: where one is inside at its beginning only and the other at its
// end, both are inside at some t if the product of the inside corners is not less than the other.
bool meetOnFace(SweptEdge a, SweptEdge b) {
  if (!a.inside() || !b.inside()) return false;
  if ((a.near >= 0.0 && b.near >= 0.0) || (a.far >= 0.0 && b.far >= 0.0)) return true;
  return a.near >= 0.0 ? a.near * b.far >= a.far * b.near : b.near * a.far >= b.far * a.near;
}

// Whether a slice has a saddle that joins a and d, which b and c lie between.
bool meetInSlice(SweptEdge a, SweptEdge d, SweptEdge b, SweptEdge c) {
  if (!a.inside() || !d.inside()) return false;
  const double begin = std::max(a.begin(), d.begin()), end = std::min(a.end(), d.end());
  if (begin > end) return false;
  const auto decider = [&](double t) { return a.at(t) * d.at(t) - b.at(t) * c.at(t); };
  if (decider(begin) >= 0.0 || decider(end) >= 0.0) return true;
  const double da = a.far - a.near, db = b.far - b.near, dc = c.far - c.near, dd = d.far - d.near;
  const double square = da * dd - db * dc;
  if (square >= 0.0) return false;
  const double linear = a.near * dd + d.near * da - b.near * dc - c.near * db;
  const double top = -linear / (2.0 * square);
  return top > begin && top < end && decider(top) >= 0.0;
}

// Union-find of four edges: each points to a smaller one, or to itself.
struct EdgeSets {
  std::array<std::uint8_t, 4> parent{0, 1, 2, 3};
  std::uint8_t root(std::size_t edge) const {
    while (parent[edge] != edge) edge = parent[edge];
    return static_cast<std::uint8_t>(edge);
  }
  void join(std::size_t a, std::size_t b) {
    const auto [low, high] = std::minmax({root(a), root(b)});
    parent[high] = low;
  }
};

}  // namespace

std::array<std::uint8_t, 8> cellPieces(const CellCorners& values) {
  std::array<SweptEdge, 4> edges;  // along z, at (x, y) = (0, 0), (1, 0), (0, 1), (1, 1)
  for (std::size_t i = 0; i < 4; ++i) edges[i] = {values[i], values[i + 4]};
  EdgeSets sets;
  constexpr std::array<std::array<std::size_t, 2>, 4> neighbours{{{0, 1}, {0, 2}, {1, 3}, {2, 3}}};
  for (const auto& [a, b] : neighbours)
    if (meetOnFace(edges[a], edges[b])) sets.join(a, b);
  if (meetInSlice(edges[0], edges[3], edges[1], edges[2])) sets.join(0, 3);
  if (meetInSlice(edges[1], edges[2], edges[0], edges[3])) sets.join(1, 2);

  std::array<std::uint8_t, 4> smallest{8, 8, 8, 8};  // corner of each set of edges
  std::array<std::uint8_t, 8> pieces;
  for (std::uint8_t corner = 0; corner < 8; ++corner) {
    std::uint8_t& first = smallest[sets.root(corner & 3u)];
    if (values[corner] >= 0.0) first = std::min(first, corner);
    pieces[corner] = values[corner] >= 0.0 ? first : 8;
  }
  return pieces;
}

int cornerAbove(const CellCorners& values, glm::dvec3 local) {
  std::array<double, 4> face;  // at the chosen x
  double atEnd[2];
  const auto interpolate = [&](std::size_t x) {
    const auto along = [&](std::size_t z) { return mix(values[x + 4 * z], values[x + 2 + 4 * z], local.y); };
    return mix(along(0), along(1), local.z);
  };
  for (const std::size_t x : {0, 1}) atEnd[x] = interpolate(x);
  const std::size_t x = atEnd[1] > atEnd[0] ? 1 : 0;
  for (std::size_t i = 0; i < 4; ++i) face[i] = values[x + 2 * i];
  for (const std::size_t y : {0, 1}) atEnd[y] = mix(face[y], face[y + 2], local.z);
  const std::size_t y = atEnd[1] > atEnd[0] ? 1 : 0;
  const std::size_t z = face[y + 2] > face[y] ? 1 : 0;
  return static_cast<int>(x + 2 * y + 4 * z);
}

}  // namespace isolux::volume
