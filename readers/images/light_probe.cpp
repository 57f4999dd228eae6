#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>

#include <OpenImageIO/imageio.h>

#include "base/color.h"
#include "base/error.h"
#include "readers/images/images.h"
#include "readers/limits.h"

namespace isolux::readers {

using namespace volume;
namespace fs = std::filesystem;
using base::throwInput;

namespace {

std::string reason(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text.empty() ? "cannot be read as an image" : text;
}

bool isSrgb(const OIIO::ImageSpec& spec) {
  const std::string space = spec.get_string_attribute("oiio:ColorSpace");
  if (space == "sRGB") return true;
  return !spec.format.is_floating_point() && space != "Linear" && space != "linear";
}

// Channels of red, green and blue: by name, else the first three, else the first alone.
std::array<int, 3> channelsOf(const OIIO::ImageSpec& spec) {
  const std::array<int, 3> named{spec.channelindex("R"), spec.channelindex("G"), spec.channelindex("B")};
  if (named[0] >= 0 && named[1] >= 0 && named[2] >= 0) return named;
  if (spec.nchannels >= 3) return {0, 1, 2};
  const int grey = std::max(0, spec.channelindex("Y"));
  return {grey, grey, grey};
}

// All channels of rows `begin` .. `end` - 1.
bool readRows(OIIO::ImageInput& input, const OIIO::ImageSpec& spec, int begin, int end, float* out) {
  if (spec.tile_width == 0) {  // one by one: read_scanlines() makes room for 64 MB of them each time
    for (int row = begin; row < end; ++row, out += std::size_t(spec.width) * spec.nchannels)
      if (!input.read_scanline(spec.y + row, 0, OIIO::TypeDesc::FLOAT, out)) return false;
    return true;
  }
  return input.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + begin, spec.y + end, 0, 1, 0,
                          spec.nchannels, OIIO::TypeDesc::FLOAT, out);
}

std::vector<glm::vec3> readPixels(OIIO::ImageInput& input, const OIIO::ImageSpec& spec,
                                  const std::string& path, base::Progress& progress) {
  const std::array<int, 3> channels = channelsOf(spec);
  const bool srgb = isSrgb(spec);
  const std::size_t width = spec.width;
  // Strips: OpenImageIO 2.4 shows zeros for damaged pixels when asked for a whole image.
  const int strip = spec.tile_width == 0 ? 1 : spec.tile_height;
  std::vector<float> buffer(width * strip * spec.nchannels);
  std::vector<glm::vec3> pixels;
  pixels.reserve(width * spec.height);
  for (int begin = 0; begin < spec.height; begin += strip) {
    progress.report(static_cast<double>(begin) / spec.height, "reading");
    const int end = std::min(begin + strip, spec.height);
    if (!readRows(input, spec, begin, end, buffer.data()))
      throwInput(path, "row " + std::to_string(begin + 1), reason(input.geterror()));
    for (std::size_t i = 0; i < width * (end - begin); ++i) {
      glm::vec3 pixel;
      for (int c = 0; c < 3; ++c) {
        const float value = buffer[i * spec.nchannels + channels[c]];
        pixel[c] = srgb ? base::decodeSrgb(value) : value;
      }
      pixels.push_back(pixel);
    }
  }
  return pixels;
}

// As the file says that the picture is to be looked at (the TIFF and EXIF orientation, 1 .. 8; Radiance files
// have one too). Width and height swap from 5 on.
std::vector<glm::vec3> upright(std::vector<glm::vec3> stored, int& width, int& height, int orientation) {
  if (orientation <= 1 || orientation > 8) return stored;
  const bool transposed = orientation >= 5;
  const bool mirrored = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
  const bool flipped = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
  std::vector<glm::vec3> turned(stored.size());
  const int newWidth = transposed ? height : width, newHeight = transposed ? width : height;
  for (int y = 0; y < newHeight; ++y)
    for (int x = 0; x < newWidth; ++x) {
      int column = transposed ? y : x, row = transposed ? x : y;
      if (mirrored) column = width - 1 - column;
      if (flipped) row = height - 1 - row;
      turned[static_cast<std::size_t>(y) * newWidth + x] =
          stored[static_cast<std::size_t>(row) * width + column];
    }
  width = newWidth;
  height = newHeight;
  return turned;
}

}  // namespace

DecodedImage decodeImage(const fs::path& file, base::Progress& progress) {
  const std::string path = file.string();
  OIIO::ImageSpec config;
  config["oiio:UnassociatedAlpha"] = 1;
  const std::unique_ptr<OIIO::ImageInput> input = OIIO::ImageInput::open(path, &config);
  if (!input) throwInput(path, "", reason(OIIO::geterror()));
  const OIIO::ImageSpec spec = input->spec();
  if (spec.deep || spec.depth > 1) throwInput(path, "header", "is not a flat image");
  if (spec.width < 1 || spec.height < 1 || spec.nchannels < 1) throwInput(path, "header", "has no pixels");
  if (static_cast<std::int64_t>(spec.width) * spec.height > kMostImagePixels || spec.nchannels > 1024)
    throwInput(path, "header",
               std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels of " +
                   std::to_string(spec.nchannels) + " channels are too many for an environment map");
  allowDecoding(fs::file_size(file));
  DecodedImage image{spec.width, spec.height, readPixels(*input, spec, path, progress)};
  image.pixels =
      upright(std::move(image.pixels), image.width, image.height, spec.get_int_attribute("Orientation", 1));
  return image;
}

}  // namespace isolux::readers
