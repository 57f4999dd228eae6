// What isolux measure says of points: distances, angles, circles, thicknesses, as JSON with errors.
#pragma once

#include <optional>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "base/progress.h"
#include "volume/measure/surface_graph.h"
#include "volume/measure/surface_point.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// The volume, the isosurface, and the way-finding graph once somebody asks for it.
struct MeasuredSurface {
  std::string file;
  const volume::PreparedVolume& prepared;
  volume::SurfaceOf surface;
  std::optional<volume::SurfaceGraph> graph = std::nullopt;

  const volume::SurfaceGraph& graphOnce(base::Progress& progress);
};

// `text`: points as parsePoints() reads them. Throw Error{usage} where points cannot be measured,
// Error{input} where a thickness is asked for beside the surface, Error{interrupted}.
nlohmann::ordered_json distanceJson(MeasuredSurface& measured, const std::string& text,
                                    base::Progress& progress);
nlohmann::ordered_json angleJson(const MeasuredSurface& measured, const std::string& text);
nlohmann::ordered_json circleJson(const MeasuredSurface& measured, const std::string& text);
nlohmann::ordered_json thicknessJson(MeasuredSurface& measured, const std::string& text,
                                     base::Progress& progress);

}  // namespace isolux::app
