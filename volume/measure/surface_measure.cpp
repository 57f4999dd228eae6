#include "volume/measure/surface_measure.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <vector>

#include <glm/common.hpp>

#include "base/number_text.h"
#include "volume/measure/box_part.h"
#include "volume/measure/surface_sums.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

// One row of blocks along x, by one thread.
class BlockRow {
 public:
  BlockRow(const Grid& grid, const MinMaxBlocks& blocks, const SurfaceQuestion& question, bool allNodes)
      : grid_(grid), blocks_(blocks), question_(question), adder_(grid, question, allNodes) {
    if (question.box) walls_.emplace(grid.geometry(), *question.box);
  }

  SurfaceSums measure(int blockY, int blockZ) {
    for (int x = 0; x < blocks_.dims().x; ++x) addBlock({x, blockY, blockZ});
    return sums_;
  }

 private:
  void addBlock(glm::ivec3 block);
  void addCell(glm::ivec3 cell, const CellCorners& corners, bool crossed);

  const Grid& grid_;
  const MinMaxBlocks& blocks_;
  const SurfaceQuestion& question_;
  CellAccumulator adder_;
  std::optional<BoxWalls> walls_;
  std::vector<CellPoint> points_;
  SurfaceSums sums_;
};

void BlockRow::addBlock(glm::ivec3 block) {
  const glm::ivec3 low = block * blocks_.blockCells(),
                   high = glm::min(low + blocks_.blockCells(), grid_.dims() - 1);
  const auto isovalue = grid_.storedIsovalue(question_.isovalue);
  const bool walk = grid_.missingCount() > 0 || question_.keeps ||
                    blocks_.active(blocks_.index(block), isovalue) ||
                    (walls_ && walls_->side(low, high) == BoxWalls::Side::cut);
  if (walk) {
    visitCells(grid_, question_.isovalue, adder_.sign(), low, high,
               [&](glm::ivec3 cell, const CellCorners& corners, int inside, int missing) {
                 if (missing > 0) sums_.meetsMissing = true;
                 if (missing == 0 && (!question_.keeps || question_.keeps(cell)))
                   addCell(cell, corners, inside < 8);
               });
    return;
  }
  if (walls_ && walls_->side(low, high) == BoxWalls::Side::outside) return;
  if (!(adder_.sign() * (grid_.value(low.x, low.y, low.z) - question_.isovalue) >= 0.0)) return;
  const glm::dvec3 cells(high - low);
  sums_.measure.volume += cells.x * cells.y * cells.z * adder_.metric().cellMm3;
}

void BlockRow::addCell(glm::ivec3 cell, const CellCorners& corners, bool crossed) {
  const BoxWalls::Side side = walls_ ? walls_->side(cell, cell + 1) : BoxWalls::Side::inside;
  if (side == BoxWalls::Side::outside) return;
  points_.clear();
  if (side == BoxWalls::Side::cut) {
    const BoxPart part = walls_->measure(cell, corners, adder_.metric(), points_);
    sums_.measure += part.measure;
    sums_.cutVolume += part.unsureVolume;
    sums_.cutArea += part.unsureArea;
  } else {
    sums_.measure += measureCell(corners, adder_.metric(), crossed ? &points_ : nullptr);
  }
  if (points_.empty()) return;
  ++sums_.cells;
  adder_.addPoints(cell, points_, sums_);
}

bool borderInside(const Grid& grid, const SurfaceQuestion& question, base::Progress& progress) {
  const glm::ivec3 dims = grid.dims();
  const double sign = question.inside == scene::Inside::above ? 1.0 : -1.0;
  std::optional<BoxWalls> walls;
  if (question.box) walls.emplace(grid.geometry(), *question.box);
  std::atomic<bool> any = false;
  for (int axis = 0; axis < 3; ++axis)
    for (const int plane : {0, dims[axis] - 1}) {
      const int u = (axis + 1) % 3, v = (axis + 2) % 3;
      parallelSteps(static_cast<std::size_t>(dims[v]), progress, {}, [&](std::size_t row) {
        glm::ivec3 p(0);
        p[axis] = plane;
        p[v] = static_cast<int>(row);
        for (p[u] = 0; p[u] < dims[u] && !any; ++p[u]) {
          if (!(sign * (grid.value(p.x, p.y, p.z) - question.isovalue) >= 0.0)) continue;
          const glm::ivec3 cell = glm::min(p, dims - 2);
          if (question.keeps && !question.keeps(cell)) continue;
          if (!walls || walls->side(p, p) == BoxWalls::Side::inside) any = true;
        }
      });
      if (any) return true;
    }
  return false;
}

}  // namespace

SurfaceMeasure measureSurface(const Grid& grid, const MinMaxBlocks& blocks, const SurfaceQuestion& question,
                              base::Progress& progress) {
  if (blocks.count() == 0 || std::isnan(question.isovalue)) return {};
  const bool allNodes = fewCells(grid, blocks, question.isovalue);
  const auto measured = [&](int y, int z) {
    return BlockRow(grid, blocks, question, allNodes).measure(y, z);
  };
  SurfaceSums sums;
  for (const SurfaceSums& row : ofBlockRows(blocks, "measuring", progress, measured)) sums += row;
  sums.meetsBorder = borderInside(grid, question, progress);
  return concluded(grid, question, sums);
}

std::string whyNoSurface(const Grid& grid) {
  const glm::ivec3 dims = grid.dims();
  if (std::min({dims.x, dims.y, dims.z}) < 2)
    return "no surface: the volume has only one voxel along an axis";
  if (grid.missingCount() == grid.geometry().voxelCount()) return "no surface: all voxels are missing";
  return "no surface; the data range is " + base::shortText(grid.minimum()) + " to " +
         base::shortText(grid.maximum());
}

}  // namespace isolux::volume
