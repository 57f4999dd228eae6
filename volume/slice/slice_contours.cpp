#include "volume/slice/slice_contours.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <unordered_set>

#include <glm/geometric.hpp>

#include "base/hash.h"
#include "volume/hit/shown_cells.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/slice/cell_curve.h"
#include "volume/slice/plane_lattice.h"

namespace isolux::volume {

namespace {

constexpr double kSamePoint = 1e-9;
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

struct CurveEdgeHash {
  std::size_t operator()(const CurveEdge& edge) const {
    base::Hasher hash;
    hash.add(edge.low.x).add(edge.low.y).add(edge.high.x).add(edge.high.y);
    return static_cast<std::size_t>(static_cast<std::uint64_t>(hash));
  }
};

void addPoint(std::vector<glm::dvec2>& points, glm::dvec2 point) {
  if (points.empty() || glm::distance(points.back(), point) > kSamePoint) points.push_back(point);
}

// Pieces of curves, each from one edge to another, as whole curves. Of each edge at most one piece begins and
// at most one ends there. Points closer than 1e-9 are one.
std::vector<SliceCurve> joinedCurves(const std::vector<CurvePiece>& pieces, const PlaneLattice& lattice) {
  std::unordered_map<CurveEdge, std::size_t, CurveEdgeHash> beginning;
  std::unordered_set<CurveEdge, CurveEdgeHash> ends;
  beginning.reserve(pieces.size());
  ends.reserve(pieces.size());
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    beginning.emplace(pieces[i].from, i);
    ends.insert(pieces[i].to);
  }
  std::vector<bool> used(pieces.size());
  std::vector<SliceCurve> curves;
  const auto follow = [&](std::size_t first) {
    std::vector<glm::dvec2> points;  // (a, b)
    bool closed = false;
    std::size_t at = first;
    while (!used[at]) {
      used[at] = true;
      addPoint(points, pieces[at].start);
      const auto next = beginning.find(pieces[at].to);
      if (next == beginning.end() || (used[next->second] && next->second != first)) {
        addPoint(points, pieces[at].end);
        break;
      }
      at = next->second;
      closed = at == first;
    }
    while (closed && points.size() > 1 && glm::distance(points.front(), points.back()) <= kSamePoint)
      points.pop_back();
    if (points.size() < 2) return;
    SliceCurve& curve = curves.emplace_back();
    curve.closed = closed;
    curve.points.reserve(points.size());
    for (const glm::dvec2& point : points) curve.points.push_back(lattice.voxel(point));
  };
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!ends.contains(pieces[i].from)) follow(i);
  for (std::size_t i = 0; i < pieces.size(); ++i)
    if (!used[i]) follow(i);
  return curves;
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
  const Extent2 steps{{(squares.x + kSquaresPerStep - 1) / kSquaresPerStep, squares.y}};
  std::vector<FoundPieces> found(steps.count());
  parallelSteps(steps.count(), progress, {0.0, 1.0, "finding isocontours"}, [&](std::size_t step) {
    const glm::ivec2 first = steps.at(step) * glm::ivec2(kSquaresPerStep, 1);
    found[step] = piecesOf(field, lattice, isovalue, shown ? &*shown : nullptr, first,
                           std::min(kSquaresPerStep, squares.x - first.x));
  });
  std::vector<CurvePiece> pieces;
  for (FoundPieces& some : found) {
    pieces.insert(pieces.end(), some.pieces.begin(), some.pieces.end());
    result.held.add(std::move(some.held));
    some.pieces = {};
  }
  progress.throwIfStopped();
  result.curves = joinedCurves(pieces, lattice);
  return result;
}

}  // namespace isolux::volume
