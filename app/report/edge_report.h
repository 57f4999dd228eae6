// What isolux info --edge says: how far the isosurface lies from the edge of its object.
#pragma once

#include <iosfwd>
#include <memory>

#include <nlohmann/json_fwd.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/edge/surface_edges.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct EdgeReport {
  scene::Scene scene;     // complete
  double searchMm = 0.0;  // each way
  volume::EdgeStatistics edges;
};

// Of the scene's first isosurface, at points that can be seen from somewhere.
EdgeReport measureEdges(scene::Scene scene, const std::shared_ptr<const volume::PreparedVolume>& volume,
                        base::Progress& progress);
nlohmann::ordered_json edgeJson(const EdgeReport& report);
// "half of this surface lies within 0.1 mm of an edge, 90 % within 0.4 mm, 3 % have none within 3 mm"
std::string edgeText(const EdgeReport& report);

}  // namespace isolux::app
