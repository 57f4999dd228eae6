#include "volume/statistics/histogram.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include <gtest/gtest.h>

#include "base/random.h"
#include "tests/support/test_data.h"
#include "tests/support/unwatched.h"
#include "volume/phantom/phantom.h"
#include "volume/read/reader.h"

namespace isolux::volume {
namespace {

Grid lineOf(VoxelArray voxels, double slope = 1.0, double intercept = 0.0) {
  const auto count = static_cast<int>(std::visit([](const auto& v) { return v.size(); }, voxels));
  return Grid(GridGeometry::make({count, 1, 1}, glm::dvec3(1)), std::move(voxels), slope, intercept);
}

std::uint64_t total(const Histogram& histogram) {
  return std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0});
}

TEST(Histogram, FewIntegersGetOneBinPerValue) {
  const Grid grid = lineOf(std::vector<std::uint8_t>{3, 3, 5, 7, 7, 7}, 2.0, 1.0);
  const Histogram histogram = makeHistogram(grid);
  EXPECT_EQ(histogram.counts, (std::vector<std::uint64_t>{2, 0, 1, 0, 3}));
  EXPECT_EQ(histogram.binCentre(0), 7.0);
  EXPECT_EQ(histogram.binCentre(4), 15.0);
  EXPECT_EQ(histogram.minimum, 6.0);
  EXPECT_EQ(histogram.maximum, 16.0);
}

TEST(Histogram, ManyIntegersShareBinsOfWholeValues) {
  std::vector<std::int16_t> voxels(65536);
  for (std::size_t i = 0; i < voxels.size(); ++i)
    voxels[i] = static_cast<std::int16_t>(static_cast<int>(i) - 32768);
  const Histogram histogram = makeHistogram(lineOf(std::move(voxels)), 500);
  ASSERT_LE(histogram.counts.size(), 500u);
  EXPECT_EQ(total(histogram), 65536u);
  for (std::size_t i = 0; i + 1 < histogram.counts.size(); ++i) EXPECT_EQ(histogram.counts[i], 132u);
}

TEST(Histogram, NegativeSlopeTurnsItRound) {
  const Histogram histogram = makeHistogram(lineOf(std::vector<std::uint8_t>{0, 1, 1}, -1.0));
  EXPECT_EQ(histogram.counts, (std::vector<std::uint64_t>{2, 1}));
  EXPECT_EQ(histogram.binCentre(0), -1.0);
}

TEST(Histogram, FloatsAreSpreadOverTheRangeAndMissingOnesLeftOut) {
  const Grid grid =
      lineOf(std::vector<float>{0.0f, 0.24f, 0.26f, 1.0f, std::numeric_limits<float>::quiet_NaN(), 0.99f});
  const Histogram histogram = makeHistogram(grid, 4);
  EXPECT_EQ(histogram.counts, (std::vector<std::uint64_t>{2, 1, 0, 2}));
}

// Nothing of the stored numbers is left in the values: bins must come from the numbers themselves.
TEST(Histogram, CountsEveryVoxelWhereTheScalingMapsAllValuesToOne) {
  for (const double slope : {1e-20, -1e-20, 1e-17}) {
    std::vector<std::int16_t> integers(65536);
    std::vector<float> floats;
    for (std::size_t i = 0; i < integers.size(); ++i) {
      integers[i] = static_cast<std::int16_t>(static_cast<int>(i) - 32768);
      floats.push_back(static_cast<float>(integers[i]));
    }
    for (const Grid& grid :
         {lineOf(std::move(integers), slope, 1.0), lineOf(std::move(floats), slope, 1.0)}) {
      EXPECT_EQ(grid.storedMinimum(), -32768.0);
      EXPECT_EQ(grid.storedMaximum(), 32767.0);
      const Histogram histogram = makeHistogram(grid);
      EXPECT_EQ(histogram.counts.size(), 512u);
      for (const std::uint64_t count : histogram.counts) EXPECT_NEAR(static_cast<double>(count), 128.0, 1.0);
    }
  }
}

TEST(Histogram, ConstantEmptyTinyAndHugeValuesWork) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN(), most = std::numeric_limits<float>::max();
  const Grid constant = lineOf(std::vector<float>{2.5f, 2.5f});
  const Histogram one = makeHistogram(constant);
  EXPECT_EQ(one.counts, (std::vector<std::uint64_t>{2}));
  EXPECT_EQ(one.binCentre(0), 2.5);
  EXPECT_EQ(suggestIsovalue(constant, one, ""), 2.5);
  const Grid none = lineOf(std::vector<float>{nan, nan});
  EXPECT_EQ(total(makeHistogram(none)), 0u);
  EXPECT_TRUE(std::isfinite(suggestIsovalue(none, makeHistogram(none), "HU")));
  for (const Grid& grid :
       {lineOf(std::vector<float>{0.0f, 1e-20f, 2e-20f}), lineOf(std::vector<float>{-most, 0.0f, most}),
        lineOf(std::vector<float>{1e6f, 1e6f + 0.0625f})}) {
    const Histogram histogram = makeHistogram(grid);
    EXPECT_EQ(total(histogram), grid.geometry().voxelCount());
    const double iso = suggestIsovalue(grid, histogram, "");
    EXPECT_LT(grid.minimum(), iso);
    EXPECT_LT(iso, grid.maximum());
  }
}

TEST(Histogram, PeaksOfThreeTissuesAreFound) {
  std::vector<float> voxels;
  for (std::uint64_t i = 0; i < 60000; ++i) {
    const double centre = i < 40000 ? 0.0 : i < 55000 ? 60.0 : 150.0;
    voxels.push_back(static_cast<float>(centre + 6.0 * base::normalNoise(1, i)));
  }
  const Histogram histogram = makeHistogram(lineOf(std::move(voxels)), 256);
  ASSERT_GE(histogram.peaks.size(), 3u);
  EXPECT_LE(histogram.peaks.size(), 8u);
  for (const double expected : {0.0, 60.0, 150.0}) {
    bool found = false;
    for (std::size_t i = 0; i < 3; ++i) found = found || std::abs(histogram.peaks[i] - expected) < 4.0;
    EXPECT_TRUE(found) << expected;
  }
}

TEST(SuggestIsovalue, IsTheSkinForCtInHounsfieldUnits) {
  base::Progress progress;
  const Grid head = makePhantom(parsePhantom("head:48"), progress);
  EXPECT_EQ(suggestIsovalue(head, makeHistogram(head), "HU"), -300.0);
  const Grid brain = lineOf(std::vector<std::int16_t>{0, 20, 40, 80});
  EXPECT_GT(suggestIsovalue(brain, makeHistogram(brain), "HU"), 0.0);
}

TEST(SuggestIsovalue, SeparatesTheObjectsFromTheBackgroundOrEachOther) {
  // Much noisy background, two materials: any isovalue above the background shows an object.
  std::vector<std::uint8_t> voxels;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double centre = i < 80000 ? 10.0 : i < 95000 ? 90.0 : 200.0;
    voxels.push_back(static_cast<std::uint8_t>(std::max(0.0, centre + 3.0 * base::normalNoise(2, i))));
  }
  const Grid grid = lineOf(std::move(voxels));
  const double iso = suggestIsovalue(grid, makeHistogram(grid), "");
  EXPECT_GT(iso, 30.0);
  EXPECT_LT(iso, 190.0);
  const Grid binary = lineOf(std::vector<std::uint8_t>{0, 0, 0, 0, 0, 1, 1});
  EXPECT_EQ(suggestIsovalue(binary, makeHistogram(binary), ""), 0.5);
}

// What is weak at the border belongs to the object: its least class is not left out, nor is half of it, where
// more of it is strong.
TEST(SuggestIsovalue, IsTheBorderOfTheWholeObject) {
  std::vector<std::uint8_t> leaves, scalp, negative;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    const double noise = 3.0 * base::normalNoise(5, i);
    leaves.push_back(static_cast<std::uint8_t>(std::max(0.0, (i < 90000   ? 4.0
                                                              : i < 94000 ? 60.0
                                                              : i < 96000 ? 110.0
                                                                          : 200.0) +
                                                                 noise)));
    scalp.push_back(static_cast<std::uint8_t>(std::max(0.0, (i < 70000   ? 4.0
                                                             : i < 76000 ? 70.0
                                                                         : 140.0) +
                                                                3.0 * noise)));
    negative.push_back(static_cast<std::uint8_t>(255 - leaves.back()));
  }
  const auto suggested = [](std::vector<std::uint8_t> voxels) {
    const Grid grid = lineOf(std::move(voxels));
    return suggestIsovalue(grid, makeHistogram(grid), "");
  };
  const double ofLeaves = suggested(leaves);
  EXPECT_GT(ofLeaves, 20.0);
  EXPECT_LT(ofLeaves, 55.0);
  EXPECT_NEAR(suggested(negative), 255.0 - ofLeaves, 1.5) << "a bright background";
  const double ofScalp = suggested(scalp);
  EXPECT_GT(ofScalp, 20.0);
  EXPECT_LT(ofScalp, 62.0);
}

// Of the test data, what experts show first.
TEST(SuggestIsovalue, IsWhatExpertsTake) {
  ISOLUX_NEEDS_DATA();
  struct Known {
    const char* file;
    double least, most;
  };
  const Known all[] = {{"tooth.mhd", 540, 700},
                       {"mri_head_t1.nii.gz", 34, 48},
                       {"mri_colin27.nii.gz", 34, 48},
                       {"bonsai.nii.gz", 30, 50},
                       {"engine_crop.mhd", 60, 100},
                       {"viscous_fingers_060.mhd", 14, 26},
                       {"viscous_fingers_030.mhd", 14, 26},
                       {"heptane.nii.gz", 35, 65},
                       {"fuel.nii.gz", 30, 60},
                       {"ct_cranium.mhd", -300, -300},
                       {"ct_head_skin_bone.nii.gz", 0.15, 0.21},
                       {"teapot.mhd", 25, 62}};
  for (const Known& one : all) {
    base::Progress progress;
    const Volume volume = readVolume(test::dataFolder() / "volumes" / one.file, {}, progress);
    const double value = suggestIsovalue(*volume.grid, makeHistogram(*volume.grid), volume.unit);
    EXPECT_GE(value, one.least) << one.file;
    EXPECT_LE(value, one.most) << one.file;
  }
}

// Classes of values with some spread, as many voxels of each as given.
Grid classes(const std::vector<std::pair<double, int>>& meansAndCounts, double spread = 6.0) {
  std::uint64_t counter = 0;
  const auto uniform = [&counter] { return base::uniformNoise(7, counter++); };
  std::vector<float> voxels;
  for (const auto& [mean, count] : meansAndCounts)
    for (int i = 0; i < count; ++i)
      voxels.push_back(static_cast<float>(mean + spread * (uniform() + uniform() - 1.0)));
  return lineOf(std::move(voxels));
}

TEST(Histogram, SuggestsABorderForEachClass) {
  struct Case {
    const char* what;
    Grid grid;
    std::string unit;
    std::vector<std::pair<double, double>> within;  // of each suggestion
  };
  const std::vector<Case> cases = {
      {"air, tissue and bone of a CT",
       classes({{-1000, 5000}, {40, 3000}, {900, 800}}),
       "HU",
       {{-300, -300}, {300, 300}}},
      {"three classes", classes({{0, 6000}, {100, 3000}, {220, 1000}}), "", {{40, 70}, {120, 200}}},
      {"object and background", classes({{10, 6000}, {150, 2000}}), "", {{20, 150}}},
      {"a bright background", classes({{200, 6000}, {100, 3000}, {20, 1000}}), "", {{40, 80}, {130, 170}}},
      {"four classes",
       classes({{0, 8000}, {60, 3000}, {120, 2000}, {240, 1500}}),
       "",
       {{20, 70}, {130, 190}}},
      {"one value", lineOf(std::vector<float>{3, 3, 3}), "", {{3, 3}}}};
  for (const Case& one : cases) {
    SCOPED_TRACE(one.what);
    const Histogram histogram = makeHistogram(one.grid);
    const double first = suggestIsovalue(one.grid, histogram, one.unit);
    const std::vector<double> found = suggestIsovalues(one.grid, histogram, one.unit, first);
    EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
    EXPECT_EQ(std::count(found.begin(), found.end(), first), 1);
    for (const auto& [low, high] : one.within)
      EXPECT_TRUE(std::any_of(
          found.begin(), found.end(),
          [&, least = low, most = high](double value) { return least <= value && value <= most; }))
          << low << ".." << high << ": " << ::testing::PrintToString(found);
  }
}

}  // namespace
}  // namespace isolux::volume
