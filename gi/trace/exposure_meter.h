// Measures the brightness of a lit surface for automatic exposure.
//
// It path-traces a few hundred points of the surface, seen from the front with the whole volume in the image.
// The result does not depend on the view, the image size or the progress of the bake. Rotating the view
// therefore does not change the exposure, tiles agree, and an image redrawn from its session is the same.
#pragma once

#include <memory>
#include <optional>

#include "base/progress.h"
#include "gi/light_scene.h"
#include "gi/picture_light.h"

namespace isolux::gi {

// Returns the scene reduced to the settings that affect brightness. Equal results have equal brightness in
// one volume and environment.
scene::Scene meteredScene(const scene::Scene& resolved);

// Measures the brightness. Returns nullopt if the front view shows no front face. `tracer`, `environment`: as
// for makeLightScene(). Takes about 20 ms. Throws Error{interrupted}.
std::optional<SurfaceBrightness> measureBrightness(
    const scene::Scene& resolved, const std::shared_ptr<const volume::PreparedVolume>& volume,
    std::shared_ptr<const volume::IsosurfaceTracer> tracer, std::shared_ptr<const Environment> environment,
    base::Progress& progress);

// Returns the exposure [stops] that maps the median to middle grey, or less if highlights require it.
double exposureOf(const SurfaceBrightness& seen);

}  // namespace isolux::gi
