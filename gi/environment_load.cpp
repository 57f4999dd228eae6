#include <filesystem>
#include <new>

#include "gi/environment.h"
#include "scene/error.h"
#include "volume/read/foreign.h"

namespace isolux::gi {

Environment Environment::load(const std::string& path, scene::Progress& progress) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(path, ignored)) scene::throwInput(path, "", "is not a file");
  try {
    volume::DecodedImage image = volume::readImage(path, progress);
    return Environment(image.width, image.height, std::move(image.pixels));
  } catch (const std::bad_alloc&) {
    throw scene::Error(scene::ErrorKind::memory, path, "", "is too large for the memory of this machine");
  }
}

Environment Environment::load(const std::string& path) {
  scene::Progress progress;
  return load(path, progress);
}

}  // namespace isolux::gi
