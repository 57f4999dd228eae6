#include "volume/mesh/mesh_edges.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <tbb/parallel_sort.h>
#include <glm/geometric.hpp>

#include "volume/mesh/merge_points.h"

namespace isolux::volume {

MeshEdges::MeshEdges(const std::vector<Triangle>& triangles) : ofSides_(3 * triangles.size()) {
  struct Side {
    std::uint64_t key;
    std::size_t side;
  };
  std::vector<Side> sides(ofSides_.size());
  for (std::size_t t = 0; t < triangles.size(); ++t)
    for (int i = 0; i < 3; ++i) {
      const auto [low, high] = std::minmax({triangles[t][i], triangles[t][(i + 1) % 3]});
      sides[3 * t + static_cast<std::size_t>(i)] = {
          static_cast<std::uint64_t>(low) << 32 | static_cast<std::uint32_t>(high),
          3 * t + static_cast<std::size_t>(i)};
    }
  tbb::parallel_sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) { return a.key < b.key; });
  for (std::size_t i = 0; i < sides.size();) {
    std::size_t same = i;
    for (; same < sides.size() && sides[same].key == sides[i].key; ++same)
      ofSides_[sides[same].side] = ends_.size();
    if (same - i != 2) ++open_;
    ends_.emplace_back(sides[i].key >> 32, sides[i].key & 0xffffffffu);
    i = same;
  }
}

std::vector<Triangle> splitTriangles(const TriangleMesh& mesh, const MeshEdges& edges,
                                     const std::vector<int>& split) {
  std::vector<Triangle> out;
  out.reserve(2 * mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle c = mesh.triangles[t];
    std::array<int, 3> m{};
    for (int i = 0; i < 3; ++i) m[static_cast<std::size_t>(i)] = split[edges.of(t, i)];
    const auto count = std::ranges::count_if(m, [](int point) { return point >= 0; });
    if (count == 0) {
      out.push_back(c);
      continue;
    }
    if (count == 3) {
      out.insert(out.end(), {{c[0], m[0], m[2]}, {m[0], c[1], m[1]}, {m[2], m[1], c[2]}, {m[0], m[1], m[2]}});
      continue;
    }
    // Turned so that side 0 is the one that is split, or side 2 the one that is not.
    while (!(count == 1 ? m[0] >= 0 : m[2] < 0)) {
      c = {c[1], c[2], c[0]};
      std::rotate(m.begin(), m.begin() + 1, m.end());
    }
    if (count == 1) {
      out.insert(out.end(), {{c[0], m[0], c[2]}, {m[0], c[1], c[2]}});
      continue;
    }
    const auto far = [&](int a, int b) {
      return glm::distance(mesh.points[static_cast<std::size_t>(a)],
                           mesh.points[static_cast<std::size_t>(b)]);
    };
    out.push_back({m[0], c[1], m[1]});
    if (far(c[0], m[1]) <= far(m[0], c[2]))
      out.insert(out.end(), {{c[0], m[0], m[1]}, {c[0], m[1], c[2]}});
    else
      out.insert(out.end(), {{c[0], m[0], c[2]}, {m[0], m[1], c[2]}});
  }
  return out;
}

void mergeEqualPoints(TriangleMesh& mesh, std::vector<char>& marks, const base::Progress& progress) {
  constexpr double same = 1e-9;  // voxels
  const std::vector<int> first = mergedPoints(mesh.points, same, progress);
  std::vector<int> number(mesh.points.size(), -1);
  std::size_t kept = 0;
  std::vector<char> used(mesh.points.size(), 0);
  std::vector<Triangle> triangles;
  triangles.reserve(mesh.triangles.size());
  for (Triangle t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) t[i] = first[static_cast<std::size_t>(t[i])];
    if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) continue;
    for (int i = 0; i < 3; ++i) used[static_cast<std::size_t>(t[i])] = 1;
    triangles.push_back(t);
  }
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    if (!used[i]) continue;
    number[i] = static_cast<int>(kept);
    mesh.points[kept] = mesh.points[i];
    marks[kept++] = marks[i];
  }
  mesh.points.resize(kept);
  marks.resize(kept);
  for (Triangle& t : triangles)
    for (int i = 0; i < 3; ++i) t[i] = number[static_cast<std::size_t>(t[i])];
  mesh.triangles = std::move(triangles);
}

}  // namespace isolux::volume
