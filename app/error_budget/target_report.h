// Reports a choice of settings as text and JSON (app/error_budget/target_search.h).
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/error_budget/target_search.h"

namespace isolux::app {

// docs/reference/outputs.md has the keys.
nlohmann::ordered_json targetJson(const TargetAnswer& answer);
// "chosen because ...", then a line for each combination that was measured.
std::vector<std::string> targetLines(const TargetAnswer& answer);

}  // namespace isolux::app
