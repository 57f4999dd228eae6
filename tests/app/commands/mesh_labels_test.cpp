// isolux mesh --labels and --label: closed objects of the volumes that measure states, with their names.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string kRaw = "26x20x18 uint16 spacing 0.5,0.5,1";

// A folder with organs.raw: two balls that touch, of labels 4 and 300, and a lone voxel, 7.
class LabelMeshes : public testing::Test {
 protected:
  LabelMeshes() {
    std::ofstream file(folder_ / "organs.raw", std::ios::binary);
    for (int z = 0; z < 18; ++z)
      for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 26; ++x) {
          const glm::dvec3 p(x, y, z);
          const int label = glm::length(p - glm::dvec3(7, 9, 8)) <= 5.0        ? 4
                            : glm::length(p - glm::dvec3(17, 9.4, 8.3)) <= 5.2 ? 300
                            : x == 24 && y == 18 && z == 1                     ? 7
                                                                               : 0;
          const char bytes[] = {static_cast<char>(label & 255), static_cast<char>(label >> 8)};
          file.write(bytes, 2);
        }
  }
  RunResult run(const std::string& command, const std::vector<std::string>& more) const {
    std::vector<std::string> words{command, "organs.raw", "--raw", kRaw};
    words.insert(words.end(), more.begin(), more.end());
    return callIsolux(words, folder_);
  }
  json jsonOf(const std::string& command, const std::vector<std::string>& more) const {
    const RunResult result = run(command, more);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return json::parse(result.out);
  }
  std::filesystem::path folder_ = temporaryFolder();
};

struct ObjectOfFile {
  double volume = 0.0;                       // enclosed, by the divergence theorem
  std::map<std::pair<int, int>, int> edges;  // triangles along each, less those the other way round
  std::size_t triangles = 0;
};

std::map<std::string, ObjectOfFile> objectsOf(const std::filesystem::path& obj) {
  std::map<std::string, ObjectOfFile> objects;
  std::vector<glm::dvec3> points;
  std::ifstream file(obj);
  ObjectOfFile* object = nullptr;
  for (std::string line; std::getline(file, line);) {
    std::istringstream words(line.substr(std::min<std::size_t>(line.size(), 2)));
    if (line.starts_with("o ")) {
      object = &objects[line.substr(2)];
    } else if (line.starts_with("v ")) {
      points.emplace_back();
      words >> points.back().x >> points.back().y >> points.back().z;
    } else if (line.starts_with("f ") && object != nullptr) {
      int corner[3];
      words >> corner[0] >> corner[1] >> corner[2];
      const auto at = [&](int i) { return points[static_cast<std::size_t>(corner[i] - 1)]; };
      object->volume += glm::dot(at(0), glm::cross(at(1), at(2))) / 6.0;
      ++object->triangles;
      for (int i = 0; i < 3; ++i) {
        const int from = corner[i], to = corner[(i + 1) % 3];
        object->edges[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
      }
    }
  }
  return objects;
}

TEST_F(LabelMeshes, EveryLabelIsAClosedObjectOfItsVolume) {
  const json made = jsonOf("mesh", {"--labels", "--out", "organs.obj", "--json", "--tolerance", "0.01"});
  const json measured = jsonOf("measure", {"--labels", "--json"});
  const std::map<std::string, ObjectOfFile> objects = objectsOf(folder_ / "organs.obj");
  ASSERT_EQ(objects.size(), 3u);
  ASSERT_EQ(made["labels"].size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const json& label = made["labels"][i];
    EXPECT_EQ(label["label"], measured["labels"][i]["label"]);
    EXPECT_EQ(label["closed"], true);
    EXPECT_LE(label["largest_distance_mm"], 0.01);
    const ObjectOfFile& object = objects.at("label_" + std::to_string(label["label"].get<int>()));
    EXPECT_EQ(object.triangles, label["triangles"]);
    const double volume = measured["labels"][i]["volume_mm3"]["value"];
    EXPECT_NEAR(object.volume, volume, 0.01 * measured["labels"][i]["area_mm2"]["value"].get<double>());
    for (const auto& [edge, balance] : object.edges) ASSERT_EQ(balance, 0);
  }
}

TEST_F(LabelMeshes, OneLabelGoesIntoAnyFormat) {
  for (const char* name : {"one.stl", "one.ply", "one.obj", "one.vtp"}) {
    const json made = jsonOf("mesh", {"--label", "300", "--out", name, "--json", "--smoothing", "2"});
    ASSERT_EQ(made["labels"].size(), 1u);
    EXPECT_EQ(made["labels"][0]["label"], 300);
    EXPECT_EQ(made["labels"][0]["closed"], true);
    EXPECT_EQ(made["smoothing_voxels"], 2.0);
    EXPECT_TRUE(std::filesystem::exists(folder_ / name));
  }
  EXPECT_THAT(run("mesh", {"--label", "300", "--out", "two.ply"}).out, HasSubstr("maximum deviation mm"));
}

TEST_F(LabelMeshes, RefusesWhatHasNoMeaning) {
  const auto refused = [&](const std::vector<std::string>& words, const std::string& what) {
    const RunResult result = run("mesh", words);
    EXPECT_EQ(result.exitCode, 2) << result.err;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, HasSubstr(what));
  };
  refused({"--labels", "--out", "all.stl"}, "--label");
  refused({"--label", "5", "--out", "one.stl"}, "no label 5");
  refused({"--labels", "--closed", "--out", "all.obj"}, "--closed");
  refused({"--labels", "--label", "4", "--out", "all.obj"}, "--label");
  refused({"--smoothing", "1", "--out", "all.obj"}, "--smoothing");
  refused({"--labels", "--smoothing", "-1", "--out", "all.obj"}, "--smoothing");
  EXPECT_EQ(filesIn(folder_), std::vector<std::string>{"organs.raw"});
}

}  // namespace
}  // namespace isolux::test
