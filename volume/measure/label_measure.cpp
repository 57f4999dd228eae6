#include "volume/measure/label_measure.h"

#include <stop_token>

#include <glm/vec3.hpp>

#include "volume/labels/label_surface.h"
#include "volume/measure/piece_measure.h"
#include "volume/pieces/pieces.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/voxels/bounds.h"

namespace isolux::volume {

namespace {

LabelMeasure measureLabel(const Grid& grid, const LabelExtent& label, double smoothing,
                          base::Progress& progress) {
  const LabelSurface surface = labelSurface(grid, label, smoothing, progress);
  const MaskField& mask = surface.mask;
  const MinMaxBlocks blocks(*mask.grid, kBlockCells, progress);
  const SurfaceQuestion question{.isovalue = 0.0};
  const Pieces pieces(mask.grid, blocks, question.isovalue, question.inside, progress);
  const PieceMeasures measures = measurePieces(pieces, blocks, question, {}, progress);
  Bounds<glm::dvec3> bounds;
  for (const PieceMeasure& piece : measures.pieces) {
    bounds.add(piece.bounds.lowMm);
    bounds.add(piece.bounds.highMm);
  }
  return {label.label,
          label.voxels,
          static_cast<double>(label.voxels) * grid.geometry().voxelMm3(),
          measures.whole.volumeMm3,
          measures.whole.areaMm2,
          mask.thinVoxels(),
          {bounds.low, bounds.high},
          measures.pieces.size(),
          surface.meetsBorder};
}

}  // namespace

std::vector<LabelMeasure> measureLabels(const LabelBlocks& blocks, double smoothing,
                                        base::Progress& progress) {
  double all = 0.0, done = 0.0;
  for (const LabelExtent& label : blocks.list())
    all += label.label == 0 ? 0.0 : static_cast<double>(label.voxels);
  std::vector<LabelMeasure> measures;
  for (const LabelExtent& label : blocks.list()) {
    if (label.label == 0) continue;
    progress.report(done / all, "measuring labels");
    base::Progress own;  // its fractions are those of one label
    const std::stop_callback stop(progress.token(), [&own] { own.requestStop(); });
    measures.push_back(measureLabel(blocks.grid(), label, smoothing, own));
    done += static_cast<double>(label.voxels);
  }
  return measures;
}

}  // namespace isolux::volume
