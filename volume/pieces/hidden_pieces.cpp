#include "volume/pieces/hidden_pieces.h"

#include "base/hash.h"
#include "scene/shown_surfaces.h"
#include "volume/pieces/piece_sets.h"
#include "volume/pieces/shown_pieces.h"

namespace isolux::volume {

namespace {

// A choice that hides no piece may still hide what a spline has beside all pieces.
bool hidesOf(const scene::Scene& resolved, const std::shared_ptr<const HiddenVoxels>& voxels) {
  return voxels && (voxels->any() || resolved.hit.field != scene::Field::trilinear);
}

}  // namespace

std::vector<HiddenOfSurface> hiddenOf(const scene::Scene& resolved, const PieceSets& pieces,
                                      base::Progress& progress) {
  std::vector<HiddenOfSurface> result;
  if (!hidesPieces(resolved.pieces)) return result;
  const scene::Inside inside = resolved.isosurface.inside;
  for (const auto& surface : scene::shownSurfaces(resolved))
    if (auto voxels = pieces.hidden(resolved.pieces, *surface.value, inside, progress);
        hidesOf(resolved, voxels))
      result.push_back({*surface.value, std::move(voxels), inside});
  return result;
}

std::vector<HiddenOfSurface> knownHidden(const scene::Scene& resolved, const PieceSets& pieces) {
  std::vector<HiddenOfSurface> result;
  const scene::Inside inside = resolved.isosurface.inside;
  for (const auto& surface : scene::shownSurfaces(resolved))
    if (const auto voxels = pieces.findHidden(resolved.pieces, *surface.value, inside);
        voxels && hidesOf(resolved, *voxels))
      result.push_back({*surface.value, *voxels, inside});
  return result;
}

bool hiddenIsReady(const scene::Scene& resolved, const PieceSets& pieces) {
  return !hidesPieces(resolved.pieces) || (pieces.any() && pieces.knowsBody(resolved.pieces));
}

HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, double isovalue) {
  for (const HiddenOfSurface& surface : surfaces)
    if (surface.isovalue == isovalue) return {surface.voxels.get(), surface.inside};
  return {};
}

HiddenPieces hiddenAt(std::span<const HiddenOfSurface> surfaces, const Grid& grid, float storedIsovalue) {
  for (const HiddenOfSurface& surface : surfaces)
    if (grid.storedIsovalue(surface.isovalue) == storedIsovalue)
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
