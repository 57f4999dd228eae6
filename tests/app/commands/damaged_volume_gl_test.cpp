// Pictures of volumes of which a part cannot be read: whole around it, hatched where nobody knows, and said.
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/app/commands/run_isolux.h"
#include "tests/support/png_reader.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "tests/support/zarr_folder.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

constexpr int kSize = 96, kChunk = 32;

void writeBall(const fs::path& folder) {
  const volume::Grid grid = phantomGrid("ball", glm::ivec3(kSize));
  std::vector<float> voxels;
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) voxels.push_back(static_cast<float>(grid.stored(x, y, z)));
  writeZarr(folder, glm::ivec3(kSize), glm::ivec3(kChunk), voxels);
}

class DamagedVolumeGl : public testing::Test {
 protected:
  void SetUp() override {
    writeBall(zarr_);
    whole_ = folder_ / "kept";
    fs::copy(chunk_, whole_);
  }
  void cutChunk() const { fs::resize_file(chunk_, fs::file_size(chunk_) / 2); }
  void mendChunk() const { fs::copy_file(whole_, chunk_, fs::copy_options::overwrite_existing); }

  RunResult render(const std::string& out, const std::vector<std::string>& more = {}) {
    std::vector<std::string> all{"render", "ball.zarr", "--out", out, "--size", "200x160"};
    for (const char* set : {"memory.voxels=file", "picture.executor=gpu", "picture.supersampling=1",
                            "camera.eye=47.5,47.5,-200", "camera.target=47.5,47.5,47.5", "camera.up=0,1,0",
                            "isosurface.albedo=1,0.1,0.05", "look.background_top=0.1,0.2,0.9",
                            "look.background_bottom=0.1,0.2,0.9", "isosurface.value=0.25", "light.setup=key"})
      all.insert(all.end(), {"--set", set});
    all.insert(all.end(), more.begin(), more.end());
    return callIsolux(all, folder_);
  }
  json statsOf(const std::string& file) const { return json::parse(std::ifstream(folder_ / file)); }

  // Of the picture with a hole: what differs from the whole one, and that nothing but grey does.
  double hole(const std::string& damaged, const std::string& undamaged) const {
    const render::ColorImage a = test::readPng(folder_ / damaged), b = test::readPng(folder_ / undamaged);
    EXPECT_EQ(a.rgba.size(), b.rgba.size());
    std::size_t differing = 0, coloured = 0;
    for (std::size_t i = 0; i < a.rgba.size(); i += 4) {
      if (std::equal(&a.rgba[i], &a.rgba[i] + 3, &b.rgba[i])) continue;
      ++differing;
      coloured += std::abs(a.rgba[i] - a.rgba[i + 1]) > 3 || std::abs(a.rgba[i] - a.rgba[i + 2]) > 3;
    }
    EXPECT_EQ(coloured, 0u) << "of " << differing;
    return 4.0 * static_cast<double>(differing) / static_cast<double>(a.rgba.size());
  }

  fs::path folder_ = temporaryFolder(), zarr_ = folder_ / "ball.zarr", chunk_ = zarr_ / "0.1.1",
           whole_;  // in the middle of what is nearest to the camera
};

TEST_F(DamagedVolumeGl, ACutChunkIsAHatchedHole) {
  ASSERT_EQ(render("whole.png").exitCode, 0);
  for (const char* const method : {"hit.method=exact", "hit.method=sampled"}) {
    fs::remove_all(folder_ / "ball.zarr.index");
    const std::vector<std::string> more{"--set", method, "--stats", "stats.json"};
    mendChunk();
    ASSERT_EQ(render("whole.png", more).exitCode, 0);
    EXPECT_EQ(statsOf("stats.json")["bricks"]["lost"], 0.0);
    fs::remove_all(folder_ / "ball.zarr.index");
    cutChunk();
    const RunResult cut = render("cut.png", more);
    EXPECT_EQ(cut.exitCode, 3) << method;
    EXPECT_THAT(cut.err, HasSubstr("isolux: cut.png: "));
    EXPECT_THAT(cut.err, HasSubstr("% of the image is hatched"));
    EXPECT_THAT(cut.err, HasSubstr("0.1.1"));
    const json bricks = statsOf("stats.json")["bricks"];
    const double lost = bricks["lost"];
    EXPECT_GT(lost, 0.02) << method;
    EXPECT_LT(lost, 0.3) << method;
    EXPECT_GT(bricks["lost_bricks"], 0);
    EXPECT_EQ(bricks["missing"], 0.0);
    EXPECT_NEAR(hole("cut.png", "whole.png"), lost, 0.002) << method;
  }
}

// The index is of a volume that was whole; the chunk went afterwards.
TEST_F(DamagedVolumeGl, SoIsOneThatIsCutAfterTheIndexWasMade) {
  ASSERT_EQ(render("whole.png").exitCode, 0);
  cutChunk();
  const RunResult cut = render("cut.png", {"--stats", "stats.json"});
  EXPECT_EQ(cut.exitCode, 3) << cut.err;
  EXPECT_NEAR(hole("cut.png", "whole.png"), statsOf("stats.json")["bricks"]["lost"], 0.002);
}

TEST_F(DamagedVolumeGl, WhatIsMendedIsDrawnAgain) {
  ASSERT_EQ(render("whole.png").exitCode, 0);
  fs::remove_all(folder_ / "ball.zarr.index");
  cutChunk();
  ASSERT_EQ(render("cut.png").exitCode, 3);
  ASSERT_TRUE(fs::exists(folder_ / "ball.zarr.index"));
  mendChunk();
  const RunResult mended = render("mended.png");
  EXPECT_EQ(mended.exitCode, 0) << mended.err;
  EXPECT_TRUE(contentOf(folder_ / "mended.png") == contentOf(folder_ / "whole.png"));
}

// The camera looks away from what is lost, or the damage lies behind what is seen: the picture is whole.
TEST_F(DamagedVolumeGl, WhatRaysDoNotComeToIsANoteOnly) {
  const std::vector<std::string> larger{"--set",
                                        "isosurface.value=-6"};  // a ball that hides all of the chunk
  ASSERT_EQ(render("whole.png", larger).exitCode, 0);
  fs::remove_all(folder_ / "ball.zarr.index");
  fs::resize_file(zarr_ / "2.1.1", 100);
  const RunResult cut = render("cut.png", larger);
  EXPECT_EQ(cut.exitCode, 0) << cut.err;
  EXPECT_THAT(cut.err, HasSubstr("a part of it cannot be read: "));
  EXPECT_THAT(cut.err, HasSubstr("2.1.1"));
  EXPECT_EQ(hole("cut.png", "whole.png"), 0.0);
}

TEST_F(DamagedVolumeGl, TheIndexGoesAroundAndSaysSo) {
  cutChunk();
  fs::resize_file(zarr_ / "2.2.2", 7);
  for (int i = 0; i < 2; ++i) {
    const RunResult index = callIsolux({"index", "ball.zarr"}, folder_);
    EXPECT_EQ(index.exitCode, 3);
    EXPECT_TRUE(index.isOneErrorLine()) << index.err;
    EXPECT_THAT(index.err, HasSubstr("2 parts of it cannot be read, the first: "));
    EXPECT_TRUE(fs::exists(folder_ / "ball.zarr.index"));
  }
}

TEST_F(DamagedVolumeGl, AVolumeOfWhichNothingCanBeReadIsOneLine) {
  for (const fs::directory_entry& file : fs::directory_iterator(zarr_))
    if (file.path().filename() != ".zarray") fs::resize_file(file.path(), 100);
  const RunResult none = render("none.png");
  EXPECT_EQ(none.exitCode, 3) << none.err;
  EXPECT_THAT(none.err, HasSubstr("nothing of it can be read"));
  EXPECT_FALSE(fs::exists(folder_ / "none.png"));
  EXPECT_FALSE(fs::exists(folder_ / "ball.zarr.index"));
}

}  // namespace
}  // namespace isolux::test
