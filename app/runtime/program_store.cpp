#include "app/runtime/program_store.h"

#include "app/files/state_folder.h"
#include "app/version.h"
#include "render/gl/program_cache.h"

namespace isolux::app {

std::filesystem::path programFolder() {
  const std::filesystem::path cache = cacheFolder();
  return cache.empty() ? cache : cache / "programs";
}

void storePrograms() {
  render::setProgramStore({.folder = programFolder(), .version = std::string(version())});
}

}  // namespace isolux::app
