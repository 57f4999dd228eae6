// Pictures and deferred images to files, written beside and renamed when complete (png_file.h, exr_file.h).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/graph/frame.h"

namespace isolux::app {

// The name of the text that holds the session, in PNG (a tEXt chunk) and EXR (an attribute).
constexpr const char* sessionKey = "isolux_session";
constexpr int kLargestPicture = 16384;  // pixels of an axis, to be drawn

// 8-bit sRGB PNG (with alpha where the picture is transparent) with the session text in a text chunk
// ("isolux_session"); empty text: none.
void writePng(const render::ColorImage& image, const std::filesystem::path& file, const std::string& session);
// The same file as bytes, for a pipe.
std::string pngBytes(const render::ColorImage& image, const std::string& session);
// float32 EXR: channels R G B (linear, as they are), and A where it is transparent, of `color` unless null,
// and each AOV as "name" or
// "name.channel".
void writeExr(const render::LinearImage* color, const std::vector<render::AovImage>& aovs,
              const std::filesystem::path& file, const std::string& session);
// float32 EXR of these channels; values row by row, row 0 at the top.
struct FloatChannel {
  std::string name;
  std::vector<float> values;
};
void writeExr(glm::ivec2 size, const std::vector<FloatChannel>& channels, const std::filesystem::path& file,
              const std::string& session);
// The session text of a PNG or EXR; empty when there is none. Throws Error{input} for anything else.
std::string readSessionText(const std::filesystem::path& file);
// Whether a file begins like a picture that may carry a session.
bool looksLikePicture(std::string_view beginning);
// Pixels, as the file says; 0 for anything but a PNG of 1 to kLargestPicture pixels each.
glm::ivec2 pngSize(const std::filesystem::path& file);
render::ColorImage readPng(const std::filesystem::path& file);

}  // namespace isolux::app
