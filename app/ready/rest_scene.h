// Chooses the hits of idle images (picture.rest_hits): those of the interpolating spline, if the surface
// gains from them. AOVs and images lit by baked lighting keep hit.field.
#pragma once

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// Returns the resolved scene for idle images. Measures and computes what is missing; blocks until done. If
// the spline's field does not fit into memory, `auto` keeps the hits. Throws Error{interrupted}, and
// Error{memory} for a field that was requested by name.
scene::Scene atRest(scene::Scene resolved, const volume::PreparedVolume& volume, base::Progress& progress);

// As atRest(), without waiting: returns the scene unchanged if nothing is ready.
scene::Scene atRestIfReady(scene::Scene resolved, const volume::PreparedVolume& volume);
bool restIsReady(const scene::Scene& resolved, const volume::PreparedVolume& volume);

}  // namespace isolux::app
