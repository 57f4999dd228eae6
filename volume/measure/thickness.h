// How thick the inside is at a point of the surface: straight through along the normal, and as the largest
// ball that touches the surface there from within.
#pragma once

#include <optional>

#include "volume/measure/measured.h"
#include "volume/measure/surface_graph.h"
#include "volume/measure/surface_point.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

// Where the ray against the outward normal leaves the inside.
struct ThicknessByRay {
  Measured mm;
  glm::dvec3 exit{0.0};  // world mm
};
// Nothing where it does not leave the inside within the volume.
std::optional<ThicknessByRay> thicknessByRay(const SurfaceOf& surface, const MinMaxBlocks& blocks,
                                             const SurfacePoint& point);

// A ball's surface through the point with its centre on the inward normal, as large as the surface allows but
// for ripples of the size of the point's error (Ma, Bae & Choi 2012, "3D medial axis point approximation
// using nearest neighbors and the normal field").
struct InscribedBall {
  Measured diameterMm;
  glm::dvec3 centre{0.0}, touches{0.0};  // world mm; where it meets the surface elsewhere
};
// Nothing where no surface lies on that side, or the inside goes on beyond the border there.
std::optional<InscribedBall> inscribedBall(const SurfaceOf& surface, const SurfaceGraph& graph,
                                           const SurfacePoint& point);

}  // namespace isolux::volume
