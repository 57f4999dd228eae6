// The images of errors that --aov names beside the renderer's own (render/graph/frame.h).
#pragma once

#include <string>
#include <vector>

#include "app/accuracy/picture_errors.h"
#include "app/files/image_io.h"
#include "render/graph/frame.h"

namespace isolux::app {

// noise: of depth, by noise and sampling; depth, normal and kappa: by arithmetic.
enum class ErrorImage { depth, normal, kappa, light, noise, normalNoise, kappaNoise };
struct ErrorImageInfo {
  ErrorImage image;
  const char* name;                           // as on the command line
  std::vector<float> PictureErrors::*bounds;  // those of light are empty where none is stored
};
const std::vector<ErrorImageInfo>& errorImages();
const ErrorImageInfo& errorImage(ErrorImage image);

// What --aov asks for, in its order but for the errors, which come last.
struct WantedImages {
  std::vector<render::Aov> aovs;
  std::vector<ErrorImage> errors;
};
// Throws base::Error{usage} as render::parseAovList().
WantedImages parseImageList(const std::string& text);
std::string imageNames();  // all of them, by commas
// Returns what the renderer must draw for them: some image, and stored light where its error is wanted.
std::vector<render::Aov> drawnFor(const WantedImages& wanted);

// The channels of an .exr with these images. drawn: what the renderer made.
std::vector<FloatChannel> channelsOf(const std::vector<render::AovImage>& drawn, const WantedImages& wanted,
                                     const PictureErrors& errors);

}  // namespace isolux::app
