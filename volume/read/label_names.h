// Parses files that name labels: BIDS tables (.tsv), nnU-Net's dataset.json, ITK-SNAP's label descriptions
// (.label, .txt) and colour tables of 3D Slicer (.ctbl) and FreeSurfer (FreeSurferColorLUT.txt).
//
//   BIDS         index<TAB>name<TAB>color           a line of column names; color "#RRGGBB", if any
//   nnU-Net      {"labels": {"background": 0, "liver": 1}}, or {"labels": {"0": "background"}}
//   ITK-SNAP     1  255 0 0  1 1 1  "liver"         index, RGB, opacity, two switches, name
//   colour table 1 liver 255 0 0 255                index, name, RGB, opacity
//
// Any thread. Sources: BIDS 1.9 "Segmentations"; nnU-Net documentation/dataset_format.md; the comments that
// ITK-SNAP and Slicer write into their files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "volume/labels/label_table.h"

namespace isolux::volume {

// `file` names the format by its ending and is named in errors. Throws base::Error{input} with the line.
std::vector<Label> labelNamesIn(std::string_view text, const std::string& file);

}  // namespace isolux::volume
