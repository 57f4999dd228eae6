// Measures each label of a label map: its counted volume, and volume, area, extent and connected components
// of its smoothed surface.
//
// A label's surface is that of labels/label_surface.h, measured as any other (piece_measure.h).
#pragma once

#include <cstddef>
#include <vector>

#include "base/progress.h"
#include "volume/labels/label_blocks.h"
#include "volume/measure/box_part.h"
#include "volume/measure/measured.h"

namespace isolux::volume {

struct LabelMeasure {
  int label = 0;
  std::size_t voxels = 0;
  double countedMm3 = 0.0;      // voxels times the volume of one: exact
  Measured volumeMm3, areaMm2;  // of the smoothed surface
  std::size_t thinVoxels = 0;   // of the voxels: drawn as they are, too thin to smooth
  WorldBox bounds;              // of the smoothed surface, world mm
  std::size_t pieces = 0;       // connected components of the smoothed surface's inside
  bool meetsBorder = false;     // a voxel of it is the last one of an axis: it may go on beyond the volume
};

// In ascending order of label; all but 0, the background. `smoothing`: voxels, [0, kMostSmoothing]. Each
// label is computed in a box of its own. Throws Error: interrupted, memory.
std::vector<LabelMeasure> measureLabels(const LabelBlocks& blocks, double smoothing,
                                        base::Progress& progress);

}  // namespace isolux::volume
