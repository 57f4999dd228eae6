// Walks a ray through the cells of a grid, front to back, past blocks that hold no surface: what every hit
// finder of the CPU shares.
//
// Positions are voxel coordinates; t is along the ray in units of |direction|. Nothing is accumulated: every
// t is computed from the origin, the direction and an integer plane, so that neighbouring cells agree.
#pragma once

#include <cmath>
#include <limits>
#include <optional>

#include <glm/vec3.hpp>

#include "volume/grid.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

class ShownCells;

struct Ray {
  glm::dvec3 origin{0.0}, direction{0.0};  // direction need not be unit
  double tMinimum = 0.0, tMaximum = std::numeric_limits<double>::infinity();

  bool valid() const;  // finite and not without direction
};

// Which side of the isosurface an open segment of the ray lies on; unknown before the first cell and after
// cells that hold no field.
enum class Side { unknown, outside, inside };

// a at t = 0, b at t = 1, a when a == b, all exactly: what makes neighbouring cells agree on their face.
inline double mix(double a, double b, double t) {
  return t == 1.0 ? b : a + t * (b - a);
}

class CellWalk {
 public:
  // A ray's way through one cell: `from` and `to` are in [0, 1]^3 of the cell, on its faces exactly where the
  // ray enters and leaves it.
  struct Segment {
    double tBegin, tEnd;
    glm::dvec3 from, to;
    double t(double s) const;  // s in [0, 1]
    glm::dvec3 local(double s) const { return from + s * (to - from); }
  };

  // `dims`: voxels, at least two per axis; the ray must be valid().
  CellWalk(glm::ivec3 dims, const Ray& ray);

  bool inside() const { return inside_; }  // false: the ray does not meet the voxel domain
  glm::ivec3 cell() const { return cell_; }
  double tBegin() const { return t_; }     // where the ray enters the cell
  double tEnd() const { return tEnd_; }    // of the whole ray
  std::optional<Segment> segment() const;  // nothing when the ray only touches the cell
  // Moves to the cell behind the box of cells between the planes `low` and `high`, which holds the current
  // one; false at the end of the ray.
  bool leave(glm::ivec3 low, glm::ivec3 high);
  bool next() { return leave(cell_, cell_ + 1); }

 private:
  double planeT(int axis, int plane) const;
  double coordinate(int axis, double t) const;
  bool clip(double tMinimum, double tMaximum);
  int cellAt(int axis, int low, int high) const;

  glm::ivec3 dims_;
  glm::dvec3 origin_, direction_;
  double t_ = 0.0, tEnd_ = 0.0;
  glm::ivec3 cell_{0};
  glm::dvec3 entry_{0.0};  // where the ray enters cell_, voxel coordinates
  bool inside_ = false;
};

// The side of a block that cannot be crossed, empty where its cells must be looked at. Where voxels are
// missing the ray may have come through a gap, so that nothing is known about the side before. `shown`: null
// where no piece is hidden; the side is that which is seen.
std::optional<Side> sideOfBlock(const MinMaxBlocks& blocks, glm::ivec3 block, const Grid& grid,
                                double isovalue, const ShownCells* shown);

// Calls crossCell(walk, side) -> optional<Hit> for the ray's cells, front to back, until one answers; `side`
// is that of the ray's way before the cell, and crossCell sets that behind it. Cells of blocks that cannot be
// crossed are passed over. Invalid rays and isovalues, and grids without cells, meet nothing. `shown`: as of
// sideOfBlock().
template <class Hit, class CrossCell>
std::optional<Hit> firstCrossing(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                 const Ray& ray, const ShownCells* shown, const CrossCell& crossCell) {
  if (blocks.count() == 0 || std::isnan(isovalue) || !ray.valid()) return std::nullopt;
  CellWalk walk(grid.dims(), ray);
  Side side = Side::unknown;
  for (bool more = walk.inside(); more;) {
    const glm::ivec3 block = walk.cell() / blocks.blockCells();
    if (const auto skipped = sideOfBlock(blocks, block, grid, isovalue, shown)) {
      side = *skipped;
      const glm::ivec3 low = block * blocks.blockCells();
      more = walk.leave(low, glm::min(low + blocks.blockCells(), grid.dims() - 1));
      continue;
    }
    if (std::optional<Hit> hit = crossCell(walk, side)) return hit;
    more = walk.next();
  }
  return std::nullopt;
}

// What crossing a cell does in which pieces are hidden: where on the segment another side than `side` is seen
// first, and sets `side` behind; an unknown side becomes that at the beginning.
std::optional<double> firstShownChange(const ShownCells& shown, glm::ivec3 cell,
                                       const CellWalk::Segment& segment, Side& side);

// The root of f between `low` and `high`, where f is monotone or at least changes its sign once, from
// `lowIsNegative` to its opposite: regula falsi in the Illinois form, with a bisection whenever it does not
// halve the bracket in two steps. To the last bit.
template <class Function>
double bracketedRoot(const Function& f, double low, double high, double atLow, double atHigh,
                     bool lowIsNegative) {
  double weightLow = atLow, weightHigh = atHigh;
  int side = 0;
  double reference = high - low;
  for (int step = 0; step < 200; ++step) {
    double s = low - weightLow * (high - low) / (weightHigh - weightLow);
    if (step % 3 == 2) {
      if (high - low > 0.5 * reference) s = 0.5 * (low + high);
      reference = high - low;
    }
    if (!(s > low && s < high)) s = 0.5 * (low + high);
    if (!(s > low && s < high)) break;  // neighbouring doubles
    const double value = f(s);
    if (value == 0.0) return s;
    if ((value < 0.0) == lowIsNegative) {
      low = s;
      weightLow = atLow = value;
      if (side == -1) weightHigh *= 0.5;
      side = -1;
    } else {
      high = s;
      weightHigh = atHigh = value;
      if (side == 1) weightLow *= 0.5;
      side = 1;
    }
  }
  return std::abs(atLow) < std::abs(atHigh) ? low : high;
}

}  // namespace isolux::volume
