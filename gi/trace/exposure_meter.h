// How bright a surface is in its light, as an automatic exposure sees it.
//
// Measured by path tracing a few hundred points of the surface as it is seen from the front, the whole volume
// in the picture: the same whatever the view, the size of the picture and what is stored so far. So turning
// the view changes no exposure, tiles agree, and a picture that is drawn again from its session is the same.
#pragma once

#include <memory>
#include <optional>

#include "base/progress.h"
#include "gi/light_scene.h"
#include "gi/picture_light.h"

namespace isolux::gi {

// The scene as far as brightness depends on it: equal ones have equal brightness in one volume and
// environment.
scene::Scene meteredScene(const scene::Scene& resolved);

// Nothing where the front view sees no outer side of a surface. `tracer`, `environment`: as of
// makeLightScene(). About 20 ms. Throws Error{interrupted}.
std::optional<SurfaceBrightness> measureBrightness(
    const scene::Scene& resolved, const std::shared_ptr<const volume::PreparedVolume>& volume,
    std::shared_ptr<const volume::IsosurfaceTracer> tracer, std::shared_ptr<const Environment> environment,
    base::Progress& progress);

// Stops that put the median at a middle grey, or below it as far as highlights ask for.
double exposureOf(const SurfaceBrightness& seen);

}  // namespace isolux::gi
