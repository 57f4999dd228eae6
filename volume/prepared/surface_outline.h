// Points that say how far the isosurfaces of a scene reach in every direction, and samples of what they look
// like: enough to frame them from anywhere, and to choose from where.
#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

struct OutlineSample {
  glm::dvec3 positionMm{0.0}, normal{0.0};  // world; the normal is unit, outward
};

struct SurfaceOutline {
  std::vector<glm::dvec3> pointsMm;    // the surface lies within their hull, or out of it by 1 % of its size
  std::vector<OutlineSample> samples;  // some ten thousand, evenly over it; only where asked for
};

// Measures what surfaceReach() does, without specks: groups of blocks that are less than a hundredth of all.
// Empty where no surface is shown, or voxels stay in their file. The same for the same volume, always.
// `resolved`: scene::resolve of this volume. Throws Error: interrupted; memory, of pieces.
SurfaceOutline surfaceOutline(const PreparedVolume& volume, const scene::Scene& resolved, bool withSamples,
                              base::Progress& progress);

}  // namespace isolux::volume
