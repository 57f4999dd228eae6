#include "tests/support/test_data.h"
#include "tests/support/paths.h"

#include <stdlib.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstdlib>
#include <string>
#include <system_error>

namespace isolux::test {

namespace fs = std::filesystem;

fs::path dataFolder() {
  const char* set = std::getenv("ISOLUX_DATA");
  const fs::path folder = set ? fs::path(set) : fs::path(ISOLUX_SOURCE_DIR) / ".." / "shared" / "data";
  std::error_code ignored;
  return fs::is_directory(folder / "volumes", ignored) ? fs::weakly_canonical(folder) : fs::path();
}

namespace {
// A new one: process numbers come again, and a killed test leaves its folder.
fs::path newFolder() {
  std::string name = (fs::temp_directory_path() / "isolux-test-XXXXXX").string();
  constexpr mode_t forEverybody = 0755;  // some tests run the program as another user
  if (!::mkdtemp(name.data()) || ::chmod(name.c_str(), forEverybody) != 0)
    throw std::system_error(errno, std::generic_category(), name);
  return name;
}

struct Folder {
  fs::path root = newFolder();
  int count = 0;
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(root, ignored);
  }
};
}  // namespace

fs::path temporaryFolder() {
  static Folder folder;
  const fs::path path = folder.root / std::to_string(folder.count++);
  fs::create_directories(path);
  return path;
}

}  // namespace isolux::test
