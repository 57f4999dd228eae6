// Segmentations are told from scans, also from those of few values.
#include "volume/statistics/label_map.h"

#include <cmath>
#include <cstdint>
#include <functional>
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
  return labelMapOf(grid, false, base::Progress());
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

TEST(LabelMaps, OfTheTestDataNoneIsOne) {
  ISOLUX_NEEDS_DATA();
  base::Progress progress;
  for (const char* name :
       {"teapot.mhd", "hydrogen_atom.mhd", "engine.nii.gz", "bonsai.nii.gz", "heptane.nii.gz"})
    EXPECT_FALSE(found(*readVolume(test::dataFolder() / "volumes" / name, {}, progress).grid)) << name;
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
