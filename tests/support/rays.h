// Rays of every kind that an intersector must stand up to, deterministic by a counter.
#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "volume/hit/cell_walk.h"

namespace isolux::test {

// Three numbers in [0, 1) of a stream of random numbers.
glm::dvec3 randomVector(std::uint64_t i, std::uint64_t stream);

// Evenly in the box between two corners.
glm::dvec3 randomPoint(std::uint64_t i, glm::dvec3 low, glm::dvec3 high);

// By i % 8: through the box from outside (0, 1), from inside it in any direction (2), along an axis off (3)
// and on (4) the planes of voxels, from one corner of cells to another (5), diagonal through corners of cells
// (6), in a plane of voxels (7). Voxel coordinates.
volume::Ray randomRay(std::uint64_t i, glm::ivec3 dims);

// A tangent of a surface through `point` with this normal, off by up to 1e-2 .. 1e-7 voxels, from 60 voxels
// away.
volume::Ray grazingRay(std::uint64_t i, glm::dvec3 point, glm::dvec3 normal);

}  // namespace isolux::test
