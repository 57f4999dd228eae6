// Pieces of isosurfaces hidden and shown by hand: what a gesture makes of the scene's choice. Pure functions.
//
// World points, mm, name the pieces that hold them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "app/view_math/surface_pick.h"
#include "scene/scene.h"
#include "volume/pieces/pieces.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// The point that names the piece under a pick (volume::seedAbove). Looks at few voxels and needs no pieces.
// Nothing where the picked point has no inside voxel beside it.
std::optional<glm::dvec3> seedOfPick(const volume::PreparedVolume& volume, const Pick& pick,
                                     scene::Inside inside);

// The others stay as they are.
scene::Pieces withHidden(scene::Pieces choice, const std::vector<glm::dvec3>& seedsMm);
// No condition hides piece `id` any more but its size: points that name it leave the hidden ones, and where
// only some pieces are shown, it is one of them. `seedMm` lies in it.
scene::Pieces withShown(scene::Pieces choice, const volume::Pieces& pieces, std::uint32_t id,
                        const glm::dvec3& seedMm);
// Whatever else was chosen before.
scene::Pieces onlyThese(const std::vector<glm::dvec3>& seedsMm);
scene::Pieces onlyLargest(int count);

}  // namespace isolux::app
