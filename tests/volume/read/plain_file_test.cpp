// Parts of files whose voxels are plain bytes: the voxels that the readers of whole files find.
#include "volume/read/plain_file.h"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/test_data.h"
#include "tests/support/volumes.h"
#include "volume/voxels/stored_type.h"
#include "volume/write/writer.h"

namespace isolux::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using volume::ChunkedVolume;

// Some numbers of each type, with a NaN and an infinity where the type has them.
template <class T>
std::vector<T> countedVoxels(std::size_t count) {
  std::vector<T> voxels(count);
  for (std::size_t i = 0; i < count; ++i) voxels[i] = static_cast<T>((i * 2654435761u) >> 7);
  if constexpr (std::is_same_v<T, float>) {
    voxels[5] = std::nanf("");
    voxels[9] = INFINITY;
  }
  return voxels;
}

void writeBytes(const fs::path& file, const void* bytes, std::size_t count) {
  std::ofstream(file, std::ios::binary)
      .write(static_cast<const char*>(bytes), static_cast<std::streamsize>(count));
}

std::shared_ptr<const ChunkedVolume> opened(const fs::path& file, volume::ReadOptions options = {}) {
  std::string reason;
  const auto chunked = volume::openPlainFile(file, options, reason);
  EXPECT_TRUE(chunked) << reason;
  return chunked;
}

volume::ReadOptions rawOptions(std::string description) {
  volume::ReadOptions options;
  options.raw = std::move(description);
  return options;
}

// Boxes at corners, of single voxels, rows, slices, and all of it.
void expectSameVoxels(const ChunkedVolume& file, volume::VolumePart part, const volume::Grid& whole) {
  const glm::ivec3 dims = whole.dims();
  EXPECT_EQ(file.facts().storedType, whole.storedType());
  EXPECT_EQ(file.facts().levels.front().geometry.dims, dims);
  EXPECT_EQ(file.facts().levels.front().geometry.worldFromVoxel, whole.geometry().worldFromVoxel);
  const struct {
    glm::ivec3 low, size;
  } boxes[] = {{{0, 0, 0}, dims},
               {{0, 0, 1}, {dims.x, dims.y, 2}},
               {{0, 2, 1}, {dims.x, 3, 2}},
               {{3, 1, 2}, {4, 5, 3}},
               {dims - 1, {1, 1, 1}}};
  for (const auto& box : boxes) {
    volume::withStoredType(whole.storedType(), [&](auto zero) {
      std::vector<decltype(zero)> voxels(static_cast<std::size_t>(box.size.x * box.size.y * box.size.z));
      EXPECT_GE(file.read(part, 0, box.low, box.size, std::as_writable_bytes(std::span(voxels))),
                voxels.size() * sizeof(zero));
      std::size_t i = 0, differing = 0;
      for (int z = 0; z < box.size.z; ++z)
        for (int y = 0; y < box.size.y; ++y)
          for (int x = 0; x < box.size.x; ++x, ++i) {
            const double stored = whole.stored(box.low.x + x, box.low.y + y, box.low.z + z),
                         read = static_cast<double>(voxels[i]);
            if (std::isnan(stored) ? !std::isnan(read) : stored != read) ++differing;
          }
      EXPECT_EQ(differing, 0u);
    });
  }
}

class PlainFiles : public testing::Test {
 protected:
  volume::Volume readWhole(const fs::path& file, volume::ReadOptions options = {}) const {
    base::Progress progress;
    return volume::readVolume(file.string(), options, progress);
  }
  fs::path folder_ = temporaryFolder();
};

TEST_F(PlainFiles, EveryFormatHasTheVoxelsOfItsReader) {
  const volume::Grid ball = phantomGrid("ball", glm::ivec3(13, 11, 9));
  for (const char* name : {"a.nrrd", "a.mhd", "a.mha"}) {
    SCOPED_TRACE(name);
    writeVolume(ball, folder_ / name);
    expectSameVoxels(*opened(folder_ / name), {}, *readWhole(folder_ / name).grid);
  }
}

TEST_F(PlainFiles, RawOfEveryTypeAndByteOrder) {
  const auto check = [&]<class T>(T, const char* type) {
    const auto voxels = countedVoxels<T>(12 * 10 * 8);
    writeBytes(folder_ / "v.raw", voxels.data(), voxels.size() * sizeof(T));
    for (const char* order : {"little", "big"}) {
      SCOPED_TRACE(std::string(type) + " " + order);
      const volume::ReadOptions options = rawOptions("12x10x8 " + std::string(type) + " " + order);
      expectSameVoxels(*opened(folder_ / "v.raw", options), {}, *readWhole(folder_ / "v.raw", options).grid);
    }
  };
  check(std::int8_t{}, "int8");
  check(std::uint8_t{}, "uint8");
  check(std::int16_t{}, "int16");
  check(std::uint16_t{}, "uint16");
  check(float{}, "float32");
}

TEST_F(PlainFiles, ComponentsTimeStepsAndSeveralDataFiles) {
  const auto voxels = countedVoxels<std::int16_t>(2 * 9 * 8 * 6 * 3);
  for (int file = 0; file < 2; ++file)
    writeBytes(folder_ / ("part" + std::to_string(file) + ".raw"), voxels.data() + file * voxels.size() / 2,
               voxels.size());
  std::ofstream(folder_ / "v.nhdr") << "NRRD0005\ntype: short\ndimension: 5\nsizes: 2 9 8 6 3\n"
                                       "kinds: vector domain domain domain time\nencoding: raw\nendian: big\n"
                                       "data file: LIST\npart0.raw\npart1.raw\n";
  const auto file = opened(folder_ / "v.nhdr");
  EXPECT_EQ(file->facts().channels, 2);
  EXPECT_EQ(file->facts().times, 3);
  for (int time = 0; time < 3; ++time)
    for (int channel = 0; channel < 2; ++channel) {
      SCOPED_TRACE(std::to_string(time) + " " + std::to_string(channel));
      volume::ReadOptions options;
      options.component = channel;
      options.timeStep = time;
      expectSameVoxels(*file, {time, channel}, *readWhole(folder_ / "v.nhdr", options).grid);
    }
}

TEST_F(PlainFiles, AppendedRawOfVtkXml) {
  const auto voxels = countedVoxels<std::uint16_t>(7 * 6 * 5);
  std::ofstream out(folder_ / "v.vti", std::ios::binary);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" "
         "header_type=\"UInt64\">\n<ImageData WholeExtent=\"0 6 0 5 0 4\" Origin=\"1 2 3\" Spacing=\"1 2 "
         "3\">\n"
         "<Piece Extent=\"0 6 0 5 0 4\"><PointData Scalars=\"v\"><DataArray type=\"UInt16\" Name=\"v\" "
         "format=\"appended\" offset=\"0\"/></PointData></Piece></ImageData>\n<AppendedData "
         "encoding=\"raw\">_";
  const std::uint64_t bytes = voxels.size() * 2;
  out.write(reinterpret_cast<const char*>(&bytes), 8);
  out.write(reinterpret_cast<const char*>(voxels.data()), static_cast<std::streamsize>(bytes));
  out << "</AppendedData></VTKFile>";
  out.close();
  const volume::GridGeometry geometry =
      volume::GridGeometry::make({7, 6, 5}, {1.0, 2.0, 3.0}, {1.0, 2.0, 3.0});
  expectSameVoxels(*opened(folder_ / "v.vti"), {}, volume::Grid(geometry, voxels));
}

TEST_F(PlainFiles, WhatCannotBeReadInPartsSaysWhy) {
  const auto reasonOf = [&](const std::string& header) {
    std::ofstream(folder_ / "v.nrrd") << "NRRD0005\ndimension: 3\nsizes: 4 4 4\n"
                                      << header << "\n\n"
                                      << std::string(1000, '1');
    std::string reason;
    EXPECT_FALSE(volume::openPlainFile(folder_ / "v.nrrd", {}, reason)) << header;
    return reason;
  };
  EXPECT_THAT(reasonOf("type: uchar\nencoding: gzip"), HasSubstr("compressed"));
  EXPECT_THAT(reasonOf("type: uchar\nencoding: text"), HasSubstr("text"));
  EXPECT_THAT(reasonOf("type: double\nencoding: raw\nendian: little"), HasSubstr("float64"));
}

TEST_F(PlainFiles, AFileThatIsTooShortIsRefusedAndOneThatBecomesShorterIsAnError) {
  const auto voxels = countedVoxels<std::uint16_t>(8 * 8 * 8);
  writeBytes(folder_ / "v.raw", voxels.data(), voxels.size() * 2);
  std::string reason;
  EXPECT_THROW(volume::openPlainFile(folder_ / "v.raw", rawOptions("8x8x9 uint16"), reason), base::Error);
  const auto file = opened(folder_ / "v.raw", rawOptions("8x8x8 uint16"));
  fs::resize_file(folder_ / "v.raw", 300);
  std::vector<std::uint16_t> slice(64);
  EXPECT_EQ(file->read({}, 0, {0, 0, 0}, {8, 8, 1}, std::as_writable_bytes(std::span(slice))), 128u);
  try {
    file->read({}, 0, {0, 0, 7}, {8, 8, 1}, std::as_writable_bytes(std::span(slice)));
    FAIL() << "read beyond the end";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_THAT(error.what(), HasSubstr("truncated"));
  }
}

}  // namespace
}  // namespace isolux::test
