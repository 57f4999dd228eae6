#include "volume/statistics/white_matter.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/volumes.h"

namespace isolux::volume {
namespace {

// Folds of white and grey matter about a ventricle, under 3 mm of fluid, and, of a head, skull and fat.
Grid brain(bool inHead, double grey, double white, double noise) {
  const GridGeometry geometry = GridGeometry::make({90, 90, 90}, {2.0, 2.0, 2.0});
  const Grid clean = test::gridOfWorld(geometry, [&](glm::dvec3 p) {
    const double r = glm::length(p - 89.0);
    if (r < 28.0) return 60.0;
    if (r < 64.0) return std::cos(0.25 * p.x) * std::cos(0.25 * p.y) > 0.1 ? white : grey;
    if (r < 67.0) return 30.0;
    if (!inHead) return 0.0;
    if (r < 74.0) return 8.0;
    return r < 82.0 ? 220.0 : 0.0;
  });
  return test::withNoise(clean, noise, glm::dvec3(0.0), 7);
}

TEST(WhiteMatter, IsFoundInABrainAndInAHead) {
  base::Progress progress;
  for (const bool inHead : {false, true}) {
    const auto found = whiteMatterOf(brain(inHead, 95.0, 125.0, 4.0), 40.0, progress);
    ASSERT_TRUE(found) << inHead;
    EXPECT_NEAR(found->border, 110.0, 5.0) << inHead;
    EXPECT_NEAR(found->mean, 125.0, 2.0) << inHead;
  }
}

TEST(WhiteMatter, IsNotFoundWhereTheTissuesAreNone) {
  base::Progress progress;
  EXPECT_FALSE(whiteMatterOf(brain(true, 30.0, 220.0, 4.0), 20.0, progress)) << "too far apart";
  const Grid vessels = test::gridOfWorld(GridGeometry::make({90, 90, 90}, {2.0, 2.0, 2.0}), [](glm::dvec3 p) {
    const double r = glm::length(p - 89.0);
    if (r > 80.0) return 0.0;
    return glm::length(glm::dvec2(p) - 89.0) < 8.0 ? 250.0 : 90.0;
  });
  EXPECT_FALSE(whiteMatterOf(test::withNoise(vessels, 4.0, glm::dvec3(0.0), 3), 40.0, progress));
  EXPECT_FALSE(whiteMatterOf(brain(true, 95.0, 125.0, 4.0), 1000.0, progress)) << "nothing is above";
}

}  // namespace
}  // namespace isolux::volume
