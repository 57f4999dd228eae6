// What a coarser level hides: of blocks by hand, along rays by steps.
#include "volume/large/lost_structure.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/rays.h"
#include "tests/support/test_data.h"
#include "volume/large/coarse_level.h"
#include "volume/large/index_file.h"
#include "volume/read/volume_file.h"

namespace isolux::volume {
namespace {

constexpr glm::ivec3 kGapDims{67, 50, 61};
constexpr double kGapIsovalue = 100.0;

// A ball, which any level shows, a needle of one voxel, which no coarser one does, and a sheet of three
// voxels, which level 1 shows and level 3 does not.
std::uint8_t ballNeedleAndSheet(int x, int y, int z) {
  if (y == 5 && z == 50 && x > 3 && x < 60) return 180;
  if (x >= 56 && x <= 58 && y > 20 && z < 40) return 180;
  const double depth = 14.0 - std::hypot(x - 22.0, y - 27.0, z - 22.0);
  return static_cast<std::uint8_t>(std::lround(std::clamp(100.0 + 10.0 * depth, 0.0, 255.0)));
}

class LostStructureTest : public testing::Test {
 protected:
  scene::Source written(const auto& value) {
    std::ofstream file(folder_ / "volume.raw", std::ios::binary);
    for (int z = 0; z < kGapDims.z; ++z)
      for (int y = 0; y < kGapDims.y; ++y)
        for (int x = 0; x < kGapDims.x; ++x) file.put(static_cast<char>(value(x, y, z)));
    scene::Source source;
    source.path = (folder_ / "volume.raw").string();
    source.raw = "67x50x61 uint8 spacing 0.5,1,2";
    return source;
  }
  IndexedVolume indexed(const scene::Source& source) {
    std::optional<VolumeIndex> index;
    IndexFile(source.path, readOptions(source))
        .make(*openSource(source, progress_).parts, {}, index, progress_);
    return indexedVolume(source, progress_).value();
  }
  Volume level(scene::Source source, int n) {
    source.level = n;
    return readLevel(openSource(source, progress_), source, progress_);
  }

  std::filesystem::path folder_ = test::temporaryFolder();
  base::Progress progress_;
};

bool crossed(const Grid& grid, glm::ivec3 low, glm::ivec3 high) {
  bool below = false, above = false;
  for (int z = low.z; z <= high.z; ++z)
    for (int y = low.y; y <= high.y; ++y)
      for (int x = low.x; x <= high.x; ++x) (grid.value(x, y, z) < kGapIsovalue ? below : above) = true;
  return below && above;
}

// Of the block that holds a cell: from the voxels, and the level's voxels around its ends.
bool isGap(const Grid& whole, const Grid& level, glm::ivec3 cell) {
  const glm::ivec3 low = cell / 8 * 8, high = glm::min(low + 8, whole.dims() - 1);
  if (!crossed(whole, low, high)) return false;
  glm::ivec3 from, to;
  for (int axis = 0; axis < 3; ++axis) {
    const double f = std::round(level.geometry().spacingMm()[axis] / whole.geometry().spacingMm()[axis]);
    const int last = level.dims()[axis] - 1;  // voxel n of the level lies at f n + (f - 1) / 2
    from[axis] = std::clamp(static_cast<int>(std::floor((low[axis] - 0.5 * (f - 1.0)) / f)), 0, last);
    to[axis] = std::clamp(static_cast<int>(std::ceil((high[axis] - 0.5 * (f - 1.0)) / f)), 0, last);
  }
  return !crossed(level, from, to);
}

TEST_F(LostStructureTest, RaysMeetWhatTheLevelHides) {
  const scene::Source source = written(ballNeedleAndSheet);
  const IndexedVolume whole = indexed(source);
  const Volume fine = readVolume(source.path, readOptions(source), progress_);
  const std::vector<double> isovalues{kGapIsovalue};
  for (const int n : {1, 2, 3}) {
    const Volume coarse = level(source, n);
    const LostStructure gaps(whole, *coarse.grid, isovalues, progress_);
    const glm::ivec3 blockDims = (kGapDims + 6) / 8;
    std::vector<bool> expectedGaps;
    for (int z = 0; z < blockDims.z; ++z)
      for (int y = 0; y < blockDims.y; ++y)
        for (int x = 0; x < blockDims.x; ++x)
          expectedGaps.push_back(isGap(*fine.grid, *coarse.grid, 8 * glm::ivec3(x, y, z)));
    const auto residualAt = [&](glm::ivec3 cell) {
      const glm::ivec3 b = cell / 8;
      return expectedGaps[static_cast<std::size_t>((b.z * blockDims.y + b.y) * blockDims.x + b.x)];
    };
    const auto blocks = static_cast<std::size_t>(std::count(expectedGaps.begin(), expectedGaps.end(), true));
    EXPECT_EQ(gaps.count(), blocks) << n;
    EXPECT_GT(blocks, 0U) << n;
    int met = 0;
    for (std::uint64_t i = 0; i < 400; ++i) {
      const Ray ray = test::randomRay(i, kGapDims);
      bool expected = false;
      for (double t = 0.0; t < 400.0 && !expected; t += 0.01) {
        const glm::dvec3 p = ray.origin + t / glm::length(ray.direction) * ray.direction;
        const glm::ivec3 cell(glm::floor(p));
        if (glm::all(glm::greaterThanEqual(cell, glm::ivec3(0))) &&
            glm::all(glm::lessThan(cell, kGapDims - 1)))
          expected = residualAt(cell);
      }
      if (expected != gaps.on(ray)) {  // a corner that steps pass by
        Ray beside = ray;
        beside.origin += 0.02;
        EXPECT_NE(gaps.on(beside), gaps.on(ray)) << n << ' ' << i;
      }
      met += expected;
    }
    EXPECT_GT(met, 20) << n;
    // Along the needle, and along the sheet, before and behind their ends.
    EXPECT_TRUE(gaps.on({{-5.0, 5.0, 50.0}, {1.0, 0.0, 0.0}}));
    EXPECT_FALSE(gaps.on({{-5.0, 5.0, 50.0}, {1.0, 0.0, 0.0}, 0.0, 4.9}));
    EXPECT_EQ(gaps.on({{57.0, 60.0, 10.0}, {0.0, -1.0, 0.0}}), n == 3) << n;
    EXPECT_FALSE(gaps.on({{22.0, 27.0, -5.0}, {0.0, 0.0, 1.0}, 0.0, 40.0})) << "through the ball";
  }
}

TEST_F(LostStructureTest, OtherIsovaluesAndLevelsThatShowAllHideNothing) {
  const scene::Source needle = written(ballNeedleAndSheet);
  const IndexedVolume whole = indexed(needle);
  const Volume coarse = level(needle, 2);
  const std::vector<double> outside{300.0}, two{300.0, kGapIsovalue}, one{kGapIsovalue};
  EXPECT_EQ(LostStructure(whole, *coarse.grid, outside, progress_).count(), 0U);
  EXPECT_EQ(LostStructure(whole, *coarse.grid, two, progress_).count(),
            LostStructure(whole, *coarse.grid, one, progress_).count());
  const scene::Source ramp = written([](int x, int y, int z) { return x + y + z; });
  EXPECT_EQ(LostStructure(indexed(ramp), *level(ramp, 2).grid, one, progress_).count(), 0U);
}

TEST_F(LostStructureTest, WithoutAnIndexNothingIsKnown) {
  scene::Source source = written(ballNeedleAndSheet);
  EXPECT_FALSE(indexedVolume(source, progress_));
  indexed(source);
  source.level = 2;
  EXPECT_TRUE(indexedVolume(source, progress_));
  std::filesystem::last_write_time(source.path,
                                   std::filesystem::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_FALSE(indexedVolume(source, progress_)) << "of another state of the file";
}

}  // namespace
}  // namespace isolux::volume
