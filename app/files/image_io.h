// Writes images and AOVs, and reads the sessions in them; files are written under a temporary name and
// renamed when complete. Errors: base::Error{input} naming the file. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "render/graph/frame.h"

namespace isolux::app {

// The key of the text that contains the session, in PNG (a tEXt chunk) and EXR (an attribute).
constexpr const char* sessionKey = "isolux_session";
constexpr int kLargestPicture = 16384;  // pixels per axis of a rendered image

// Returns the names and texts that every image carries: the program, and the session unless empty.
std::vector<std::pair<std::string, std::string>> pictureTexts(const std::string& session);

// Writes an 8-bit sRGB PNG (with alpha if the image is transparent) with the session text in a text chunk
// ("isolux_session"); empty text: none.
void writePng(const render::ColorImage& image, const std::filesystem::path& file, const std::string& session);
// Returns the same file as bytes, for a pipe. Throws Error{memory} if there is no room for them.
std::string pngBytes(const render::ColorImage& image, const std::string& session);
// Writes a float32 EXR: channels R G B (linear, not converted), and A if it is transparent, of `color` unless
// null, and each AOV as "name" or "name.channel".
void writeExr(const render::LinearImage* color, const std::vector<render::AovImage>& aovs,
              const std::filesystem::path& file, const std::string& session);
// Channels of a float32 EXR; values row by row, row 0 at the top.
struct FloatChannel {
  std::string name;
  std::vector<float> values;
};
void writeExr(glm::ivec2 size, const std::vector<FloatChannel>& channels, const std::filesystem::path& file,
              const std::string& session);
// Returns the session text of a PNG or EXR, or "" if there is none. Throws Error{input} for other files.
std::string readSessionText(const std::filesystem::path& file);
// Returns whether a file begins like an image that may contain a session.
bool looksLikePicture(std::string_view beginning);
// Returns the size in pixels; 0 for anything but a PNG of 1 to kLargestPicture pixels per axis.
glm::ivec2 pngSize(const std::filesystem::path& file);

}  // namespace isolux::app
