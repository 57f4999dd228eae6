// Words and tables of study.md that all knobs share.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

#include "app/study/study_results.h"

namespace isolux::app {

// "0.0123"; "–" for what is not finite.
std::string tableNumber(double value, int digits = 3);
// "22.8 (21.9–24)": median and quartiles.
std::string tableTime(const TimeSpread& spread);
// The value, marked where it is the default.
std::string markedValue(const StudySetting& setting);
// A cost with its unit: "1.2 s".
std::string costText(const Knob& knob, double cost);
// An error as sentences have it: "0.031 voxels".
std::string errorText(const Panel& panel, double error);

struct TableColumn {
  std::string head;
  std::function<std::string(const StudySetting&)> cell;
};
// "processor, ms": the processor's own time of a frame; no column where none was measured.
std::vector<TableColumn> processorColumn(const KnobStudy& study);
// A row per setting, its value first.
void writeTable(std::ostream& out, const KnobStudy& study, const std::vector<TableColumn>& columns);
// FLIP and root mean square of the whole picture, in steps of 255; their heads say against what. None where
// all rows have the same picture.
std::vector<TableColumn> pictureColumns(const KnobStudy& study);

}  // namespace isolux::app
