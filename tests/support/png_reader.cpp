#include "tests/support/png_reader.h"

#include <cstdint>
#include <memory>

#include <png.h>

#include "base/error.h"
#include "volume/read/input/streams.h"

namespace isolux::test {

namespace fs = std::filesystem;
using base::throwInput;

namespace {

constexpr std::uint32_t largestAxis = 32768;  // pixels

[[noreturn]] void cannotRead(const fs::path& file, png_image& image) {
  const std::string reason = image.message;
  png_image_free(&image);
  throwInput(file.string(), "", "cannot be read: " + reason);
}

// A larger claim than deflate can pack is no picture.
bool canHold(const fs::path& file, const png_image& image) {
  std::error_code error;
  const std::uintmax_t bytes = fs::file_size(file, error);
  return !error && std::uint64_t{image.width} * image.height * 3 / volume::kBestDeflateRatio <= bytes;
}

}  // namespace

render::ColorImage readPng(const fs::path& file) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&header, file.c_str()) == 0) cannotRead(file, header);
  const std::unique_ptr<png_image, decltype(&png_image_free)> freed(&header, png_image_free);
  if (header.width > largestAxis || header.height > largestAxis)
    throwInput(file.string(), "", "a picture of at most 32768 x 32768 pixels was expected");
  if ((header.format & PNG_FORMAT_FLAG_COLOR) == 0)
    throwInput(file.string(), "", "a colour picture was expected");
  if (!canHold(file, header)) throwInput(file.string(), "", "truncated: too short for its size in pixels");
  const bool transparent = (header.format & PNG_FORMAT_FLAG_ALPHA) != 0;
  header.format = PNG_FORMAT_RGBA;
  render::ColorImage image;
  image.size = {static_cast<int>(header.width), static_cast<int>(header.height)};
  image.rgba.assign(PNG_IMAGE_SIZE(header), 255);
  image.transparent = transparent;
  if (png_image_finish_read(&header, nullptr, image.rgba.data(), 0, nullptr) == 0) cannotRead(file, header);
  return image;
}

}  // namespace isolux::test
