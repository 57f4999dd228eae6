#include "volume/measure/surface_graph.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/error.h"
#include "volume/hit/bernstein_cubic.h"
#include "volume/measure/slice_measure.h"
#include "volume/measure/surface_sums.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

// An edge of a cell: its axis and the corner (bit per axis) that it starts from.
struct CellEdge {
  int axis, corner;
};

// That edge of a face: `u` and `v` are the face's axes, the third one is at `side` (0 or 1).
CellEdge edgeOf(SliceEdge edge, int u, int v, int across, int side) {
  const int base = side << across;
  switch (edge) {
    case SliceEdge::bottom:
      return {u, base};
    case SliceEdge::top:
      return {u, base | 1 << v};
    case SliceEdge::left:
      return {v, base};
    case SliceEdge::right:
      break;
  }
  return {v, base | 1 << u};
}

int edgeNumber(CellEdge edge) {
  return edge.axis * 8 + edge.corner;
}

// Which edges (edgeNumber) are joined to each in the faces of a cell: none or two.
struct CellLinks {
  std::array<std::array<int, 2>, 24> to{};
  std::array<int, 24> count{};

  void join(CellEdge a, CellEdge b) {
    const int i = edgeNumber(a), k = edgeNumber(b);
    add(i, k);
    add(k, i);
  }
  void add(int from, int target) {
    int& n = count[static_cast<std::size_t>(from)];
    if (n < 2) to[static_cast<std::size_t>(from)][static_cast<std::size_t>(n++)] = target;
  }
};

CellLinks linksOf(const CellCorners& corner) {
  CellLinks links;
  for (int across = 0; across < 3; ++across) {
    const int u = (across + 1) % 3, v = (across + 2) % 3;
    for (int side = 0; side < 2; ++side) {
      const int base = side << across;
      const auto at = [&](int i) { return corner[static_cast<std::size_t>(base | i)]; };
      const SliceArcs arcs = arcsOf({at(0), at(1 << u), at(1 << v), at(1 << u | 1 << v)});
      for (int i = 0; i < arcs.count; ++i) {
        const SliceArc& arc = arcs.arc[static_cast<std::size_t>(i)];
        links.join(edgeOf(arc.from, u, v, across, side), edgeOf(arc.to, u, v, across, side));
      }
    }
  }
  return links;
}

using EdgeKey = std::uint64_t;  // 3 * voxel index + axis: the edge that starts at that voxel

// Loops of a row of blocks: polygons as runs of edge keys.
struct Loops {
  std::vector<EdgeKey> keys;
  std::vector<std::uint32_t> sizes;
};

void addLoops(const Grid& grid, glm::ivec3 cell, const CellCorners& corner, Loops& loops) {
  const CellLinks links = linksOf(corner);
  std::array<bool, 24> used{};
  for (int start = 0; start < 24; ++start) {
    if (used[static_cast<std::size_t>(start)] || links.count[static_cast<std::size_t>(start)] < 2) continue;
    std::uint32_t size = 0;
    int before = -1, here = start;
    do {
      used[static_cast<std::size_t>(here)] = true;
      const int from = here % 8, axis = here / 8;
      loops.keys.push_back(3 * EdgeKey{grid.index(cell + cornerStep(from))} + static_cast<EdgeKey>(axis));
      ++size;
      const auto& to = links.to[static_cast<std::size_t>(here)];
      const int next = to[0] != before ? to[0] : to[1];
      before = here;
      here = next;
    } while (!used[static_cast<std::size_t>(here)] && links.count[static_cast<std::size_t>(here)] == 2);
    if (size >= 3) {
      loops.sizes.push_back(size);
    } else {
      loops.keys.resize(loops.keys.size() - size);
    }
  }
}

glm::dvec3 crossingOf(const Grid& grid, double isovalue, EdgeKey key) {
  const auto axis = static_cast<int>(key % 3);
  const glm::ivec3 from = grid.extent().at(key / 3);
  glm::ivec3 to = from;
  ++to[axis];
  const double here = grid.value(from) - isovalue, there = grid.value(to) - isovalue;
  glm::dvec3 voxel(from);
  voxel[axis] += here / (here - there);
  return grid.geometry().worldOf(voxel);
}

void addTrianglesOfPoints(SurfaceGraph& graph) {
  graph.firstOfPoint.assign(graph.points.size() + 1, 0);
  for (const glm::ivec3& triangle : graph.triangles)
    for (int i = 0; i < 3; ++i) ++graph.firstOfPoint[static_cast<std::size_t>(triangle[i]) + 1];
  for (std::size_t i = 1; i < graph.firstOfPoint.size(); ++i)
    graph.firstOfPoint[i] += graph.firstOfPoint[i - 1];
  graph.trianglesOfPoint.resize(3 * graph.triangles.size());
  std::vector<std::uint32_t> next(graph.firstOfPoint.begin(), graph.firstOfPoint.end() - 1);
  for (std::size_t t = 0; t < graph.triangles.size(); ++t)
    for (int i = 0; i < 3; ++i)
      graph.trianglesOfPoint[next[static_cast<std::size_t>(graph.triangles[t][i])]++] =
          static_cast<std::uint32_t>(t);
}

}  // namespace

SurfaceGraph surfaceGraph(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                          base::Progress& progress) {
  SurfaceGraph graph;
  if (blocks.count() == 0 || std::isnan(isovalue)) return graph;
  const std::vector<Loops> rows = ofBlockRows(blocks, "following the surface", progress, [&](int y, int z) {
    Loops loops;
    visitCrossedCells(grid, blocks, isovalue, 1.0, y, z, [&](glm::ivec3 cell, const CellCorners& corners) {
      addLoops(grid, cell, corners, loops);
    });
    return loops;
  });
  std::vector<EdgeKey> edges;
  for (const Loops& row : rows) edges.insert(edges.end(), row.keys.begin(), row.keys.end());
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  if (edges.size() >= std::size_t{1} << 31)
    throw base::Error(base::ErrorKind::memory, "", "", "the surface has too many points for ways along it");
  graph.points.resize(edges.size());
  parallelPieces(edges.size(), 4096, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) graph.points[i] = crossingOf(grid, isovalue, edges[i]);
  });
  const auto numberOf = [&](EdgeKey key) {
    return static_cast<int>(std::lower_bound(edges.begin(), edges.end(), key) - edges.begin());
  };
  for (const Loops& row : rows) {
    std::size_t first = 0;
    for (const std::uint32_t size : row.sizes) {
      const int apex = numberOf(row.keys[first]);
      int last = numberOf(row.keys[first + 1]);
      for (std::size_t i = 2; i < size; ++i) {
        const int next = numberOf(row.keys[first + i]);
        graph.triangles.emplace_back(apex, last, next);
        last = next;
      }
      first += size;
    }
  }
  addTrianglesOfPoints(graph);
  return graph;
}

}  // namespace isolux::volume
