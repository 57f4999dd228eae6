// What a bilinear slice through a cell holds: which parts of its edges are inside, and the arcs of its
// isocurve.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace isolux::volume {

// Values at (0,0), (1,0), (0,1), (1,1) of the unit square; inside is >= 0.
using SliceCorners = std::array<double, 4>;

// s = s0 + x sx + y sy + x y sxy.
struct SliceField {
  explicit SliceField(const SliceCorners& c)
      : s0(c[0]), sx(c[1] - c[0]), sy(c[2] - c[0]), sxy((c[3] - c[2]) - (c[1] - c[0])) {}
  double byX(double y) const { return sx + y * sxy; }  // the derivative by x
  double byY(double x) const { return sy + x * sxy; }

  double s0, sx, sy, sxy;
};

enum class SliceEdge { bottom, right, top, left };  // y = 0, x = 1, y = 1, x = 0

// A piece of the isocurve, from one edge of the square to another.
struct SliceArc {
  double x0, y0, x1, y1;
  SliceEdge from, to;
};

struct SliceArcs {
  std::array<SliceArc, 2> arc;
  int count = 0;
};

// Two where diagonal corners are alike; the sign of the saddle tells which they are (asymptotic decider,
// Nielson & Hamann 1991).
SliceArcs arcsOf(const SliceCorners& corners);

// The integral of (x dy - y dx) / 2 over those parts of the square's edges that are inside,
// counter-clockwise. With that over the arcs, the inside on their left, it is the area inside (Green).
double insideAlongEdges(const SliceCorners& corners);

// A point of an arc, and its share of the integral of dtau = |dx| / |s_y| = |dy| / |s_x|.
struct ArcNode {
  double x, y, dtau;
};

inline constexpr double kSmoothRatio = 1.6;  // by which s_y may change along a segment of an arc
inline constexpr int kMostStretches = 24;

// Calls take(ArcNode) for the nodes of Gauss's rule of two or three points on segments of the arc. s_x s_y
// is the same all along an arc, so s_x changes by as much as s_y: a segment is smooth in x as in y.
// leastStretches: what is integrated may bend more.
template <class Take>
void alongArc(const SliceField& field, const SliceArc& arc, bool three, int leastStretches,
              const Take& take) {
  constexpr std::array<double, 2> place2{0.21132486540518712, 0.78867513459481288};
  constexpr std::array<double, 3> place3{0.11270166537925831, 0.5, 0.88729833462074169};
  constexpr std::array<double, 3> weight3{5.0 / 18.0, 8.0 / 18.0, 5.0 / 18.0};
  const bool overX = std::abs(arc.x1 - arc.x0) >= std::abs(arc.y1 - arc.y0);
  const double begin = overX ? arc.x0 : arc.y0, end = overX ? arc.x1 : arc.y1;
  const double first = overX ? field.byY(begin) : field.byX(begin);
  const double last = overX ? field.byY(end) : field.byX(end);
  const double ratio = last / first;
  int segments = leastStretches;
  if (ratio > kSmoothRatio || ratio < 1.0 / kSmoothRatio) {
    const double wanted = std::abs(std::log(ratio)) / std::log(kSmoothRatio);
    const int needed =
        wanted < kMostStretches ? static_cast<int>(wanted) + 1 : kMostStretches;  // NaN: the most
    segments = std::max(segments, needed);
  }
  const bool bent = std::abs(last - first) > 1e-3 * std::abs(first);
  const double step = bent && segments > 1 ? std::pow(ratio, 1.0 / segments) : 1.0;
  double low = begin, slope = first;
  for (int i = 0; i < segments; ++i) {
    slope *= step;
    const double part = bent ? (slope - first) / (last - first) : (i + 1.0) / segments;
    const double high = i + 1 == segments ? end : begin + (end - begin) * part;
    for (std::size_t k = 0; k < (three ? 3u : 2u); ++k) {
      const double at = low + (high - low) * (three ? place3[k] : place2[k]);
      const double across = overX ? field.byY(at) : field.byX(at);
      const double other = std::clamp(-(field.s0 + at * (overX ? field.sx : field.sy)) / across, 0.0, 1.0);
      const double dtau = std::abs((high - low) / across) * (three ? weight3[k] : 0.5);
      if (!(dtau < 1e300)) continue;  // a saddle on the isocurve itself
      take(overX ? ArcNode{at, other, dtau} : ArcNode{other, at, dtau});
    }
    low = high;
  }
}

}  // namespace isolux::volume
