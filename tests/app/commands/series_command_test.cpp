// isolux info --series: the DICOM series of a folder, listed without reading voxels.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"
#include "tests/volume/read/dicom_disc.h"

namespace isolux::test {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(SeriesCommand, ListsPatientsStudiesAndSeries) {
  const auto folder = temporaryFolder();
  writeDicomDisc(folder / "disc");
  const RunResult text = callIsolux({"info", "disc", "--series"}, folder);
  ASSERT_EQ(text.exitCode, 0) << text.err;
  for (const char* part : {"DOE, JANE, id ID4711, born 1960-01-02", "MUSTER, MAX", "Head CT 2024-01-31",
                           "axial bone: CT, 2024-01-31, 16 slices, 16 × 16, 2 × 2 × 2 mm, kernel H60s",
                           "warning: gantry tilt", "slices are missing"})
    EXPECT_THAT(text.out, HasSubstr(part));
  EXPECT_THAT(text.err, HasSubstr("1 DICOM files are unreadable"));

  const RunResult json = callIsolux({"info", "disc", "--series", "--json"}, folder);
  ASSERT_EQ(json.exitCode, 0) << json.err;
  const auto list = nlohmann::json::parse(json.out)["series"];
  ASSERT_EQ(list.size(), 6u);
  EXPECT_EQ(list[0]["series"], "1.4") << "the older study first";
  EXPECT_EQ(list[1]["series"], "1.1");
  EXPECT_EQ(list[1]["spacing_mm"][2], 2.0);
  EXPECT_EQ(list[1]["patient_id"], "ID4711");
}

TEST(SeriesCommand, NamesNobodyWhereThatIsAsked) {
  const auto folder = temporaryFolder();
  writeDicomDisc(folder / "disc");
  for (const bool json : {false, true}) {
    std::vector<std::string> arguments{"info", "disc", "--series", "--anonymous"};
    if (json) arguments.emplace_back("--json");
    const RunResult result = callIsolux(arguments, folder);
    ASSERT_EQ(result.exitCode, 0) << result.err;
    for (const char* hidden : {"DOE", "JANE", "MUSTER", "4711", "0815", "1960", "1970"})
      EXPECT_THAT(result.out + result.err, Not(HasSubstr(hidden)));
    EXPECT_THAT(result.out, HasSubstr("anonymous 2"));
    EXPECT_THAT(result.out, HasSubstr("T1 of anonymous"));
  }
}

TEST(SeriesCommand, AFolderWithoutDicomIsAnError) {
  const auto folder = temporaryFolder();
  writeBytes(folder / "plain" / "notes.txt", "nothing");
  const RunResult result = callIsolux({"info", "plain", "--series"}, folder);
  EXPECT_EQ(result.exitCode, 3);
  EXPECT_THAT(result.err, HasSubstr("has no DICOM images"));
}

}  // namespace
}  // namespace isolux::test
