// Components of a block's voxels, against a flood from voxel to voxel.
#include "volume/pieces/block_voxels.h"

#include <vector>

#include <gtest/gtest.h>

#include "base/random.h"

namespace isolux::volume {
namespace {

int floodedComponents(const VoxelBits& bits, std::array<int, 512>& label) {
  label.fill(-1);
  int count = 0;
  const auto at = [](glm::ivec3 v) { return static_cast<std::size_t>(v.x + 8 * v.y + 64 * v.z); };
  for (int i = 0; i < 512; ++i) {
    const glm::ivec3 first(i % 8, i / 8 % 8, i / 64);
    if (!bitAt(bits, first) || label[at(first)] >= 0) continue;
    std::vector<glm::ivec3> open{first};
    label[at(first)] = count;
    while (!open.empty()) {
      const glm::ivec3 voxel = open.back();
      open.pop_back();
      for (int axis = 0; axis < 3; ++axis)
        for (const int step : {-1, 1}) {
          glm::ivec3 next = voxel;
          next[axis] += step;
          if (next[axis] < 0 || next[axis] > 7 || !bitAt(bits, next) || label[at(next)] >= 0) continue;
          label[at(next)] = count;
          open.push_back(next);
        }
    }
    ++count;
  }
  return count;
}

void expectFlooded(const VoxelBits& bits) {
  std::array<int, 512> expected;
  VoxelLabels labels{};
  const int count = floodedComponents(bits, expected);
  ASSERT_EQ(labelVoxels(bits, labels), count);
  for (std::size_t i = 0; count > 1 && i < 512; ++i)
    if (expected[i] >= 0) {
      ASSERT_EQ(labels[i], expected[i]) << i;
    }
}

void set(VoxelBits& bits, int x, int y, int z) {
  bits[static_cast<std::size_t>(z)] |= std::uint64_t{1} << (x + 8 * y);
}

TEST(BlockVoxels, OfNoiseAreThoseOfAFlood) {
  for (std::uint64_t seed = 0; seed < 400; ++seed) {
    VoxelBits bits{};
    const double part = base::uniformNoise(1, seed);
    for (int i = 0; i < 512; ++i)
      if (base::uniformNoise(seed + 2, static_cast<std::uint64_t>(i)) < part)
        set(bits, i % 8, i / 8 % 8, i / 64);
    expectFlooded(bits);
  }
}

// One way through the whole block, which a flood along the axes follows turn by turn; and the same, cut.
TEST(BlockVoxels, OfASnake) {
  VoxelBits snake{};
  for (int z = 0; z < 8; z += 2) {
    for (int y = 0; y < 8; y += 2) {
      for (int x = 0; x < 8; ++x) set(snake, x, y, z);
      if (y < 6) set(snake, y % 4 == 0 ? 7 : 0, y + 1, z);
    }
    if (z < 6) set(snake, 0, z % 4 == 0 ? 6 : 0, z + 1);
    if (z < 6 && z % 4 == 0) set(snake, 0, 6, z + 1);
  }
  expectFlooded(snake);
  VoxelBits cut = snake;
  cut[2] &= ~(std::uint64_t{1} << (3 + 8 * 2));
  expectFlooded(cut);
}

// Voxels that touch at edges and corners only.
TEST(BlockVoxels, DiagonalsAreApart) {
  VoxelBits bits{};
  for (int z = 0; z < 8; ++z)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x)
        if ((x + y + z) % 2 == 0) set(bits, x, y, z);
  expectFlooded(bits);  // 256 of them
  VoxelBits rows{};     // the end of a row and the beginning of the next one in memory
  set(rows, 7, 2, 3);
  set(rows, 0, 3, 3);
  set(rows, 7, 7, 3);
  set(rows, 0, 0, 4);
  expectFlooded(rows);
  expectFlooded({});
}

}  // namespace
}  // namespace isolux::volume
