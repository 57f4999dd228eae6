// isolux-reader-images: what OpenImageIO parses.
#include <string_view>

#include <OpenImageIO/imageio.h>
#include <tiffio.h>

#include "readers/images/images.h"
#include "readers/serve.h"

namespace {

// OpenImageIO packs its version as 10000 * major + 100 * minor + patch; libtiff writes "LIBTIFF,
// Version 4.5.0" and then its copyright.
std::string versions() {
  const int packed = OIIO::openimageio_version();
  std::string_view tiff = TIFFGetVersion();
  tiff = tiff.substr(0, tiff.find('\n'));
  return "OpenImageIO " + std::to_string(packed / 10000) + '.' + std::to_string(packed / 100 % 100) + '.' +
         std::to_string(packed % 100) + ", libtiff " + std::string(tiff.substr(tiff.find_last_of(' ') + 1));
}

}  // namespace

int main() {
  using namespace isolux;
  OIIO::attribute("threads", 1);  // rows are decoded one after the other
  return readers::serve({.volume = readers::decodeTiff, .image = readers::decodeImage, .versions = versions});
}
