// How far the isosurfaces that a scene shows reach: what a camera needs to frame them, and no more.
//
// Measured at the crossings of the trilinear field with the edges of the grid: the surface between them is at
// most part of a voxel farther. Pieces that pieces. hides do not count, nor surfaces of opacity 0.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {

// For each direction (world, any length) the largest dot product with a point of the surface, mm times the
// direction's length. Nothing where no surface is shown. `resolved`: scene::resolve of this volume. Throws
// Error: interrupted; memory, of pieces.
std::optional<std::vector<double>> surfaceReach(const PreparedVolume& volume, const scene::Scene& resolved,
                                                std::span<const glm::dvec3> directions,
                                                base::Progress& progress);

// A ball that holds it, mm: about the middle of its box of the world.
struct Ball {
  glm::dvec3 centreMm{0.0};
  double radiusMm = 0.0;
};
std::optional<Ball> surfaceBall(const PreparedVolume& volume, const scene::Scene& resolved,
                                base::Progress& progress);

}  // namespace isolux::volume
