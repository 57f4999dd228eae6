// Damaged files of the formats that others parse: whatever becomes of the reader, there is a volume or one
// line.
#include <array>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/resource.h>

#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using base::ErrorKind;
using test::expectError;
using test::writeFile;

// Up to four bytes of [begin, end) become others; the recipe is the seed (Knuth's MMIX numbers).
std::string mutantOf(std::string bytes, std::size_t begin, std::size_t end, std::uint64_t seed) {
  std::uint64_t state = seed;
  const auto next = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return state >> 33;
  };
  for (int i = 0; i < 3; ++i) next();
  for (std::uint64_t edits = 1 + next() % 4; edits > 0; --edits) {
    const std::size_t at = begin + next() % (end - begin);
    bytes[at] = static_cast<char>(next() & 255);
  }
  return bytes;
}

// A volume, or one error of a kind that files have.
void expectAnswer(const fs::path& path) {
  try {
    test::readFile(path);
  } catch (const base::Error& error) {
    EXPECT_TRUE(error.kind() == ErrorKind::input || error.kind() == ErrorKind::memory) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
  }
}

TEST(DamagedFiles, DicomHeaders) {
  ISOLUX_NEEDS_DATA();
  const std::string whole = test::contentOfFile(test::dataFolder() / "dicom" / "ct_head_64" / "CTHead34.dcm");
  ASSERT_GT(whole.size(), 1410u);
  const fs::path file = test::temporaryFolder() / "a.dcm";
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    SCOPED_TRACE(seed);
    writeFile(file, mutantOf(whole, 132, 1410, seed));
    expectAnswer(file);
  }
}

std::string polyData(const std::string& components, const std::string& offsets) {
  return R"(<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt32"><PolyData>
<Piece NumberOfPoints="4" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" NumberOfPolys="4"><Points>
<DataArray type="Float32" NumberOfComponents=")" +
         components + R"(" format="ascii">0 0 0 1 0 0 0 1 0 0 0 1</DataArray></Points><Polys>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 0 1 3 0 2 3 1 2 3</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">)" +
         offsets + "</DataArray></Polys></Piece></PolyData></VTKFile>";
}

TEST(DamagedFiles, PolyData) {
  const fs::path file = test::temporaryFolder() / "a.vtp";
  const std::string whole = polyData("3", "3 6 9 12");
  writeFile(file, whole);
  EXPECT_EQ(test::readFile(file).format, "VTK PolyData mesh");
  // Once "a mistake in Isolux itself: vector::_M_default_append", and minutes.
  writeFile(file, polyData("-3", "3 6 9 12"));
  expectError(file, "NumberOfComponents");
  writeFile(file, polyData("3000000000", "3 6 9 12"));
  expectError(file, "NumberOfComponents");
  writeFile(file, polyData("3", "3 6 9 99999999"));
  expectError(file, "");
  writeFile(file, polyData("3", "3 -6 9 12"));
  expectError(file, "");
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    writeFile(file, mutantOf(whole, 0, whole.size(), seed));
    expectAnswer(file);
  }
}

// As `isolux bake` writes its key: strings as numbers of characters.
std::string imageWithText(const std::string& tuples, const std::string& text) {
  return R"(<VTKFile type="ImageData" version="1.0" byte_order="LittleEndian" header_type="UInt64">
<ImageData WholeExtent="0 1 0 1 0 1" Origin="0 0 0" Spacing="1 1 1"><FieldData>
<Array type="String" Name="key" NumberOfTuples=")" +
         tuples + "\" format=\"ascii\">" + text + R"(</Array></FieldData>
<Piece Extent="0 1 0 1 0 1"><PointData Scalars="a"><DataArray type="UInt8" Name="a" format="ascii">
0 1 2 3 4 5 6 7</DataArray></PointData></Piece></ImageData></VTKFile>)";
}

TEST(DamagedFiles, TextsBesideAnImage) {
  const fs::path file = test::temporaryFolder() / "a.vti";
  const std::string whole = imageWithText("1", "107 101 121 0");
  writeFile(file, whole);
  EXPECT_EQ(test::readFile(file).grid->maximum(), 7.0);
  writeFile(file, imageWithText("99999999999", "107 0"));
  expectError(file, "NumberOfTuples");
  for (const char* text : {"107", "", "107 999 -4 0", "0 0 0 0 0"}) {
    SCOPED_TRACE(text);
    writeFile(file, imageWithText("2", text));
    expectAnswer(file);
  }
  for (std::uint64_t seed = 1; seed <= 24; ++seed) {
    SCOPED_TRACE(seed);
    writeFile(file, mutantOf(whole, 0, whole.size(), seed));
    expectAnswer(file);
  }
}

// What this process and its readers that have ended have taken in.
struct Taken {
  std::uint64_t bytesRead = 0;
  long pages = 0;  // of memory and of mapped files that were touched for the first time
};

Taken takenSoFar() {
  Taken taken;
  std::ifstream io("/proc/self/io");
  for (std::string name; io >> name >> taken.bytesRead && name != "rchar:";) {
  }
  for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
    rusage used{};
    ::getrusage(who, &used);
    taken.pages += used.ru_minflt + used.ru_majflt;
  }
  return taken;
}

// Files that are long and empty cost nothing: their headers are read first.
TEST(DamagedFiles, HugeSparseFilesAreRefusedAtOnce) {
  const fs::path folder = test::temporaryFolder();
  const std::string vti =
      R"(<VTKFile type="ImageData"><ImageData WholeExtent="0 1 0 1 0 1"><Piece Extent="0 1 0 1 0 1">)";
  const std::array<std::pair<const char*, std::string>, 4> files{
      {{"a.vti", vti}, {"a.dcm", ""}, {"b.dcm", std::string(128, '\0') + "DICM"}, {"a.tif", "II*"}}};
  for (const auto& [name, head] : files) {
    SCOPED_TRACE(name);
    const fs::path file = folder / name;
    writeFile(file, head);
    fs::resize_file(file, std::uintmax_t{20} << 30);
    const Taken before = takenSoFar();
    expectAnswer(file);
    const Taken after = takenSoFar();
    EXPECT_LT(after.bytesRead - before.bytesRead, std::uint64_t{64} << 20);
    EXPECT_LT(after.pages - before.pages, 200000);  // starting a reader takes a tenth of that
    fs::remove(file);
  }
}

}  // namespace
}  // namespace isolux
