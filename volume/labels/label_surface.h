// Makes the surface of a label by itself, in a box around it: what is measured and meshed.
//
// Beyond the volume's border lies none of a label: where it reaches the border its surface is closed there,
// half a voxel outside. So a label of a volume that is one voxel thick has a closed surface, too.
#pragma once

#include "base/progress.h"
#include "volume/labels/label_blocks.h"
#include "volume/labels/mask_field.h"

namespace isolux::volume {

struct LabelSurface {
  MaskField
      mask;  // of the label alone: 1 in the set; its grid is the box, 4 voxels larger than the label's blocks
  bool meetsBorder = false;  // a voxel of the label is the last one of an axis of the volume
};

// `smoothing`: voxels, [0, kMostSmoothing]. On all cores. Throws Error: interrupted, memory.
LabelSurface labelSurface(const Grid& grid, const LabelExtent& label, double smoothing,
                          base::Progress& progress);

}  // namespace isolux::volume
