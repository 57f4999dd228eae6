// What study.md and study.json say of the knob of the scale.
#pragma once

#include <iosfwd>

#include <nlohmann/json_fwd.hpp>

#include "app/study/study_results.h"

namespace isolux::app {

nlohmann::ordered_json scaleJson(const StudySetting& setting);
void writeScaleTable(std::ostream& out, const KnobStudy& study);

}  // namespace isolux::app
