// Time steps that are files of their own.
//
// The last part of Source::path may name several: names with ';' between them, and '*' in a name for any
// characters ("scan/t_*.nrrd", "scan/rest.mhd;stress.mhd"). They lie in one folder. Each is one step, in the
// order of the list; the files that one '*' stands for are in natural order ("t_2" before "t_10"). Where a
// file or folder has the whole path as its name, that one is meant.
#pragma once

#include <string>
#include <vector>

#include "scene/scene.h"

namespace isolux::volume {

// The files in order; empty: the path names no series, or none of its files is there. Any thread.
std::vector<std::string> stepFiles(const std::string& path);

// The path that names these files as steps: '*' for where the names differ if it stands for no others, else
// their list. "" if they are fewer than two, of several folders or endings, or slices (DICOM, TIFF).
std::string pathOfSteps(const std::vector<std::string>& files);

// The source without blending: of step `step`, and of its own file if the steps are files. A step that does
// not exist stays as it is, for the reader to refuse.
scene::Source sourceOfStep(scene::Source source, int step);

}  // namespace isolux::volume
