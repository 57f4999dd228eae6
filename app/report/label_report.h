// The labels of a volume, as JSON and as a table.
#pragma once

#include <ostream>

#include <nlohmann/json_fwd.hpp>

#include "base/progress.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// {"reason", "names_from", "list": [{"label", "name", "color", "voxels"}]} by ascending label, without the
// background, 0; also labels that the file names and no voxel has. `color` is linear RGB. `voxels` is null
// where the volume stays in its file. Null for volumes that hold no labels. Throws Error{interrupted}.
nlohmann::ordered_json labelTableJson(const volume::PreparedVolume& prepared, base::Progress& progress);

// A line for each of the first 20.
void printLabelTable(const nlohmann::ordered_json& labels, std::ostream& out);

}  // namespace isolux::app
