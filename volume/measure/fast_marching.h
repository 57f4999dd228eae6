// First-order geodesic distances over a surface's graph, as far as one point: which way to go.
#pragma once

#include <vector>

#include "base/progress.h"
#include "volume/measure/surface_graph.h"

namespace isolux::volume {

// Points of the graph from `end` back to `begin`, one step of the front each; empty where none leads there.
// Throws Error{interrupted}.
std::vector<glm::dvec3> marchedWay(const SurfaceGraph& graph, int begin, int end, base::Progress& progress);

}  // namespace isolux::volume
