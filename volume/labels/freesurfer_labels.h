// Names the labels of FreeSurfer's segmentations (aseg, aparc+aseg, wmparc), where FreeSurferColorLUT.txt is
// not at hand.
#pragma once

#include <vector>

#include "volume/labels/label_table.h"

namespace isolux::volume {

// Returns the subcortical structures and, of the Desikan-Killiany atlas, cortex and the white matter under it
// of both hemispheres, by ascending value; without colours.
std::vector<Label> freesurferLabels();

}  // namespace isolux::volume
