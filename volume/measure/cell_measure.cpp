#include "volume/measure/cell_measure.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/measure/slice_measure.h"
#include "volume/voxels/extent.h"

namespace isolux::volume {

namespace {

constexpr double kEnough = 1e-4;   // of the cell, by what the two rules may differ on a segment of slices
constexpr int kMostHalvings = 30;  // sheets that hug the faces of a cell end within a millionth of a slice
constexpr double kOfZero = 1e-8;   // of the cell's largest value: a corner at the isovalue is so far inside
constexpr int kMostArcStretches = 16;  // of arcs in halved segments of slices, doubled with each

// A cell turned so that slices are stacked along its last axis, scaled to values of 1 at most.
struct TurnedCell {
  CellCorners corner;
  std::array<int, 3> axis;  // of the cell, of each axis here
  glm::dmat3 gradients;
  double scale;
};

double changeAlong(const CellCorners& c, std::size_t bit) {
  double sum = 0.0;
  for (std::size_t i = 0; i < 8; ++i) sum += (i & bit) != 0 ? c[i] : -c[i];
  return std::abs(sum);
}

TurnedCell turned(const CellCorners& c, const CellMetric& metric) {
  TurnedCell cell;
  const std::array<double, 3> change{changeAlong(c, 1), changeAlong(c, 2), changeAlong(c, 4)};
  const int least = static_cast<int>(std::min_element(change.begin(), change.end()) - change.begin());
  cell.axis = {(least + 1) % 3, (least + 2) % 3, least};
  double largest = 0.0;
  for (const double value : c) largest = std::max(largest, std::abs(value));
  cell.scale = largest > 0.0 ? largest : 1.0;
  for (std::size_t i = 0; i < 8; ++i) {
    std::size_t from = 0;
    for (std::size_t k = 0; k < 3; ++k) from |= (i >> k & 1) << cell.axis[k];
    cell.corner[i] = c[from] == 0.0 ? kOfZero : c[from] / cell.scale;
  }
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k)
      cell.gradients[static_cast<int>(i)][static_cast<int>(k)] = metric.gradients[cell.axis[i]][cell.axis[k]];
  return cell;
}

SliceCorners sliceAt(const CellCorners& c, double t) {
  SliceCorners slice;
  for (std::size_t i = 0; i < 4; ++i) slice[i] = c[i] + t * (c[i + 4] - c[i]);
  return slice;
}

// Where slices change their kind, ascending, between 0 and 1.
struct Breaks {
  std::array<double, 8> at{0.0, 1.0};
  std::size_t count = 2;

  void add(double t) {
    std::size_t i = count++;
    for (; i > 0 && at[i - 1] > t; --i) at[i] = at[i - 1];
    at[i] = t;
  }
};

// Integrals over slices, voxels of the cell.
struct Sums {
  double volume = 0.0, area = 0.0, sensitivity = 0.0;
};

class CellSweep {
 public:
  CellSweep(const CellCorners& corners, const CellMetric& metric, std::vector<CellPoint>* points)
      : cell_(turned(corners, metric)), metric_(metric), points_(points) {
    const CellCorners& c = cell_.corner;
    for (std::size_t i = 0; i < 4; ++i) rise_[i] = c[i + 4] - c[i];
  }

  CellMeasure measure() {
    const Breaks breaks = breaksOf();
    for (std::size_t i = 0; i + 1 < breaks.count; ++i)
      if (breaks.at[i] < breaks.at[i + 1]) addStretch(breaks.at[i], breaks.at[i + 1], kMostHalvings);
    const double cell = metric_.cellMm3;
    return {sums_.volume * cell, sums_.area * cell, sums_.sensitivity * cell / cell_.scale,
            volumeError_ * cell, areaError_ * cell};
  }

 private:
  Breaks breaksOf() const;
  void addStretch(double from, double to, int halvings);
  Sums slice(double t, bool three, double weight, int segments);
  void keepPoint(const ArcNode& node, double t, const glm::dvec3& gradient, double area);

  TurnedCell cell_;
  const CellMetric& metric_;
  std::vector<CellPoint>* points_;
  std::array<double, 4> rise_;
  Sums sums_;
  double volumeError_ = 0.0, areaError_ = 0.0;
};

// The saddle of the slice lies in the square or not far from it.
bool saddleNear(const SliceCorners& corners) {
  const SliceField field(corners);
  const double x = -field.sy, y = -field.sx, reach = std::abs(field.sxy);
  return std::abs(x - 0.5 * field.sxy) < reach && std::abs(y - 0.5 * field.sxy) < reach;
}

Breaks CellSweep::breaksOf() const {
  const CellCorners& c = cell_.corner;
  Breaks breaks;
  for (std::size_t i = 0; i < 4; ++i)
    if ((c[i] >= 0.0) != (c[i + 4] >= 0.0)) breaks.add(c[i] / (c[i] - c[i + 4]));
  // c0 c3 - c1 c2 of the slice at t, where the isocurve passes its saddle: a t^2 + 2 h t + s.
  const double a = rise_[0] * rise_[3] - rise_[1] * rise_[2];
  const double h = 0.5 * (c[0] * rise_[3] + c[3] * rise_[0] - c[1] * rise_[2] - c[2] * rise_[1]);
  const double s = c[0] * c[3] - c[1] * c[2], discriminant = std::max(h * h - a * s, 0.0);
  const double q =
      -(h + std::copysign(std::sqrt(discriminant), h));  // where there is no root: nearest to one
  const double first = a != 0.0 ? q / a : -1.0, second = q != 0.0 ? s / q : -1.0;
  for (const double root : {first, discriminant > 0.0 ? second : -1.0})
    if (root > 0.0 && root < 1.0 && saddleNear(sliceAt(c, root))) breaks.add(root);
  return breaks;
}

void CellSweep::addStretch(double from, double to, int halvings) {
  const double length = to - from;
  const SliceCorners middle = sliceAt(cell_.corner, from + 0.5 * length);
  const int inside = (middle[0] >= 0.0) + (middle[1] >= 0.0) + (middle[2] >= 0.0) + (middle[3] >= 0.0);
  if (inside == 0) return;
  if (inside == 4) {
    sums_.volume += length;
    return;
  }
  constexpr double far3 = 0.11270166537925831, far2 = 0.21132486540518712;
  const std::size_t before = points_ ? points_->size() : 0;
  const int segments = std::min(1 << std::min(kMostHalvings - halvings, 30), kMostArcStretches);
  Sums three, two;
  const auto add = [](Sums& to_, const Sums& s) {
    to_.volume += s.volume;
    to_.area += s.area;
    to_.sensitivity += s.sensitivity;
  };
  add(three, slice(from + far3 * length, true, length * 5.0 / 18.0, segments));
  add(three, slice(from + 0.5 * length, true, length * 8.0 / 18.0, segments));
  add(three, slice(to - far3 * length, true, length * 5.0 / 18.0, segments));
  add(two, slice(from + far2 * length, false, length * 0.5, segments));
  add(two, slice(to - far2 * length, false, length * 0.5, segments));
  const double volumeOff = std::abs(three.volume - two.volume);
  // The two rules may agree by chance; both integrals seldom do.
  const double sensitivityOff = std::abs(three.sensitivity - two.sensitivity) / three.sensitivity;
  const double areaOff = std::max(std::abs(three.area - two.area), three.area * sensitivityOff);
  if (halvings > 0 && (volumeOff > kEnough || areaOff * metric_.cellMm3 > kEnough * metric_.faceMm2)) {
    if (points_) points_->resize(before);
    addStretch(from, from + 0.5 * length, halvings - 1);
    addStretch(from + 0.5 * length, to, halvings - 1);
    return;
  }
  add(sums_, three);
  volumeError_ += volumeOff;
  areaError_ += areaOff;
}

Sums CellSweep::slice(double t, bool three, double weight, int segments) {
  const SliceCorners corners = sliceAt(cell_.corner, t);
  const SliceField field(corners);
  const SliceArcs arcs = arcsOf(corners);
  Sums sums;
  double along = 0.0;
  for (int i = 0; i < arcs.count; ++i)
    alongArc(field, arcs.arc[static_cast<std::size_t>(i)], three, segments, [&](const ArcNode& node) {
      const double x = node.x, y = node.y, rise0 = rise_[0] + x * (rise_[1] - rise_[0]);
      const glm::dvec3 gradient(field.byX(y), field.byY(x),
                                rise0 + y * (rise_[2] + x * (rise_[3] - rise_[2]) - rise0));
      // The arc's tangent with the inside on its left is (s_y, -s_x).
      along -= 0.5 * (x * gradient.x + y * gradient.y) * node.dtau;
      const double area = std::sqrt(glm::dot(gradient, cell_.gradients * gradient)) * node.dtau;
      sums.area += area;
      sums.sensitivity += node.dtau;
      if (three && points_) keepPoint(node, t, gradient, area * weight * metric_.cellMm3);
    });
  sums.volume = std::clamp(insideAlongEdges(corners) + along, 0.0, 1.0) * weight;
  sums.area *= weight;
  sums.sensitivity *= weight;
  return sums;
}

void CellSweep::keepPoint(const ArcNode& node, double t, const glm::dvec3& gradient, double area) {
  CellPoint point;
  const std::array<double, 3> local{node.x, node.y, t};
  for (std::size_t k = 0; k < 3; ++k) {
    point.local[cell_.axis[k]] = local[k];
    point.gradient[cell_.axis[k]] = gradient[static_cast<int>(k)] * cell_.scale;
  }
  point.area = area;
  points_->push_back(point);
}

}  // namespace

CellMetric::CellMetric(const glm::dmat3& a)
    : gradients(glm::inverse(glm::transpose(a) * a)),
      cellMm3(std::abs(glm::determinant(a))),
      faceMm2(std::cbrt(cellMm3) * std::cbrt(cellMm3)) {}

CellMeasure& CellMeasure::operator+=(const CellMeasure& other) {
  volume += other.volume;
  area += other.area;
  sensitivity += other.sensitivity;
  volumeError += other.volumeError;
  areaError += other.areaError;
  return *this;
}

CellMeasure measureCell(const CellCorners& corners, const CellMetric& metric,
                        std::vector<CellPoint>* points) {
  std::size_t inside = 0;
  for (const double value : corners) inside += value >= 0.0;
  CellMeasure whole;
  if (inside == 8) whole.volume = metric.cellMm3;
  if (inside == 0 || inside == 8) return whole;
  return CellSweep(corners, metric, points).measure();
}

CellMeasure measureCellPart(const CellCorners& corners, const CellMetric& metric, const glm::dvec3& low,
                            const glm::dvec3& high, std::vector<CellPoint>* points) {
  const glm::dvec3 size = high - low;
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) return {};
  CellCorners part;
  for (std::size_t i = 0; i < 8; ++i)
    part[i] = trilinear(corners, glm::mix(low, high, glm::bvec3(cornerStep(i))));
  CellMetric scaled = metric;
  for (int i = 0; i < 3; ++i)
    for (int k = 0; k < 3; ++k) scaled.gradients[i][k] /= size[i] * size[k];
  scaled.cellMm3 *= size.x * size.y * size.z;
  scaled.faceMm2 = std::cbrt(scaled.cellMm3) * std::cbrt(scaled.cellMm3);
  const std::size_t before = points ? points->size() : 0;
  const CellMeasure measure = measureCell(part, scaled, points);
  for (std::size_t i = before; points && i < points->size(); ++i) {
    (*points)[i].local = low + (*points)[i].local * size;
    (*points)[i].gradient /= size;
  }
  return measure;
}

}  // namespace isolux::volume
