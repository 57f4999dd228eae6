// A first look at a volume: its own voxels, in their own places, of the file's level or every n-th; and where
// there is none.
#include "volume/large/volume_preview.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>
#include <glm/vec4.hpp>

#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "tests/support/zarr_folder.h"
#include "volume/large/index_file.h"
#include "volume/read/volume_file.h"
#include "volume/write/writer.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;

class VolumePreviewTest : public testing::Test {
 protected:
  scene::Source at(const fs::path& path) const {
    scene::Source source;
    source.path = path.string();
    return source;
  }
  static std::string bytesOf(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  // Packs the chunks of what writeZarr() has written.
  static void packChunks(const fs::path& folder) {
    std::string metadata = bytesOf(folder / ".zarray");
    const std::string plain = "\"compressor\": null";
    metadata.replace(metadata.find(plain), plain.size(), R"("compressor": {"id": "zlib", "level": 1})");
    for (const fs::directory_entry& chunk : fs::directory_iterator(folder)) {
      const std::string voxels = bytesOf(chunk.path());
      std::string packed(compressBound(voxels.size()), '\0');
      uLongf length = packed.size();
      ASSERT_EQ(compress(reinterpret_cast<Bytef*>(packed.data()), &length,
                         reinterpret_cast<const Bytef*>(voxels.data()), voxels.size()),
                Z_OK);
      std::ofstream(chunk.path(), std::ios::binary)
          .write(packed.data(), static_cast<std::streamsize>(length));
    }
    std::ofstream(folder / ".zarray") << metadata;
  }
  fs::path folder_ = temporaryFolder();
  base::Progress progress_;
};

TEST_F(VolumePreviewTest, IsOfSingleVoxelsWhereTheyLie) {
  const volume::GridGeometry geometry =
      volume::GridGeometry::make({250, 97, 40}, {0.5, 0.7, 2.0}, {-10.0, 20.0, 5.0});
  const volume::Grid grid = phantomGrid("gyroid", geometry);
  writeVolume(grid, folder_ / "g.nrrd");
  const auto preview = volume::readVolumePreview(at(folder_ / "g.nrrd"), progress_, 0);
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->step, glm::ivec3(3, 2, 1));
  const volume::Grid& seen = *preview->volume.grid;
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

TEST_F(VolumePreviewTest, IsTheFilesLevelWhereItHasOne) {
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
  const auto preview = volume::readVolumePreview(at(image), progress_, 0);
  ASSERT_TRUE(preview);
  EXPECT_EQ(preview->step, glm::ivec3(2));
  EXPECT_EQ(preview->volume.grid->dims(), glm::ivec3(100));
  EXPECT_EQ(preview->volume.grid->stored(3, 0, 0), 103.0);
  EXPECT_DOUBLE_EQ(preview->volume.grid->geometry().spacingMm().x, 2.0);
}

// Packed chunks would have to be unpacked; what an index knows is there at once.
TEST_F(VolumePreviewTest, IsOfTheIndexWhereChunksArePacked) {
  const fs::path image = folder_ / "p.zarr";
  const glm::ivec3 dims(70, 50, 41);
  const auto value = [](int x, int y, int z) { return static_cast<std::uint8_t>((x * 3 + y * 2 + z) % 251); };
  std::vector<std::uint8_t> voxels;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x) voxels.push_back(value(x, y, z));
  writeZarr(image, dims, glm::ivec3(32), voxels);
  packChunks(image);
  EXPECT_FALSE(volume::readVolumePreview(at(image), progress_, 0)) << "no index";
  const auto file = volume::openSource(at(image), progress_).parts;
  ASSERT_TRUE(file);
  std::optional<volume::VolumeIndex> index;
  volume::IndexFile(image.string(), {}).make(*file, {}, index, progress_);
  for (const int box : {8, 16}) {
    const std::size_t most = box == 8 ? volume::kPreviewVoxels : 100;
    const auto preview = volume::readVolumePreview(at(image), progress_, 0, most);
    ASSERT_TRUE(preview);
    EXPECT_TRUE(preview->fromIndex);
    EXPECT_EQ(preview->step, glm::ivec3(box));
    const volume::Grid& seen = *preview->volume.grid;
    ASSERT_EQ(seen.dims(), box == 8 ? glm::ivec3(9, 7, 5) : glm::ivec3(5, 4, 3));
    EXPECT_EQ(glm::dvec3(seen.geometry().worldFromVoxel[3]), glm::dvec3(0.5 * box)) << "the middle of a box";
    EXPECT_EQ(seen.geometry().spacingMm(), glm::dvec3(box));
    for (int bz = 0; bz < seen.dims().z; ++bz)
      for (int by = 0; by < seen.dims().y; ++by)
        for (int bx = 0; bx < seen.dims().x; ++bx) {
          int low = 255, high = 0;
          for (int z = box * bz; z <= std::min(box * (bz + 1), dims.z - 1); ++z)
            for (int y = box * by; y <= std::min(box * (by + 1), dims.y - 1); ++y)
              for (int x = box * bx; x <= std::min(box * (bx + 1), dims.x - 1); ++x) {
                low = std::min<int>(low, value(x, y, z));
                high = std::max<int>(high, value(x, y, z));
              }
          ASSERT_EQ(seen.value(bx, by, bz), 0.5 * (low + high)) << bx << ' ' << by << ' ' << bz;
        }
  }
}

// What could not be read is missing in it, not what its bounds allow.
TEST_F(VolumePreviewTest, OfTheIndexHasHolesWhereThereIsDamage) {
  const fs::path image = folder_ / "d.zarr";
  writeZarr(image, glm::ivec3(64), glm::ivec3(32), std::vector<std::uint8_t>(64 * 64 * 64, 7));
  packChunks(image);
  cutChunk(image, glm::ivec3(1, 0, 1));
  std::optional<volume::VolumeIndex> index;
  volume::IndexFile(image.string(), {})
      .make(*volume::openSource(at(image), progress_).parts, {}, index, progress_);
  ASSERT_EQ(index->damaged().size(), 1u);
  const auto preview = volume::readVolumePreview(at(image), progress_, 0);
  ASSERT_TRUE(preview);
  const volume::Grid& seen = *preview->volume.grid;
  EXPECT_TRUE(std::isnan(seen.value(6, 2, 6)));
  EXPECT_EQ(seen.value(2, 2, 2), 7.0);
  EXPECT_EQ(seen.maximum(), 7.0);
  EXPECT_EQ(seen.minimum(), 7.0);
}

TEST_F(VolumePreviewTest, ThereIsNoneOfSmallVolumesAndOfThoseThatAreReadAsAWhole) {
  writeVolume(phantomGrid("ball", 40), folder_ / "small.nrrd");
  EXPECT_FALSE(volume::readVolumePreview(at(folder_ / "small.nrrd"), progress_));
  std::ofstream(folder_ / "packed.nrrd")
      << "NRRD0004\ntype: uint8\nencoding: gzip\ndimension: 3\nsizes: 64 64 64\n\n";
  EXPECT_FALSE(volume::readVolumePreview(at(folder_ / "packed.nrrd"), progress_, 0));
  EXPECT_FALSE(volume::readVolumePreview(at("phantom:ball:300"), progress_, 0));
}

}  // namespace
}  // namespace isolux::test
