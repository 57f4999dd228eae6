// What of an isosurface is hidden, as those are told who find its points or trace its light.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/pieces/hidden_voxels.h"

namespace isolux::volume {

class Grid;
class PieceSets;

struct HiddenPieces {
  const HiddenVoxels* voxels = nullptr;  // null: all is shown
  scene::Inside inside = scene::Inside::above;
};

// The same of one of several isosurfaces, kept.
struct HiddenOfSurface {
  double isovalue = 0.0;  // data units
  std::shared_ptr<const HiddenVoxels> voxels;
  scene::Inside inside = scene::Inside::above;
};
// Of each isosurface of the scene that has something hidden; makes what is not there yet. Throws Error:
// interrupted; memory.
std::vector<HiddenOfSurface> hiddenOf(const scene::Scene& resolved, const PieceSets& pieces,
                                      base::Progress& progress);
// The same of what is known already: nobody waits.
std::vector<HiddenOfSurface> knownHidden(const scene::Scene& resolved, const PieceSets& pieces);
// Whether making takes no longer than a step of the isovalue.
bool hiddenIsReady(const scene::Scene& resolved, const PieceSets& pieces);

HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, double isovalue);
// The same by the stored isovalue that rays compare with.
HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, const Grid& grid, float storedIsovalue);
// Equal where the same is hidden; 0 where nothing is.
std::uint64_t keyOf(std::span<const HiddenOfSurface> surfaces);

}  // namespace isolux::volume
