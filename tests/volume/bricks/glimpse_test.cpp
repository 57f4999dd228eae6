// A first look at a volume: its own voxels, in their own places, of the file's level or every n-th; and where
// there is none.
#include "volume/bricks/glimpse.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <glm/vec4.hpp>

#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "volume/write/writer.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;

class GlimpseTest : public testing::Test {
 protected:
  scene::Source at(const fs::path& path) const {
    scene::Source source;
    source.path = path.string();
    return source;
  }
  fs::path folder_ = temporaryFolder();
  base::Progress progress_;
};

TEST_F(GlimpseTest, IsOfSingleVoxelsWhereTheyLie) {
  const volume::GridGeometry geometry =
      volume::GridGeometry::make({250, 97, 40}, {0.5, 0.7, 2.0}, {-10.0, 20.0, 5.0});
  const volume::Grid grid = phantomGrid("gyroid", geometry);
  writeVolume(grid, folder_ / "g.nrrd");
  const auto glimpse = volume::readGlimpse(at(folder_ / "g.nrrd"), progress_, 0);
  ASSERT_TRUE(glimpse);
  EXPECT_EQ(glimpse->step, glm::ivec3(3, 2, 1));
  const volume::Grid& seen = *glimpse->volume.grid;
  EXPECT_EQ(seen.dims(), glm::ivec3(83, 49, 40));
  const glm::dmat4 voxelFromWorld = grid.geometry().voxelFromWorld();
  for (int z = 0; z < seen.dims().z; ++z)
    for (int y = 0; y < seen.dims().y; ++y)
      for (int x = 0; x < seen.dims().x; ++x) {
        const glm::dvec3 voxel(voxelFromWorld * seen.geometry().worldFromVoxel * glm::dvec4(x, y, z, 1.0));
        const glm::ivec3 own(glm::round(voxel));
        ASSERT_LT(glm::length(voxel - glm::dvec3(own)), 1e-9);
        ASSERT_EQ(seen.stored(x, y, z), grid.stored(own.x, own.y, own.z));
      }
}

TEST_F(GlimpseTest, IsTheFilesLevelWhereItHasOne) {
  const fs::path image = folder_ / "i.zarr";
  const auto writeArray = [&](const std::string& name, int n, std::uint8_t first) {
    fs::create_directories(image / name);
    const std::string size = std::to_string(n);
    std::ofstream(image / name / ".zarray")
        << R"({"zarr_format": 2, "shape": [)" + size + "," + size + "," + size + R"(], "chunks": [)" + size +
               "," + size + "," + size +
               R"(], "dtype": "|u1", "compressor": null, "fill_value": 0, "order": "C", "filters": null})";
    std::ofstream chunk(image / name / "0.0.0", std::ios::binary);
    for (int i = 0; i < n * n * n; ++i) chunk.put(static_cast<char>(first + i % 7));
  };
  writeArray("0", 200, 1);
  writeArray("1", 100, 100);
  std::ofstream(image / ".zgroup") << R"({"zarr_format": 2})";
  std::ofstream(image / ".zattrs") << R"({"multiscales": [{"version": "0.4",
    "axes": [{"name": "z", "type": "space"}, {"name": "y", "type": "space"}, {"name": "x", "type": "space"}],
    "datasets": [
      {"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 1]}]},
      {"path": "1", "coordinateTransformations": [{"type": "scale", "scale": [2, 2, 2]},
                                                  {"type": "translation", "translation": [0.5, 0.5, 0.5]}]}]}]})";
  const auto glimpse = volume::readGlimpse(at(image), progress_, 0);
  ASSERT_TRUE(glimpse);
  EXPECT_EQ(glimpse->step, glm::ivec3(2));
  EXPECT_EQ(glimpse->volume.grid->dims(), glm::ivec3(100));
  EXPECT_EQ(glimpse->volume.grid->stored(3, 0, 0), 103.0);
  EXPECT_DOUBLE_EQ(glimpse->volume.grid->geometry().spacingMm().x, 2.0);
}

TEST_F(GlimpseTest, ThereIsNoneOfSmallVolumesAndOfThoseThatAreReadAsAWhole) {
  writeVolume(phantomGrid("ball", 40), folder_ / "small.nrrd");
  EXPECT_FALSE(volume::readGlimpse(at(folder_ / "small.nrrd"), progress_));
  std::ofstream(folder_ / "packed.nrrd")
      << "NRRD0004\ntype: uint8\nencoding: gzip\ndimension: 3\nsizes: 64 64 64\n\n";
  EXPECT_FALSE(volume::readGlimpse(at(folder_ / "packed.nrrd"), progress_, 0));
  EXPECT_FALSE(volume::readGlimpse(at("phantom:ball:300"), progress_, 0));
}

}  // namespace
}  // namespace isolux::test
