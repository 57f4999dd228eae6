#include "volume/pieces/piece_sets.h"

#include "scene/shown_surfaces.h"
#include "volume/pieces/shown_pieces.h"

namespace isolux::volume {

void PieceSets::expect(std::size_t isosurfaces) const {
  pieces_.keepAtLeast(2 * isosurfaces);
  hidden_.keepAtLeast(2 * isosurfaces);
}

bool PieceSets::any() const {
  return !pieces_.empty();
}

std::shared_ptr<const Pieces> PieceSets::find(double isovalue, scene::Inside inside) const {
  return pieces_.find({isovalue, inside}).value_or(nullptr);
}

std::shared_ptr<const Pieces> PieceSets::at(double isovalue, scene::Inside inside,
                                            base::Progress& progress) const {
  return pieces_.get({isovalue, inside}, [&] {
    return std::make_shared<const Pieces>(grid_, *blocks_, isovalue, inside, progress);
  });
}

std::shared_ptr<const Body> PieceSets::body(double isovalue, base::Progress& progress) const {
  return bodies_.get(isovalue, [&] { return std::make_shared<const Body>(*grid_, isovalue, progress); });
}

bool PieceSets::knowsBody(const scene::Pieces& choice) const {
  return !choice.within || bodies_.find(*choice.within);
}

std::vector<bool> PieceSets::shown(const Pieces& pieces, const scene::Pieces& choice,
                                   base::Progress& progress) const {
  const auto within = choice.within ? body(*choice.within, progress) : nullptr;
  return shownPieces(pieces, choice, within.get());
}

std::optional<std::shared_ptr<const VoxelMask>> PieceSets::findHidden(const scene::Pieces& choice,
                                                                      double isovalue,
                                                                      scene::Inside inside) const {
  if (!hidesPieces(choice)) return nullptr;
  return hidden_.find({choice, isovalue, inside});
}

std::shared_ptr<const VoxelMask> PieceSets::hidden(const scene::Pieces& choice, double isovalue,
                                                   scene::Inside inside, base::Progress& progress) const {
  if (!hidesPieces(choice)) return nullptr;
  return hidden_.get({choice, isovalue, inside}, [&] {
    const auto pieces = at(isovalue, inside, progress);
    auto voxels = std::make_shared<const VoxelMask>(
        hiddenVoxels(*pieces, shown(*pieces, choice, progress), hidesStrays(choice)));
    return voxels->any() || voxels->hidesStrays() ? voxels : nullptr;
  });
}

namespace {

// find(isovalue, inside): the voxels that are hidden, or null.
template <class Find>
std::vector<HiddenOfSurface> hiddenBy(const scene::Scene& resolved, const PieceSets& pieces,
                                      const Find& find) {
  std::vector<HiddenOfSurface> result;
  const scene::Inside inside = resolved.isosurface.inside;
  const std::vector<scene::Surface> surfaces = scene::shownSurfaces(resolved);
  pieces.expect(surfaces.size());
  for (const auto& surface : surfaces) {
    std::shared_ptr<const VoxelMask> voxels = find(*surface.value, inside);
    // A choice that hides no piece may still hide what a spline has beside all pieces.
    if (voxels && (voxels->any() || resolved.hit.field != scene::Field::trilinear))
      result.push_back({*surface.value, std::move(voxels), inside});
  }
  return result;
}

}  // namespace

std::vector<HiddenOfSurface> hiddenOf(const scene::Scene& resolved, const PieceSets& pieces,
                                      base::Progress& progress) {
  return hiddenBy(resolved, pieces, [&](double isovalue, scene::Inside inside) {
    return pieces.hidden(resolved.pieces, isovalue, inside, progress);
  });
}

std::vector<HiddenOfSurface> knownHidden(const scene::Scene& resolved, const PieceSets& pieces) {
  return hiddenBy(resolved, pieces, [&](double isovalue, scene::Inside inside) {
    return pieces.findHidden(resolved.pieces, isovalue, inside).value_or(nullptr);
  });
}

bool hiddenIsReady(const scene::Scene& resolved, const PieceSets& pieces) {
  return !hidesPieces(resolved.pieces) || (pieces.any() && pieces.knowsBody(resolved.pieces));
}

}  // namespace isolux::volume
