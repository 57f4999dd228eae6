// The knobs of light in study.json and study.md.
#pragma once

#include <iosfwd>
#include <vector>

#include <glm/vec2.hpp>
#include <nlohmann/json_fwd.hpp>

#include "app/study/study_results.h"

namespace isolux::app {

nlohmann::ordered_json lightCostJson(const LightCost& cost);
// `size` of the picture, for the place of the largest error.
nlohmann::ordered_json lightErrorsJson(const LightErrors& errors, glm::ivec2 size);
// What was compared with what, then a row per value.
void writeLightTable(std::ostream& out, const KnobStudy& study);
// Which value of each knob of light is the cheapest to reach an error. Nothing without such knobs.
void writeLightReach(std::ostream& out, const std::vector<KnobStudy>& studies);
// [25 %, 75 %]; null without times.
nlohmann::ordered_json quartilesJson(const std::vector<double>& times);

}  // namespace isolux::app
