#include "gi/file/bake_merge.h"

#include <filesystem>
#include <fstream>
#include <numeric>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "base/error.h"
#include "gi/bake/light_bake.h"
#include "gi/file/bake_file.h"
#include "gi/texels/texel_sets.h"
#include "tests/gi/bake/formula_estimator.h"

namespace isolux::gi {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

constexpr const char* kSkyKey = R"({"volume":"1","lattice_scale":1.0})";
constexpr const char* kMergeLampsKey = R"({"volume":"1","lamps":[]})";
const LightContent kGreyTransfer{LightContent::Kind::transfer, 1, 2};
const LightContent kColourIrradiance{LightContent::Kind::irradiance, 3, 0};

class BakeMerge : public testing::Test {
 protected:
  BakeMerge() : folder_(fs::temp_directory_path() / ("isolux_bake_merge_" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~BakeMerge() override { fs::remove_all(folder_); }

  fs::path at(const std::string& name) const { return folder_ / name; }
  std::string bytesOf(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(at(name), std::ios::binary).rdbuf();
    return text.str();
  }
  std::shared_ptr<LightLattice> baked(LightContent content, const char* key, LatticePart part,
                                      std::uint32_t samples) const {
    auto lattice = std::make_shared<LightLattice>(geometry_, content, key);
    LightBake bake(lattice, std::make_shared<FormulaEstimator>(content), {.samples = samples, .threads = 2});
    bake.want(Priority::rest, blocksOfPart(geometry_, part, allTexels(geometry_)));
    EXPECT_TRUE(bake.waitFor(0, 100.0));
    return lattice;
  }
  struct Words {
    std::uint32_t samples = 16;
    std::string texels = "full", arithmetic = "fma";
    bool complete = true;
    const char* skyKey = kSkyKey;
  };
  // Part `index` of `count`; 1 of 1: the whole, as a bake writes it.
  void write(const std::string& name, int index, int count) { write(name, index, count, Words()); }
  void write(const std::string& name, int index, int count, const Words& words) {
    const LatticePart part{index, count};
    StoredLight light{baked(kGreyTransfer, words.skyKey, part, words.samples),
                      baked(kColourIrradiance, kMergeLampsKey, part, words.samples)};
    light.facts.arithmetic = words.arithmetic;
    if (count > 1) light.facts.part = {part, words.samples, words.texels, words.complete};
    writeBakeFile(at(name), grid_, light, progress_);
  }
  void merge(const std::vector<std::string>& names, bool mix = false) {
    std::vector<fs::path> files;
    for (const std::string& name : names) files.push_back(at(name));
    mergeBakeFiles(files, at("merged.vti"), mix, progress_);
  }
  // The line of an error of input; nothing may have been written.
  std::string refusal(const std::vector<std::string>& names) {
    try {
      merge(names);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::input);
      EXPECT_FALSE(fs::exists(at("merged.vti")));
      return error.what();
    }
    return "";
  }

  fs::path folder_;
  base::Progress progress_;
  volume::Grid grid_ = [] {
    std::vector<std::uint8_t> voxels(70 * 40 * 36);
    std::iota(voxels.begin(), voxels.end(), std::uint8_t{0});
    return volume::Grid(volume::GridGeometry::make({70, 40, 36}, {0.5, 0.7, 3.0}, {10.0, -20.0, 30.0},
                                                   glm::dmat3(0.6, 0.8, 0.0, 0.8, -0.6, 0.0, 0.0, 0.0, 1.0)),
                        std::move(voxels));
  }();
  LatticeGeometry geometry_ = LatticeGeometry::make({70, 40, 36}, 1.0);
};

TEST_F(BakeMerge, PartsAreTheWholeByteForByte) {
  write("whole.vti", 1, 1);
  for (int i = 1; i <= 3; ++i) write("part" + std::to_string(i), i, 3);
  merge({"part2", "part3", "part1"});
  EXPECT_TRUE(bytesOf("merged.vti") == bytesOf("whole.vti"));
}

TEST_F(BakeMerge, PartsWithoutTilesAreParts) {
  write("whole.vti", 1, 1);
  std::vector<std::string> names;
  for (int i = 1; i <= 14; ++i) {  // 12 tiles
    names.push_back("part" + std::to_string(i));
    write(names.back(), i, 14);
  }
  merge(names);
  EXPECT_TRUE(bytesOf("merged.vti") == bytesOf("whole.vti"));
}

TEST_F(BakeMerge, WhatIsMissingDoubledOrUnfinishedIsNamed) {
  for (int i : {1, 2, 4}) write("part" + std::to_string(i), i, 4);
  EXPECT_THAT(refusal({"part1", "part2", "part4"}), HasSubstr("part 3 of 4 is missing"));
  EXPECT_THAT(refusal({"part1", "part4"}), HasSubstr("parts 2, 3 of 4 are missing"));
  EXPECT_THAT(refusal({"part1", "part2", "part2", "part4"}),
              testing::AllOf(HasSubstr("part2"), HasSubstr("is part 2 of 4, and so is")));
  write("part3", 3, 4, {.complete = false});
  EXPECT_THAT(refusal({"part1", "part2", "part3", "part4"}), HasSubstr("part 3 of 4 is not finished"));
  write("whole.vti", 1, 1);
  EXPECT_THAT(refusal({"part1", "whole.vti"}), HasSubstr("this is not a part of a bake"));
}

TEST_F(BakeMerge, PartsOfOtherBakesAreRefused) {
  write("part1", 1, 2);
  const auto withSecond = [&](int index, int count, const Words& words) {
    write("part2", index, count, words);
    return refusal({"part1", "part2"});
  };
  EXPECT_THAT(withSecond(2, 3, {}), HasSubstr("is part 2 of 3, and"));
  EXPECT_THAT(withSecond(2, 2, {.samples = 64}), HasSubstr("has 64 paths a texel"));
  EXPECT_THAT(withSecond(2, 2, {.texels = "band 1 2"}), HasSubstr("band 1 2"));
  EXPECT_THAT(withSecond(2, 2, {.skyKey = R"({"volume":"1","lattice_scale":1.0,"bounces":2})"}),
              HasSubstr("bounces differs"));
  EXPECT_THAT(withSecond(2, 2, {.arithmetic = "no-fma"}), HasSubstr("--mix-arithmetic"));
  EXPECT_EQ(withSecond(2, 2, {}), "");
}

TEST_F(BakeMerge, MixedArithmeticIsSaid) {
  write("part1", 1, 2);
  write("part2", 2, 2, {.arithmetic = "no-fma"});
  merge({"part1", "part2"}, true);
  const BakeFacts facts = readBakeFile(at("merged.vti"), grid_, {}, kSkyKey, kMergeLampsKey, progress_).facts;
  EXPECT_EQ(facts.arithmetic, "fma, no-fma");
  EXPECT_FALSE(facts.part);
}

// A file whose name lies about its part: two have the same texels.
TEST_F(BakeMerge, TexelsOfTwoPartsAreFound) {
  write("part1", 1, 2);
  StoredLight light{baked(kGreyTransfer, kSkyKey, {1, 2}, 16),
                    baked(kColourIrradiance, kMergeLampsKey, {1, 2}, 16)};
  light.facts = {"fma", BakedPart{{2, 2}, 16, "full", true}};
  writeBakeFile(at("part2"), grid_, light, progress_);
  EXPECT_THAT(refusal({"part1", "part2"}), HasSubstr("has texels of another part"));
}

}  // namespace
}  // namespace isolux::gi
