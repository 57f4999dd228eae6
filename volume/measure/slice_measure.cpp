#include "volume/measure/slice_measure.h"

namespace isolux::volume {

namespace {

// Where a linear function with these values at 0 and 1 vanishes.
double crossing(double at0, double at1) {
  return at0 / (at0 - at1);
}

// How much of an edge is inside.
double insideLength(double at0, double at1) {
  const bool inside0 = at0 >= 0.0, inside1 = at1 >= 0.0;
  if (inside0 == inside1) return inside0 ? 1.0 : 0.0;
  return inside0 ? crossing(at0, at1) : 1.0 - crossing(at0, at1);
}

}  // namespace

SliceArcs arcsOf(const SliceCorners& c) {
  struct Point {
    double x, y;
    SliceEdge edge;
  };
  const auto changes = [&](std::size_t a, std::size_t b) { return (c[a] >= 0.0) != (c[b] >= 0.0); };
  const auto bottom = [&] { return Point{crossing(c[0], c[1]), 0.0, SliceEdge::bottom}; };
  const auto right = [&] { return Point{1.0, crossing(c[1], c[3]), SliceEdge::right}; };
  const auto top = [&] { return Point{crossing(c[2], c[3]), 1.0, SliceEdge::top}; };
  const auto left = [&] { return Point{0.0, crossing(c[0], c[2]), SliceEdge::left}; };
  SliceArcs arcs;
  const auto add = [&](Point a, Point b) {
    arcs.arc[static_cast<std::size_t>(arcs.count++)] = {a.x, a.y, b.x, b.y, a.edge, b.edge};
  };
  const bool atBottom = changes(0, 1), atRight = changes(1, 3), atTop = changes(2, 3), atLeft = changes(0, 2);
  if (atBottom && atRight && atTop && atLeft) {
    // The saddle has the sign of c0 c3 - c1 c2 where c0 and c3 are inside, else the opposite one: either way
    // arcs go round corners 1 and 2 where it is positive.
    const bool roundOneAndTwo = c[0] * c[3] - c[1] * c[2] > 0.0;
    add(bottom(), roundOneAndTwo ? right() : left());
    add(top(), roundOneAndTwo ? left() : right());
    return arcs;
  }
  std::array<Point, 2> end{};
  std::size_t count = 0;
  if (atBottom) end[count++] = bottom();
  if (atRight) end[count++] = right();
  if (atTop && count < 2) end[count++] = top();
  if (atLeft && count < 2) end[count++] = left();
  if (count == 2) add(end[0], end[1]);
  return arcs;
}

double insideAlongEdges(const SliceCorners& c) {
  return 0.5 * (insideLength(c[1], c[3]) + insideLength(c[2], c[3]));  // those at x = 0 and y = 0 add nothing
}

}  // namespace isolux::volume
