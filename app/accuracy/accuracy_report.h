// What `isolux render --accuracy` says of a picture: in --stats and as a line.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "app/accuracy/accuracy.h"

namespace isolux::app {

// docs/reference/outputs.md has the keys; null for what no pixel has.
nlohmann::ordered_json accuracyJson(const Accuracy& accuracy);
// "accuracy: 99 % of pixels: depth ± 1.2e-05 mm, normal ± 0.003 degrees, ..., 0.02 % of pixels are not
// certain"
std::string accuracyLine(const Accuracy& accuracy);

}  // namespace isolux::app
