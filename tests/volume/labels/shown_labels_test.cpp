// Which labels a text names, which label a point has, and what a label map becomes when it is loaded.
#include "volume/labels/shown_labels.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/label_volumes.h"

namespace isolux::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using volume::LabelBlocks;
using volume::LabelTable;
using volume::ShownLabels;

LabelBlocks shownBlocksOf(volume::Grid grid) {
  base::Progress progress;
  return LabelBlocks(std::make_shared<const volume::Grid>(std::move(grid)), "f", progress);
}

// Labels 0, 2, 4, 5, 9 and -3.
LabelBlocks someLabels() {
  std::vector<std::int16_t> voxels{0, 2, 4, 5, 9, -3, 0, 2};
  return shownBlocksOf(volume::Grid(unitGeometry(glm::ivec3(2)), std::move(voxels)));
}

LabelTable names() {
  return {"", "", {{.value = 2, .name = "Liver"}, {.value = 4, .name = "Left kidney"}}};
}

TEST(ShownLabels, ATextNamesThemByNumberRangeAndName) {
  const LabelBlocks blocks = someLabels();
  const LabelTable table = names();
  const auto named = [&](const char* text) { return volume::labelsNamed(text, blocks, &table); };
  EXPECT_THAT(named(""), ElementsAre(-3, 2, 4, 5, 9));
  EXPECT_THAT(named(" 9 , 2"), ElementsAre(2, 9));
  EXPECT_THAT(named("3-7,2"), ElementsAre(2, 4, 5));
  EXPECT_THAT(named("-3"), ElementsAre(-3));
  EXPECT_THAT(named("-5--1,0"), ElementsAre(-3, 0));
  EXPECT_THAT(named("left Kidney,LIVER,4"), ElementsAre(2, 4));
  for (const char* bad : {"7", "6-8", "spleen", "livr", "2-x", ",", "values"}) {
    try {
      (void)named(bad);
      ADD_FAILURE() << bad;
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::usage) << bad;
      EXPECT_THAT(error.what(), HasSubstr("source.labels")) << bad;
    }
  }
}

TEST(ShownLabels, EverySetHasATextThatNamesIt) {
  const LabelBlocks blocks = someLabels();
  const LabelTable table = names();
  for (unsigned set = 1; set < 64; ++set) {
    std::vector<int> labels;
    for (std::size_t i = 0; i < 6; ++i)
      if (set >> i & 1) labels.push_back(blocks.list()[i].label);
    const std::string text = volume::textOfLabels(labels, blocks);
    EXPECT_EQ(volume::labelsNamed(text, blocks, &table), labels) << text;
  }
  EXPECT_EQ(volume::textOfLabels({-3, 2, 4, 5, 9}, blocks), "");
  EXPECT_EQ(volume::textOfLabels({2, 4, 5}, blocks), "2-5");
}

// The uniform cubic B-spline as it is defined, of a distance.
double splineOf(double x) {
  const double a = std::abs(x);
  if (a >= 2.0) return 0.0;
  return a >= 1.0 ? std::pow(2.0 - a, 3.0) / 6.0 : 2.0 / 3.0 - a * a + 0.5 * a * a * a;
}

TEST(ShownLabels, APointHasTheLabelOfTheLargestWeight) {
  std::mt19937_64 random(3);
  constexpr int n = 12;
  std::vector<std::uint8_t> voxels(n * n * n);
  for (auto& voxel : voxels) voxel = static_cast<std::uint8_t>(random() % 5);
  const volume::Grid grid(unitGeometry(glm::ivec3(n)), voxels);
  base::Progress progress;
  const auto blocks =
      std::make_shared<const LabelBlocks>(std::make_shared<const volume::Grid>(grid), "f", progress);
  const auto shown = volume::showLabels(blocks, nullptr, "1-3", 1.0, nullptr, progress);
  std::uniform_real_distribution<double> inside(0.0, n - 1.0);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 p(inside(random), inside(random), inside(random));
    std::map<int, double> sums;
    for (int z = -2; z < n + 2; ++z)
      for (int y = -2; y < n + 2; ++y)
        for (int x = -2; x < n + 2; ++x) {
          const double weight = splineOf(p.x - x) * splineOf(p.y - y) * splineOf(p.z - z);
          const glm::ivec3 at = glm::clamp(glm::ivec3(x, y, z), glm::ivec3(0), glm::ivec3(n - 1));
          const int label = static_cast<int>(grid.value(at));
          if (weight > 0.0 && label >= 1 && label <= 3) sums[label] += weight;
        }
    const auto label = volume::labelAt(*shown, p);
    ASSERT_EQ(label.has_value(), !sums.empty());
    if (!label) continue;
    for (const auto& [other, sum] : sums) ASSERT_LE(sum, sums[*label] + 1e-12) << other;
  }
}

TEST(ShownLabels, EqualWeightsGiveTheSmallerLabel) {
  const volume::Grid grid(unitGeometry(glm::ivec3(2)), std::vector<std::uint8_t>{7, 3, 7, 3, 7, 3, 7, 3});
  base::Progress progress;
  const auto shown = volume::showLabels(
      std::make_shared<const LabelBlocks>(std::make_shared<const volume::Grid>(grid), "f", progress), nullptr,
      "", 0.0, nullptr, progress);
  EXPECT_EQ(volume::labelAt(*shown, glm::dvec3(0.5, 0.5, 0.5)), 3);
}

TEST(ShownLabels, ALoadedLabelMapIsItsMaskField) {
  const auto all = loadedLabels(threeLabels());
  ASSERT_TRUE(all->labels);
  EXPECT_THAT(all->labels->mask.labels, ElementsAre(1, 2, 3));
  EXPECT_EQ(all->volume.labels, 3);
  EXPECT_EQ(all->facts.suggestedIsovalue, 0.0);
  EXPECT_EQ(&all->grid(), all->labels->mask.grid.get());
  const scene::Scene resolved = scene::resolve(scene::Scene{}, all->facts);
  EXPECT_EQ(resolved.surfaces.front().value, 0.0);
  EXPECT_EQ(resolved.source.kind, scene::DataKind::labels);
  EXPECT_EQ(resolved.derivatives.noise.value_or(0.0), 0.0);

  scene::Source other;
  other.labels = "2-3";
  other.smoothing = 1.0;
  base::Progress progress;
  const auto two = volume::showOtherLabels(*all, other, progress), same = loadedLabels(threeLabels(), "2-3");
  EXPECT_THAT(two->labels->mask.labels, ElementsAre(2, 3));
  EXPECT_EQ(two->grid().hash(), same->grid().hash()) << "as if it had been loaded so";
  EXPECT_EQ(two->volume.warnings, same->volume.warnings);
  for (std::size_t i = 0; i < same->blocks->count(); ++i) {
    EXPECT_EQ(two->blocks->minimum(i), same->blocks->minimum(i));
    EXPECT_EQ(two->blocks->maximum(i), same->blocks->maximum(i));
  }
  std::vector<std::uint8_t> flags;
  std::vector<std::uint64_t> boxes, expected;
  const float isovalue = 0.0f;
  same->blocks->activeBlocks(isovalue, flags);
  two->boxes->masks(std::span(&isovalue, 1), flags, boxes);
  same->boxes->masks(std::span(&isovalue, 1), flags, expected);
  EXPECT_EQ(boxes, expected);
  EXPECT_EQ(two->histogram.counts, same->histogram.counts);
  EXPECT_EQ(two->facts.boundsMinMm, same->facts.boundsMinMm);
  EXPECT_EQ(two->facts.outlineMm, same->facts.outlineMm);
  EXPECT_NE(two->grid().hash(), all->grid().hash());
}

TEST(ShownLabels, AsValuesTheyStayWhatTheyWere) {
  const auto values = loadedLabels(threeLabels(), scene::kLabelsAsValues);
  EXPECT_FALSE(values->labels);
  EXPECT_EQ(values->grid().hash(), threeLabels().hash());
  EXPECT_EQ(values->facts.suggestedIsovalue, 0.5);
}

}  // namespace
}  // namespace isolux::test
