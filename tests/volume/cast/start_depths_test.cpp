#include "volume/cast/start_depths.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"

namespace isolux::volume {
namespace {

constexpr glm::ivec3 kVoxels{41, 30, 53};
constexpr glm::ivec3 kBlocks{5, 4, 7};
constexpr glm::ivec2 kPicture{64, 48};

PictureRays raysFrom(glm::vec3 eye, glm::vec3 at, bool orthographic) {
  PictureRays rays;
  rays.orthographic = orthographic;
  rays.eye = eye;
  rays.forward = glm::normalize(at - eye);
  rays.right = glm::normalize(glm::cross(rays.forward, glm::vec3(0.1f, 1.0f, 0.2f)));
  rays.up = glm::cross(rays.right, rays.forward);
  rays.halfExtent = orthographic ? glm::vec2(40, 30) : glm::vec2(0.8f, 0.6f);
  rays.picture = kPicture;
  return rays;
}

float random(std::uint64_t stream, std::uint64_t i) {
  return static_cast<float>(base::uniformNoise(stream, i));
}

// Points in blocks that hold something, seen through a pixel, lie within the depths of its tile.
TEST(StartDepths, HoldEveryPointOfEveryBlockWithABox) {
  int checked = 0;
  for (std::uint64_t trial = 0; trial < 60; ++trial) {
    std::vector<std::uint64_t> masks(static_cast<std::size_t>(kBlocks.x * kBlocks.y * kBlocks.z));
    for (std::size_t i = 0; i < masks.size(); ++i) masks[i] = base::hash64(i * 1000 + trial) % 4 == 0 ? 1 : 0;
    const glm::vec3 middle = 0.5f * glm::vec3(kVoxels);
    const glm::vec3 offset = glm::vec3(random(1, trial), random(2, trial), random(3, trial)) - 0.5f;
    const bool inside = trial % 3 == 0;
    const PictureRays rays = raysFrom(middle + (inside ? 30.0f : 200.0f) * offset, middle, trial % 5 == 1);
    const StartDepths depths = startDepths(rays, kPicture, kVoxels, {kBlocks, masks});
    ASSERT_EQ(depths.tiles, (kPicture + 3) / 4);
    for (std::uint64_t i = 0; i < 4000; ++i) {
      const glm::vec3 p = glm::vec3(random(4, i), random(5, i), random(6, i)) * glm::vec3(kVoxels - 1);
      const glm::ivec3 block = glm::ivec3(p) / 8;
      if (masks[static_cast<std::size_t>((block.z * kBlocks.y + block.y) * kBlocks.x + block.x)] == 0)
        continue;
      const glm::vec3 to = p - rays.eye;
      const float depth = glm::dot(to, rays.forward);
      if (!rays.orthographic && depth <= 0.01f) continue;
      const glm::vec2 plane =
          glm::vec2(glm::dot(to, rays.right), glm::dot(to, rays.up)) / (rays.orthographic ? 1.0f : depth);
      const glm::vec2 pixel = (plane / rays.halfExtent * 0.5f + 0.5f) * glm::vec2(kPicture);
      if (pixel.x < 0.0f || pixel.y < 0.0f || pixel.x >= 64.0f || pixel.y >= 48.0f) continue;
      const StartDepths::Depths tile =
          depths.at(static_cast<int>(pixel.x) / 4, static_cast<int>(pixel.y) / 4);
      EXPECT_LE(tile.first, depth + 1e-3f);
      EXPECT_GE(tile.last, depth - 1e-3f);
      ++checked;
    }
  }
  EXPECT_GT(checked, 10000);
}

TEST(StartDepths, AreEmptyWhereNoBlockIs) {
  std::vector<std::uint64_t> masks(static_cast<std::size_t>(kBlocks.x * kBlocks.y * kBlocks.z), 0);
  const PictureRays rays = raysFrom({20, 15, -80}, {20, 15, 26}, false);
  for (const auto& depths : startDepths(rays, kPicture, kVoxels, {kBlocks, masks}).depths)
    EXPECT_GT(depths.first, depths.last);
  masks[0] = 1;  // a corner: a few tiles
  int tiles = 0;
  for (const auto& depths : startDepths(rays, kPicture, kVoxels, {kBlocks, masks}).depths)
    tiles += depths.first <= depths.last;
  EXPECT_GT(tiles, 0);
  EXPECT_LT(tiles, 20);
}

// Blocks behind the eye count for nothing; those around it for the whole picture.
TEST(StartDepths, KnowTheEye) {
  std::vector<std::uint64_t> masks(static_cast<std::size_t>(kBlocks.x * kBlocks.y * kBlocks.z), 0);
  masks[0] = 1;
  const PictureRays away = raysFrom({-20, -20, -20}, {-80, -80, -80}, false);
  for (const auto& depths : startDepths(away, kPicture, kVoxels, {kBlocks, masks}).depths)
    EXPECT_GT(depths.first, depths.last);
  const PictureRays within = raysFrom({4, 4, 4}, {80, 80, 80}, false);
  for (const auto& depths : startDepths(within, kPicture, kVoxels, {kBlocks, masks}).depths) {
    EXPECT_LE(depths.first, 0.0f);
    EXPECT_GT(depths.last, 0.0f);
  }
}

}  // namespace
}  // namespace isolux::volume
