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

// A relative path is to be ignored, says the specification.
fs::path folderOfKind(const char* variable, const char* belowHome) {
  if (const char* folder = std::getenv(variable); folder != nullptr && *folder == '/')
    return fs::path(folder) / "isolux";
  const fs::path home = homeFolder();
  return home.empty() ? fs::path() : home / belowHome / "isolux";
}

}  // namespace

fs::path stateFolder() {
  return folderOfKind("XDG_STATE_HOME", ".local/state");
}

fs::path configFolder() {
  return folderOfKind("XDG_CONFIG_HOME", ".config");
}

fs::path cacheFolder() {
  return folderOfKind("XDG_CACHE_HOME", ".cache");
}

void makePrivateFolder(const fs::path& folder) {
  std::error_code error;
  if (fs::is_directory(folder, error)) return;
  fs::create_directories(folder, error);
  if (!error) fs::permissions(folder, fs::perms::owner_all, error);
  if (error) base::throwInput(folder.string(), "", "cannot be made: " + error.message());
}

}  // namespace isolux::app
