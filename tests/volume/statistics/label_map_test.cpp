// Segmentations are told from scans, also from those of few values.
#include "volume/statistics/label_map.h"

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/test_data.h"
#include "volume/phantom/phantom.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/read/reader.h"

namespace isolux::volume {
namespace {

constexpr int kSize = 40;

template <class T = std::uint8_t>
Grid gridOf(const std::function<double(glm::dvec3)>& valueAt) {
  std::vector<T> voxels;
  for (int z = 0; z < kSize; ++z)
    for (int y = 0; y < kSize; ++y)
      for (int x = 0; x < kSize; ++x) voxels.push_back(static_cast<T>(valueAt({x, y, z})));
  return Grid(GridGeometry::make(glm::ivec3(kSize), glm::dvec3(1)), std::move(voxels));
}

// Five balls that touch and overlap, each of its own number.
double organs(glm::dvec3 p) {
  double label = 0.0;
  for (int i = 0; i < 5; ++i)
    if (glm::length(p - glm::dvec3(8 + 6 * i, 20 - 3 * (i % 2), 16 + 2 * i)) < 7.0) label = i + 1;
  return label;
}

double ballDistance(glm::dvec3 p) {
  return glm::length(p - glm::dvec3(0.5 * kSize));
}

std::optional<LabelMap> found(const Grid& grid) {
  base::Progress progress;
  return labelMapOf(grid, false, progress);
}

TEST(LabelMaps, AreFewWholeNumbersThatJump) {
  const auto map = found(gridOf(organs));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->labels, 5);
  EXPECT_EQ(map->background, 0.0);
  EXPECT_TRUE(found(gridOf<float>(organs))) << "stored as floats";
  EXPECT_EQ(found(gridOf<std::uint16_t>([](glm::dvec3 p) { return 200.0 * organs(p); }))->labels, 5)
      << "an atlas counts by its own numbers";
}

TEST(LabelMaps, ScansAndSmoothFieldsAreNone) {
  EXPECT_FALSE(found(gridOf([](glm::dvec3 p) { return ballDistance(p) < 12.0 ? 1.0 : 0.0; })))
      << "a mask has one isosurface";
  EXPECT_FALSE(found(gridOf([](glm::dvec3 p) { return std::max(0.0, 16.0 - ballDistance(p)); })))
      << "a smooth field in steps of one";
  EXPECT_FALSE(found(gridOf([](glm::dvec3 p) {
    return 8.0 * std::round(std::max(0.0, 16.0 - ballDistance(p)) / 4);
  }))) << "and in coarse ones";
  const auto inBlock = [](glm::dvec3 p) {  // 20 voxels wide, along the axes, or needles beside it
    const bool needle = p.x > 30 && std::fmod(p.y, 6) < 1 && std::fmod(p.z, 6) < 1;
    return needle || (p.x > 8 && p.x < 28 && p.y > 7 && p.y < 32 && p.z > 8 && p.z < 30);
  };
  EXPECT_FALSE(found(gridOf([&](glm::dvec3 p) {
    double sum = 0.0;
    for (int i = 0; i < 8; ++i) sum += inBlock(p + 0.5 * glm::dvec3(i & 1, i / 2 & 1, i / 4)) ? 22.0 : 0.0;
    return sum;
  }))) << "a mask that was averaged";
  EXPECT_FALSE(found(gridOf([](glm::dvec3 p) {  // steep, so that its borders jump
    if (ballDistance(p) < 14.0) return std::clamp(std::floor(12.0 * (14.0 - ballDistance(p))), 0.0, 90.0);
    return p.z < 6 ? 4.0 : p.x < 6 ? 2.0 : 0.0;
  }))) << "a scan without noise of constant things";
  std::uint64_t counter = 0;
  EXPECT_FALSE(found(gridOf([&](glm::dvec3 p) {
    return 20.0 * organs(p) + 8.0 * base::uniformNoise(7, counter++);
  }))) << "noise";
  EXPECT_FALSE(found(gridOf<float>([](glm::dvec3 p) { return 0.25 * organs(p); }))) << "no whole numbers";
}

TEST(LabelMaps, TheBackgroundIsZeroElseTheMostFrequentEnd) {
  const auto backgroundOf = [](std::vector<std::int16_t> values) {
    base::Progress progress;
    const glm::ivec3 dims(static_cast<int>(values.size()), 1, 1);
    const Grid grid(GridGeometry::make(dims, glm::dvec3(1)), std::move(values));
    return labelMapOf(grid, true, progress);
  };
  EXPECT_EQ(backgroundOf({0, 3, 3, 3})->background, 0.0) << "however rare";
  EXPECT_EQ(backgroundOf({-1, 0, 0, 3})->background, 0.0);
  EXPECT_FALSE(backgroundOf({-1, 0, 0, 3})->isOutermost);
  EXPECT_EQ(backgroundOf({1, 9, 9, 3})->background, 9.0);
  EXPECT_EQ(backgroundOf({1, 3, 3, 9})->background, 1.0);
  EXPECT_EQ(backgroundOf({1, 3, 3, 9})->labels, 2);
}

TEST(LabelMaps, FourThousandLabelsAreFound) {
  const auto map = found(gridOf<std::uint16_t>([](glm::dvec3 p) {
    const glm::ivec3 cell = glm::ivec3(p) * 16 / kSize;
    return 16.0 * (16.0 * cell.z + cell.y) + cell.x;
  }));
  ASSERT_TRUE(map);
  EXPECT_EQ(map->labels, 4095);
}

TEST(LabelMaps, VoxelsAreCountedWhateverTheirType) {
  base::Progress progress;
  const auto valueAt = [](glm::dvec3 p) { return organs(p) == 0.0 ? -3.0 : organs(p); };
  const ValueCounts wanted = [&] {
    ValueCounts counts;
    for (int i = 0; i < kSize * kSize * kSize; ++i)
      ++counts[valueAt(glm::dvec3(i % kSize, i / kSize % kSize, i / kSize / kSize))];
    return counts;
  }();
  EXPECT_EQ(valueCounts(gridOf<std::int8_t>(valueAt), 6, progress), wanted);
  EXPECT_EQ(valueCounts(gridOf<std::int16_t>(valueAt), 6, progress), wanted);
  EXPECT_EQ(valueCounts(gridOf<float>(valueAt), 6, progress), wanted);
  EXPECT_FALSE(valueCounts(gridOf<std::int8_t>(valueAt), 5, progress)) << "too many";
}

TEST(LabelMaps, OfTheTestDataNoneIsOne) {
  ISOLUX_NEEDS_DATA();
  base::Progress progress;
  int volumes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(test::dataFolder() / "volumes")) {
    const std::string name = entry.path().filename().string();
    if (!name.ends_with(".mhd") && !name.ends_with(".nii.gz")) continue;
    EXPECT_FALSE(found(*readVolume(entry.path().string(), {}, progress).grid)) << name;
    ++volumes;
  }
  EXPECT_GE(volumes, 5);
}

// No isovalue between labels, no noise, and the file is said to be what it is.
TEST(LabelMaps, AreShownAsOneSurfaceAndSaidToBeLabels) {
  base::Progress progress;
  Volume volume;
  volume.grid = std::make_shared<Grid>(gridOf(organs));
  const auto prepared = prepareVolume(std::move(volume), progress);
  EXPECT_EQ(prepared->volume.labels, 5);
  EXPECT_EQ(prepared->facts.suggestedIsovalue, 0.5);
  EXPECT_EQ(prepared->facts.suggestedIsovalues, std::vector<double>{0.5});
  EXPECT_EQ(prepared->derivativeChoices->noise(progress).at(0.5), 0.0);
  ASSERT_FALSE(prepared->volume.warnings.empty());
  EXPECT_NE(prepared->volume.warnings.back().find("label map of 5 labels"), std::string::npos);
}

}  // namespace
}  // namespace isolux::volume
