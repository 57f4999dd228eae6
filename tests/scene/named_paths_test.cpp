// Comments and pages name files; after a move they must not send their reader to where nothing is.
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace isolux::scene {
namespace {

namespace fs = std::filesystem;

// "room/file.ext" of the tree's own folders, not after a character that would make it part of a longer path.
const std::regex namedPath(
    R"((^|[^\w/.-])((?:base|scene|volume|readers|gi|render|app|ui|tests|bench|resources|docs|cmake)/[\w./-]*\w\.(?:h|cpp|glsl|py|sh|md|txt|cmake))\b)");

bool isText(const fs::path& file) {
  static const std::set<std::string> extensions = {".h",  ".cpp", ".glsl", ".md",
                                                   ".py", ".sh",  ".txt",  ".cmake"};
  return extensions.count(file.extension().string()) > 0;
}

// Made up by the tests of such reading, or made at build.
bool isInvented(const fs::path& file, const std::string& path) {
  const std::string name = file.filename().string();
  return name == "include_direction_test.cpp" || name == "named_paths_test.cpp" ||
         path.ends_with("_plot_script.h") || path.ends_with("built_in_preset_texts.h") ||
         path == "tests/support/paths.h" || path == "volume/simd_sets.h";
}

int checkFile(const fs::path& root, const fs::path& file) {
  std::ifstream in(file);
  int found = 0, number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    for (std::sregex_iterator at(line.begin(), line.end(), namedPath), end; at != end; ++at) {
      const std::string path = (*at)[2];
      if (isInvented(file, path)) continue;
      ++found;
      EXPECT_TRUE(fs::exists(root / path) || fs::exists(file.parent_path() / path))
          << fs::relative(file, root).string() << ':' << number << " names " << path;
    }
  }
  return found;
}

TEST(NamedPaths, AreThere) {
  const fs::path root = ISOLUX_SOURCE_DIR;
  int found = 0;
  for (const char* folder : {"base", "scene", "volume", "readers", "gi", "render", "app", "ui", "tests",
                             "bench", "resources", "docs", "cmake"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder))
      if (entry.is_regular_file() && isText(entry.path())) found += checkFile(root, entry.path());
  for (const char* file : {"README.md", "CONTRIBUTING.md", "CHANGELOG.md", "CMakeLists.txt"})
    found += checkFile(root, root / file);
  EXPECT_GT(found, 1000);  // the includes alone
}

}  // namespace
}  // namespace isolux::scene
