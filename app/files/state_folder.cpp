#include "app/files/state_folder.h"

#include <cstdlib>
#include <system_error>
#include <vector>

#include <pwd.h>
#include <unistd.h>

#include "base/error.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

// $HOME, else what the system's list of users says.
fs::path homeFolder() {
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') return home;
  std::vector<char> buffer(16384);
  passwd entry{};
  passwd* found = nullptr;
  if (getpwuid_r(::getuid(), &entry, buffer.data(), buffer.size(), &found) != 0 || found == nullptr)
    return {};
  return found->pw_dir != nullptr && *found->pw_dir == '/' ? fs::path(found->pw_dir) : fs::path();
}

}  // namespace

fs::path stateFolder() {
  // A relative path is to be ignored, says the specification.
  if (const char* state = std::getenv("XDG_STATE_HOME"); state != nullptr && *state == '/')
    return fs::path(state) / "isolux";
  const fs::path home = homeFolder();
  return home.empty() ? fs::path() : home / ".local" / "state" / "isolux";
}

fs::path configFolder() {
  if (const char* config = std::getenv("XDG_CONFIG_HOME"); config != nullptr && *config == '/')
    return fs::path(config) / "isolux";
  const fs::path home = homeFolder();
  return home.empty() ? fs::path() : home / ".config" / "isolux";
}

fs::path cacheFolder() {
  if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache != nullptr && *cache == '/')
    return fs::path(cache) / "isolux";
  const fs::path home = homeFolder();
  return home.empty() ? fs::path() : home / ".cache" / "isolux";
}

void makePrivateFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  fs::create_directories(folder, error);
  if (!error) fs::permissions(folder, fs::perms::owner_all, error);
  if (error) base::throwInput(folder.string(), "", "cannot be made: " + error.message());
}

}  // namespace isolux::app
