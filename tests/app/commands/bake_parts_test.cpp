// isolux bake --part and isolux merge: parts baked anywhere are the bake made at once, byte for byte.
#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/pending_file.h"
#include "tests/app/commands/run_isolux.h"
#include "tests/support/test_data.h"

namespace isolux::test {
namespace {

using testing::HasSubstr;

class BakeParts : public testing::Test {
 protected:
  RunResult isolux(std::vector<std::string> arguments) { return callIsolux(arguments, folder_); }
  // One bounce, a lamp beside the sky: both lattices.
  RunResult bake(const std::string& out, std::vector<std::string> more = {},
                 const char* samples = "gi.samples=4") {
    std::vector<std::string> all{"bake",  "phantom:gyroid:40",
                                 "--out", out,
                                 "--set", samples,
                                 "--set", "light.environment.builtin=studio"};
    for (std::string& word : more) all.push_back(std::move(word));
    return isolux(all);
  }
  std::string bytesOf(const std::string& name) const { return contentOf(folder_ / name); }

  std::filesystem::path folder_ = temporaryFolder();
};

TEST_F(BakeParts, MergedTheyAreTheBakeMadeAtOnce) {
  ASSERT_EQ(bake("whole.vti").exitCode, 0);
  for (const char* part : {"2/3", "1/3", "3/3"}) {
    const RunResult result = bake("light.vti", {"--part", part, "--threads", "1"});
    ASSERT_EQ(result.exitCode, 0) << result.err;
  }
  const RunResult merged = isolux({"merge", "light.part-1-of-3.vti", "light.part-2-of-3.vti",
                                   "light.part-3-of-3.vti", "--out", "light.vti"});
  ASSERT_EQ(merged.exitCode, 0) << merged.err;
  EXPECT_TRUE(bytesOf("light.vti") == bytesOf("whole.vti"));
}

TEST_F(BakeParts, ABandInPartsIsTheBandAtOnce) {
  const std::vector<std::string> band{"--set", "gi.extent=band", "--set", "gi.band=-0.2,0.2"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.end(), band.begin(), band.end());
    return more;
  };
  ASSERT_EQ(bake("whole.vti", band).exitCode, 0);
  for (const char* part : {"1/2", "2/2"}) ASSERT_EQ(bake("b.vti", with({"--part", part})).exitCode, 0);
  const RunResult merged = isolux({"merge", "b.part-1-of-2.vti", "b.part-2-of-2.vti", "--out", "merged.vti"});
  ASSERT_EQ(merged.exitCode, 0) << merged.err;
  EXPECT_TRUE(bytesOf("merged.vti") == bytesOf("whole.vti"));
}

TEST_F(BakeParts, MorePathsGoOnFromTheFileOfThePart) {
  ASSERT_EQ(bake("once.vti", {"--part", "1/2"}, "gi.samples=16").exitCode, 0);
  ASSERT_EQ(bake("twice.vti", {"--part", "1/2"}).exitCode, 0);
  ASSERT_EQ(bake("twice.vti", {"--part", "1/2"}, "gi.samples=16").exitCode, 0);
  EXPECT_TRUE(bytesOf("once.part-1-of-2.vti") == bytesOf("twice.part-1-of-2.vti"));
}

TEST_F(BakeParts, WhatAnotherOneBakesIsRefused) {
  {
    const base::OutputLock held(folder_ / "light.vti");
    const std::vector<std::vector<std::string>> commands{
        {"bake", "phantom:gyroid:40", "--out", "light.vti"},
        {"merge", "light.part-1-of-2.vti", "--out", "light.vti"}};
    for (const auto& command : commands) {
      const RunResult refused = runIsolux(command, {.folder = folder_});
      EXPECT_EQ(refused.exitCode, 3);
      EXPECT_TRUE(refused.isOneErrorLine()) << refused.err;
      EXPECT_THAT(refused.err, HasSubstr("light.vti: another isolux is at work on this file"));
    }
    EXPECT_EQ(bake("light.vti", {"--part", "1/2"}).exitCode, 0) << "another file";
    EXPECT_FALSE(std::filesystem::exists(folder_ / "light.vti"));
  }
  EXPECT_EQ(bake("light.vti").exitCode, 0);
  EXPECT_THAT(filesIn(folder_), testing::UnorderedElementsAre("light.vti", "light.part-1-of-2.vti"));
}

TEST_F(BakeParts, PiecesReplaceStoredLightOnly) {
  for (const char* name : {"light.pvti", "light.piece-1-of-2.vti", "light.piece-1-of-1.vti"}) {
    std::ofstream(folder_ / name) << "notes";
    const RunResult refused = bake("light.vti", {"--pieces", "2"});
    EXPECT_EQ(refused.exitCode, 3) << name;
    EXPECT_TRUE(refused.isOneErrorLine()) << refused.err;
    EXPECT_THAT(refused.err, testing::AllOf(HasSubstr(name), HasSubstr("--overwrite")));
    EXPECT_EQ(bytesOf(name), "notes");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "light.vti"));
    std::filesystem::remove(folder_ / name);
  }
  std::ofstream(folder_ / "light.pvti") << "notes";
  EXPECT_EQ(bake("light.vti", {"--pieces", "2", "--overwrite"}).exitCode, 0);
  EXPECT_THAT(bytesOf("light.pvti"), HasSubstr(".piece-1-of-2."));
  EXPECT_EQ(bake("light.vti", {"--pieces", "2"}).exitCode, 0) << "its own";
}

TEST_F(BakeParts, WrongUseIsOneLine) {
  for (const char* part : {"0/3", "4/3", "1", "1/", "/3", "a/b", "1/3x", "-1/3", "1/99999999999"}) {
    const RunResult result = bake("light.vti", {"--part", part});
    EXPECT_EQ(result.exitCode, 2) << part;
    EXPECT_TRUE(result.isOneErrorLine()) << result.err;
    EXPECT_THAT(result.err, HasSubstr("--part"));
  }
  ASSERT_EQ(bake("light.vti", {"--part", "1/2"}).exitCode, 0);
  const RunResult missing = isolux({"merge", "light.part-1-of-2.vti", "--out", "light.vti"});
  EXPECT_EQ(missing.exitCode, 3);
  EXPECT_TRUE(missing.isOneErrorLine()) << missing.err;
  EXPECT_THAT(missing.err, HasSubstr("part 2 of 2 is missing"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "light.vti"));
  const RunResult itself = isolux({"merge", "light.part-1-of-2.vti", "--out", "light.part-1-of-2.vti"});
  EXPECT_EQ(itself.exitCode, 2) << itself.err;
  // A part under the name of another one.
  std::filesystem::copy_file(folder_ / "light.part-1-of-2.vti", folder_ / "light.part-2-of-2.vti");
  const RunResult other = bake("light.vti", {"--part", "2/2"});
  EXPECT_EQ(other.exitCode, 3);
  EXPECT_THAT(other.err, HasSubstr("is part 1 of 2, not part 2 of 2"));
}

}  // namespace
}  // namespace isolux::test
