// How a first hit compares with the independent search (tests/support/trilinear_oracle.h) on fields that the
// search itself finds hard.
#pragma once

#include <optional>
#include <string>

#include "tests/support/trilinear_oracle.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {

// What is wrong with the hit; empty where it agrees, or where the field does not leave the isovalue by more
// than rounding between both answers: a surface that starts in a voxel of the isovalue, say.
std::string disagreement(const TrilinearOracle& oracle, double isovalue, const volume::Ray& ray,
                         const std::optional<volume::RayHit>& found);

std::string textOf(const volume::Ray& ray);

}  // namespace isolux::test
