#include <filesystem>
#include <new>

#include "base/error.h"
#include "gi/sampling/environment.h"
#include "volume/read/process/foreign.h"

namespace isolux::gi {

Environment Environment::load(const std::string& path) {
  base::Progress progress;
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) base::throwInput(path, "", "is not a file");
  try {
    volume::DecodedImage image = volume::readImage(path, progress);
    return Environment(image.width, image.height, std::move(image.pixels));
  } catch (const std::bad_alloc&) {
    throw base::Error(base::ErrorKind::memory, path, "", "is too large for the memory of this computer");
  }
}

}  // namespace isolux::gi
