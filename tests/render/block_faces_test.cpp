#include "render/block_faces.h"

#include <gtest/gtest.h>

namespace isolux::render {
namespace {

// Faces counted by brute force: each active block against its six neighbours.
std::size_t bruteForce(const std::vector<std::uint8_t>& active, glm::ivec3 dims) {
  const auto at = [&](int x, int y, int z) {
    if (x < 0 || y < 0 || z < 0 || x >= dims.x || y >= dims.y || z >= dims.z) return false;
    return active[static_cast<std::size_t>((z * dims.y + y) * dims.x + x)] != 0;
  };
  std::size_t count = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        if (at(x, y, z))
          count += static_cast<std::size_t>(!at(x - 1, y, z) + !at(x + 1, y, z) + !at(x, y - 1, z) +
                                            !at(x, y + 1, z) + !at(x, y, z - 1) + !at(x, y, z + 1));
  return count;
}

TEST(BlockFacesTest, OneBlockHasSixFaces) {
  const auto faces = boundaryFaces({1}, glm::ivec3(1));
  ASSERT_EQ(faces.size(), 6u);
  unsigned seen = 0;
  for (const PackedFace face : faces) seen |= 1u << ((face >> 27 & 3u) * 2 + (face >> 29 & 1u));
  EXPECT_EQ(seen, 0x3fu);
}

TEST(BlockFacesTest, InnerFacesAreLeftOut) {
  EXPECT_EQ(boundaryFaces({1, 1}, {2, 1, 1}).size(), 10u);
  EXPECT_EQ(boundaryFaces({1, 0}, {2, 1, 1}).size(), 6u);
  EXPECT_TRUE(boundaryFaces({0, 0}, {2, 1, 1}).empty());
}

TEST(BlockFacesTest, AgreesWithBruteForceOnRandomPatterns) {
  unsigned state = 1;
  for (int round = 0; round < 50; ++round) {
    const glm::ivec3 dims(1 + round % 5, 1 + round % 7, 1 + round % 3);
    std::vector<std::uint8_t> active(static_cast<std::size_t>(dims.x * dims.y * dims.z));
    for (auto& flag : active) flag = (state = state * 1664525u + 1013904223u) >> 31;
    EXPECT_EQ(boundaryFaces(active, dims).size(), bruteForce(active, dims));
  }
}

TEST(BlockFacesTest, PacksTheLargestCoordinate) {
  std::vector<std::uint8_t> active(512, 0);
  active[511] = 1;
  for (const PackedFace face : boundaryFaces(active, {512, 1, 1})) EXPECT_EQ(face & 511u, 511u);
}

}  // namespace
}  // namespace isolux::render
