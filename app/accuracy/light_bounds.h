// Bounds of the light that pixels show where it is stored: how far E may be from path tracing at the pixel's
// own point. Found from the picture itself: where it changes when half of the texels are left out, and from
// paths traced at some pixels, which say by how much to multiply that (docs/explanation/accuracy.md has the
// derivation).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "app/accuracy/picture_errors.h"
#include "render/renderer.h"

namespace isolux::app {

inline constexpr double kLightLevel = 0.95;       // of the pixels that have a bound are within it
inline constexpr double kLightConfidence = 0.99;  // of pictures for which that is so
inline constexpr std::size_t kTracedPixels = 512;

// Sets errors.light, .lightWithin and .meanIrradiance of a picture with stored light, which the renderer has
// and has again afterwards; nothing where there is none, and where a surface is transparent. Throws as
// render::drawStill(); Error{memory} for copies of the light.
void boundLight(render::Renderer& renderer, const ShownPicture& picture, PictureErrors& errors,
                base::Progress& progress);

// The least of `scores`, of pixels drawn at random, that at least kLightLevel of all pixels do not exceed in
// kLightConfidence of such draws, whatever their distribution (Wilks 1941); `all`: these are all that there
// are. Infinite where there are too few to tell.
double toleranceLimit(std::span<double> scores, bool all);

// Root mean squares of `squares`, NaN where there is nothing, over those about a pixel: means over `near`
// pixels to either side in x and y, three times (deviation about `near`); rows of `width`. Nowhere less than
// a fifth of the whole picture's.
std::vector<float> smoothedRoots(std::span<const float> squares, std::size_t width, int near);

}  // namespace isolux::app
