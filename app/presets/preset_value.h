// Where in a volume a preset's value lies: {"hu": 300}, {"quantile": 0.99}, {"between": 0.3}.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "scene/settings/settings.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

bool isValueOfVolume(const nlohmann::ordered_json& value);
// Throws base::Error{usage} where the setting is not in data units or the value is none of the three.
void checkValueOfVolume(const scene::Setting& setting, const nlohmann::ordered_json& value);
// Data units. A quantile is of all voxels, interpolated within a bin of the histogram; Hounsfield units are
// as volume.kind tells them.
double valueInVolume(const nlohmann::ordered_json& value, const volume::PreparedVolume& volume);

}  // namespace isolux::app
