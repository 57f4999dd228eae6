// Levels of volumes that are too large: means computed in another way, where they lie, what fits.
#include "volume/large/coarse_level.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <type_traits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/random.h"
#include "tests/support/memory_limit.h"
#include "tests/support/test_data.h"
#include "tests/support/zarr_folder.h"
#include "volume/prepared/prepared_volume.h"

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
                      : readLevel(openSource(source, progress_), source, progress_);
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
  scene::HostSettings inFile;
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
  EXPECT_THAT(refusal(phantom, 1, base::ErrorKind::usage), HasSubstr("a phantom is not a file"));
  scene::HostSettings host;
  host.voxels = scene::VoxelPlace::file;
  scene::Source coarse = source;
  coarse.level = 1;
  EXPECT_THROW(loadVolume(coarse, host, progress_), base::Error);
}

TEST_F(CoarseLevel, TheFinestThatFitsIsNamedToWhoAsksForMore) {
  const glm::ivec3 dims(64);
  const scene::Source source = written(dims, "uint16", std::vector<std::uint16_t>(64 * 64 * 64, 3));
  EXPECT_EQ(levelThatFits(openSource(source, progress_)), 0);
  const test::MemoryLimit limit(std::size_t{100} << 10);  // level 1: 32^3 * 2.5 bytes
  EXPECT_EQ(levelThatFits(openSource(source, progress_)), 1);
  try {
    loadVolume(source, progress_);
    FAIL() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_THAT(error.what(), HasSubstr("source.level=1"));
  }
}

// Of chunks of which one is cut: means of what is known, missing where nothing is.
template <class T>
class DamagedLevel : public CoarseLevel {
 protected:
  void SetUp() override {
    source_.path = (test::temporaryFolder() / "damaged.zarr").string();
    whole_.path = (test::temporaryFolder() / "whole.zarr").string();
    for (const scene::Source& source : {source_, whole_})
      test::writeZarr(source.path, kDims, kChunk, voxels_);
    test::cutChunk(source_.path, kCut);
    source_.aroundDamage = true;
  }
  // Of a level's voxel, over those voxels that are known; NaN where there are none.
  double mean(glm::ivec3 at, int factor) const {
    double sum = 0.0, weights = 0.0;
    for (int z = factor * at.z; z < factor * (at.z + 1); ++z)
      for (int y = factor * at.y; y < factor * (at.y + 1); ++y)
        for (int x = factor * at.x; x < factor * (at.x + 1); ++x) {
          const glm::ivec3 voxel = glm::min(glm::ivec3(x, y, z), kDims - 1);
          if (voxel / kChunk == kCut) continue;
          sum += noise(voxel.x, voxel.y, voxel.z) * 100.0 > 50.0 ? 90.0 : 10.0;
          weights += 1.0;
        }
    return sum / weights;
  }
  void expectMeans(const Volume& volume, int factor, double precision) const {
    std::size_t missing = 0;
    const glm::ivec3 dims = volume.grid->dims();
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) {
          const double expected = mean({x, y, z}, factor), found = volume.grid->value(x, y, z);
          missing += std::isnan(expected);
          ASSERT_EQ(std::isnan(expected), std::isnan(found)) << x << " " << y << " " << z;
          if (std::isnan(expected)) continue;
          ASSERT_NEAR(found, expected, precision) << x << " " << y << " " << z;
        }
    EXPECT_GT(missing, 0u);
    EXPECT_EQ(volume.grid->missingCount(), missing);
  }
  // Why the source is not loaded, as an input error.
  std::string whyNot(int level) {
    scene::Source source = source_;
    source.level = level;
    try {
      loadVolume(source, this->progress_);
    } catch (const base::Error& error) {
      EXPECT_EQ(error.kind(), base::ErrorKind::input) << error.what();
      return error.what();
    }
    ADD_FAILURE() << "level " << level << " was read";
    return {};
  }

  static constexpr glm::ivec3 kDims{41, 35, 29}, kChunk{9}, kCut{2, 1, 1};
  const std::vector<T> voxels_ = this->template filled<T>(
      kDims, [](int x, int y, int z) { return noise(x, y, z) * 100.0 > 50.0 ? 90.0 : 10.0; });
  scene::Source source_, whole_;
};
using DamagedTypes = testing::Types<std::uint8_t, std::int16_t, float>;
TYPED_TEST_SUITE(DamagedLevel, DamagedTypes);

TYPED_TEST(DamagedLevel, MeansAreOfWhatIsKnown) {
  const double rounding = std::is_integral_v<TypeParam> ? 0.5 : 1e-5;
  const Volume level = this->at(this->source_, 1);
  this->expectMeans(level, 2, rounding);
  EXPECT_THAT(level.damage, HasSubstr("a part of it cannot be read: "));
  EXPECT_THAT(level.damage, HasSubstr("1.1.2"));
  EXPECT_THAT(level.warnings.at(0), HasSubstr(level.damage + "; its voxels count as missing"));
  EXPECT_THAT(level.warnings.at(1), HasSubstr("level 1: each voxel is the mean of 2x2x2"));
}

TYPED_TEST(DamagedLevel, VoxelsThemselvesAreMissingWhereNothingIsKnown) {
  const auto volume = loadVolume(this->source_, this->progress_);
  this->expectMeans(volume->volume, 1, 0.0);
  EXPECT_EQ(volume->grid().missingCount(), 729u);
  EXPECT_THAT(volume->volume.damage, HasSubstr("1.1.2"));
  for (const std::string& warning : volume->volume.warnings) EXPECT_THAT(warning, Not(HasSubstr("level 0")));
}

TYPED_TEST(DamagedLevel, WhereNothingIsDamagedNothingChanges) {
  for (const int level : {0, 1}) {
    scene::Source around = this->whole_;
    around.aroundDamage = true;
    around.level = this->whole_.level = level;
    const auto with = loadVolume(around, this->progress_),
               without = loadVolume(this->whole_, this->progress_);
    EXPECT_EQ(with->grid().hash(), without->grid().hash());
    EXPECT_EQ(with->grid().storedType(), without->grid().storedType());
    EXPECT_EQ(with->volume.damage, "");
    EXPECT_EQ(with->volume.warnings, without->volume.warnings);
  }
}

// Unasked, a file with damage is refused, and who asks for it hears what would read the rest.
TYPED_TEST(DamagedLevel, ItIsRefusedUnasked) {
  this->source_.aroundDamage = false;
  for (const int level : {0, 1}) {
    const std::string why = this->whyNot(level);
    EXPECT_THAT(why, HasSubstr("1.1.2"));
    EXPECT_THAT(why, HasSubstr("source.around_damage=true reads the rest"));
  }
}

TYPED_TEST(DamagedLevel, OfWhichNothingCanBeReadIsRefused) {
  const glm::ivec3 chunks = (this->kDims + this->kChunk - 1) / this->kChunk;
  for (int z = 0; z < chunks.z; ++z)
    for (int y = 0; y < chunks.y; ++y)
      for (int x = 0; x < chunks.x; ++x) test::cutChunk(this->source_.path, {x, y, z});
  for (const int level : {0, 1}) {
    const std::string why = this->whyNot(level);
    EXPECT_THAT(why, HasSubstr("80 parts of it cannot be read, the first: "));
    EXPECT_THAT(why, HasSubstr("0.0.0")) << "whichever thread was first";
    EXPECT_THAT(why, Not(HasSubstr("around_damage")));
  }
}

// Types that know no missing voxels become one that does, which is larger.
TEST_F(CoarseLevel, WhatMissingVoxelsTakeIsAskedFor) {
  scene::Source source;
  source.path = (test::temporaryFolder() / "cut.zarr").string();
  source.aroundDamage = true;
  constexpr std::size_t voxels = 32 * 32 * 32;
  test::writeZarr(source.path, glm::ivec3(32), glm::ivec3(16), std::vector<std::uint8_t>(voxels, 7));
  const auto readWithin = [&](std::size_t bytes) {
    const test::MemoryLimit limit(bytes);
    return readLevel(openSource(source, progress_), source, progress_).grid->missingCount();
  };
  EXPECT_EQ(readWithin(5 * voxels / 2), 0u);
  test::cutChunk(source.path, glm::ivec3(1));
  try {
    readWithin(5 * voxels / 2);
    ADD_FAILURE() << "the budget was not asked";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
    EXPECT_THAT(error.what(), HasSubstr("missing"));
  }
  EXPECT_EQ(readWithin(10 * voxels), 16u * 16u * 16u);
}

TEST_F(CoarseLevel, AStopIsHeeded) {
  const glm::ivec3 dims(64);
  const scene::Source source = written(dims, "uint8", std::vector<std::uint8_t>(64 * 64 * 64, 3));
  progress_.requestStop();
  refusal(source, 1, base::ErrorKind::interrupted);
}

}  // namespace
}  // namespace isolux::volume
