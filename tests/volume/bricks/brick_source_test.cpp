// Bricks of a volume in a file: the right voxels, read once, within a budget.
#include "volume/bricks/brick_source.h"

#include <atomic>
#include <mutex>
#include <thread>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/poll.h"
#include "tests/support/volumes.h"
#include "tests/volume/bricks/grid_as_file.h"

namespace isolux::test {
namespace {

constexpr glm::ivec3 kDims(83, 70, 49);

std::shared_ptr<GridAsFile> rows() {
  return std::make_shared<GridAsFile>(phantomGrid("gyroid", kDims), glm::ivec3(kDims.x, 1, 1));
}

TEST(BrickSource, BoxesHaveTheVoxelsOfTheGridAndItsBorderBeyond) {
  for (const glm::ivec3& chunk : {glm::ivec3(kDims.x, 1, 1), glm::ivec3(16), glm::ivec3(64, 20, 33)}) {
    const auto file = std::make_shared<GridAsFile>(phantomGrid("gyroid", kDims), chunk);
    volume::BrickSource source(file, {}, std::size_t{1} << 20);
    for (const glm::ivec3& first : {glm::ivec3(-1), glm::ivec3(31, 31, 31), glm::ivec3(63, 31, 31),
                                    glm::ivec3(5, -9, 40), glm::ivec3(80, 69, 48)}) {
      const glm::ivec3 size(35, 35, 35);
      std::vector<float> voxels(35 * 35 * 35);
      source.copyBox(0, first, size, std::as_writable_bytes(std::span(voxels)));
      std::size_t i = 0, differing = 0;
      for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
          for (int x = 0; x < size.x; ++x, ++i) {
            const glm::ivec3 at = glm::clamp(first + glm::ivec3(x, y, z), glm::ivec3(0), kDims - 1);
            if (static_cast<double>(voxels[i]) != file->grid().stored(at.x, at.y, at.z)) ++differing;
          }
      EXPECT_EQ(differing, 0u) << chunk.x << " from " << first.x;
    }
    EXPECT_EQ(source.stored({40, 30, 20}), file->grid().stored(40, 30, 20));
  }
}

// As the bricks on the GPU are cut.
TEST(BrickSource, ABrickOfTheGpuIsOneReadingOfAFileOfRows) {
  const auto file = rows();
  volume::BrickSource source(file, {}, std::size_t{1} << 30);
  std::vector<float> voxels(35 * 35 * 35);
  for (int z = 0; z < 2; ++z)
    for (int y = 0; y < 3; ++y)
      for (int x = 0; x < 3; ++x)
        source.copyBox(0, 32 * glm::ivec3(x, y, z) - 1, glm::ivec3(35),
                       std::as_writable_bytes(std::span(voxels)));
  EXPECT_EQ(file->reads, 18);
  EXPECT_EQ(source.reads().bricks, 18u);
}

TEST(BrickSource, KeepsWhatWasUsedLastWithinItsBudget) {
  const auto file = rows();
  volume::BrickSource source(file, {}, 3 * 35 * 35 * 35 * sizeof(float));
  const auto use = [&](int x, int y) { source.brick(0, {x, y, 0}); };
  for (const int x : {0, 1, 2}) use(x, 0);
  use(0, 0);  // now 1 is the oldest
  use(0, 1);
  EXPECT_TRUE(source.has(0, {0, 0, 0}));
  EXPECT_FALSE(source.has(0, {1, 0, 0}));
  EXPECT_LE(source.reads().keptBytes, source.budgetBytes());
  EXPECT_EQ(file->reads, 4);
  use(1, 0);
  EXPECT_EQ(file->reads, 5);
}

TEST(BrickSource, SeveralWhoAskAtOnceReadOnce) {
  const auto file = rows();
  file->isOpen = false;
  volume::BrickSource source(file, {}, std::size_t{1} << 30);
  std::vector<std::jthread> threads;
  std::atomic<int> got{0};
  for (int i = 0; i < 4; ++i)
    threads.emplace_back([&] {
      source.brick(0, {1, 1, 1});
      ++got;
    });
  file->open();
  threads.clear();
  EXPECT_EQ(got, 4);
  EXPECT_EQ(file->reads, 1);
}

TEST(BrickSource, ADamagedChunkIsAnErrorOfThoseWhoWaitAndReadAgainLater) {
  const auto file = rows();
  volume::BrickSource source(file, {}, std::size_t{1} << 30);
  file->fails = true;
  EXPECT_THROW(source.brick(0, {0, 0, 0}), base::Error);
  EXPECT_THROW(source.stored({1, 1, 1}), base::Error);
  file->fails = false;
  EXPECT_NO_THROW(source.brick(0, {0, 0, 0}));
}

TEST(BrickSource, WhateverAReaderThrowsIsAnErrorOfThoseWhoWait) {
  const auto file = rows();
  volume::BrickSource source(file, {}, std::size_t{1} << 30);
  file->breaks = true;
  EXPECT_THROW(source.brick(0, {0, 0, 0}), base::Error);
  const auto ahead = source.request(0, {1, 0, 0}, 1);
  ASSERT_TRUE(pollUntil([&] { return file->reads == 2; }));
  EXPECT_THROW(source.brick(0, {1, 0, 0}), base::Error);
  file->breaks = false;
  EXPECT_NO_THROW(source.brick(0, {1, 0, 0}));
}

TEST(BrickSource, RequestsAreReadAheadUnlessLetGo) {
  const auto file = rows();
  file->isOpen = false;
  volume::BrickSource source(file, {}, std::size_t{1} << 30);
  std::vector<volume::BrickSource::Request> kept;
  // More than it has threads: all but the first few wait.
  for (int i = 0; i < 18; ++i) kept.push_back(source.request(0, {i % 3, i / 3 % 3, i / 9}, i));
  ASSERT_TRUE(pollUntil([&] { return file->reads > 0; }));
  const int begun = file->reads;
  kept.clear();
  file->open();
  source.brick(0, {0, 0, 0});
  EXPECT_LT(file->reads, 18);
  EXPECT_GE(file->reads, begun);
  const volume::BrickSource::Request wanted = source.request(0, {2, 2, 1}, 0);
  EXPECT_TRUE(pollUntil([&] { return source.has(0, {2, 2, 1}); }));
}

}  // namespace
}  // namespace isolux::test
