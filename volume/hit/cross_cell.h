// What a ray does in one cell, whatever the field in it: the first change of the side that is seen.
#pragma once

#include <cmath>
#include <optional>

#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"
#include "volume/hit/shown_cells.h"

namespace isolux::volume {

// On which sides the numbers lie that bound the field in a cell.
struct CellSigns {
  bool anyBelow = false, anyAbove = false, missing = false;

  void add(double value) {
    missing = missing || std::isnan(value);
    anyBelow = anyBelow || value < 0.0;
    anyAbove = anyAbove || value >= 0.0;
  }
};

// `cell`: `signs`, and valueAt() of positions in it, less the isovalue. firstChange(segment) of the field
// answers as firstShownChange() does, from the same `side`.
template <class Cell, class FirstChange>
std::optional<RayHit> crossCell(const Cell& cell, const CellWalk& walk, const ShownCells* shown, Side& side,
                                const FirstChange& firstChange) {
  if (cell.signs.missing) {
    side = Side::unknown;
    return std::nullopt;
  }
  const bool uniform = !(cell.signs.anyBelow && cell.signs.anyAbove);
  const bool hides = shown && shown->hides(walk.cell());
  const Side whole = cell.signs.anyAbove ? Side::inside : Side::outside;
  if (uniform && side == whole && !hides) return std::nullopt;  // most cells: the ray stays on its side
  const auto segment = walk.segment();
  if (!segment) return std::nullopt;
  std::optional<double> s;
  if (hides) {
    s = firstShownChange(*shown, walk.cell(), *segment, side);
  } else if (!uniform) {
    s = firstChange(*segment);
  } else {
    if (side != Side::unknown) s = 0.0;
    side = whole;
  }
  if (!s) return std::nullopt;
  const glm::dvec3 local = segment->local(*s);
  return RayHit{segment->t(*s), glm::dvec3(walk.cell()) + local, std::abs(cell.valueAt(local)),
                side == Side::inside};
}

}  // namespace isolux::volume
