// A path traced picture as a file, for `isolux reference` and the window.
#pragma once

#include <filesystem>
#include <string>

#include "gi/reference.h"

namespace isolux::app {

// float32 EXR: R G B (linear), irradiance.R G B, variance, samples and hit (gi::ReferenceImage). Written
// beside and renamed. Throws Error{input}.
void writeReferenceExr(const gi::ReferenceImage& image, const std::filesystem::path& file,
                       const std::string& session);

}  // namespace isolux::app
