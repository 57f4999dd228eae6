// Measures how brightly a surface is lit, for automatic exposure.
//
// It path-traces a few hundred points of the surface that a camera sees and meters illuminance, as an
// incident light meter does: E / pi times one reflectance, whatever the surface's own colour. Dark surfaces
// therefore look dark. The result does not depend on the image size or the progress of the bake, so tiles
// agree.
#pragma once

#include <memory>
#include <optional>

#include "base/progress.h"
#include "gi/light_scene.h"
#include "gi/picture_light.h"

namespace isolux::gi {

// Returns the scene reduced to the settings that affect brightness. Equal results have equal brightness in
// one volume and environment. The points are those that `resolved.camera` sees in a square image; without an
// eye, those seen from the front with the whole volume in the image.
scene::Scene meteredScene(const scene::Scene& resolved);

// Measures the brightness at the points of meteredScene(), or from the front if the camera sees no front
// face. Returns nullopt if that shows none, either. `tracer`, `environment`: as for makeLightScene(). Takes
// about 20 ms. Throws Error{interrupted}.
std::optional<SurfaceBrightness> measureBrightness(
    const scene::Scene& resolved, const std::shared_ptr<const volume::PreparedVolume>& volume,
    std::shared_ptr<const volume::IsosurfaceTracer> tracer, std::shared_ptr<const Environment> environment,
    base::Progress& progress);

// Returns the exposure [stops] that maps the median to middle grey, or less if highlights require it.
double exposureOf(const SurfaceBrightness& seen);

}  // namespace isolux::gi
