// No command writes over what it reads: which files count as read, and every command refusing them.
#include "app/files/output_guard.h"

#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "app/documents/session.h"
#include "app/files/files.h"
#include "base/error.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"
#include "volume/read/source_files.h"

namespace isolux::app {
namespace {

namespace fs = std::filesystem;
using test::callIsolux;
using testing::AnyOf;
using testing::HasSubstr;
using testing::UnorderedElementsAre;

void write(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

std::map<std::string, std::string> contentsOf(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    contents[entry.path().string()] = entry.is_regular_file() ? test::contentOf(entry.path()) : "";
  return contents;
}

std::vector<std::string> namesOf(const std::vector<fs::path>& files, const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(fs::relative(file, folder).string());
  return names;
}

TEST(SourceFiles, HoldEverythingAVolumeIsReadFrom) {
  const fs::path folder = test::temporaryFolder();
  const auto files = [&](const std::string& name) {
    return namesOf(volume::filesOfVolume((folder / name).string()), folder);
  };
  write(folder / "a.mhd",
        "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = b.bin\n");
  write(folder / "b.bin", "12345678");
  EXPECT_THAT(files("a.mhd"), UnorderedElementsAre("a.mhd", "b.bin"));
  write(
      folder / "l.mhd",
      "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\nElementDataFile = s%d.raw 1 "
      "2 1\n");
  write(folder / "s1.raw", "1234");
  write(folder / "s2.raw", "1234");
  EXPECT_THAT(files("l.mhd"), UnorderedElementsAre("l.mhd", "s1.raw", "s2.raw"));
  write(folder / "n.nhdr",
        "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: b.bin\n\n");
  EXPECT_THAT(files("n.nhdr"), UnorderedElementsAre("n.nhdr", "b.bin"));
  write(folder / "p.hdr", "x");
  write(folder / "p.img.gz", "x");
  EXPECT_THAT(files("p.hdr"), testing::IsSupersetOf({"p.hdr", "p.img.gz"}));
  const std::string dicom = std::string(128, '\0') + "DICM";
  write(folder / "series" / "1", dicom);
  write(folder / "series" / "deeper" / "2.dcm", "an old file without the mark");
  write(folder / "series" / "picture.png", "x");
  EXPECT_THAT(files("series"), UnorderedElementsAre("series/1", "series/deeper/2.dcm"));
  EXPECT_THAT(files("series/"), UnorderedElementsAre("series/1", "series/deeper/2.dcm"));
  EXPECT_THAT(files("series/1"), testing::IsSupersetOf({"series/1", "series/deeper/2.dcm"}));
  write(folder / "stack" / "7.TIF", "x");
  EXPECT_THAT(files("stack"), UnorderedElementsAre("stack/7.TIF"));
  EXPECT_THAT(files("missing"), testing::IsEmpty());
  EXPECT_THAT(volume::filesOfVolume("phantom:head"), testing::IsEmpty());
}

TEST(OutputGuard, TellsFilesByWhatTheyAreNotByTheirNames) {
  const fs::path folder = test::temporaryFolder();
  write(folder / "scan.vti", "scan");
  write(folder / "other.vti", "other");
  fs::create_symlink("scan.vti", folder / "link.vti");
  fs::create_hard_link(folder / "scan.vti", folder / "hard.vti");
  fs::create_directory_symlink(".", folder / "here");
  OutputGuard guard;
  guard.reads(folder / "scan.vti", "the volume");
  for (const fs::path& same :
       {folder / "scan.vti", folder / "link.vti", folder / "hard.vti", folder / "here" / "scan.vti",
        folder / "here" / ".." / folder.filename() / "scan.vti", fs::relative(folder / "scan.vti")})
    EXPECT_THROW(guard.writes(same, "--out"), base::Error) << same;
  guard.writes(folder / "other.vti", "--out");
  guard.writes(folder / "new.json", "--stats");
  EXPECT_THROW(guard.writes(folder / "here" / "new.json", "--again"), base::Error) << "not there yet";
  fs::create_symlink("future.json", folder / "to_future.json");
  guard.writes(folder / "to_future.json", "--stats");
  EXPECT_THROW(guard.writes(folder / "future.json", "--again"), base::Error);
}

// A folder with one of everything that a command can read.
class Inputs : public testing::Test {
 protected:
  Inputs() : folder_(test::temporaryFolder()) {
    EXPECT_EQ(call({"phantom", "ball", "--size", "8", "--out", "v.vti"}).exitCode, 0);
    EXPECT_EQ(call({"phantom", "ball", "--size", "8", "--out", "w.mhd"}).exitCode, 0);
    write(folder_ / "probe.exr", "a light probe");
    write(folder_ / "light.vti", "stored light");
    scene::Scene scene;
    scene.source.path = (folder_ / "v.vti").string();
    saveSession(scene, folder_ / "s.isolux");
    write(folder_ / "p.json",
          R"({"isolux_preset": 1, "name": "p", "title": "P", "meaning": "m.", "set": {"look.mode": "gi"}})");
    write(folder_ / "tour.jsonl", R"({"isolux_recording": 1, "scene": {"source": {"path": "v.vti"}}})"
                                  "\n");
    fs::copy_file(folder_ / "tour.jsonl", folder_ / "frame_00000.png");
    fs::create_symlink("v.vti", folder_ / "link.vti");
    fs::create_hard_link(folder_ / "probe.exr", folder_ / "hard.exr");
  }
  test::RunResult call(const std::vector<std::string>& arguments) const {
    return callIsolux(arguments, folder_);
  }

  fs::path folder_;
};

TEST_F(Inputs, AreRefusedAsOutputsByEveryCommand) {
  const auto before = contentsOf(folder_);
  for (const std::vector<std::string>& arguments : std::vector<std::vector<std::string>>{
           {"render", "v.vti", "--out", "a.png", "--stats", "v.vti"},
           {"render", "v.vti", "--out", "a.png", "--stats", "./link.vti"},
           {"render", "w.mhd", "--out", "a.png", "--stats", "w.raw"},
           {"render", "v.vti", "--environment", "probe.exr", "--out", "probe.exr"},
           {"render", "v.vti", "--environment", "probe.exr", "--out", "hard.exr"},
           {"render", "v.vti", "--light", "light.vti", "--out", "a.png", "--stats", "light.vti"},
           {"render", "v.vti", "--set", "source.csg=union", "--set", "source.csg_path=w.mhd", "--out",
            "a.png", "--stats", "w.mhd"},
           {"render", "s.isolux", "--out", "a.png", "--stats", "s.isolux"},
           {"render", "v.vti", "--preset", "p.json", "--out", "a.png", "--stats", "p.json"},
           {"bake", "v.vti", "--preset", "./p.json", "--out", "a.vti", "--stats", "p.json"},
           {"reference", "v.vti", "--preset", "p.json", "--out", "a.exr", "--stats", "p.json"},
           {"render", "s.isolux", "--out", "a.png", "--stats", "v.vti"},
           {"render", "w.mhd", "--session", "s.isolux", "--out", "a.png", "--stats", "s.isolux"},
           {"render", "v.vti", "--out", "a.png", "--stats", "a.png"},
           {"render", "v.vti", "--out", "a.png", "--stats", "../" + folder_.filename().string() + "/a.png"},
           {"bake", "v.vti", "--out", "v.vti"},
           {"bake", "v.vti", "--out", "v.vti", "--overwrite"},
           {"bake", "v.vti", "--out", "link.vti", "--overwrite"},
           {"bake", "v.vti", "--out", "a.vti", "--stats", "v.vti"},
           {"bake", "v.vti", "--out", "a.vti", "--environment", "probe.exr", "--stats", "probe.exr"},
           {"reference", "v.vti", "--environment", "probe.exr", "--out", "probe.exr"},
           {"reference", "v.vti", "--out", "a.exr", "--stats", "v.vti"},
           {"replay", "frame_00000.png", "--out", "."},
           {"v.vti", "--record", "v.vti"},
           {"s.isolux", "--record", "s.isolux"}}) {
    const test::RunResult result = call(arguments);
    const std::string shown = testing::PrintToString(arguments);
    EXPECT_EQ(result.exitCode, 2) << shown << result.err;
    EXPECT_TRUE(result.isOneErrorLine()) << shown << result.err;
    EXPECT_THAT(result.err, AnyOf(HasSubstr("is read from this file"), HasSubstr("is the file of"))) << shown;
    EXPECT_TRUE(contentsOf(folder_) == before) << shown;
  }
}

TEST_F(Inputs, AStudyBesideItsSessionKeepsIt) {
  fs::create_directory(folder_ / "out");
  fs::copy_file(folder_ / "s.isolux", folder_ / "out" / "study.json");
  const auto before = contentsOf(folder_);
  const test::RunResult result = call({"study", "out/study.json", "--out", "out"});
  EXPECT_EQ(result.exitCode, 2) << result.err;
  EXPECT_TRUE(contentsOf(folder_) == before);
}

TEST_F(Inputs, ABakeReplacesNothingButLightUnlessTold) {
  const std::vector<std::string> words{"bake",  "v.vti",        "--out", "other.vti",
                                       "--set", "gi.samples=1", "--set", "gi.lattice_scale=0.5"};
  EXPECT_EQ(call({"phantom", "torus", "--size", "8", "--out", "other.vti"}).exitCode, 0);
  const auto before = contentsOf(folder_);
  const test::RunResult refused = call(words);
  EXPECT_EQ(refused.exitCode, 3) << refused.err;
  EXPECT_THAT(refused.err, HasSubstr("--overwrite"));
  EXPECT_TRUE(contentsOf(folder_) == before);
  std::vector<std::string> told = words;
  told.push_back("--overwrite");
  EXPECT_EQ(call(told).exitCode, 0);
  EXPECT_EQ(call(words).exitCode, 0) << "light of the same command is gone on with";
}

TEST_F(Inputs, ThePhantomsVoxelsReplaceNoFileOfAnotherHeader) {
  write(folder_ / "scan.raw", "a scan");
  EXPECT_EQ(call({"phantom", "ball", "--size", "8", "--out", "scan.mhd"}).exitCode, 3);
  EXPECT_EQ(test::contentOf(folder_ / "scan.raw"), "a scan");
  EXPECT_EQ(call({"phantom", "ball", "--size", "9", "--out", "w.mhd"}).exitCode, 0) << "its own may be";
}

}  // namespace
}  // namespace isolux::app
