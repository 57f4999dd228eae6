// An isosurface as points that stand for the area about them: one in each cell, or for each piece in it.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "volume/measure/cell_measure.h"
#include "volume/pieces/pieces.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct SurfacePatch {
  glm::dvec3 voxel{0.0};  // on the trilinear surface
  double areaMm2 = 0.0;
  std::uint32_t piece = Pieces::kNone;
};

// Of the blocks with these y and z, in the order of their cells. For one thread at a time.
class PatchFinder {
 public:
  PatchFinder(const Pieces& pieces, const MinMaxBlocks& blocks);
  void appendRow(int blockY, int blockZ, std::vector<SurfacePatch>& patches);

 private:
  void appendCell(glm::ivec3 cell, const CellCorners& corners, std::vector<SurfacePatch>& patches);

  const Pieces& pieces_;
  const MinMaxBlocks& blocks_;
  CellMetric metric_;
  double sign_;
  std::vector<CellPoint> points_;
  std::vector<std::uint32_t> pieceOfPoint_;
};

}  // namespace isolux::volume
