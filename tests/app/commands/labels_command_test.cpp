// isolux info on label maps: the labels, as a table and as JSON.
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

// 16 x 16 x 16 voxels: label z + 1 for z < `labels`, 0 above; the first two are named.
std::string labelFile(int labels) {
  const std::filesystem::path path = temporaryFolder() / "organs.nrrd";
  std::ofstream file(path, std::ios::binary);
  file << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 16 16 16\nspacings: 1 1 1\nencoding: raw\n"
          "Segment0_Name:=liver\nSegment0_LabelValue:=1\nSegment0_Color:=1 0 0\n"
          "Segment1_Name:=spleen\nSegment1_LabelValue:=99\n\n";
  for (int z = 0; z < 16; ++z) file << std::string(256, static_cast<char>(z < labels ? z % labels + 1 : 0));
  return path.string();
}

RunResult infoOf(const std::string& path, const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments{"info", path};
  arguments.insert(arguments.end(), more.begin(), more.end());
  RunResult result = callIsolux(arguments, temporaryFolder());
  EXPECT_EQ(result.exitCode, 0) << result.err;
  return result;
}

TEST(LabelsCommand, JsonListsEachLabelOnce) {
  const json info = json::parse(infoOf(labelFile(3), {"--json"}).out);
  EXPECT_EQ(info["kind"], "labels");
  EXPECT_EQ(info["labels"], 3);
  EXPECT_EQ(info["suggested_isovalue"], 0.5);
  const json& table = info["label_table"];
  EXPECT_EQ(table["reason"], "its header lists segments");
  ASSERT_EQ(table["list"].size(), 4u) << "three with voxels, and one that is named alone";
  EXPECT_EQ(table["list"][0],
            json({{"label", 1}, {"name", "liver"}, {"color", {1.0, 0.0, 0.0}}, {"voxels", 256}}));
  EXPECT_EQ(table["list"][2]["name"], "");
  EXPECT_EQ(table["list"][3]["label"], 99);
  EXPECT_EQ(table["list"][3]["voxels"], 0);
  EXPECT_TRUE(json::parse(infoOf("phantom:ball:8", {"--json"}).out)["label_table"].is_null());
}

TEST(LabelsCommand, TextNamesAndCountsThem) {
  const std::string text = infoOf(labelFile(3)).out;
  EXPECT_THAT(text, HasSubstr("1 liver, 256 voxels, #ff0000\n"));
  EXPECT_THAT(text, HasSubstr("99 spleen, 0 voxels"));
  EXPECT_THAT(text, HasSubstr("is a label map (its header lists segments) of 3 labels"));
  EXPECT_THAT(text, Not(HasSubstr("isosurface at")));  // a report says nothing of what pictures show
}

// Names of another file take the place of those of the header.
TEST(LabelsCommand, NamesComeFromTheFileThatIsGiven) {
  const std::filesystem::path folder = temporaryFolder();
  std::ofstream(folder / "other.tsv") << "index\tname\tcolor\n1\tcortex\t#0000ff\n2\tfat\t#00ff00\n";
  const std::string path = (folder / "other.tsv").string();
  const json table =
      json::parse(infoOf(labelFile(3), {"--json", "--set", "source.label_names=" + path}).out)["label_table"];
  EXPECT_EQ(table["list"][0]["name"], "cortex");
  EXPECT_EQ(table["list"][0]["color"], json({0.0, 0.0, 1.0}));
  EXPECT_EQ(table["names_from"], "other.tsv");
  const auto refusal = [&](const std::string& file) {
    return callIsolux({"info", labelFile(3), "--set", "source.label_names=" + file}, folder);
  };
  EXPECT_EQ(refusal("absent.tsv").exitCode, 3);
  std::ofstream(folder / "empty.txt") << "nothing\n";
  const RunResult none = refusal("empty.txt");
  EXPECT_EQ(none.exitCode, 3) << none.err;
}

// The label of the nearest voxel at points, that of the surface where rays hit it.
TEST(LabelsCommand, ProbeNamesLabels) {
  const std::filesystem::path folder = temporaryFolder();
  const std::string file = labelFile(3);
  const std::string points = (folder / "points.csv").string(), rays = (folder / "rays.csv").string();
  std::ofstream(points) << "8,8,0\n8,8,2\n8,8,9\n";
  std::ofstream(rays) << "8,8,40,0,0,-1\n8,8,-20,0,0,1\n";
  const auto probe = [&](const std::vector<std::string>& arguments) {
    std::vector<std::string> all{"probe", file, "--set", "source.labels=1,3"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const RunResult result = callIsolux(all, folder);
    EXPECT_EQ(result.exitCode, 0) << result.err;
    return result.out;
  };
  const json seen = json::parse(probe({"--points", points, "--rays", rays, "--json"}));
  EXPECT_EQ(seen["points"][0]["label"], 1);
  EXPECT_EQ(seen["points"][0]["label_name"], "liver");
  EXPECT_EQ(seen["points"][1]["label"], 3);
  EXPECT_EQ(seen["points"][2]["label"], 0);
  EXPECT_EQ(seen["rays"][0]["hit"]["label"], 3);
  EXPECT_EQ(seen["rays"][1]["hit"]["label_name"], "liver");
  EXPECT_THAT(probe({"--points", points}), HasSubstr(",1,liver"));
}

TEST(LabelsCommand, ASettingSaysThatTheyAreNone) {
  const json info = json::parse(infoOf(labelFile(3), {"--json", "--set", "source.kind=other"}).out);
  EXPECT_EQ(info["kind"], "other");
  EXPECT_EQ(info["labels"], 0);
  EXPECT_TRUE(info["label_table"].is_null());
}

}  // namespace
}  // namespace isolux::test
