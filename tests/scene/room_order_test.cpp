// Rooms, the folders of the tree, stand one above the other: each includes only rooms below it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr std::size_t kMostSources = 24;  // of a room; a header and its source are one

// Lowest first. A new room gets a place above all that it includes.
const std::vector<std::string_view> kRooms{"base",
                                           "scene",
                                           "scene/settings",
                                           "scene/rules",
                                           "volume/voxels",
                                           "volume/parallel",
                                           "volume/bricks",
                                           "volume",
                                           "volume/mesh",
                                           "volume/visible",
                                           "volume/field",
                                           "volume/phantom",
                                           "volume/skip",
                                           "volume/hit",
                                           "volume/derived",
                                           "volume/labels",
                                           "volume/read/input",
                                           "volume/read/dicom",
                                           "volume/read/vtk",
                                           "volume/read/plain",
                                           "volume/read/tiff",
                                           "volume/read/chunks",
                                           "volume/read/zarr",
                                           "volume/read/process",
                                           "volume/read/hdf5",
                                           "volume/read/mesh",
                                           "volume/write",
                                           "volume/slice",
                                           "volume/clip",
                                           "volume/pieces",
                                           "volume/simd",
                                           "volume/tracer",
                                           "volume/statistics",
                                           "volume/read",
                                           "volume/color",
                                           "volume/large",
                                           "volume/prepared",
                                           "volume/edge",
                                           "volume/cast",
                                           "volume/error",
                                           "volume/measure",
                                           "volume/extraction",
                                           "readers",
                                           "readers/surface",
                                           "readers/dicom",
                                           "readers/hdf5",
                                           "readers/images",
                                           "readers/vtk",
                                           "gi/lattice",
                                           "gi/bake",
                                           "gi/harmonics",
                                           "gi/sampling",
                                           "gi/texels",
                                           "gi",
                                           "gi/ground",
                                           "gi/file",
                                           "gi/trace",
                                           "gi/gloss",
                                           "gi/reference",
                                           "render/legend",
                                           "render/graph",
                                           "render/gl",
                                           "render/light",
                                           "render/volume",
                                           "render/passes",
                                           "render",
                                           "app",
                                           "app/launcher",
                                           "app/image_metrics",
                                           "app/browser",
                                           "app/cuts",
                                           "app/mesh",
                                           "app/ready",
                                           "app/files",
                                           "app/runtime",
                                           "app/marks",
                                           "app/overlay_text",
                                           "app/series",
                                           "app/slices",
                                           "app/view_math",
                                           "app/light",
                                           "app/cluster",
                                           "app/study",
                                           "app/study_report",
                                           "app/accuracy",
                                           "app/picture",
                                           "app/documents",
                                           "app/presets",
                                           "app/surface_list",
                                           "app/options",
                                           "app/tasks",
                                           "app/error_budget",
                                           "app/report",
                                           "app/commands",
                                           "python",
                                           "ui/theme",
                                           "ui/language",
                                           "ui/widgets",
                                           "ui/tour",
                                           "ui/document",
                                           "ui/dicom_browser",
                                           "ui/levels",
                                           "ui/slices",
                                           "ui/editors",
                                           "ui/dialogs",
                                           "ui/viewport",
                                           "ui/panels",
                                           "ui/presets",
                                           "ui/accuracy",
                                           "ui/window",
                                           "ui"};

std::size_t placeOf(std::string_view room) {
  return static_cast<std::size_t>(std::find(kRooms.begin(), kRooms.end(), room) - kRooms.begin());
}

std::vector<std::string> includesUpward(const std::string& path, std::istream& content) {
  static const std::regex include(R"re(^\s*#\s*include\s*"([^"]+)/[^"/]+")re");
  const std::size_t own = placeOf(fs::path(path).parent_path().generic_string());
  std::vector<std::string> wrong;
  std::string line;
  while (std::getline(content, line))
    if (std::smatch match; std::regex_search(line, match, include))
      if (const std::size_t place = placeOf(match[1].str()); place > own && place < kRooms.size())
        wrong.push_back(path + " includes " + match[1].str());
  return wrong;
}

TEST(RoomOrder, RoomsIncludeOnlyRoomsBelow) {
  const fs::path root(ISOLUX_SOURCE_DIR);
  std::map<std::string, std::set<std::string>> sources;  // of each room
  for (const std::string_view layer :
       {"base", "scene", "volume", "readers", "gi", "render", "app", "python", "ui"})
    for (const auto& entry : fs::recursive_directory_iterator(root / layer)) {
      const fs::path path = fs::relative(entry.path(), root);
      if (path.extension() != ".h" && path.extension() != ".cpp") continue;
      std::ifstream content(entry.path());
      EXPECT_THAT(includesUpward(path.generic_string(), content), IsEmpty());
      sources[path.parent_path().generic_string()].insert(path.stem().string());
    }
  for (const auto& [room, names] : sources) {
    EXPECT_LT(placeOf(room), kRooms.size()) << room << " has no place in the order";
    EXPECT_LE(names.size(), kMostSources) << room;
    EXPECT_TRUE(fs::exists(root / room / "README.md") || room.starts_with("readers/")) << room;
  }
  EXPECT_EQ(sources.size(), kRooms.size()) << "the order has rooms that do not exist";
}

TEST(RoomOrder, FindsAnIncludeOfARoomAbove) {
  std::istringstream up("#include <vector>\n\n#include \"volume/prepared/prepared_volume.h\"\n"),
      down("#include \"volume/grid.h\"\n#include \"base/error.h\"\n");
  EXPECT_THAT(includesUpward("volume/field/curvature.h", up),
              ElementsAre("volume/field/curvature.h includes volume/prepared"));
  EXPECT_THAT(includesUpward("volume/field/curvature.h", down), IsEmpty());
}

}  // namespace
}  // namespace isolux
