// Boxes of the parts of a volume in a file: those of the whole volume in memory.
#include "render/volume/part_boxes.h"

#include <cmath>

#include <gtest/gtest.h>

#include "render/volume/brick_cache.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/write/writer.h"

namespace isolux::test {
namespace {

struct Loaded {
  std::shared_ptr<const volume::PreparedVolume> inFile, inMemory;
};

Loaded load(const volume::Grid& grid) {
  const auto folder = temporaryFolder();
  volume::writeVolume(grid, folder / "v.nrrd");
  scene::Source source;
  source.path = (folder / "v.nrrd").string();
  scene::HostSettings host;
  host.voxels = scene::VoxelPlace::file;
  base::Progress progress;
  return {volume::loadVolume(source, host, progress), volume::loadVolume(source, progress)};
}

volume::Grid waves(bool gaps) {
  const volume::GridGeometry geometry = unitGeometry({75, 33, 41});
  std::vector<float> voxels(geometry.voxelCount());
  for (std::size_t i = 0; i < voxels.size(); ++i) {
    const auto x = static_cast<double>(i % 75), y = static_cast<double>(i / 75);
    voxels[i] =
        gaps && i % 997 == 0 ? std::nanf("") : static_cast<float>(std::sin(0.3 * x) + std::cos(0.011 * y));
  }
  return {geometry, voxels};
}

TEST(PartBoxes, AreThoseOfTheWholeVolume) {
  for (const Loaded& volume : {load(waves(false)), load(waves(true)), load(phantomGrid("head", 50))}) {
    const volume::Grid& grid = volume.inMemory->grid();
    const auto least = static_cast<float>(grid.storedMinimum()),
               most = static_cast<float>(grid.storedMaximum());
    const float isovalues[] = {least + 0.4f * (most - least), least + 0.7f * (most - least)};
    volume::ActiveBlocks active(volume.inMemory->blocks);
    active.update(isovalues);
    std::vector<std::uint64_t> whole;
    volume.inMemory->boxes->masks(isovalues, active.flags(), whole);

    render::PartBoxes parts(volume.inFile->volume.grid);
    const glm::ivec3 bricks = render::brickDims(grid.dims()), dims = active.blocks().dims();
    std::size_t compared = 0, notAll = 0;
    for (glm::ivec3 brick(0); brick.z < bricks.z; ++brick.z)
      for (brick.y = 0; brick.y < bricks.y; ++brick.y)
        for (brick.x = 0; brick.x < bricks.x; ++brick.x) {
          EXPECT_TRUE(parts.masks(brick, isovalues, active).masks.empty());
          parts.moved(brick, true);
          const render::PartBoxes::Blocks found = parts.masks(brick, isovalues, active);
          ASSERT_EQ(found.masks.size(), static_cast<std::size_t>(found.size.x * found.size.y * found.size.z));
          std::size_t i = 0;
          for (int z = found.low.z; z < found.low.z + found.size.z; ++z)
            for (int y = found.low.y; y < found.low.y + found.size.y; ++y)
              for (int x = found.low.x; x < found.low.x + found.size.x; ++x, ++i) {
                const std::uint64_t expected = whole[static_cast<std::size_t>((z * dims.y + y) * dims.x + x)];
                ASSERT_EQ(found.masks[i], expected) << x << ' ' << y << ' ' << z;
                notAll += expected != 0 && ~expected != 0;
                ++compared;
              }
        }
    EXPECT_EQ(compared, whole.size()) << "each block once";
    EXPECT_GT(notAll, 10u);
    EXPECT_EQ(parts.resident().size(), static_cast<std::size_t>(bricks.x * bricks.y * bricks.z));
    parts.moved({1, 0, 0}, false);
    EXPECT_TRUE(parts.masks({1, 0, 0}, isovalues, active).masks.empty());
    EXPECT_FALSE(parts.masks({0, 0, 0}, isovalues, active).masks.empty());
    parts.clear();
    EXPECT_TRUE(parts.resident().empty());
  }
}

}  // namespace
}  // namespace isolux::test
