#include "app/ready/rest_scene.h"

#include <optional>

#include "base/error.h"
#include "scene/rules/needs.h"

namespace isolux::app {

namespace {

using scene::Field;
using scene::StillField;

constexpr Field kFieldAtRest = Field::cubic_interpolating;

scene::Scene withSplineHits(scene::Scene scene) {
  scene.hit.field = kFieldAtRest;
  return scene;
}

// Whether the spline's hits are wanted; nothing: it has not been measured.
std::optional<bool> wantsSpline(const scene::Scene& resolved, const volume::StillHits& hits) {
  if (!scene::mayRefineHits(resolved)) return false;
  if (resolved.picture.restHits == StillField::cubic_interpolating) return true;
  const std::optional<double> share = hits.find(resolved.surfaces.front().value.value());
  return share ? std::optional(hits.gains(*share)) : std::nullopt;
}

}  // namespace

scene::Scene atRest(scene::Scene resolved, const volume::PreparedVolume& volume, base::Progress& progress) {
  const volume::StillHits& hits = *volume.stillHits;
  if (!wantsSpline(resolved, hits)) hits.measure(resolved.surfaces.front().value.value(), progress);
  if (!*wantsSpline(resolved, hits)) return resolved;
  try {
    volume.cubicFields->make(kFieldAtRest, progress);
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::memory || resolved.picture.restHits != StillField::automatic) throw;
    hits.giveUp();
    return resolved;
  }
  return withSplineHits(std::move(resolved));
}

scene::Scene atRestIfReady(scene::Scene resolved, const volume::PreparedVolume& volume) {
  if (!wantsSpline(resolved, *volume.stillHits).value_or(false) || !volume.cubicFields->find(kFieldAtRest))
    return resolved;
  return withSplineHits(std::move(resolved));
}

bool restIsReady(const scene::Scene& resolved, const volume::PreparedVolume& volume) {
  const std::optional<bool> wanted = wantsSpline(resolved, *volume.stillHits);
  return wanted && (!*wanted || volume.cubicFields->find(kFieldAtRest));
}

}  // namespace isolux::app
