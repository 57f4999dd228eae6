#include "tests/volume/read/reader_support.h"

#include <algorithm>
#include <fstream>

#include <bzlib.h>
#include <zlib.h>

namespace isolux::test {

namespace fs = std::filesystem;

void writeFile(const fs::path& path, const std::string& bytes) {
  std::ofstream out(path, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  ASSERT_TRUE(out.good()) << path;
}

std::string contentOfFile(const fs::path& path) {
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

namespace {
std::string deflated(const std::string& bytes, int windowBits) {
  z_stream z{};
  EXPECT_EQ(deflateInit2(&z, 9, Z_DEFLATED, windowBits, 8, Z_DEFAULT_STRATEGY), Z_OK);
  std::string out(deflateBound(&z, bytes.size()) + 64, '\0');
  std::string in = bytes;
  z.next_in = reinterpret_cast<Bytef*>(in.data());
  z.avail_in = static_cast<uInt>(in.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  EXPECT_EQ(deflate(&z, Z_FINISH), Z_STREAM_END);
  out.resize(z.total_out);
  deflateEnd(&z);
  return out;
}
}  // namespace

std::string gzipped(const std::string& bytes) {
  return deflated(bytes, 31);
}
std::string zlibbed(const std::string& bytes) {
  return deflated(bytes, 15);
}

std::string bzip2(const std::string& bytes) {
  std::string in = bytes, out(bytes.size() + bytes.size() / 100 + 600, '\0');
  auto size = static_cast<unsigned>(out.size());
  EXPECT_EQ(BZ2_bzBuffToBuffCompress(out.data(), &size, in.data(), static_cast<unsigned>(in.size()), 1, 0, 0),
            BZ_OK);
  out.resize(size);
  return out;
}

volume::Volume readFile(const fs::path& path, const volume::ReadOptions& options) {
  base::Progress progress;
  return volume::readVolume(path.string(), options, progress);
}

std::vector<double> valuesOf(const volume::Volume& volume) {
  std::vector<double> values;
  const auto& grid = *volume.grid;
  for (int z = 0; z < grid.dims().z; ++z)
    for (int y = 0; y < grid.dims().y; ++y)
      for (int x = 0; x < grid.dims().x; ++x) values.push_back(grid.value(x, y, z));
  return values;
}

glm::dvec3 worldOf(const volume::Volume& volume, int x, int y, int z) {
  return glm::dvec3(volume.grid->geometry().worldFromVoxel * glm::dvec4(x, y, z, 1.0));
}

void expectNear(const glm::dvec3& got, const glm::dvec3& wanted, double tolerance) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(got[axis], wanted[axis], tolerance) << "axis " << axis;
}

bool warns(const volume::Volume& volume, const std::string& part) {
  return std::any_of(volume.warnings.begin(), volume.warnings.end(),
                     [&](const std::string& warning) { return warning.find(part) != std::string::npos; });
}

void expectError(const fs::path& path, const std::string& reason, const volume::ReadOptions& options,
                 base::ErrorKind kind) {
  SCOPED_TRACE(path.string());
  try {
    readFile(path, options);
    FAIL() << "was read";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), kind) << error.what();
    EXPECT_THAT(error.file(), testing::HasSubstr(path.stem().string())) << error.what();
    EXPECT_THAT(std::string(error.what()), testing::HasSubstr(reason));
    EXPECT_FALSE(error.place().empty() && error.reason().empty());
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
  }
}

std::string NiftiFile::header() const {
  std::string out(348, '\0');
  const auto put = [&](std::size_t at, auto value) {
    const std::string raw = bytesOf(std::vector{value}, big);
    out.replace(at, raw.size(), raw);
  };
  put(0, std::int32_t{348});
  put(40, static_cast<std::int16_t>(dims.size()));
  for (std::size_t i = 0; i < 7; ++i)
    put(42 + 2 * i, static_cast<std::int16_t>(i < dims.size() ? dims[i] : 1));
  put(68, static_cast<std::int16_t>(intent));
  put(70, static_cast<std::int16_t>(datatype));
  put(72, static_cast<std::int16_t>(bitpix));
  for (std::size_t i = 0; i < pixdim.size(); ++i) put(76 + 4 * i, pixdim[i]);
  put(108, voxOffset);
  put(112, slope);
  put(116, intercept);
  put(123, static_cast<std::uint8_t>(units));
  put(252, static_cast<std::int16_t>(qformCode));
  put(254, static_cast<std::int16_t>(sformCode));
  for (std::size_t i = 0; i < 3; ++i) {
    put(256 + 4 * i, quaternion[i]);
    put(268 + 4 * i, qoffset[i]);
  }
  for (std::size_t i = 0; i < 12; ++i) put(280 + 4 * i, srow[i]);
  out.replace(344, magic.size(), magic);
  return out;
}

std::string NiftiFile::bytes() const {
  return header() + std::string(4, '\0') + voxels;
}

}  // namespace isolux::test
