// FreeSurfer's MGH, field by field; compare_readers.py compares whole files with nibabel.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "tests/volume/read/reader_support.h"
#include "volume/read/volume_file.h"

namespace isolux {
namespace {

using test::bytesOf;
using test::expectError;
using test::expectNear;
using test::ramp;
using test::readFile;
using test::valuesOf;
using test::worldOf;
using test::writeFile;
using test::zeroToSeven;

struct MghFile {
  std::vector<std::int32_t> sizes{2, 2, 2, 1};
  std::int32_t version = 1, type = 0;
  std::int16_t hasRas = 1;
  std::vector<float> delta{1, 1, 1}, directions{-1, 0, 0, 0, 0, -1, 0, 1, 0}, centre{0, 0, 0};
  std::string voxels = bytesOf(ramp<std::uint8_t>(8));
  std::string bytes() const {
    std::string head = bytesOf<std::int32_t>({version}, true) + bytesOf(sizes, true) +
                       bytesOf<std::int32_t>({type, 0}, true) + bytesOf<std::int16_t>({hasRas}, true) +
                       bytesOf(delta, true) + bytesOf(directions, true) + bytesOf(centre, true);
    head.resize(284, '\0');
    return head + voxels;
  }
};

volume::Volume read(const MghFile& file, const volume::ReadOptions& options = {}) {
  const auto path = test::temporaryFolder() / "v.mgh";
  writeFile(path, file.bytes());
  return readFile(path, options);
}

TEST(Mgh, TheCentreLiesAtHalfTheNumberOfVoxels) {
  MghFile file;
  file.delta = {2, 3, 4};
  file.centre = {10, 20, 30};
  const auto v = read(file);
  EXPECT_EQ(v.format, "FreeSurfer MGH");
  EXPECT_EQ(v.axes, scene::WorldAxes::anatomical);
  EXPECT_EQ(valuesOf(v), zeroToSeven);
  expectNear(worldOf(v, 1, 1, 1), {-10, -20, 30});
  expectNear(worldOf(v, 2, 1, 1), {-8, -20, 30});   // RAS (-1, 0, 0)
  expectNear(worldOf(v, 1, 2, 1), {-10, -20, 27});  // RAS (0, 0, -1)
  expectNear(worldOf(v, 1, 1, 2), {-10, -24, 30});  // RAS (0, 1, 0)
}

TEST(Mgh, TypesAreBigEndian) {
  MghFile file;
  const auto expectType = [&](int type, const std::string& voxels, volume::VoxelType wanted) {
    file.type = type;
    file.voxels = voxels;
    const auto v = read(file);
    EXPECT_EQ(v.fileType, wanted);
    EXPECT_EQ(valuesOf(v), zeroToSeven) << type;
  };
  expectType(0, bytesOf(ramp<std::uint8_t>(8)), volume::VoxelType::uint8);
  expectType(1, bytesOf(ramp<std::int32_t>(8), true), volume::VoxelType::int32);
  expectType(3, bytesOf(ramp<float>(8), true), volume::VoxelType::float32);
  expectType(4, bytesOf(ramp<std::int16_t>(8), true), volume::VoxelType::int16);
  expectType(10, bytesOf(ramp<std::uint16_t>(8), true), volume::VoxelType::uint16);
}

TEST(Mgh, FramesAreTimeSteps) {
  MghFile file;
  file.sizes[3] = 2;
  file.voxels += bytesOf(ramp<std::uint8_t>(8, 100));
  volume::ReadOptions options;
  options.timeStep = 1;
  const auto v = read(file, options);
  EXPECT_EQ(v.timeSteps, 2);
  EXPECT_EQ(valuesOf(v), ramp<double>(8, 100));
}

TEST(Mgh, WithoutOrientationFreeSurfersOwnHolds) {
  MghFile file;
  file.hasRas = 0;
  file.delta = {5, 5, 5};  // means nothing then
  const auto v = read(file);
  EXPECT_TRUE(test::warns(v, "goodRASFlag is 0"));
  EXPECT_TRUE(test::warns(v, "1 mm assumed"));
  EXPECT_EQ(v.axes, scene::WorldAxes::zUp);
  expectNear(worldOf(v, 0, 0, 0), {-1, 1, 1});
  expectNear(worldOf(v, 1, 1, 1), {0, 0, 0});
}

TEST(Mgh, GzippedUnderAnyName) {
  MghFile file;
  file.voxels += bytesOf<float>({2.5f, 0.1f, 3, 0, 0}, true) + "tags of FreeSurfer";
  for (const char* name : {"a.mgz", "a.mgh.gz", "named.differently"}) {
    const auto path = test::temporaryFolder() / name;
    writeFile(path, test::gzipped(file.bytes()));
    const auto v = readFile(path);
    EXPECT_EQ(valuesOf(v), zeroToSeven) << name;
    EXPECT_TRUE(v.warnings.empty()) << name << ": what follows the voxels is known";
  }
}

TEST(Mgh, PlainBytesAreReadInParts) {
  const auto path = test::temporaryFolder() / "v.mgh";
  writeFile(path, MghFile{}.bytes());
  base::Progress progress;
  const volume::VolumeFile file = volume::openVolume(path.string(), {}, progress);
  ASSERT_NE(file.parts, nullptr) << file.whyWhole;
  EXPECT_EQ(file.parts->facts().levels.front().geometry.dims, glm::ivec3(2));
}

TEST(Mgh, BrokenFilesAreRefusedInOneLine) {
  const auto path = test::temporaryFolder() / "b.mgh";
  const auto refuse = [&](const std::string& bytes, const std::string& reason) {
    writeFile(path, bytes);
    expectError(path, reason);
  };
  MghFile file;
  refuse(file.bytes().substr(0, 200), "an MGH header has 284 bytes");
  refuse(file.bytes().substr(0, 290), "truncated");
  file.version = 2;
  refuse(file.bytes(), "version");
  file.version = 1;
  file.type = 5;
  refuse(file.bytes(), "voxel type 5");
  file.type = 0;
  file.sizes[1] = 70000;
  refuse(file.bytes(), "at most 65535");
  file.sizes[1] = -2;
  refuse(file.bytes(), "at least 1");
  file.sizes[1] = 2;
  file.delta[0] = 0;
  EXPECT_TRUE(test::warns(read(file), "spacing along x is 0"));
  const auto packed = test::temporaryFolder() / "b.mgz";
  writeFile(packed, test::gzipped("short"));
  expectError(packed, "an MGH header has 284 bytes");
}

}  // namespace
}  // namespace isolux
