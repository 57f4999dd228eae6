#include "volume/slice/slice_contours.h"

#include <algorithm>
#include <optional>

#include "volume/hit/shown_cells.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/slice/cell_curve.h"
#include "volume/slice/join_curves.h"
#include "volume/slice/plane_lattice.h"

namespace isolux::volume {

namespace {

constexpr int kSquaresPerStep = 1024;

struct FoundPieces {
  std::vector<CurvePiece> pieces;
  base::MemoryBudget::Held held{};
};

// Of some squares of a row, with the memory that they take, of joining them, too.
FoundPieces piecesOf(const SliceField& field, const PlaneLattice& lattice, double isovalue,
                     const ShownCells* shown, glm::ivec2 first, int count) {
  FoundPieces found;
  CellCurves curves(field, lattice, isovalue);
  for (glm::ivec2 square = first; square.x < first.x + count; ++square.x) {
    const PlaneLattice::Cells cells = lattice.cellsAbove(square);
    for (int k = cells.first; k <= cells.last; ++k) curves.find(square, k, found.pieces);
  }
  if (shown)
    std::erase_if(found.pieces, [&](const CurvePiece& piece) {
      return shown->hiddenAt(lattice.voxel(piece.start)) || shown->hiddenAt(lattice.voxel(piece.end));
    });
  found.held =
      base::machineMemory().reserve(2 * found.pieces.size() * sizeof(CurvePiece),
                                    "the isocontours of a slice", "slice.contour_width=0 draws none");
  return found;
}

}  // namespace

SliceCurves sliceContours(const SliceField& field, const SlicePlane& plane, double isovalue,
                          const HiddenPieces& hidden, base::Progress& progress) {
  const PlaneLattice lattice(field.grid.geometry(), plane);
  SliceCurves result;
  if (!lattice.hasSquares()) return result;
  std::optional<ShownCells> shown;
  if (hidden.voxels)
    shown.emplace(field.grid, hidden.voxels, isovalue, hidden.inside, field.field, field.coefficients);
  const glm::ivec2 squares = lattice.squares();
  const int perRow = (squares.x + kSquaresPerStep - 1) / kSquaresPerStep;
  const auto steps = static_cast<std::size_t>(perRow) * static_cast<std::size_t>(squares.y);
  std::vector<FoundPieces> found(steps);
  parallelSteps(steps, progress, {0.0, 1.0, "finding isocontours"}, [&](std::size_t step) {
    const int begin = static_cast<int>(step % static_cast<std::size_t>(perRow)) * kSquaresPerStep;
    const int row = static_cast<int>(step / static_cast<std::size_t>(perRow));
    found[step] = piecesOf(field, lattice, isovalue, shown ? &*shown : nullptr, {begin, row},
                           std::min(kSquaresPerStep, squares.x - begin));
  });
  std::vector<CurvePiece> pieces;
  for (FoundPieces& some : found) {
    pieces.insert(pieces.end(), some.pieces.begin(), some.pieces.end());
    result.held.add(std::move(some.held));
    some.pieces = {};
  }
  progress.throwIfStopped();
  for (const JoinedCurve& joined : joinedCurves(pieces)) {
    SliceCurve& curve = result.curves.emplace_back();
    curve.closed = joined.closed;
    curve.points.reserve(joined.points.size());
    for (const glm::dvec2& point : joined.points) curve.points.push_back(lattice.voxel(point));
  }
  return result;
}

}  // namespace isolux::volume
