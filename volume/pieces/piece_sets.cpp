#include "volume/pieces/piece_sets.h"

#include <algorithm>

#include "base/make_room.h"
#include "volume/pieces/shown_pieces.h"

namespace isolux::volume {

namespace {

template <class T>
void keep(std::vector<T>& kept, T value, std::size_t most) {
  if (kept.size() >= most) kept.erase(kept.begin());
  kept.push_back(std::move(value));
}

}  // namespace

bool PieceSets::any() const {
  const std::lock_guard lock(mutex_);
  return !pieces_.empty();
}

std::shared_ptr<const Pieces> PieceSets::find(double isovalue, scene::Inside inside) const {
  const std::lock_guard lock(mutex_);
  const auto found = std::find_if(pieces_.begin(), pieces_.end(), [&](const auto& pieces) {
    return pieces->isovalue() == isovalue && pieces->inside() == inside;
  });
  if (found == pieces_.end()) return nullptr;
  std::rotate(found, found + 1, pieces_.end());
  return pieces_.back();
}

std::shared_ptr<const Pieces> PieceSets::at(double isovalue, scene::Inside inside,
                                            base::Progress& progress) const {
  if (auto found = find(isovalue, inside)) return found;
  auto pieces = base::madeWithRoom(
      [&] { return std::make_shared<const Pieces>(grid_, *blocks_, isovalue, inside, progress); },
      [this] { return forgetOldest(); });
  const std::lock_guard lock(mutex_);
  keep(pieces_, std::shared_ptr<const Pieces>(pieces), kMostKept);
  return pieces;
}

bool PieceSets::forgetOldest() const {
  const std::lock_guard lock(mutex_);
  if (pieces_.empty()) return false;
  pieces_.erase(pieces_.begin());
  return true;
}

std::shared_ptr<const Body> PieceSets::body(double isovalue, base::Progress& progress) const {
  {
    const std::lock_guard lock(mutex_);
    for (const auto& body : bodies_)
      if (body->isovalue() == isovalue) return body;
  }
  auto body = std::make_shared<const Body>(*grid_, isovalue, progress);
  const std::lock_guard lock(mutex_);
  keep(bodies_, std::shared_ptr<const Body>(body), kMostBodies);
  return body;
}

bool PieceSets::knowsBody(const scene::Pieces& choice) const {
  if (!choice.within) return true;
  const std::lock_guard lock(mutex_);
  return std::any_of(bodies_.begin(), bodies_.end(),
                     [&](const auto& body) { return body->isovalue() == *choice.within; });
}

std::vector<bool> PieceSets::shown(const Pieces& pieces, const scene::Pieces& choice,
                                   base::Progress& progress) const {
  const auto within = choice.within ? body(*choice.within, progress) : nullptr;
  return shownPieces(pieces, choice, within.get());
}

std::optional<std::shared_ptr<const HiddenVoxels>> PieceSets::findHidden(const scene::Pieces& choice,
                                                                         double isovalue,
                                                                         scene::Inside inside) const {
  if (!hidesPieces(choice)) return nullptr;
  const std::lock_guard lock(mutex_);
  for (const Hidden& kept : hidden_)
    if (kept.choice == choice && kept.isovalue == isovalue && kept.inside == inside) return kept.voxels;
  return std::nullopt;
}

std::shared_ptr<const HiddenVoxels> PieceSets::hidden(const scene::Pieces& choice, double isovalue,
                                                      scene::Inside inside, base::Progress& progress) const {
  if (const auto found = findHidden(choice, isovalue, inside)) return *found;
  const auto pieces = at(isovalue, inside, progress);
  auto voxels = std::make_shared<const HiddenVoxels>(
      hiddenVoxels(*pieces, shown(*pieces, choice, progress), hidesStrays(choice)));
  if (!voxels->any() && !voxels->hidesStrays()) voxels = nullptr;
  const std::lock_guard lock(mutex_);
  keep(hidden_, {choice, isovalue, inside, voxels}, kMostKept);
  return voxels;
}

namespace {

std::vector<double> isovaluesThere(const scene::Scene& resolved) {
  std::vector<double> values{resolved.isosurface.value.value()};
  for (const scene::ExtraIsosurface& extra : resolved.extraIsosurfaces)
    if (extra.shown) values.push_back(extra.value.value());
  return values;
}

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
  for (const double isovalue : isovaluesThere(resolved))
    if (auto voxels = pieces.hidden(resolved.pieces, isovalue, inside, progress); hidesOf(resolved, voxels))
      result.push_back({isovalue, std::move(voxels), inside});
  return result;
}

std::vector<HiddenOfSurface> knownHidden(const scene::Scene& resolved, const PieceSets& pieces) {
  std::vector<HiddenOfSurface> result;
  const scene::Inside inside = resolved.isosurface.inside;
  for (const double isovalue : isovaluesThere(resolved))
    if (const auto voxels = pieces.findHidden(resolved.pieces, isovalue, inside);
        voxels && hidesOf(resolved, *voxels))
      result.push_back({isovalue, *voxels, inside});
  return result;
}

bool hiddenIsReady(const scene::Scene& resolved, const PieceSets& pieces) {
  return !hidesPieces(resolved.pieces) || (pieces.any() && pieces.knowsBody(resolved.pieces));
}

}  // namespace isolux::volume
