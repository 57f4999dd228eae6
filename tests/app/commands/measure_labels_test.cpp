// isolux measure --labels: what it prints and writes, and what it refuses.
#include <cstdint>
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

namespace fs = std::filesystem;
using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

// A folder with a.raw: a box of label 5, one of label 2 that reaches the border, a lone voxel of label 9.
struct LabelFile {
  fs::path folder = temporaryFolder();
  std::vector<std::string> words{"measure", "a.raw", "--raw", "20x16x12 uint8 spacing 0.5,0.5,2", "--labels"};

  LabelFile() {
    std::ofstream file(folder / "a.raw", std::ios::binary);
    for (int z = 0; z < 12; ++z)
      for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 20; ++x) {
          const bool deep = z >= 3 && z < 9 && y >= 3 && y < 13;
          const int label = deep && x >= 2 && x < 8        ? 5
                            : deep && x >= 12              ? 2
                            : x == 10 && y == 14 && z == 1 ? 9
                                                           : 0;
          file.put(static_cast<char>(label));
        }
  }
  RunResult run(const std::vector<std::string>& more) const {
    std::vector<std::string> all = words;
    all.insert(all.end(), more.begin(), more.end());
    return callIsolux(all, folder);
  }
};

TEST(MeasureLabelsCommand, EachLabelIsCountedExactly) {
  const LabelFile file;
  const RunResult result = file.run({"--json"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  const json found = json::parse(result.out);
  EXPECT_EQ(found["smoothing_voxels"], 1.0);
  ASSERT_EQ(found["labels"].size(), 3u);
  const int labels[] = {2, 5, 9}, voxels[] = {480, 360, 1};
  for (std::size_t i = 0; i < 3; ++i) {
    const json& label = found["labels"][i];
    EXPECT_EQ(label["label"], labels[i]);
    EXPECT_EQ(label["name"], "");
    EXPECT_EQ(label["voxels"], voxels[i]);
    EXPECT_EQ(label["counted_mm3"], 0.5 * voxels[i]);
    EXPECT_EQ(label["pieces"], 1);
    EXPECT_EQ(label["open"], labels[i] == 2);
    EXPECT_GT(label["area_mm2"]["value"], 0.0);
  }
  EXPECT_EQ(found["labels"][2]["thin_share"], 1.0);
  const json smoother = json::parse(file.run({"--json", "--smoothing", "2"}).out),
             raw = json::parse(file.run({"--json", "--smoothing", "0"}).out);
  EXPECT_EQ(smoother["smoothing_voxels"], 2.0);
  EXPECT_GT(smoother["labels"][1]["thin_share"], found["labels"][1]["thin_share"]);
  EXPECT_GT(raw["labels"][1]["volume_mm3"]["value"], found["labels"][1]["volume_mm3"]["value"]);
  EXPECT_EQ(raw["labels"][2]["thin_share"], 0.0);
}

TEST(MeasureLabelsCommand, PrintsAndWritesARowForEach) {
  const LabelFile file;
  const RunResult result = file.run({"--out", "labels.csv"});
  ASSERT_EQ(result.exitCode, 0) << result.err;
  EXPECT_THAT(result.out, AllOf(HasSubstr("labels        3\n"), HasSubstr("\n  2      "), HasSubstr("1 open"),
                                HasSubstr("\n  9      "), HasSubstr("100 %")));
  std::ifstream table(file.folder / "labels.csv");
  std::vector<std::string> lines;
  for (std::string line; std::getline(table, line);) lines.push_back(line);
  ASSERT_EQ(lines.size(), 4u);
  EXPECT_THAT(lines[0], StartsWith("label,name,voxels,counted_mm3,volume_mm3,volume_error_mm3,"));
  EXPECT_THAT(lines[1], StartsWith("2,,480,240,"));
  EXPECT_THAT(lines[3], StartsWith("9,,1,0.5,"));
}

TEST(MeasureLabelsCommand, RefusesWhatHasNoLabelsOrNoMeaning) {
  const LabelFile file;
  const auto refused = [&](const RunResult& result, int exitCode, const std::string& words) {
    EXPECT_EQ(result.exitCode, exitCode) << result.err;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, HasSubstr(words));
  };
  refused(file.run({"--box", "0,0,0 1,1,1"}), 2, "--box");
  refused(file.run({"--smoothing", "2.5"}), 2, "--smoothing");
  refused(file.run({"--out", "a.raw"}), 2, "a.raw");
  refused(callIsolux({"measure", "phantom:ball:16", "--smoothing", "1"}, file.folder), 2, "--labels");
  refused(callIsolux({"measure", "phantom:ball:16", "--labels"}, file.folder), 3, "is not a whole number");
  refused(callIsolux({"measure", "phantom:head:32", "--labels"}, file.folder), 3, "source.kind=labels");
  std::ofstream(file.folder / "a.nrrd", std::ios::binary)  // without a spacing
      << "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 4 4 4\nencoding: raw\n\n"
      << std::string(64, '\1');
  refused(callIsolux({"measure", "a.nrrd", "--labels"}, file.folder), 3, "lengths are doubtful");
  const RunResult anyway = callIsolux({"measure", "a.nrrd", "--labels", "--anyway", "--json"}, file.folder);
  ASSERT_EQ(anyway.exitCode, 0) << anyway.err;
  EXPECT_TRUE(json::parse(anyway.out).contains("doubt"));
}

}  // namespace
}  // namespace isolux::test
