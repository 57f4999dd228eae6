#include "volume/read/raw_guess.h"

#include <gtest/gtest.h>

namespace isolux::volume {

TEST(RawGuess, ReadsDimsTypeAndByteOrderFromTheName) {
  const auto guesses = guessRaw("Skull_256x256x128_uint8.raw", 256 * 256 * 128);
  ASSERT_FALSE(guesses.empty());
  EXPECT_EQ(guesses.front().dims, glm::ivec3(256, 256, 128));
  EXPECT_EQ(guesses.front().type, VoxelType::uint8);
  const auto big = guessRaw("a_20x30x10_uint16_be.raw", 20 * 30 * 10 * 2 + 128);
  ASSERT_FALSE(big.empty());
  EXPECT_EQ(big.front().type, VoxelType::uint16);
  EXPECT_EQ(big.front().endianness, Endianness::big);
  EXPECT_EQ(big.front().headerBytes, 128U);
  // The size decides between types the name leaves open.
  const auto wide = guessRaw("a_20x30x10.raw", 20 * 30 * 10 * 8);
  ASSERT_FALSE(wide.empty());
  EXPECT_EQ(wide.front().type, VoxelType::float64);
}

TEST(RawGuess, FindsCubesAndStacksFromTheSizeAlone) {
  const auto cube = guessRaw("volume.raw", 100 * 100 * 100);
  ASSERT_FALSE(cube.empty());
  EXPECT_EQ(cube.front().dims, glm::ivec3(100));
  const auto stack = guessRaw("volume.raw", 512 * 512 * 77 * 2);
  ASSERT_FALSE(stack.empty());
  EXPECT_EQ(stack.front().dims.x, 512);
  EXPECT_TRUE(guessRaw("volume.raw", 1013).empty());  // a prime
  EXPECT_TRUE(guessRaw("99999x99999x99999.raw", 61).empty());
}

}  // namespace isolux::volume
