// Marks for `isolux measure`: of a file or of the scene, measured, as JSON, text and CSV.
#pragma once

#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/marks/mark_report.h"
#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct MeasuredMarks {
  std::vector<scene::Mark> marks;
  std::vector<MarkReport> reports;
};

struct WantedMarks {
  std::vector<scene::Mark> marks;
  std::vector<std::string> notes;  // what of the file is no mark
};

// Those of the Markups file, or, where its name is empty, of the scene (a session has them). Throws
// Error{input}.
WantedMarks marksToMeasure(const std::string& file, const scene::Scene& scene);

// Throws Error{interrupted, memory}.
MeasuredMarks measuredMarks(std::vector<scene::Mark> marks,
                            const std::shared_ptr<const volume::PreparedVolume>& volume,
                            const scene::Scene& resolved, bool anyway, base::Progress& progress);

nlohmann::ordered_json marksJson(const MeasuredMarks& measured);
void printMarks(const MeasuredMarks& measured, std::ostream& out);

}  // namespace isolux::app
