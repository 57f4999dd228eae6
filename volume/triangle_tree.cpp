#include "volume/triangle_tree.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>

#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

constexpr int kLeafTriangles = 4;

double squared(const glm::dvec3& v) {
  return glm::dot(v, v);
}

double squaredToBox(const glm::dvec3& p, const glm::dvec3& low, const glm::dvec3& high) {
  return squared(glm::max(glm::max(low - p, p - high), glm::dvec3(0.0)));
}

glm::dvec3 closestOnEdge(const glm::dvec3& p, const glm::dvec3& a, const glm::dvec3& b) {
  const double length = squared(b - a);
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

TriangleTree::TriangleTree(const TriangleMesh& mesh) {
  assert(!mesh.triangles.empty());
  std::vector<int> order(mesh.triangles.size());
  std::iota(order.begin(), order.end(), 0);
  std::vector<glm::dvec3> middles;
  middles.reserve(order.size());
  triangles_.reserve(order.size());
  for (const Triangle& t : mesh.triangles) {
    const Corners& corners = triangles_.emplace_back(mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2));
    middles.push_back((corners.a + corners.b + corners.c) / 3.0);
  }
  nodes_.reserve(order.size());
  build(order, middles, 0, static_cast<int>(order.size()));
  std::vector<Corners> sorted;
  sorted.reserve(order.size());
  for (const int i : order) sorted.push_back(triangles_[static_cast<std::size_t>(i)]);
  triangles_ = std::move(sorted);
}

// Halves the triangles at the median along the longest axis of their middles.
int TriangleTree::build(std::vector<int>& order, const std::vector<glm::dvec3>& middles, int begin, int end) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Node node{glm::dvec3(infinity), glm::dvec3(-infinity), begin, end - begin};
  glm::dvec3 low(infinity), high(-infinity);
  for (int i = begin; i < end; ++i) {
    const auto index = static_cast<std::size_t>(order[static_cast<std::size_t>(i)]);
    const Corners& t = triangles_[index];
    node.low = glm::min(node.low, glm::min(t.a, glm::min(t.b, t.c)));
    node.high = glm::max(node.high, glm::max(t.a, glm::max(t.b, t.c)));
    low = glm::min(low, middles[index]);
    high = glm::max(high, middles[index]);
  }
  const int self = static_cast<int>(nodes_.size());
  nodes_.push_back(node);
  if (end - begin <= kLeafTriangles) return self;
  const glm::dvec3 extent = high - low;
  int axis = extent.y > extent.x ? 1 : 0;
  if (extent.z > extent[axis]) axis = 2;
  const int middle = begin + (end - begin) / 2;
  std::nth_element(order.begin() + begin, order.begin() + middle, order.begin() + end, [&](int a, int b) {
    return middles[static_cast<std::size_t>(a)][axis] < middles[static_cast<std::size_t>(b)][axis];
  });
  build(order, middles, begin, middle);
  const int right = build(order, middles, middle, end);
  nodes_[static_cast<std::size_t>(self)].first = right;
  nodes_[static_cast<std::size_t>(self)].count = 0;
  return self;
}

double TriangleTree::distance(const glm::dvec3& p, double limit, int& nearest) const {
  double best = limit * limit;
  const auto consider = [&](int i) {
    const Corners& t = triangles_[static_cast<std::size_t>(i)];
    const double candidate = squared(p - closestPoint(p, t.a, t.b, t.c));
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
  stack[size++] = {0, squaredToBox(p, nodes_[0].low, nodes_[0].high)};
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
    const Entry left{entry.node + 1, squaredToBox(p, l.low, l.high)};
    const Entry right{node.first, squaredToBox(p, r.low, r.high)};
    const bool leftFirst = left.squared <= right.squared;
    stack[size++] = leftFirst ? right : left;
    stack[size++] = leftFirst ? left : right;
  }
  return std::sqrt(best);
}

}  // namespace isolux::volume
