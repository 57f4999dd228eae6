#include "volume/visible/hidden_pieces.h"

#include "base/hash.h"
#include "volume/grid.h"

namespace isolux::volume {

HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, double isovalue) {
  for (const HiddenOfSurface& surface : surfaces)
    if (surface.isovalue == isovalue) return {surface.voxels.get(), surface.inside};
  return {};
}

HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, const Grid& grid, float storedIsovalue) {
  for (const HiddenOfSurface& surface : surfaces)
    if (static_cast<float>(grid.storedOfValue(surface.isovalue)) == storedIsovalue)
      return {surface.voxels.get(), surface.inside};
  return {};
}

std::uint64_t keyOf(std::span<const HiddenOfSurface> surfaces) {
  if (surfaces.empty()) return 0;
  base::Hasher hash;
  for (const HiddenOfSurface& surface : surfaces) {
    hash.add(surface.isovalue);
    hash.add(surface.inside);
    hash.add(surface.voxels->key());
    hash.add(surface.voxels->hidesStrays());
  }
  return hash;
}

}  // namespace isolux::volume
