#include "render/volume/block_faces.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "base/random.h"

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
  for (const PackedFace face : faces) seen |= 1u << face % 6;
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

TEST(BlockFacesTest, AnAxisMayHaveAnyNumberOfBlocks) {
  std::vector<std::uint8_t> active(8192, 0);  // 65536 voxels
  active[8191] = 1;
  const std::vector<PackedFace> faces = boundaryFaces(active, {8192, 1, 1});
  EXPECT_EQ(faces.size(), 6u);
  for (const PackedFace face : faces) EXPECT_EQ(face / 6, 8191u);
}

TEST(BlockFaceSetTest, FollowsRandomChangesAndSaysWhatItWrote) {
  const glm::ivec3 dims(19, 17, 12);
  const auto count = static_cast<std::size_t>(dims.x * dims.y * dims.z);
  std::vector<std::uint8_t> active(count, 0);
  BlockFaceSet set(dims);
  std::vector<PackedFace> buffer;  // follows by the dirty ranges alone
  for (std::uint64_t round = 0; round < 300; ++round) {
    // Between no change and all of them, on both sides of where everything is found anew.
    const double fraction = std::pow(base::uniformNoise(1, round), 8.0);
    std::vector<std::uint32_t> changed;
    for (std::uint32_t block = 0; block < count; ++block)
      if (base::uniformNoise(2 + round, block) < fraction) {
        active[block] ^= 1;
        changed.push_back(block);
      }
    std::reverse(changed.begin(), changed.end());  // any order will do
    set.update(active, changed);

    buffer.resize(set.faces().size(), 0);
    std::size_t end = 0;
    for (const auto& range : set.takeDirty()) {
      ASSERT_TRUE(end == 0 || range.first >= end) << "ranges overlap";
      end = range.first + range.count;
      ASSERT_LE(end, set.faces().size());
      std::copy_n(set.faces().begin() + static_cast<std::ptrdiff_t>(range.first), range.count,
                  buffer.begin() + static_cast<std::ptrdiff_t>(range.first));
    }
    ASSERT_EQ(buffer, set.faces()) << "round " << round;
    ASSERT_TRUE(set.takeDirty().empty());
    std::vector<PackedFace> sorted = set.faces(), expected = boundaryFaces(active, dims);
    std::sort(sorted.begin(), sorted.end());
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(sorted, expected) << "round " << round;
  }
}

TEST(BlockFaceSetTest, ASmallChangeWritesLittle) {
  const glm::ivec3 dims(32);
  std::vector<std::uint8_t> active(32 * 32 * 32, 0);
  std::vector<std::uint32_t> all;
  for (std::uint32_t block = 0; block < active.size(); ++block)
    if (block % 3 == 0) {
      active[block] = 1;
      all.push_back(block);
    }
  BlockFaceSet set(dims);
  set.update(active, all);
  set.takeDirty();
  active[3 * 777] = 0;
  const std::uint32_t one[] = {3 * 777};
  set.update(active, one);
  std::size_t written = 0;
  for (const auto& range : set.takeDirty()) written += range.count;
  EXPECT_GT(set.faces().size(), 50 * BlockFaceSet::kPageFaces);
  EXPECT_LE(written, 12 * BlockFaceSet::kPageFaces);
}

}  // namespace
}  // namespace isolux::render
