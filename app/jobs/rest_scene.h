// Hits of pictures at rest (picture.rest_hits): those of the spline through the samples, where the surface
// gains from them. Deferred images and pictures lit by stored light keep hit.field.
#pragma once

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/prepared_volume.h"

namespace isolux::app {

// The resolved scene as pictures at rest show it. Measures and makes what is not there yet: for those who may
// wait. Where the spline's field does not fit into memory, `auto` keeps the hits. Throws Error{interrupted},
// and Error{memory} of a field that was asked for by name.
scene::Scene atRest(scene::Scene resolved, const volume::PreparedVolume& volume, base::Progress& progress);

// What of it is there already: the scene as it is where nothing is.
scene::Scene atRestIfReady(scene::Scene resolved, const volume::PreparedVolume& volume);
bool restIsReady(const scene::Scene& resolved, const volume::PreparedVolume& volume);

}  // namespace isolux::app
