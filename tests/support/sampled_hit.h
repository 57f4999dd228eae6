// First hit by sampling the trilinear field along the ray, Hadwiger et al. 2005 sec. 3.2 and 3.3, in double
// precision: what the GL pass of that name does, for measuring what sampling misses.
#pragma once

#include <optional>

#include "volume/grid.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct SampledOptions {
  double rate = 2.0;           // r0, samples per voxel of distance along the ray, > 0
  double nearFactor = 8.0;     // n: r1 = n r0 after a sample near the isovalue, >= 1
  double nearThreshold = 0.0;  // delta, data units: nearer than this is near; 0: always r0
  int refinements = 4;         // regula falsi steps, eq. (1)
};

// Samples start where the ray enters the first active block, leave out what is in others, and end with the
// ray. A hit is a change of (f >= isovalue) between two samples with no missing
// voxel between them, refined; a surface crossed twice between two
// samples is missed. Otherwise as firstHit().
std::optional<RayHit> firstHitSampled(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                      const Ray& ray, const SampledOptions& options);

}  // namespace isolux::volume
