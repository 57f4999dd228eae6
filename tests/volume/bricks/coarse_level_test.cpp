// Levels of volumes that are too large: means computed in another way, where they lie, what fits.
#include "volume/bricks/coarse_level.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "tests/support/memory_limit.h"
#include "tests/support/test_data.h"
#include "volume/prepared_volume.h"

namespace isolux::volume {
namespace {

using testing::HasSubstr;
using testing::Not;

class CoarseLevel : public testing::Test {
 protected:
  // Voxels x fastest, as a raw file of this type with spacing 0.5, 1, 2 mm.
  template <class T>
  scene::Source written(glm::ivec3 dims, const char* type, const std::vector<T>& voxels) {
    const std::filesystem::path path = test::temporaryFolder() / "volume.raw";
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(voxels.data()),
               static_cast<std::streamsize>(voxels.size() * sizeof(T)));
    scene::Source source;
    source.path = path.string();
    source.raw = std::to_string(dims.x) + "x" + std::to_string(dims.y) + "x" + std::to_string(dims.z) + " " +
                 type + " spacing 0.5,1,2";
    return source;
  }
  template <class T>
  std::vector<T> filled(glm::ivec3 dims, const auto& value) {
    std::vector<T> voxels;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) voxels.push_back(static_cast<T>(value(x, y, z)));
    return voxels;
  }
  Volume at(scene::Source source, int level) {
    source.level = level;
    return level == 0 ? readVolume(source.path, readOptions(source), progress_)
                      : readLevel(source, progress_);
  }
  std::string refusal(const scene::Source& source, int level, base::ErrorKind kind) {
    try {
      at(source, level);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "level " << level << " was read";
    return {};
  }
  base::Progress progress_;
};

double noise(int x, int y, int z) {
  return base::uniformNoise(3, static_cast<std::uint64_t>((z * 1000 + y) * 1000 + x));
}

TEST_F(CoarseLevel, VoxelsAreTheMeansOfThoseThatTheyStandFor) {
  const glm::ivec3 dims(37, 22, 19);
  const auto uint16 = filled<std::uint16_t>(dims, [](auto... at) { return 65535.0 * noise(at...); });
  const auto int16 = filled<std::int16_t>(dims, [](auto... at) { return 2000.0 * noise(at...) - 1000.0; });
  auto floats = filled<float>(dims, [](auto... at) { return noise(at...); });
  const auto index = [&](int x, int y, int z) {
    return static_cast<std::size_t>((z * dims.y + y) * dims.x + x);
  };
  for (int i = 0; i < 8; ++i) floats[index(4 + (i & 1), 6 + (i >> 1 & 1), 8 + (i >> 2))] = NAN;  // a mean's
  floats[index(20, 10, 2)] = INFINITY;
  const auto check = [&](const scene::Source& source, bool isWhole) {
    const Volume whole = at(source, 0);
    for (const int level : {1, 2}) {
      const glm::ivec3 factor = level == 1 ? glm::ivec3(2) : glm::ivec3(4, 2, 2);  // 8 voxels stay
      const Volume coarse = at(source, level);
      EXPECT_EQ(coarse.grid->dims(), (dims + factor - 1) / factor);
      EXPECT_EQ(coarse.grid->storedType(), whole.grid->storedType());
      const glm::ivec3 n = coarse.grid->dims();
      int differing = 0;
      for (int z = 0; z < n.z; ++z)
        for (int y = 0; y < n.y; ++y)
          for (int x = 0; x < n.x; ++x) {
            double sum = 0.0;
            int count = 0;
            for (int i = 0; i < factor.x * factor.y * factor.z; ++i) {
              const glm::ivec3 voxel =
                  glm::min(factor * glm::ivec3(x, y, z) +
                               glm::ivec3(i % factor.x, i / factor.x % factor.y, i / (factor.x * factor.y)),
                           dims - 1);
              const double value = whole.grid->value(voxel.x, voxel.y, voxel.z);
              if (std::isnan(value)) continue;
              sum += value;
              ++count;
            }
            const double found = coarse.grid->value(x, y, z), mean = sum / count;
            if (count == 0)
              differing += !std::isnan(found);
            else
              differing += !(std::abs(found - mean) <= (isWhole ? 0.5 : 1e-6));
          }
      EXPECT_EQ(differing, 0) << source.raw << ", level " << level;
    }
  };
  check(written(dims, "uint16", uint16), true);
  check(written(dims, "int16", int16), true);
  const scene::Source ofFloats = written(dims, "float32", floats);
  check(ofFloats, false);
  EXPECT_EQ(at(ofFloats, 1).grid->missingCount(), 1u) << "where all eight are";
}

TEST_F(CoarseLevel, LiesWhereTheVolumeLies) {
  const glm::ivec3 dims(32, 24, 40);
  const scene::Source source = written(
      dims, "float32", filled<float>(dims, [](int x, int y, int z) { return 3.0 * x - 2.0 * y + 0.5 * z; }));
  const glm::dmat4 voxelFromWorld = at(source, 0).grid->geometry().voxelFromWorld();
  for (const int level : {1, 2}) {
    const Volume coarse = at(source, level);
    const glm::ivec3 n = coarse.grid->dims();
    EXPECT_EQ(n, level == 1 ? dims / 2 : glm::ivec3(8, 12, 10));
    for (const glm::ivec3& voxel : {glm::ivec3(0), n - 1, n / 2}) {
      const glm::dvec3 p(voxelFromWorld * coarse.grid->geometry().worldFromVoxel *
                         glm::dvec4(glm::dvec3(voxel), 1.0));
      EXPECT_NEAR(coarse.grid->value(voxel.x, voxel.y, voxel.z), 3.0 * p.x - 2.0 * p.y + 0.5 * p.z, 1e-4);
    }
    EXPECT_THAT(coarse.warnings.front(), HasSubstr("level " + std::to_string(level)));
    EXPECT_THAT(coarse.warnings.front(), HasSubstr("of the file's 32x24x40"));
    EXPECT_THAT(coarse.warnings.front(), HasSubstr("thinner than " + std::to_string(4 << level) + " mm"));
  }
}

TEST_F(CoarseLevel, FilesOwnLevelsComeFirst) {
  scene::Source source;
  const auto file = [&] {
    // An OME-Zarr image with two levels, written by hand: 16^3 of 10, and 8^3 of 77, which are no means.
    const std::filesystem::path folder = test::temporaryFolder() / "image.zarr";
    for (const auto& [name, size, value] : {std::tuple{"0", 16, 10}, std::tuple{"1", 8, 77}}) {
      std::filesystem::create_directories(folder / name);
      const std::string n = std::to_string(size);
      std::ofstream(folder / name / ".zarray")
          << R"({"zarr_format": 2, "shape": [)" << n << "," << n << "," << n << R"(], "chunks": [)" << n
          << "," << n << "," << n
          << R"(], "dtype": "|u1", "compressor": null, "fill_value": 0, "order": "C", "filters": null})";
      std::ofstream(folder / name / "0.0.0", std::ios::binary)
          << std::string(static_cast<std::size_t>(size * size * size), static_cast<char>(value));
    }
    std::ofstream(folder / ".zgroup") << R"({"zarr_format": 2})";
    std::ofstream(folder / ".zattrs") << R"({"multiscales": [{"version": "0.4", "name": "x",
      "axes": [{"name": "z", "type": "space", "unit": "millimeter"}, {"name": "y", "type": "space", "unit": "millimeter"},
               {"name": "x", "type": "space", "unit": "millimeter"}],
      "datasets": [{"path": "0", "coordinateTransformations": [{"type": "scale", "scale": [1, 1, 1]}]},
                   {"path": "1", "coordinateTransformations": [{"type": "scale", "scale": [2, 2, 2]},
                                                               {"type": "translation", "translation": [0.5, 0.5, 0.5]}]}]}]})";
    return folder.string();
  };
  source.path = file();
  EXPECT_EQ(at(source, 0).grid->value(1, 1, 1), 10.0);
  const Volume one = at(source, 1);
  EXPECT_EQ(one.grid->dims(), glm::ivec3(8));
  EXPECT_EQ(one.grid->value(1, 1, 1), 77.0);
  EXPECT_EQ(one.coarsestLevel, 1) << "8 voxels are left";
}

// However the volume is read: whole, from its file, a coarser level.
TEST_F(CoarseLevel, OtherVolumesOfAFileAreOffered) {
  const std::filesystem::path folder = test::temporaryFolder() / "several.zarr";
  for (const char* name : {"ct", "mr"}) {
    std::filesystem::create_directories(folder / name);
    std::ofstream(folder / name / ".zarray")
        << R"({"zarr_format": 2, "shape": [16,16,16], "chunks": [16,16,16], "dtype": "|u1", "compressor": null,
               "fill_value": 0, "order": "C", "filters": null})";
    std::ofstream(folder / name / "0.0.0", std::ios::binary) << std::string(4096, name[0]);
  }
  std::ofstream(folder / ".zgroup") << R"({"zarr_format": 2})";
  scene::Source source;
  source.path = folder.string();
  scene::Machine inFile;
  inFile.voxels = scene::VoxelPlace::file;
  for (const char* series : {"", "mr"}) {
    source.series = series;
    for (const auto& volume : {at(source, 0), at(source, 1), loadVolume(source, inFile, progress_)->volume}) {
      EXPECT_EQ(volume.name, "several.zarr");
      EXPECT_THAT(volume.seriesChoices, testing::ElementsAre("ct\tct", "mr\tmr"));
      const auto note = testing::Contains(HasSubstr("2 images; the first is shown"));
      if (*series)
        EXPECT_THAT(volume.warnings, Not(note));
      else
        EXPECT_THAT(volume.warnings, note);
      EXPECT_EQ(volume.grid->value(1, 1, 1), *series ? 'm' : 'c');
    }
  }
}

TEST_F(CoarseLevel, WhatThereIsNotIsRefused) {
  const glm::ivec3 dims(64, 20, 20);
  const scene::Source source = written(dims, "uint8", std::vector<std::uint8_t>(64 * 400, 3));
  EXPECT_EQ(at(source, 3).coarsestLevel, 3);
  EXPECT_THAT(refusal(source, 4, base::ErrorKind::usage), HasSubstr("the coarsest is 3"));
  scene::Source phantom;
  phantom.path = "phantom:ball:32";
  EXPECT_THAT(refusal(phantom, 1, base::ErrorKind::usage), HasSubstr("phantoms are no files"));
  scene::Machine machine;
  machine.voxels = scene::VoxelPlace::file;
  scene::Source coarse = source;
  coarse.level = 1;
  EXPECT_THROW(loadVolume(coarse, machine, progress_), base::Error);
}

TEST_F(CoarseLevel, TheFinestThatFitsIsNamedToWhoAsksForMore) {
  const glm::ivec3 dims(64);
  const scene::Source source = written(dims, "uint16", std::vector<std::uint16_t>(64 * 64 * 64, 3));
  EXPECT_EQ(levelThatFits(source, progress_), 0);
  const test::MemoryLimit limit(std::size_t{100} << 10);  // level 1: 32^3 * 2.5 bytes
  EXPECT_EQ(levelThatFits(source, progress_), 1);
  try {
    loadVolume(source, progress_);
    FAIL() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_THAT(error.what(), HasSubstr("source.level=1"));
  }
}

TEST_F(CoarseLevel, AStopIsHeeded) {
  const glm::ivec3 dims(64);
  const scene::Source source = written(dims, "uint8", std::vector<std::uint8_t>(64 * 64 * 64, 3));
  progress_.requestStop();
  refusal(source, 1, base::ErrorKind::interrupted);
}

}  // namespace
}  // namespace isolux::volume
