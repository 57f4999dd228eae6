// What rays see of an isosurface of which some pieces are hidden, cell by cell: inside is what is inside and
// of no hidden piece.
//
// In cells whose inside corners are all hidden there is no surface. In those that have both kinds, a segment
// of a ray that lies inside belongs to the piece of the corner above it (cornerAbove()). Cubic fields have no
// pieces of their own: there the same ascent among the cell's samples decides, and where it ends outside, the
// nearest inside sample of the 4^3 around the cell. Where there is none the spline overshoots: a stray
// surface, of no piece (VoxelMask::hidesStrays()).
//
// Double precision and one ray at a time, for every executor on the processor: few cells have hidden corners
// and may be crossed.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include <glm/vec3.hpp>

#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"
#include "volume/hit/bernstein_cubic.h"
#include "volume/hit/cell_pieces.h"
#include "volume/visible/inside_level.h"
#include "volume/visible/voxel_mask.h"

namespace isolux::volume {

// A ray's way through one cell: where along it, s in [0, 1], the side changes that is seen. The first part
// begins at 0; `inside`: of a shown piece.
class VisibilityIntervals {
 public:
  struct Part {
    double begin;
    bool inside;
  };
  void add(double begin, bool inside) {  // where it is another side
    if (count_ < parts_.size() && (count_ == 0 || parts_[count_ - 1].inside != inside))
      parts_[count_++] = {begin, inside};
  }
  std::span<const Part> parts() const { return {parts_.data(), count_}; }
  // The first part on another side; null where the ray stays on its side.
  const Part* firstOther(bool inside) const;

 private:
  std::array<Part, 12> parts_{};
  std::size_t count_ = 0;
};

// A cell from its corners' depths (>= 0 inside, linear in the values), of which a bit each says whether they
// are hidden.
class ShownCell {
 public:
  ShownCell(const CellCorners& depths, unsigned hidden) : depths_(depths), hidden_(hidden) {}

  const CellCorners& depths() const { return depths_; }
  // Of the piece at `local`, which lies inside.
  bool hiddenAt(const glm::dvec3& local) const { return (hidden_ >> cornerAbove(depths_, local) & 1) != 0; }
  // Of the trilinear field between `from` and `to`, both in [0, 1]^3.
  VisibilityIntervals along(const glm::dvec3& from, const glm::dvec3& to) const;

 private:
  CellCorners depths_;
  unsigned hidden_;
};

// The cells of a volume for one isovalue.
class ShownCells {
 public:
  // hidden: null where all pieces are shown. isovalue: data units. coefficients: of cubic_interpolating. All
  // must outlive this.
  ShownCells(const Grid& grid, const VoxelMask* hidden, double isovalue, scene::Inside inside,
             scene::Field field = scene::Field::trilinear, const Coefficients* coefficients = nullptr);

  scene::Inside inside() const { return inside_; }
  // Whether what is seen in the cell is not the field: one of its corners is hidden (cubic: of the samples
  // that it looks up, or where strays are hidden, none of them is inside).
  bool hides(glm::ivec3 cell) const;
  // Of the 8^3 cells from `first` on of a cubic field, those that hide or lie beside one that does: what is
  // seen may change within them or at their faces, where the field does not. Bit x + 8 y of word z.
  std::array<std::uint64_t, 8> aroundHidden(glm::ivec3 first) const;
  // Of a cell without missing corners.
  VisibilityIntervals along(glm::ivec3 cell, const glm::dvec3& from, const glm::dvec3& to) const;
  // Whether a surface point belongs to a hidden piece.
  bool hiddenAt(const glm::dvec3& voxel) const;
  bool voxelHidden(glm::ivec3 voxel) const { return hidden_ && hidden_->at(voxel); }

 private:
  ShownCell cellAt(glm::ivec3 cell) const;
  bool hiddenNear(glm::ivec3 cell, const glm::dvec3& local) const;
  bool insideAny(glm::ivec3 low, glm::ivec3 high) const;
  VisibilityIntervals alongCubic(glm::ivec3 cell, const glm::dvec3& from, const glm::dvec3& to) const;

  const Grid& grid_;
  const VoxelMask* hidden_;
  double isovalue_;  // data units
  scene::Inside inside_;
  InsideLevel level_;
  scene::Field field_;
  const Coefficients* coefficients_;
};

}  // namespace isolux::volume
