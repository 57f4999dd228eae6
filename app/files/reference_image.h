// A path traced picture as a file, for `isolux reference` and the window.
#pragma once

#include <filesystem>
#include <string>

#include "gi/reference/reference.h"
#include "render/graph/frame.h"

namespace isolux::app {

// float32 EXR: R G B (linear), irradiance.R G B, variance, samples and hit (gi::ReferenceImage). Written
// beside and renamed. Throws Error{input}.
void writeReferenceExr(const gi::ReferenceImage& image, const std::filesystem::path& file,
                       const std::string& session);

// As a screen shows it: sRGB, through the tone curve, before the look's background where nothing else is.
render::ColorImage screenImage(const gi::ReferenceImage& image, const scene::Scene& scene);

}  // namespace isolux::app
