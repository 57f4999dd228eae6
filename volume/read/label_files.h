// Finds out what the name of a volume's file, and files beside it, state of labels.
//
// Names that state labels: *_dseg.nii (BIDS), *.seg.nrrd (3D Slicer), and FreeSurfer's aseg, aparc and wmparc
// volumes. Files of names, the first that exists: those of the same name that end in .tsv, .label, .ctbl or
// .txt, and nnU-Net's dataset.json beside the file, or above its folder "labels..."; of FreeSurfer's volumes
// also FreeSurferColorLUT.txt beside the file or in the folder $FREESURFER_HOME, else freesurferLabels().
// Files state labels where the voxels lie between 0 and the greatest label they name. Any thread that may
// read the environment.
#pragma once

#include <filesystem>
#include <string>

#include "volume/volume.h"

namespace isolux::volume {

// Returns the clause that says so, "its name has ..."; "": the name states nothing.
std::string labelsByName(const std::filesystem::path& path);

// Completes Volume::labelTable; what the volume's own file states has precedence. What cannot be parsed
// becomes a warning.
void addLabelFiles(Volume& volume, const std::filesystem::path& path);

// Takes names and colours from that file in place of those that are there. It states labels where the voxels
// lie between 0 and the greatest label it names. Throws Error of kind input if it names none.
void nameLabels(Volume& volume, const std::filesystem::path& file);

}  // namespace isolux::volume
