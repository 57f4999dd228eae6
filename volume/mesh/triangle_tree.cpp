#include "volume/mesh/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <numeric>

#include <tbb/parallel_invoke.h>
#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

constexpr int kLeafTriangles = 4;

double lengthSquared(const glm::dvec3& v) {
  return glm::dot(v, v);
}

double squaredToBox(const glm::dvec3& p, const Bounds<glm::dvec3>& box) {
  return lengthSquared(glm::max(glm::max(box.low - p, p - box.high), glm::dvec3(0.0)));
}

glm::dvec3 closestOnEdge(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const double length = lengthSquared(b - a);
  return length > 0.0 ? a + (b - a) * std::clamp(glm::dot(p - a, b - a) / length, 0.0, 1.0) : a;
}

}  // namespace

glm::dvec3 closestPoint(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return a;
  const glm::dvec3 bp = p - b;
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return b;
  const glm::dvec3 cp = p - c;
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return c;
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return closestOnEdge(p, a, b);
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return closestOnEdge(p, a, c);
  if (va <= 0.0 && d4 >= d3 && d5 >= d6) return closestOnEdge(p, b, c);
  const double sum = va + vb + vc;
  return sum > 0.0 ? a + ab * (vb / sum) + ac * (vc / sum) : closestOnEdge(p, a, b);
}

// Halves the triangles at the median along the longest axis of their middles, again and again. How many nodes
// a half becomes is known by its number of triangles, so both can be built at the same time in their places.
class TriangleTree::Builder {
 public:
  Builder(std::vector<Corners>& triangles, std::vector<Node>& nodes, const base::Progress& progress)
      : triangles_(triangles), nodes_(nodes), progress_(progress), order_(triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    middles_.reserve(triangles.size());
    for (const Corners& t : triangles) middles_.push_back((t.a + t.b + t.c) / 3.0);
  }

  void build() {
    const int count = static_cast<int>(order_.size());
    nodes_.resize(static_cast<std::size_t>(nodesOf(count)));
    build(0, 0, count);
    progress_.throwIfStopped();
    std::vector<Corners> sorted;
    sorted.reserve(order_.size());
    for (const int i : order_) sorted.push_back(triangles_[static_cast<std::size_t>(i)]);
    triangles_ = std::move(sorted);
  }

 private:
  // Levels halve the triangles of their nodes, so each node has triangles / width of them or one more.
  static std::int64_t nodesOf(std::int64_t triangles) {
    std::int64_t width = 1;  // nodes of the first level that has leaves
    while (triangles / width > kLeafTriangles) width *= 2;
    const bool splitsMore = triangles / width == kLeafTriangles;  // those with one more triangle than a leaf
    return 2 * width - 1 + (splitsMore ? 2 * (triangles % width) : 0);
  }

  void build(std::int64_t self, int begin, int end) {
    if (progress_.stopRequested()) return;
    const int count = end - begin;
    int axis = 0;
    nodes_[static_cast<std::size_t>(self)] = bounded(begin, end, axis);
    if (count <= kLeafTriangles) return;
    const int middle = begin + count / 2;
    std::nth_element(
        order_.begin() + begin, order_.begin() + middle, order_.begin() + end, [&](int a, int b) {
          return middles_[static_cast<std::size_t>(a)][axis] < middles_[static_cast<std::size_t>(b)][axis];
        });
    const std::int64_t left = self + 1, right = left + nodesOf(middle - begin);
    nodes_[static_cast<std::size_t>(self)].first = static_cast<int>(right);
    nodes_[static_cast<std::size_t>(self)].count = 0;
    constexpr int worthSharing = 4096;
    if (count < worthSharing) {
      build(left, begin, middle);
      build(right, middle, end);
    } else {
      tbb::parallel_invoke([&] { build(left, begin, middle); }, [&] { build(right, middle, end); });
    }
  }

  // A leaf of these triangles, and the longest axis of their middles.
  Node bounded(int begin, int end, int& axis) const {
    Node node{{}, begin, end - begin};
    Bounds<glm::dvec3> middles;
    for (int i = begin; i < end; ++i) {
      const auto index = static_cast<std::size_t>(order_[static_cast<std::size_t>(i)]);
      const Corners& t = triangles_[index];
      for (const glm::dvec3& corner : {t.a, t.b, t.c}) node.box.add(corner);
      middles.add(middles_[index]);
    }
    const glm::dvec3 extent = middles.size();
    axis = extent.y > extent.x ? 1 : 0;
    if (extent.z > extent[axis]) axis = 2;
    return node;
  }

  std::vector<Corners>& triangles_;
  std::vector<Node>& nodes_;
  const base::Progress& progress_;
  std::vector<int> order_;
  std::vector<glm::dvec3> middles_;
};

// Calls `f` with the pieces of each triangle while it returns true: halves across the longest side, again and
// again.
template <typename F>
void TriangleTree::forEachPiece(const TriangleMesh& mesh, double longestSide, const base::Progress& progress,
                                F&& f) {
  std::vector<Corners> open;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (i % 4096 == 0) progress.throwIfStopped();
    const Triangle& t = mesh.triangles[i];
    open.push_back({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)});
    while (!open.empty()) {
      Corners piece = open.back();
      open.pop_back();
      const double ab = lengthSquared(piece.b - piece.a), bc = lengthSquared(piece.c - piece.b),
                   ca = lengthSquared(piece.a - piece.c);
      if (std::max({ab, bc, ca}) <= longestSide * longestSide) {
        if (!f(piece)) return;
        continue;
      }
      if (bc >= ab && bc >= ca) piece = {piece.b, piece.c, piece.a};
      if (ca > ab && ca > bc) piece = {piece.c, piece.a, piece.b};
      const glm::dvec3 middle = 0.5 * (piece.a + piece.b);
      open.push_back({piece.a, middle, piece.c});
      open.push_back({middle, piece.b, piece.c});
    }
  }
}

std::size_t TriangleTree::piecesOf(const TriangleMesh& mesh, double longestSide, std::size_t most,
                                   const base::Progress& progress) {
  std::size_t count = 0;
  forEachPiece(mesh, longestSide, progress, [&](const Corners&) { return ++count < most; });
  return count;
}

TriangleTree::TriangleTree(const TriangleMesh& mesh, double longestSide, const base::Progress& progress) {
  assert(!mesh.triangles.empty());
  triangles_.reserve(mesh.triangles.size());
  forEachPiece(mesh, longestSide, progress, [&](const Corners& piece) {
    triangles_.push_back(piece);
    return true;
  });
  progress.throwIfStopped();
  Builder(triangles_, nodes_, progress).build();
}

double TriangleTree::distance(const glm::dvec3& p, double limit, int& nearest) const {
  double best = limit * limit;
  const auto consider = [&](int i) {
    const Corners& t = triangles_[static_cast<std::size_t>(i)];
    const double candidate = lengthSquared(p - closestPoint(p, t.a, t.b, t.c));
    if (candidate >= best) return;
    best = candidate;
    nearest = i;
  };
  if (nearest >= 0) consider(nearest);
  struct Entry {
    int node;
    double squared;
  };
  std::array<Entry, 64> stack;  // the tree is balanced: no deeper than log2 of 2^31
  std::size_t size = 0;
  stack[size++] = {0, squaredToBox(p, nodes_[0].box)};
  while (size > 0) {
    const Entry entry = stack[--size];
    if (entry.squared >= best) continue;
    const Node& node = nodes_[static_cast<std::size_t>(entry.node)];
    if (node.count > 0) {
      for (int i = node.first; i < node.first + node.count; ++i) consider(i);
      continue;
    }
    const Node& l = nodes_[static_cast<std::size_t>(entry.node) + 1];
    const Node& r = nodes_[static_cast<std::size_t>(node.first)];
    const Entry left{entry.node + 1, squaredToBox(p, l.box)};
    const Entry right{node.first, squaredToBox(p, r.box)};
    const bool leftFirst = left.squared <= right.squared;
    stack[size++] = leftFirst ? right : left;
    stack[size++] = leftFirst ? left : right;
  }
  return std::sqrt(best);
}

}  // namespace isolux::volume
