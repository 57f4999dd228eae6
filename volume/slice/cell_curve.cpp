#include "volume/slice/cell_curve.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace isolux::volume {

namespace {

constexpr int kMostMiddles = 8;        // triangles within triangles
constexpr double kRounding = 4e-15;    // of values, relative
constexpr double kRootVoxels = 1e-11;  // how well a root is found along an edge
constexpr double kThinnest = 1e-20;    // triangles of less area hold nothing, voxels^2

// Exact at both ends, so that cells on either side of a face agree on it.
double mixed(double from, double to, double t) {
  return (1.0 - t) * from + t * to;
}

bool changesSign(const Bounds<double>& range, double rounding) {
  return range.low < -rounding && range.high > rounding;
}

}  // namespace

CellCurves::CellCurves(const SliceField& field, const PlaneLattice& lattice, double isovalue)
    : field_(field), lattice_(lattice), isovalue_(isovalue) {}

bool CellCurves::mayHoldCurve(glm::ivec2 square, int k) {
  const Grid& grid = field_.grid;
  Bounds<double> range;
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 at = glm::ivec3(square, k) + cornerStep(corner);
    const double depth = grid.value(lattice_.voxelIndex(at.x, at.y, at.z)) - isovalue_;
    if (std::isnan(depth)) return false;
    corners_[corner] = depth;
    range.add(depth);
  }
  rounding_ = kRounding * (std::max(-range.low, range.high) + std::abs(isovalue_));
  if (field_.field == scene::Field::trilinear) return range.low < 0.0 && range.high >= 0.0;
  // A spline lies between the coefficients that it looks up.
  range = {};
  bool missing = false;
  const glm::ivec3 cell = lattice_.voxelIndex(square.x, square.y, k);
  forEachIn(cell - 1, cell + 3, [&](glm::ivec3 beyond) {
    const glm::ivec3 at = glm::clamp(beyond, glm::ivec3(0), grid.dims() - 1);
    const double stored =
        field_.coefficients
            ? field_.coefficients->offset + static_cast<double>(field_.coefficients->values[grid.index(at)])
            : grid.stored(at);
    missing = missing || std::isnan(stored);
    range.add(grid.valueOfStored(stored) - isovalue_);
  });
  return !missing && range.low < 0.0 && range.high >= 0.0;
}

double CellCurves::depth(glm::dvec2 at) const {
  if (field_.field != scene::Field::trilinear) return field_.value(lattice_.voxel(at)) - isovalue_;
  const double a = std::clamp(at.x - square_.x, 0.0, 1.0), b = std::clamp(at.y - square_.y, 0.0, 1.0),
               c = std::clamp(lattice_.c(at) - k_, 0.0, 1.0);
  const double* const f = corners_;
  return mixed(mixed(mixed(f[0], f[1], a), mixed(f[2], f[3], a), b),
               mixed(mixed(f[4], f[5], a), mixed(f[6], f[7], a), b), c);
}

void CellCurves::find(glm::ivec2 square, int k, std::vector<CurvePiece>& pieces) {
  if (!mayHoldCurve(square, k)) return;
  square_ = square;
  k_ = k;
  pieces_ = &pieces;
  lattice_.part(square, k, part_);
  for (std::size_t i = 2; i < part_.size(); ++i)
    triangle(corner(part_[0]), corner(part_[i - 1]), corner(part_[i]), 0);
}

// The cubic through four points of the edge, always from the same end.
CellCurves::Edge CellCurves::edgeOf(const Corner& p, const Corner& q) const {
  const bool turned = comesFirst(q.at, p.at);
  const Corner &low = turned ? q : p, &high = turned ? p : q;
  const glm::dvec2 way = high.at - low.at;
  const double one = depth(low.at + way * (1.0 / 3.0)), two = depth(low.at + way * (2.0 / 3.0));
  const double inner[2] = {(-5.0 * low.f + 18.0 * one - 9.0 * two + 2.0 * high.f) / 6.0,
                           (2.0 * low.f - 9.0 * one + 18.0 * two - 5.0 * high.f) / 6.0};
  Bounds<double> values, steps;
  for (const double x : {low.f, inner[0], inner[1], high.f}) values.add(x);
  for (const double x : {inner[0] - low.f, inner[1] - inner[0], high.f - inner[1]}) steps.add(x);
  const double length = glm::length(way), rounding = 32.0 * rounding_;
  const bool active = changesSign(values, rounding);
  const bool spline = field_.field != scene::Field::trilinear;
  const bool split = (length > kLongestCurveEdge && (active || spline)) ||
                     (length > kShortestCurveEdge && active && changesSign(steps, rounding));
  return turned ? Edge{{inner[1], inner[0]}, split} : Edge{{inner[0], inner[1]}, split};
}

void CellCurves::triangle(const Corner& a, const Corner& b, const Corner& c, int level) {
  const glm::dvec2 ab = b.at - a.at, ac = c.at - a.at;
  if (std::abs(ab.x * ac.y - ab.y * ac.x) < kThinnest) return;
  const Corner corners[3] = {a, b, c};
  const Edge edges[3] = {edgeOf(a, b), edgeOf(b, c), edgeOf(c, a)};
  if (edges[0].split || edges[1].split || edges[2].split) {
    withSplits(corners, {edges[0].split, edges[1].split, edges[2].split}, level);
  } else if (level < kMostMiddles && mayHideCurve(a, b, c, edges)) {
    const Corner middle = corner((a.at + b.at + c.at) / 3.0);
    triangle(a, b, middle, level + 1);
    triangle(b, c, middle, level + 1);
    triangle(c, a, middle, level + 1);
  } else {
    cross(a, b, c);
  }
}

// split[i]: the edge from corner i to the next.
void CellCurves::withSplits(const Corner (&corners)[3], const bool (&split)[3], int level) {
  const auto middle = [&](int i) { return corner(0.5 * (corners[i].at + corners[(i + 1) % 3].at)); };
  const int count = split[0] + split[1] + split[2];
  if (count == 3) {
    const Corner m[3] = {middle(0), middle(1), middle(2)};
    for (int i = 0; i < 3; ++i) triangle(corners[i], m[i], m[(i + 2) % 3], level);
    triangle(m[0], m[1], m[2], level);
    return;
  }
  // Turned so that the first edge is split, and the last is not.
  int first = 0;
  while (!(split[first] && !split[(first + 2) % 3])) ++first;
  const Corner &a = corners[first], &b = corners[(first + 1) % 3], &c = corners[(first + 2) % 3];
  const Corner m = middle(first);
  if (count == 1) {
    triangle(a, m, c, level);
    triangle(m, b, c, level);
    return;
  }
  const Corner n = middle((first + 1) % 3);
  triangle(m, b, n, level);
  triangle(a, m, n, level);
  triangle(a, n, c, level);
}

// Not where the coefficients have one sign, nor where the field grows all along some edge's direction: then
// the curve is one that goes from edge to edge.
bool CellCurves::mayHideCurve(const Corner& a, const Corner& b, const Corner& c,
                              const Edge (&edges)[3]) const {
  const double b300 = a.f, b030 = b.f, b003 = c.f;
  const double b210 = edges[0].inner[0], b120 = edges[0].inner[1], b021 = edges[1].inner[0],
               b012 = edges[1].inner[1], b102 = edges[2].inner[0], b201 = edges[2].inner[1];
  const double middle = depth((a.at + b.at + c.at) / 3.0);
  const double b111 =
      (27.0 * middle - (b300 + b030 + b003) - 3.0 * (b210 + b120 + b021 + b012 + b102 + b201)) / 6.0;
  Bounds<double> values;
  for (const double x : {b300, b030, b003, b210, b120, b021, b012, b102, b201, b111}) values.add(x);
  const double rounding = 256.0 * rounding_;
  if (!changesSign(values, rounding)) return false;
  const double steps[3][6] = {{b210 - b300, b120 - b210, b030 - b120, b111 - b201, b021 - b111, b012 - b102},
                              {b021 - b030, b012 - b021, b003 - b012, b111 - b120, b102 - b111, b201 - b210},
                              {b102 - b003, b201 - b102, b300 - b201, b111 - b012, b210 - b111, b120 - b021}};
  for (const auto& alongEdge : steps) {
    Bounds<double> range;
    for (const double x : alongEdge) range.add(x);
    if (!changesSign(range, rounding)) return false;
  }
  return true;
}

void CellCurves::cross(const Corner& a, const Corner& b, const Corner& c) {
  if (std::isnan(a.f) || std::isnan(b.f) || std::isnan(c.f)) return;
  const Corner corners[3] = {a, b, c};
  CurvePiece piece;
  bool crossed = false;
  for (int i = 0; i < 3; ++i) {
    const Corner &p = corners[i], &q = corners[(i + 1) % 3];
    if ((p.f >= 0.0) == (q.f >= 0.0)) continue;
    crossed = true;
    const CurveEdge edge = comesFirst(q.at, p.at) ? CurveEdge{q.at, p.at} : CurveEdge{p.at, q.at};
    (p.f >= 0.0 ? piece.from : piece.to) = edge;
    (p.f >= 0.0 ? piece.start : piece.end) = rootOn(p, q);
  }
  if (crossed) pieces_->push_back(piece);
}

// Regula falsi with halving of the end that stays (Illinois), always from the same end.
glm::dvec2 CellCurves::rootOn(const Corner& p, const Corner& q) const {
  const bool turned = comesFirst(q.at, p.at);
  const glm::dvec2 low = turned ? q.at : p.at, way = turned ? p.at - q.at : q.at - p.at;
  double t0 = 0.0, f0 = turned ? q.f : p.f, t1 = 1.0, f1 = turned ? p.f : q.f, t = 0.0;
  const double smallest = kRootVoxels / std::max(glm::length(way), kRootVoxels);
  for (int i = 0; i < 100 && std::abs(t1 - t0) > smallest; ++i) {
    const double before = t;
    t = i % 8 == 7 ? 0.5 * (t0 + t1) : (t0 * f1 - t1 * f0) / (f1 - f0);
    const double f = depth(low + t * way);
    if (f == 0.0 || std::isnan(f) || (i % 8 != 0 && std::abs(t - before) < 0.01 * smallest)) break;
    if ((f >= 0.0) == (f1 >= 0.0)) {
      f0 *= 0.5;
    } else {
      t0 = t1;
      f0 = f1;
    }
    t1 = t;
    f1 = f;
  }
  return low + t * way;
}

}  // namespace isolux::volume
