// The tables of study.md, and words that its sentences share with them.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "app/study/study_results.h"

namespace isolux::app {

// "0.0123"; "–" for what is not finite.
std::string tableNumber(double value, int digits = 3);
// A cost with its unit: "1.2 s".
std::string costText(const QualitySetting& quality, double cost);
// An error as sentences have it: "0.031 voxels".
std::string errorText(const Panel& panel, double error);

// The tables of a quality setting: a row per value. Of a field a second one against `cubic_interpolating`.
void writeQualityTable(std::ostream& out, const QualityStudy& study);
// Which value of each quality setting of light is the cheapest to reach an error. Nothing without such
// quality settings.
void writeLightReach(std::ostream& out, const std::vector<QualityStudy>& studies);

}  // namespace isolux::app
