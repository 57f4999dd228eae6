// Legacy .vtk and .vti files.
#include "tests/volume/read/reader_support.h"

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

std::string legacy(const std::string& encoding, const std::string& attributes) {
  return "# vtk DataFile Version 3.0\na title\n" + encoding +
         "\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nSPACING 0.5 1 2\nORIGIN 10 20 30\n" + attributes;
}

TEST(VtkLegacy, TextAndBinary) {
  const auto path = test::temporaryFolder() / "v.vtk";
  writeFile(path, legacy("ASCII",
                         "POINT_DATA 8\nSCALARS density float 1\nLOOKUP_TABLE default\n0 1 2 3\n4 5 6 7\n"));
  const auto text = readFile(path);
  EXPECT_EQ(valuesOf(text), zeroToSeven);
  EXPECT_EQ(text.fileType, volume::VoxelType::float32);
  expectNear(worldOf(text, 1, 1, 1), {10.5, 21, 32});
  // Binary data are big endian; other arrays may follow.
  writeFile(path, legacy("BINARY", "POINT_DATA 8\nSCALARS density short\nLOOKUP_TABLE default\n") +
                      bytesOf(ramp<std::int16_t>(8), true) +
                      "\nMETADATA\nSCALARS other short\nLOOKUP_TABLE default\n" +
                      bytesOf(ramp<std::int16_t>(8, 9), true));
  const auto binary = readFile(path);
  EXPECT_EQ(valuesOf(binary), zeroToSeven);
  EXPECT_EQ(binary.fileType, volume::VoxelType::int16);
  EXPECT_THAT(binary.warnings, testing::IsEmpty());
}

TEST(VtkLegacy, OtherAttributes) {
  const auto path = test::temporaryFolder() / "v.vtk";
  writeFile(path, legacy("BINARY", "POINT_DATA 8\nVECTORS flow double\n") + bytesOf(ramp<double>(24), true));
  volume::ReadOptions options;
  options.component = 1;
  EXPECT_EQ(valuesOf(readFile(path, options))[7], 22.0);
  writeFile(path, legacy("ASCII", "POINT_DATA 8\nFIELD data 1\nrho 1 8 int\n0 1 2 3 4 5 6 7\n"));
  EXPECT_EQ(valuesOf(readFile(path)), zeroToSeven);
  writeFile(path, legacy("ASCII",
                         "POINT_DATA 8\nSCALARS a short\nLOOKUP_TABLE heat\n0 1 2 3 4 5 6 7\n"
                         "LOOKUP_TABLE heat 2\n0 0 0 1\n1 1 1 1\n"));
  EXPECT_EQ(valuesOf(readFile(path)), zeroToSeven) << "colours are not applied";
  writeFile(path, legacy("ASCII", "POINT_DATA 8\nCOLOR_SCALARS c 1\n0 0.5 1 0 0 0 0 0.25\n"));
  EXPECT_EQ(valuesOf(readFile(path)), (std::vector<double>{0, 0.5, 1, 0, 0, 0, 0, 0.25}));
  writeFile(path, legacy("ASCII", "CELL_DATA 1\nSCALARS c unsigned_char\nLOOKUP_TABLE default\n9\n"));
  const auto cells = readFile(path);
  EXPECT_EQ(cells.grid->dims(), glm::ivec3(1));
  expectNear(worldOf(cells, 0, 0, 0), {10.25, 20.5, 31});
  EXPECT_TRUE(test::warns(cells, "cells"));
  writeFile(path, "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 0 float\n");
  expectError(path, "a mesh; save it as");
  writeFile(path, "# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n");
  expectError(path, "Resample To Image");
}

// VisIt and ParaView write TIME and CYCLE before the dimensions.
TEST(VtkLegacy, FieldsBeforeTheDimensionsAreReadOver) {
  const auto path = test::temporaryFolder() / "v.vtk";
  const std::string data = "POINT_DATA 8\nSCALARS a short\nLOOKUP_TABLE default\n";
  const std::string points = "DIMENSIONS 2 2 2\nSPACING 0.5 1 2\nORIGIN 10 20 30\n",
                    title = "# vtk DataFile Version 3.0\nt\n";
  const std::string dataset = "DATASET STRUCTURED_POINTS\n";
  const std::string texts = "FIELD FieldData 2\nTIME 1 1 double\n0.25\nCYCLE 1 2 int\n7\n8\n";
  for (const std::string& head :
       {dataset + texts + points, texts + dataset + points, dataset + points + texts}) {
    writeFile(path, title + "ASCII\n" + head + data + "0 1 2 3 4 5 6 7\n");
    EXPECT_EQ(valuesOf(readFile(path)), zeroToSeven);
  }
  // A binary number may hold what ends a line.
  const std::string binary = "FIELD FieldData 2\nTIME 1 1 double\n" +
                             bytesOf(std::vector<double>{0.25}, true) + "\nCYCLE 1 2 int\n" +
                             bytesOf(std::vector<std::int32_t>{0x0a0a0d0a, 10}, true) + "\n";
  writeFile(path,
            title + "BINARY\n" + dataset + binary + points + data + bytesOf(ramp<std::int16_t>(8), true));
  const auto volume = readFile(path);
  EXPECT_EQ(valuesOf(volume), zeroToSeven);
  expectNear(worldOf(volume, 1, 1, 1), {10.5, 21, 32});
  writeFile(path, title + "BINARY\n" + dataset + "FIELD FieldData 1\nTIME 1 999999 double\n");
  expectError(path, "header");
}

TEST(VtkLegacy, AnEvenRectilinearGridIsAVolume) {
  const auto path = test::temporaryFolder() / "v.vtk";
  const auto grid = [](const std::string& x) {
    return "# vtk DataFile Version 3.0\nt\nASCII\nDATASET RECTILINEAR_GRID\nDIMENSIONS 4 2 1\nX_COORDINATES "
           "4 float\n" +
           x +
           "\nY_COORDINATES 2 float\n5 3\nZ_COORDINATES 1 float\n-1\nPOINT_DATA 8\nSCALARS a "
           "int\nLOOKUP_TABLE default\n"
           "0 1 2 3 4 5 6 7\n";
  };
  writeFile(path, grid("1 1.5\n2 2.5"));
  const auto volume = readFile(path);
  EXPECT_EQ(valuesOf(volume), zeroToSeven);
  expectNear(worldOf(volume, 0, 0, 0), {1, 5, -1});
  expectNear(worldOf(volume, 3, 1, 0), {2.5, 3, -1});
  writeFile(path, grid("1 1.5 2 2.6"));
  expectError(path, "(X_COORDINATES): its steps are uneven");
  writeFile(path, grid("1 1.5 2"));
  expectError(path, "line 8 (Y_COORDINATES): \"Y_COORDINATES\" is not a number");
}

std::string vti(const std::string& attributes, const std::string& array, const std::string& behind = "",
                const std::string& file = "") {
  return "<?xml version=\"1.0\"?>\n<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\" " +
         file + ">\n<ImageData WholeExtent=\"0 1 0 1 0 1\" " + attributes +
         ">\n<Piece Extent=\"0 1 0 1 0 1\">\n<PointData Scalars=\"a\">\n" + array +
         "\n</PointData>\n</Piece>\n</ImageData>\n" + behind + "</VTKFile>\n";
}

TEST(Vti, TextWithDirection) {
  const auto path = test::temporaryFolder() / "v.vti";
  // Row-major: the first column (0,1,0) is the direction of x.
  writeFile(path, vti("Origin=\"10 20 30\" Spacing=\"0.5 1 2\" Direction=\"0 0 -1 1 0 0 0 1 0\"",
                      "<DataArray type=\"Int16\" Name=\"a\" format=\"ascii\">0 1 2 3 4 5 6 7</DataArray>"));
  const auto v = readFile(path);
  EXPECT_EQ(valuesOf(v), zeroToSeven);
  EXPECT_EQ(v.fileType, volume::VoxelType::int16);
  EXPECT_EQ(v.format, "VTK XML");
  expectNear(worldOf(v, 0, 0, 0), {10, 20, 30});
  expectNear(worldOf(v, 1, 0, 0), {10, 20.5, 30});
  expectNear(worldOf(v, 0, 1, 0), {10, 20, 31});
  expectNear(worldOf(v, 0, 0, 1), {8, 20, 30});
}

TEST(Vti, ALongHeaderBeforeAppendedData) {
  const auto path = test::temporaryFolder() / "v.vti";
  for (const int arrays : {10, 20000}) {
    std::string others;
    for (int i = 0; i < arrays; ++i)
      others += "<DataArray type=\"UInt8\" Name=\"b" + std::to_string(i) +
                "\" format=\"appended\" offset=\"0\"/>\n";
    const std::string size = bytesOf(std::vector<std::uint32_t>{8});
    writeFile(path, vti("", "<DataArray type=\"UInt8\" Name=\"a\" format=\"appended\" offset=\"0\"/>\n",
                        "<FieldData>" + others + "</FieldData>\n<AppendedData encoding=\"raw\">\n_" + size +
                            bytesOf(ramp<std::uint8_t>(8)) + "\n</AppendedData>\n"));
    EXPECT_EQ(valuesOf(readFile(path)), zeroToSeven) << arrays;
  }
}

TEST(Vti, OtherKindsAreNamedWithWhatHelps) {
  const auto path = test::temporaryFolder() / "p.pvti";
  const auto pieces = [](const std::string& more) {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PImageData\">\n<PImageData WholeExtent=\"0 1 0 1 0 "
           "1\">\n"
           "<Piece Extent=\"0 1 0 1 0 1\" Source=\"p_0.vti\"/>\n" +
           more + "</PImageData>\n</VTKFile>\n";
  };
  writeFile(path, pieces(""));
  expectError(path, "the voxels are in \"p_0.vti\": open that file");
  writeFile(path, pieces("<Piece Source=\"p_1.vti\"/>"));
  expectError(path, "2 files (p_0.vti, p_1.vti)");
  writeFile(path, "<VTKFile type=\"RectilinearGrid\">\n</VTKFile>\n");
  expectError(path, "is \"RectilinearGrid\"; of volumes ImageData is read: resample it");
}

TEST(Vti, ExtentThatDoesNotStartAtZero) {
  const auto path = test::temporaryFolder() / "v.vti";
  std::string text = vti("Origin=\"10 20 30\" Spacing=\"0.5 1 2\"",
                         "<DataArray type=\"UInt8\" Name=\"a\" format=\"ascii\">0 1 2 3 4 5 6 7</DataArray>");
  for (std::size_t at; (at = text.find("\"0 1 0 1 0 1\"")) != std::string::npos;)
    text.replace(at, 13, "\"4 5 -3 -2 0 1\"");
  writeFile(path, text);
  const auto v = readFile(path);
  EXPECT_EQ(valuesOf(v), zeroToSeven);
  expectNear(worldOf(v, 0, 0, 0), {12, 17, 30});
}

TEST(Vti, AppendedRawAndCompressed) {
  const auto path = test::temporaryFolder() / "v.vti";
  const std::string array = "<DataArray type=\"Float64\" Name=\"a\" format=\"appended\" offset=\"0\"/>";
  const std::string data = bytesOf(ramp<double>(8, 0.5, 1.0));
  writeFile(path, vti("", array,
                      "<AppendedData encoding=\"raw\">_" + bytesOf<std::uint32_t>({64}) + data +
                          "\n</AppendedData>"));
  EXPECT_EQ(valuesOf(readFile(path))[7], 7.5);
  const std::string block = test::zlibbed(data.substr(0, 40)), last = test::zlibbed(data.substr(40));
  const std::string table = bytesOf<std::uint64_t>({2, 40, 24, block.size(), last.size()});
  const std::string file = "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"";
  writeFile(path, vti("", array,
                      "<AppendedData encoding=\"raw\">_" + table + block + last + "\n</AppendedData>", file));
  EXPECT_EQ(valuesOf(readFile(path))[7], 7.5);
  // The same with a table that lies.
  const auto refuse = [&](std::vector<std::uint64_t> numbers, const std::string& reason) {
    writeFile(path,
              vti("", array,
                  "<AppendedData encoding=\"raw\">_" + bytesOf(numbers) + block + last + "\n</AppendedData>",
                  file));
    expectError(path, reason);
  };
  refuse({2, 40, 25, block.size(), last.size()}, "65 bytes");
  refuse({0, 40, 24, block.size(), last.size()}, "no sense");
  refuse({~0ull, 40, 24, block.size(), last.size()}, "no sense");
  refuse({2, ~0ull, 24, block.size(), last.size()}, "no sense");
  refuse({2, 40, 24, block.size(), 1ull << 60}, "truncated");
  refuse({2, 40, 24, block.size() + 1, last.size() - 1}, "VTK");  // only the inflater can tell
}

TEST(Vti, Base64AndSeveralArrays) {
  const auto path = test::temporaryFolder() / "v.vti";
  // 8 as UInt32, then 0..7.
  writeFile(path,
            vti("",
                "<DataArray type=\"Float32\" Name=\"other\" format=\"ascii\">9 9 9 9 9 9 9 9</DataArray>\n"
                "<DataArray type=\"UInt8\" Name=\"a\" format=\"binary\">\n  CAAAAAABAgMEBQYH\n</DataArray>"));
  const auto v = readFile(path);
  EXPECT_EQ(valuesOf(v), zeroToSeven);
  EXPECT_TRUE(test::warns(v, "several arrays"));
}

TEST(Vti, ComponentsAreChosen) {
  const auto path = test::temporaryFolder() / "v.vti";
  writeFile(path, vti("",
                      "<DataArray type=\"UInt8\" Name=\"a\" NumberOfComponents=\"2\" format=\"ascii\">"
                      "9 0 9 1 9 2 9 3 9 4 9 5 9 6 9 7</DataArray>"));
  volume::ReadOptions options;
  options.component = 1;
  const auto v = readFile(path, options);
  EXPECT_EQ(v.components, 2);
  EXPECT_EQ(valuesOf(v), zeroToSeven);
}

TEST(Vti, NothingReachesStderr) {
  const auto path = test::temporaryFolder() / "v.vti";
  const std::string array = "<DataArray type=\"Float64\" Name=\"a\" format=\"appended\" offset=\"0\"/>";
  const std::string file = "header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"";
  writeFile(path, vti("", array,
                      "<AppendedData encoding=\"raw\">_" + bytesOf<std::uint64_t>({1, 64, 0, 20}) +
                          std::string(20, 'x') + "\n</AppendedData>",
                      file));
  testing::internal::CaptureStderr();
  testing::internal::CaptureStdout();
  expectError(path, "VTK");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
}

}  // namespace
}  // namespace isolux
