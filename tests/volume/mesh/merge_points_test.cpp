#include "volume/mesh/merge_points.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/stop_latency.h"

namespace isolux::volume {
namespace {

std::vector<glm::dvec3> randomPoints(std::size_t count, double width) {
  std::vector<glm::dvec3> points;
  for (std::uint64_t i = 0; i < count; ++i)
    points.push_back(
        width * glm::dvec3(base::uniformNoise(1, i), base::uniformNoise(2, i), base::uniformNoise(3, i)) -
        5.0);
  return points;
}

// The definition: each point looks at all before it.
std::vector<int> mergedByDefinition(const std::vector<glm::dvec3>& points, double tolerance) {
  std::vector<int> result;
  for (std::size_t i = 0; i < points.size(); ++i) {
    int found = static_cast<int>(i);
    for (std::size_t k = i; k-- > 0;)
      if (result[k] == static_cast<int>(k) &&
          glm::dot(points[i] - points[k], points[i] - points[k]) <= tolerance * tolerance)
        found = static_cast<int>(k);
    result.push_back(found);
  }
  return result;
}

TEST(MergePoints, IsItsDefinitionFromFewNeighboursToMany) {
  base::Progress progress;
  for (const double width : {0.0, 0.5, 3.0, 12.0, 60.0}) {
    const std::vector<glm::dvec3> points = randomPoints(1500, width);
    EXPECT_EQ(mergedPoints(points, 1.0, progress), mergedByDefinition(points, 1.0)) << width;
  }
}

TEST(MergePoints, EqualPointsBecomeTheFirstOfThemHoweverFarApartOthersAre) {
  base::Progress progress;
  const std::vector<glm::dvec3> points{
      {1, 2, 3}, {-1e12, 0, 0}, {1, 2, 3}, {1e12, 1e12, 1e12}, {-1e12, 0, 0}};
  EXPECT_EQ(mergedPoints(points, 1e-6, progress), (std::vector<int>{0, 1, 0, 3, 1}));
  EXPECT_TRUE(mergedPoints({}, 1.0, progress).empty());
}

TEST(MergePoints, AStopLeavesMostOfTheRestUndone) {
  const std::vector<glm::dvec3> points = randomPoints(500'000, 1000.0);
  test::expectStopsSoon([&](base::Progress& progress) { mergedPoints(points, 0.01, progress); }, 5);
}

}  // namespace
}  // namespace isolux::volume
