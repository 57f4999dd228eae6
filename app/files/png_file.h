// PNG files of the program's own pictures (libpng).
//
// Errors: base::Error{input} naming the file. Any thread.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "render/graph/frame.h"

namespace isolux::app {

// A text chunk (tEXt): a keyword of 1 to 79 Latin letters, and any text without a zero byte.
struct PngText {
  std::string keyword, text;
};

// 8-bit RGB, or RGBA where the picture is transparent, marked as sRGB. Writes beside `file`, then renames.
void writePngFile(const render::ColorImage& image, const std::vector<PngText>& texts,
                  const std::filesystem::path& file);

// The bytes of that file. Throws Error{memory} where there is no room for them.
std::string pngFileBytes(const render::ColorImage& image, const std::vector<PngText>& texts);

// 8-bit RGB or RGBA, at most 32768 x 32768; alpha is 255, and does not count, where the file has none.
render::ColorImage readPngFile(const std::filesystem::path& file);

}  // namespace isolux::app
