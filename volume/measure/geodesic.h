// The shortest way along a trilinear isosurface between two of its points, and its length with an error.
//
// Fast marching (Kimmel & Sethian 1998) over the surface's graph finds which way; the way is then drawn tight
// on the exact surface: each point of a polyline goes to the middle of its neighbours, straight back to the
// surface, until it no longer gets shorter, at ever closer points. So it is a shortest way among those beside
// it; that fast marching chose the right valley is not proven.
#pragma once

#include <optional>
#include <vector>

#include "volume/measure/measured.h"
#include "volume/measure/surface_graph.h"
#include "volume/measure/surface_point.h"

namespace isolux::volume {

struct Geodesic {
  Measured lengthMm;
  ErrorParts parts;              // quadrature: of the polyline, by two resolutions
  std::vector<glm::dvec3> path;  // world mm, on the surface, from begin to end
};

// begin and end: points of the surface. Nothing where no way leads from one to the other. Throws
// Error{interrupted}.
std::optional<Geodesic> geodesic(const SurfaceOf& surface, const SurfaceGraph& graph, glm::dvec3 begin,
                                 glm::dvec3 end, base::Progress& progress);

}  // namespace isolux::volume
