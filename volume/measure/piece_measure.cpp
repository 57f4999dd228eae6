#include "volume/measure/piece_measure.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include <glm/common.hpp>

#include "volume/measure/surface_sums.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr int kParts = 4;  // along each axis, of a cell that holds several pieces

struct PieceSums {
  SurfaceSums sums;
  Bounds<glm::dvec3> worldMm;
};

using SumsOfPieces = std::unordered_map<std::uint32_t, PieceSums>;

// One row of blocks along x, by one thread.
class PieceRow {
 public:
  PieceRow(const Pieces& pieces, const MinMaxBlocks& blocks, const SurfaceQuestion& question, bool allNodes)
      : pieces_(pieces),
        grid_(pieces.grid()),
        blocks_(blocks),
        question_(question),
        adder_(pieces.grid(), question, allNodes),
        partAdder_(pieces.grid(), question, false) {}

  SumsOfPieces measure(int blockY, int blockZ) {
    for (int x = 0; x < blocks_.dims().x; ++x) addBlock({x, blockY, blockZ});
    return std::move(found_);
  }

 private:
  void addBlock(glm::ivec3 block);
  void addCell(glm::ivec3 cell, const CellCorners& corners, int inside, int missing);
  void addCorners(glm::ivec3 cell, const CellCorners& corners, bool meetsMissing);
  void addParts(glm::ivec3 cell, const CellCorners& corners);
  void addInside(glm::ivec3 voxel, PieceSums& piece);
  glm::dvec3 world(glm::dvec3 voxel) const { return grid_.geometry().worldOf(voxel); }

  const Pieces& pieces_;
  const Grid& grid_;
  const MinMaxBlocks& blocks_;
  const SurfaceQuestion& question_;
  CellAccumulator adder_;
  CellAccumulator partAdder_;  // of parts of cells, which have many nodes
  std::vector<CellPoint> points_;
  SumsOfPieces found_;
};

void PieceRow::addBlock(glm::ivec3 block) {
  const glm::ivec3 low = block * blocks_.blockCells(),
                   high = glm::min(low + blocks_.blockCells(), grid_.dims() - 1);
  const auto isovalue = grid_.storedIsovalue(question_.isovalue);
  if (grid_.missingCount() > 0 || blocks_.active(blocks_.index(block), isovalue)) {
    visitCells(grid_, question_.isovalue, adder_.sign(), low, high,
               [&](glm::ivec3 cell, const CellCorners& corners, int inside, int missing) {
                 addCell(cell, corners, inside, missing);
               });
    return;
  }
  const std::uint32_t id = pieces_.ofVoxel(low);
  if (id == Pieces::kNone) return;
  PieceSums& piece = found_[id];
  const glm::dvec3 cells(high - low);
  piece.sums.measure.volume += cells.x * cells.y * cells.z * adder_.metric().cellMm3;
  for (std::size_t i = 0; i < 8; ++i) addInside(low + cornerStep(i) * (high - low), piece);
}

// Voxels inside lie within the piece, and where they are the volume's last ones it goes on beyond.
void PieceRow::addInside(glm::ivec3 voxel, PieceSums& piece) {
  piece.worldMm.add(world(voxel));
  for (int axis = 0; axis < 3; ++axis)
    if (voxel[axis] == 0 || voxel[axis] == grid_.dims()[axis] - 1) piece.sums.meetsBorder = true;
}

// The extent of the pieces in a crossed cell: inside corners, and where edges are crossed.
void PieceRow::addCorners(glm::ivec3 cell, const CellCorners& corners, bool meetsMissing) {
  for (std::size_t i = 0; i < 8; ++i) {
    if (!(corners[i] >= 0.0)) continue;
    const glm::ivec3 voxel = cell + cornerStep(i);
    const std::uint32_t id = pieces_.ofVoxel(voxel);
    if (id == Pieces::kNone) continue;
    PieceSums& piece = found_[id];
    addInside(voxel, piece);
    piece.sums.meetsMissing = piece.sums.meetsMissing || meetsMissing;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t other = i ^ std::size_t{1} << axis;
      if (!(corners[other] < 0.0)) continue;
      const glm::dvec3 from(voxel), to(cell + cornerStep(other));
      piece.worldMm.add(world(from + (to - from) * (corners[i] / (corners[i] - corners[other]))));
    }
  }
}

void PieceRow::addCell(glm::ivec3 cell, const CellCorners& corners, int inside, int missing) {
  if (inside < 8) addCorners(cell, corners, missing > 0);
  if (missing > 0) return;
  std::uint32_t one = Pieces::kNone;
  bool several = false;
  for (std::size_t i = 0; i < 8; ++i) {
    if (!(corners[i] >= 0.0)) continue;
    const std::uint32_t id = pieces_.ofVoxel(cell + cornerStep(i));
    several = several || (one != Pieces::kNone && id != Pieces::kNone && id != one);
    if (one == Pieces::kNone) one = id;
  }
  if (several) {
    addParts(cell, corners);
    return;
  }
  PieceSums& piece = found_[one];
  if (inside == 8)
    for (std::size_t i = 0; i < 8; i += 7) addInside(cell + cornerStep(i), piece);
  points_.clear();
  piece.sums.measure += measureCell(corners, adder_.metric(), inside < 8 ? &points_ : nullptr);
  if (points_.empty()) return;
  ++piece.sums.cells;
  adder_.addPoints(cell, points_, piece.sums);
}

void PieceRow::addParts(glm::ivec3 cell, const CellCorners& corners) {
  for (int part = 0; part < kParts * kParts * kParts; ++part) {
    const glm::dvec3 low = glm::dvec3(part % kParts, part / kParts % kParts, part / (kParts * kParts)) /
                           static_cast<double>(kParts);
    points_.clear();
    const CellMeasure measure = measureCellPart(corners, adder_.metric(), low, low + 1.0 / kParts, &points_);
    if (!(measure.volume > 0.0 || measure.area > 0.0)) continue;
    std::uint32_t one = Pieces::kNone;
    bool several = false;
    for (std::size_t i = 0; i < 8; ++i) {
      const glm::dvec3 local = low + glm::dvec3(cornerStep(i)) / static_cast<double>(kParts);
      if (!(trilinear(corners, local) >= 0.0)) continue;
      const std::uint32_t id = pieces_.ofPoint(glm::dvec3(cell) + local);
      several = several || (one != Pieces::kNone && id != Pieces::kNone && id != one);
      if (one == Pieces::kNone) one = id;
    }
    SurfaceSums& sums = found_[one].sums;
    sums.measure += measure;
    if (several) {
      sums.cutVolume += measure.volume;
      sums.cutArea += measure.area;
    }
    if (points_.empty()) continue;
    ++sums.cells;
    partAdder_.addPoints(cell, points_, sums);
  }
}

}  // namespace

PieceMeasures measurePieces(const Pieces& pieces, const MinMaxBlocks& blocks, const SurfaceQuestion& question,
                            const std::vector<bool>& shown, base::Progress& progress) {
  PieceMeasures result;
  if (blocks.count() == 0 || std::isnan(question.isovalue)) return result;
  const Grid& grid = pieces.grid();
  const bool allNodes = fewCells(grid, blocks, question.isovalue);
  const auto measured = [&](int y, int z) {
    return PieceRow(pieces, blocks, question, allNodes).measure(y, z);
  };
  std::vector<PieceSums> sums(pieces.list().size() + 1);  // the last: of voxels that float levels put outside
  for (const SumsOfPieces& row : ofBlockRows(blocks, "measuring pieces", progress, measured))
    for (const auto& [id, found] : row) {
      PieceSums& piece = sums[std::min<std::size_t>(id, sums.size() - 1)];
      piece.sums += found.sums;
      piece.worldMm.add(found.worldMm);
    }
  SurfaceSums whole;
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (shown.empty() || (i < shown.size() && shown[i])) whole += sums[i].sums;
  result.whole = concluded(grid, question, whole);
  for (std::size_t i = 0; i < pieces.list().size(); ++i)
    result.pieces.push_back(
        {concluded(grid, question, sums[i].sums), {sums[i].worldMm.low, sums[i].worldMm.high}});
  return result;
}

}  // namespace isolux::volume
