// Enclosures of hits on fields whose crossings are known. Whether they hold for pictures is judged by
// tests/app/accuracy.
#include "volume/error/hit_error.h"

#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include <gtest/gtest.h>

namespace isolux::volume {
namespace {

constexpr int kHitSize = 16;
constexpr float kMissing = std::numeric_limits<float>::quiet_NaN();

// Voxels of 1 mm, so that t is voxels; the picture of 8 x 8 rays looks along z from z = -20.
class HitError : public testing::Test {
 protected:
  void fill(const std::function<float(glm::ivec3)>& field) {
    std::vector<float> values;
    for (int z = 0; z < kHitSize; ++z)
      for (int y = 0; y < kHitSize; ++y)
        for (int x = 0; x < kHitSize; ++x) values.push_back(field({x, y, z}));
    grid_.emplace(GridGeometry::make(glm::ivec3(kHitSize), glm::dvec3(1.0), glm::dvec3(0.0), glm::dmat3(1.0)),
                  std::move(values));
    blocks_.emplace(*grid_, 4, progress_);
  }
  // The ray through x, y = eye + 0.5.
  HitEnclosure enclose(std::span<const RaySurface> surfaces, float eye, double fieldErrorElsewhere) {
    const PictureRays rays{.eye = {eye, eye, -20.0f},
                           .right = {1.0f, 0.0f, 0.0f},
                           .up = {0.0f, 1.0f, 0.0f},
                           .forward = {0.0f, 0.0f, 1.0f},
                           .halfExtent = {4.0f, 4.0f},
                           .orthographic = true,
                           .picture = {8, 8}};
    const Ray ray{{eye + 0.5, eye + 0.5, -20.0}, {0.0, 0.0, 1.0}};
    return encloseHit({*grid_, *blocks_}, surfaces, rays, {4.5, 4.5}, ray, 0.0, fieldErrorElsewhere);
  }
  HitEnclosure enclose(double isovalue, float eye = 8.0f) {
    const RaySurface surface{isovalue};
    return enclose({&surface, 1}, eye, 1e-4);
  }

  base::Progress progress_;
  std::optional<Grid> grid_;
  std::optional<MinMaxBlocks> blocks_;
};

TEST_F(HitError, EnclosesTheCrossingOfARamp) {
  fill([](glm::ivec3 v) { return 10.0f * static_cast<float>(v.z); });
  const HitEnclosure hit = enclose(65.0);
  ASSERT_TRUE(hit.hit && hit.certain);
  EXPECT_NEAR(hit.t, 26.5, 1e-12);
  EXPECT_LE(hit.first, hit.t);
  EXPECT_GE(hit.last, hit.t);
  EXPECT_LT(hit.last - hit.first, 1e-4);
  // At least what a depth of 26.5 mm is rounded to, and no more than a few of its roundings and those of the
  // values.
  EXPECT_GT(hit.bound, kFloatRounding * 26.5);
  EXPECT_LT(hit.bound, 1e-4);
  EXPECT_NEAR(hit.gradient.z, 10.0, 1e-12);
  EXPECT_NEAR(hit.voxel.z, 6.5, 1e-12);
}

// Where values far away keep the range wide, a flatter field puts the same error of values farther along the
// ray.
TEST_F(HitError, IsWiderTheFlatterTheFieldIs) {
  double before = 0.0;
  for (const float slope : {10.0f, 1.0f, 0.1f}) {
    fill([slope](glm::ivec3 v) {
      return v == glm::ivec3(0) ? -1e4f : 65.0f + slope * (static_cast<float>(v.z) - 6.5f);
    });
    const HitEnclosure hit = enclose(65.0);
    ASSERT_TRUE(hit.hit);
    EXPECT_GT(hit.last - hit.first, 2.0 * before);
    before = hit.last - hit.first;
  }
}

TEST_F(HitError, ARayThatMissesByLessThanARoundingIsNotCertain) {
  fill([](glm::ivec3 v) { return 50.0f - 10.0f * std::abs(static_cast<float>(v.z - 6)); });
  const HitEnclosure near = enclose(50.0 + 1e-6), far = enclose(51.0), through = enclose(49.0);
  EXPECT_FALSE(near.hit);
  EXPECT_FALSE(near.certain);
  EXPECT_FALSE(far.hit);
  EXPECT_TRUE(far.certain);
  EXPECT_TRUE(through.hit && through.certain);
  EXPECT_FALSE(enclose(50.0 - 1e-6).certain);  // it grazes
}

TEST_F(HitError, AMissingVoxelAsNearAsARoundingIsNotCertain) {
  fill([](glm::ivec3 v) { return v == glm::ivec3(10, 8, 6) ? kMissing : 10.0f * static_cast<float>(v.z); });
  EXPECT_TRUE(enclose(65.0, 7.0f).certain);   // x = 7.5
  EXPECT_FALSE(enclose(65.0, 8.5f).certain);  // x = 9: on the face of the cell
}

TEST_F(HitError, TheNearerOfTwoSurfacesCounts) {
  fill([](glm::ivec3 v) { return 10.0f * static_cast<float>(v.z); });
  // The nearer one is cut away before t = 25.
  const RaySurface surfaces[] = {{.isovalue = 90.0}, {.isovalue = 30.0, .begin = 25.0}};
  const HitEnclosure hit = enclose(surfaces, 8.0f, 1e-4);
  ASSERT_TRUE(hit.hit);
  EXPECT_EQ(hit.isovalue, 90.0);
  EXPECT_NEAR(hit.t, 29.0, 1e-12);
}

TEST(LowestStored, IsThatOfTheType) {
  const GridGeometry geometry =
      GridGeometry::make(glm::ivec3(2), glm::dvec3(1.0), glm::dvec3(0.0), glm::dmat3(1.0));
  EXPECT_EQ(lowestStored(Grid(geometry, std::vector<std::int16_t>(8))), -32768.0);
  EXPECT_EQ(lowestStored(Grid(geometry, std::vector<std::uint16_t>(8))), 0.0);
  EXPECT_EQ(lowestStored(Grid(geometry, std::vector<float>(8))), 0.0);
}

}  // namespace
}  // namespace isolux::volume
