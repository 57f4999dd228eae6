#include "tests/support/test_data.h"

#include <unistd.h>
#include <cstdlib>

namespace isolux::test {

namespace fs = std::filesystem;

fs::path dataFolder() {
  const char* set = std::getenv("ISOLUX_DATA");
  const fs::path folder = set ? fs::path(set) : fs::path(ISOLUX_SOURCE_DIR) / ".." / "shared" / "data";
  std::error_code ignored;
  return fs::is_directory(folder / "volumes", ignored) ? fs::weakly_canonical(folder) : fs::path();
}

namespace {
struct Folder {
  fs::path root = fs::temp_directory_path() / ("isolux-test-" + std::to_string(::getpid()));
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
