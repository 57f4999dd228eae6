// Reading takes at most twice what the file claims.
#include <fstream>

#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

// A line of /proc/self/status ("VmRSS:", "VmHWM:" = its peak), bytes; 0 where there is none.
std::size_t statusBytes(const std::string& field) {
  std::ifstream in("/proc/self/status");
  for (std::string word; in >> word;) {
    std::size_t kilobytes = 0;
    if (word == field && in >> kilobytes) return kilobytes * 1024;
  }
  return 0;
}

// Forgets the peak so far.
bool resetPeak() {
  std::ofstream out("/proc/self/clear_refs");
  out << 5;
  return static_cast<bool>(out.flush());
}

constexpr std::size_t voxels = std::size_t{192} * 192 * 192;

// Values that need float64 in the file (8 bytes per voxel) and float32 in the grid, written in small parts.
void writeVoxels(std::ofstream& out) {
  std::vector<double> slice(192 * 192);
  for (std::size_t z = 0; z < 192; ++z) {
    for (std::size_t i = 0; i < slice.size(); ++i) slice[i] = 1e6 + 1e-7 * static_cast<double>(i + z);
    out.write(reinterpret_cast<const char*>(slice.data()), static_cast<std::streamsize>(slice.size() * 8));
  }
}

void expectFrugal(const std::filesystem::path& path) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
  GTEST_SKIP() << "sanitizers need memory of their own";
#endif
  if (!resetPeak()) GTEST_SKIP() << "the peak of memory cannot be measured here";
  const std::size_t before = statusBytes("VmRSS:");
  const auto v = test::readFile(path);
  const std::size_t grown = statusBytes("VmHWM:") - before;
  EXPECT_EQ(v.fileType, volume::VoxelType::float64);
  EXPECT_EQ(v.grid->storedType(), volume::VoxelType::float32);
  EXPECT_LE(grown, 2 * 8 * voxels + (std::size_t{8} << 20));
}

TEST(ReaderMemory, NrrdTakesAtMostTwiceTheClaim) {
  const auto path = test::temporaryFolder() / "v.nrrd";
  std::ofstream out(path, std::ios::binary);
  out << "NRRD0004\ntype: double\ndimension: 3\nsizes: 192 192 192\nencoding: raw\nendian: little\n"
         "spacings: 1 1 1\n\n";
  writeVoxels(out);
  out.close();
  expectFrugal(path);
}

TEST(ReaderMemory, VtiTakesAtMostTwiceTheClaim) {
  const auto path = test::temporaryFolder() / "v.vti";
  std::ofstream out(path, std::ios::binary);
  out << "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">"
         "<ImageData WholeExtent=\"0 191 0 191 0 191\" Origin=\"0 0 0\" Spacing=\"1 1 1\">"
         "<Piece Extent=\"0 191 0 191 0 191\"><PointData Scalars=\"a\">"
         "<DataArray type=\"Float64\" Name=\"a\" format=\"appended\" "
         "offset=\"0\"/></PointData></Piece></ImageData>"
         "<AppendedData encoding=\"raw\">_"
      << test::bytesOf<std::uint64_t>({8 * voxels});
  writeVoxels(out);
  out << "</AppendedData></VTKFile>";
  out.close();
  expectFrugal(path);
}

}  // namespace
}  // namespace isolux
