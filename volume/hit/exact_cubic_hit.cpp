#include "volume/hit/exact_cubic_hit.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/cubic_weights.h"
#include "volume/hit/cross_cell.h"

namespace isolux::volume {

namespace {

using Row = std::array<double, 4>;

// Weights of the four coefficients in the blossom at (u, v, w) of the B-spline's piece on [0, 1], whose knots
// are -2, -1, 0, 1, 2, 3: de Boor's algorithm with one argument per level, on unit vectors. For arguments in
// [0, 1] every step is a convex combination.
Row blossomWeights(double u, double v, double w) {
  // F(-1,0,u), F(0,1,u), F(1,2,u) of the coefficients F(-2,-1,0), F(-1,0,1), F(0,1,2), F(1,2,3).
  const Row a{(1.0 - u) / 3.0, (2.0 + u) / 3.0, 0.0, 0.0};
  const Row b{0.0, (2.0 - u) / 3.0, (1.0 + u) / 3.0, 0.0};
  const Row c{0.0, 0.0, (3.0 - u) / 3.0, u / 3.0};
  Row result;
  for (std::size_t i = 0; i < 4; ++i) {
    const double d = ((1.0 - v) * a[i] + (1.0 + v) * b[i]) / 2.0;  // F(0,u,v)
    const double e = ((2.0 - v) * b[i] + v * c[i]) / 2.0;          // F(1,u,v)
    result[i] = (1.0 - w) * d + w * e;
  }
  return result;
}

std::array<Row, 4> blossomMatrix(double from, double to) {
  return {blossomWeights(from, from, from), blossomWeights(from, from, to), blossomWeights(from, to, to),
          blossomWeights(to, to, to)};
}

// out(.., row, ..) = sum over taps of matrix[row][tap] in(.., tap, ..) along the axis of this stride.
void applyAlong(const std::array<Row, 4>& matrix, std::size_t stride, std::array<double, 64>& values) {
  for (std::size_t i = 0; i < 64; ++i) {
    if (i / stride % 4 != 0) continue;
    const Row line{values[i], values[i + stride], values[i + 2 * stride], values[i + 3 * stride]};
    for (std::size_t row = 0; row < 4; ++row)
      values[i + row * stride] = matrix[row][0] * line[0] + matrix[row][1] * line[1] +
                                 matrix[row][2] * line[2] + matrix[row][3] * line[3];
  }
}

double evaluate(Bernstein9 b, double s) {  // de Casteljau
  for (std::size_t degree = 9; degree > 0; --degree)
    for (std::size_t i = 0; i < degree; ++i) b[i] = mix(b[i], b[i + 1], s);
  return b[0];
}

// The halves [0, 1/2] and [1/2, 1].
void halve(const Bernstein9& b, Bernstein9& front, Bernstein9& back) {
  back = b;
  for (std::size_t degree = 9; degree > 0; --degree) {
    front[9 - degree] = back[0];
    for (std::size_t i = 0; i < degree; ++i) back[i] = 0.5 * (back[i] + back[i + 1]);
  }
  front[9] = back[0];
}

// Signs along the coefficients, those within rounding left out: how often they change, and the first and
// last. A polynomial that is zero all along counts as inside; one that is all rounding has no side.
struct Signs {
  int changes = 0;
  Side first = Side::unknown, last = Side::unknown;
  bool hidden = false;  // there is a change of sign that may be rounding

  Signs(const Bernstein9& b, double rounding) {
    bool allZero = true, below = false, above = false;
    for (const double value : b) {
      allZero = allZero && value == 0.0;
      below = below || value < 0.0;
      above = above || value > 0.0;
      if (std::abs(value) <= rounding) continue;
      const Side side = value < 0.0 ? Side::outside : Side::inside;
      if (first == Side::unknown) first = side;
      if (last != Side::unknown && last != side) ++changes;
      last = side;
    }
    if (allZero) first = last = Side::inside;
    hidden = changes == 0 && ((below && above) || first == Side::unknown);
  }
};

// The changes of side along one cell's segment, front to back.
class Changes {
 public:
  // `rounding`: what the coefficients may be off by.
  Changes(Side& side, double rounding) : side_(side), rounding_(rounding) {}

  // The part [begin, begin + length] of the segment: calls found(s) for each change of side until one answers
  // that it is enough; whether one did.
  template <class Found>
  bool find(const Bernstein9& b, double begin, double length, const Found& found) {
    const Signs signs(b, rounding_);
    if (signs.hidden && !uncertain) uncertain = begin;
    if (signs.first == Side::unknown) return false;
    const bool changesHere = side_ != Side::unknown && side_ != signs.first;
    side_ = signs.first;
    if (changesHere && found(begin)) return true;
    if (signs.changes == 0) return false;
    if (signs.changes == 1 || length < kShortest) {
      const std::optional<double> s = crossing(b, signs, begin, length);
      return s && found(*s);
    }
    Bernstein9 front, back;
    halve(b, front, back);
    return find(front, begin, 0.5 * length, found) || find(back, begin + 0.5 * length, 0.5 * length, found);
  }
  std::optional<double> first(const Bernstein9& b) {
    std::optional<double> s;
    find(b, 0.0, 1.0, [&](double at) {
      s = at;
      return true;
    });
    return s;
  }

  std::optional<double> uncertain;  // the first place where rounding hides what happens

 private:
  static constexpr double kShortest = 0x1p-50;

  // One change of sign is one crossing. In a segment too short to be cut the first and last side tell.
  std::optional<double> crossing(const Bernstein9& b, const Signs& signs, double begin, double length) {
    if (signs.first == signs.last) {
      if (!uncertain) uncertain = begin;
      return std::nullopt;
    }
    side_ = signs.last;
    return begin + length * bracketedRoot([&](double s) { return evaluate(b, s); }, 0.0, 1.0, b[0], b[9],
                                          signs.first == Side::outside);
  }

  Side& side_;
  double rounding_;
};

// A cell's 64 coefficients minus the isovalue, in data units, and what is known of them all.
struct CellCoefficients {
  std::array<double, 64> c;
  double largest = 0.0;
  CellSigns signs;

  template <class T>
  CellCoefficients(const std::vector<T>& stored, const Grid& grid, double isovalue, glm::ivec3 cell) {
    const glm::ivec3 last = grid.dims() - 1;
    std::size_t i = 0;
    forEachIn(cell - 1, cell + 3, [&](glm::ivec3 beyond) {
      const glm::ivec3 at = glm::clamp(beyond, glm::ivec3(0), last);
      const double value = grid.valueOfStored(static_cast<double>(stored[grid.index(at)])) - isovalue;
      signs.add(value);
      largest = std::max(largest, std::abs(value));
      c[i++] = value;
    });
  }

  double rounding() const { return 16.0 * std::numeric_limits<double>::epsilon() * largest; }

  double valueAt(glm::dvec3 local) const {
    const CubicWeights x = cubicWeights(local.x), y = cubicWeights(local.y), z = cubicWeights(local.z);
    double sum = 0.0;
    for (std::size_t i = 0; i < 64; ++i) sum += x.w[i & 3] * y.w[i >> 2 & 3] * z.w[i >> 4] * c[i];
    return sum;
  }
};

SideChanges changesIn(const CellCoefficients& cell, glm::dvec3 from, glm::dvec3 to) {
  SideChanges result;
  const Bernstein9 b = alongStretch(cell.c, from, to);
  result.first = Signs(b, cell.rounding()).first;
  Side side = result.first;
  Changes(side, cell.rounding()).find(b, 0.0, 1.0, [&](double s) {
    result.s[result.count++] = s;
    return result.count == result.s.size();
  });
  return result;
}

// Coefficients lack their offset, and so does what they are compared with.
double levelOf(const Grid& grid, const Coefficients* coefficients, double isovalue) {
  return coefficients ? isovalue - grid.slope() * coefficients->offset : isovalue;
}

// `gaps`: cells with a missing corner hold no surface, whatever their coefficients.
template <class T>
CubicHit firstHitCubic(const std::vector<T>& stored, const Grid& grid, const MinMaxBlocks& blocks,
                       double isovalue, const Ray& ray, const ShownCells* shown, bool gaps) {
  CubicHit result;
  const auto cross = [&](const CellWalk& walk, Side& side) {
    CellCoefficients cell(stored, grid, isovalue, walk.cell());
    if (gaps && !cell.signs.missing) cell.signs.missing = grid.cellHasMissing(walk.cell());
    return crossCell(cell, walk, shown, side, [&](const CellWalk::Segment& segment) {
      Changes change(side, cell.rounding());
      const std::optional<double> s = change.first(alongStretch(cell.c, segment.from, segment.to));
      if (change.uncertain && result.certain) {
        result.certain = false;
        result.tUncertain = segment.t(*change.uncertain);
      }
      return s;
    });
  };
  result.hit = firstCrossing<RayHit>(grid, blocks, isovalue, ray, shown, cross);
  // A crossing at the end of a segment looks doubtful there, and is not where the next segment shows it.
  constexpr double samePlaceVoxels = 1e-6;
  if (!result.certain && result.hit &&
      (result.hit->t - result.tUncertain) * glm::length(ray.direction) < samePlaceVoxels)
    result.certain = true;
  return result;
}

}  // namespace

Bernstein9 alongStretch(const std::array<double, 64>& coefficients, glm::dvec3 from, glm::dvec3 to) {
  std::array<double, 64> points = coefficients;
  for (int axis = 0; axis < 3; ++axis)
    applyAlong(blossomMatrix(from[axis], to[axis]), std::size_t{1} << (2 * axis), points);
  constexpr double choose3[4] = {1, 3, 3, 1};
  constexpr double choose9[10] = {1, 9, 36, 84, 126, 126, 84, 36, 9, 1};
  Bernstein9 b{};
  for (std::size_t k = 0; k < 4; ++k)
    for (std::size_t j = 0; j < 4; ++j)
      for (std::size_t i = 0; i < 4; ++i)
        b[i + j + k] +=
            choose3[i] * choose3[j] * choose3[k] / choose9[i + j + k] * points[i + 4 * j + 16 * k];
  return b;
}

CubicHit firstHitOfField(const Grid& grid, scene::Field field, const Coefficients* coefficients,
                         const MinMaxBlocks& blocks, double isovalue, const Ray& ray,
                         const HiddenPieces& hidden) {
  if (field == scene::Field::trilinear) return {firstHit(grid, blocks, isovalue, ray, hidden)};
  const ShownCells shown(grid, hidden.voxels, isovalue, hidden.inside, field, coefficients);
  const bool gaps = coefficients && grid.missingCount() > 0;
  const double level = levelOf(grid, coefficients, isovalue);
  return visitSpline(grid, coefficients, [&](const auto& stored) {
    return firstHitCubic(stored, grid, blocks, level, ray, hidden.voxels ? &shown : nullptr, gaps);
  });
}

SideChanges sideChangesOfCell(const Grid& grid, const Coefficients* coefficients, double isovalue,
                              glm::ivec3 cell, glm::dvec3 from, glm::dvec3 to) {
  const double level = levelOf(grid, coefficients, isovalue);
  return visitSpline(grid, coefficients, [&](const auto& stored) {
    return changesIn(CellCoefficients(stored, grid, level, cell), from, to);
  });
}

}  // namespace isolux::volume
