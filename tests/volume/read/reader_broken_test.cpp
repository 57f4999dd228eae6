// Deliberately broken files: each gives one line naming file, place and reason; none crashes or allocates
// what the file only claims.
#include <sys/resource.h>
#include <sys/stat.h>

#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

using test::bytesOf;
using test::expectError;
using test::NiftiFile;
using test::writeFile;

struct Broken {
  const char* what;
  std::string bytes;
  const char* reason;
};

void refuseAll(const std::string& extension, const std::vector<Broken>& cases) {
  const auto folder = test::temporaryFolder();
  int number = 0;
  for (const Broken& broken : cases) {
    SCOPED_TRACE(broken.what);
    const auto path = folder / ("broken" + std::to_string(number++) + extension);
    writeFile(path, broken.bytes);
    expectError(path, broken.reason);
  }
}

const std::string eight = bytesOf(test::ramp<std::uint8_t>(8));

// With all cases read, the program must not have grown by what they claim (some claim petabytes).
class BrokenFiles : public testing::Test {
 protected:
  static long peakKilobytes() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  }
  void SetUp() override { before_ = peakKilobytes(); }
  void TearDown() override { EXPECT_LT(peakKilobytes() - before_, 64 * 1024); }

 private:
  long before_ = 0;
};

TEST_F(BrokenFiles, MetaImage) {
  const auto with = [](const std::string& dims, const std::string& fields = "",
                       const std::string& data = eight) {
    const auto has = [&](const char* key) { return fields.find(key) != std::string::npos; };
    return "NDims = 3\nDimSize = " + dims + "\nElementSpacing = 1 1 1\n" +
           (has("ElementType") ? "" : "ElementType = MET_UCHAR\n") + fields +
           (has("ElementDataFile") ? "" : "ElementDataFile = LOCAL\n") + data;
  };
  refuseAll(
      ".mha",
      {{"truncated", with("2 2 2", "", "1234567"), "truncated"},
       {"a million on an axis", with("1000000 2 2"), "at most 65535"},
       {"zero dims", with("2 0 2"), "at least 1"},
       {"negative dims", with("2 -2 2"), "DimSize"},
       {"dims that overflow", with("65535 65535 65535"), "truncated"},
       {"dims beyond 64 bits", with("99999999999999999999 1 1"), "DimSize"},
       {"dims that are words", with("two 2 2"), "line 2 (DimSize)"},
       {"too few dims", with("2 2"), "2 sizes for 3 axes"},
       {"40 GB in 1 kB", with("4096 4096 2400", "", std::string(900, 'x')), "truncated"},
       {"40 GB compressed in 1 kB", with("4096 4096 2400", "CompressedData = True\n", std::string(900, 'x')),
        "cannot hold"},
       {"unknown type", with("2 2 2", "ElementType = MET_STRING\n"), "MET_STRING"},
       {"type is missing", "NDims = 3\nDimSize = 2 2 2\nElementDataFile = LOCAL\n" + eight, "ElementType"},
       {"no data file field", "NDims = 3\nDimSize = 2 2 2\nElementType = MET_UCHAR\n", "ElementDataFile"},
       {"data file is missing", with("2 2 2", "ElementDataFile = nothing.raw\n"), "no such file"},
       {"path escapes", with("2 2 2", "ElementDataFile = ../../etc/passwd\n"), "path leaves"},
       {"absolute path", with("2 2 2", "ElementDataFile = /etc/passwd\n"), "path leaves"},
       {"data file is a folder", with("2 2 2", "ElementDataFile = .\n"), "is not a file"},
       {"compressed rubbish", with("2 2 2", "CompressedData = True\n", "no zlib stream"), "damaged"},
       {"compressed and too short", with("2 2 2", "CompressedData = True\n", test::zlibbed("abc")),
        "truncated"},
       {"compressed size lies",
        with("2 2 2", "CompressedData = True\nCompressedDataSize = 5000\n", test::zlibbed(eight)),
        "truncated"},
       {"no channels", with("2 2 2", "ElementNumberOfChannels = 0\n"), "channel"},
       {"absurd channels", with("2 2 2", "ElementNumberOfChannels = 4000000000000\n"), "absurd"},
       {"negative header size", with("2 2 2", "HeaderSize = -7\n"), "HeaderSize"},
       {"key twice", with("2 2 2", "DimSize = 3 3 3\n"), "twice"},
       {"line without key", with("2 2 2", "what is this\n"), "line 5"},
       {"text with a word in it", with("2 2 2", "BinaryData = False\n", "0 1 2 3 x 5 6 7"),
        "not a whole number"},
       {"text too short", with("2 2 2", "BinaryData = False\n", "0 1 2 3 4 5 6          "), "truncated"},
       {"text out of range", with("2 2 2", "BinaryData = False\n", "0 1 2 3 4 5 6 256"), "does not fit"},
       {"matrix with 8 numbers", with("2 2 2", "TransformMatrix = 1 0 0 0 1 0 0 0\n"), "TransformMatrix"}});
}

TEST_F(BrokenFiles, Nrrd) {
  const auto with = [](const std::string& fields, const std::string& data = eight) {
    return "NRRD0004\ntype: uint8\ndimension: 3\n" + fields + "\n" + data;
  };
  const std::string sizes = "sizes: 2 2 2\n", raw = "encoding: raw\n";
  refuseAll(
      ".nrrd",
      {{"truncated", with(sizes + raw, "1234567"), "truncated"},
       {"zero size", with("sizes: 2 0 2\n" + raw), "at least 1"},
       {"a million on an axis", with("sizes: 1000000 2 2\n" + raw), "at most 65535"},
       {"negative size", with("sizes: 2 2 -2\n" + raw), "sizes"},
       {"overflow", with("sizes: 65535 65535 65535\n" + raw), "truncated"},
       {"sizes are missing", with(raw), "sizes"},
       {"encoding is missing", with(sizes), "encoding"},
       {"unknown encoding", with(sizes + "encoding: rot13\n"), "rot13"},
       {"unknown type", "NRRD0004\ntype: block\ndimension: 3\n" + sizes + raw + "\n" + eight, "block"},
       {"17 axes", "NRRD0004\ntype: uint8\ndimension: 17\n" + sizes + raw + "\n" + eight, "2 to 5 axes"},
       {"path escapes", with(sizes + raw + "data file: ../x.raw\n"), "path leaves"},
       {"data file is missing", with(sizes + raw + "data file: nothing.raw\n"), "no such file"},
       {"vector not closed", with(sizes + raw + "space: LPS\nspace directions: (1,0,0 (0,1,0) (0,0,1)\n"),
        "space directions"},
       {"vector of two", with(sizes + raw + "space: LPS\nspace directions: (1,0) (0,1,0) (0,0,1)\n"),
        "vector of 3"},
       {"byte skip too far", with(sizes + raw + "byte skip: 9999999999999\n"), "behind the end"},
       {"line skip too far", with(sizes + raw + "line skip: 100\n"), "fewer lines"},
       {"magic", "NRRD0099\n" + sizes, "magic"},
       {"gzip rubbish", with(sizes + "encoding: gzip\n", "nothing gzipped"), "damaged"},
       {"header only", "NRRD0004\ntype: uint8\ndimension: 3\n" + sizes + raw, "truncated"},
       {"singular directions are no error but a mad spacing is", with(sizes + raw + "spacings: 1 1e300 1\n"),
        "spacing"}});
}

TEST_F(BrokenFiles, Nifti) {
  const auto with = [](const std::function<void(NiftiFile&)>& change) {
    NiftiFile file;
    file.sformCode = 1;
    file.voxels = eight;
    change(file);
    return file.bytes();
  };
  const std::string good = with([](NiftiFile&) {});
  refuseAll(".nii",
            {{"header cut", good.substr(0, 200), "348 bytes"},
             {"voxels cut", good.substr(0, good.size() - 1), "truncated"},
             {"zero dim", with([](NiftiFile& f) {
                f.dims = {2, 0, 2};
              }),
              "dim[2]"},
             {"negative dim", with([](NiftiFile& f) {
                f.dims = {2, 2, -2};
              }),
              "dim[3]"},
             {"too many claimed", with([](NiftiFile& f) {
                f.dims = {32767, 32767, 32767};
              }),
              "truncated"},
             {"eight axes", with([](NiftiFile& f) { f.dims = {2, 2, 2, 1, 1, 1, 1, 1}; }), "dim[0]"},
             {"a sixth axis", with([](NiftiFile& f) { f.dims = {2, 1, 1, 1, 1, 4}; }), "dim[6]"},
             {"unknown type", with([](NiftiFile& f) { f.datatype = 7; }), "datatype"},
             {"one bit", with([](NiftiFile& f) { f.datatype = 1; }), "1 bit"},
             {"offset in the header", with([](NiftiFile& f) { f.voxOffset = 10; }), "vox_offset"},
             {"offset nan", with([](NiftiFile& f) { f.voxOffset = std::nanf(""); }), "vox_offset"},
             {"offset behind the end", with([](NiftiFile& f) { f.voxOffset = 4096; }), "behind the end"},
             {"ANALYZE", with([](NiftiFile& f) { f.magic = ""; }), "ANALYZE"},
             {"no NIfTI at all", std::string(400, 'x'), "sizeof_hdr"},
             {"gzip cut", test::gzipped(good).substr(0, 40), "348 bytes"}});
  const auto folder = test::temporaryFolder();
  writeFile(folder / "rubbish.nii.gz", std::string("\x1f\x8b") + "rubbish that is no gzip");
  expectError(folder / "rubbish.nii.gz", "damaged");
  // 40 GB claimed by 1 kB of gzip.
  writeFile(folder / "bomb.nii.gz", test::gzipped(with([](NiftiFile& f) { f.dims = {4096, 4096, 2400}; })));
  expectError(folder / "bomb.nii.gz", "cannot hold");
}

TEST_F(BrokenFiles, Vtk) {
  const auto legacy = [](const std::string& dims, const std::string& rest) {
    return "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS " + dims +
           "\nSPACING 1 1 1\nORIGIN 0 0 0\n" + rest;
  };
  const std::string scalars = "SCALARS a unsigned_char\nLOOKUP_TABLE default\n";
  refuseAll(
      ".vtk",
      {{"truncated", legacy("2 2 2", "POINT_DATA 8\n" + scalars + "1234"), "truncated"},
       {"zero", legacy("2 0 2", "POINT_DATA 0\n"), "at least 1"},
       {"negative", legacy("2 -2 2", "POINT_DATA 8\n"), "at least 1"},
       {"a million", legacy("1000000 1 1", "POINT_DATA 1000000\n"), "at most 65535"},
       {"count disagrees", legacy("2 2 2", "POINT_DATA 9\n" + scalars + eight), "9 values for 8 points"},
       {"type", legacy("2 2 2", "POINT_DATA 8\nSCALARS a string\nLOOKUP_TABLE default\n"), "string"},
       {"bits", legacy("2 2 2", "POINT_DATA 8\nSCALARS a bit\nLOOKUP_TABLE default\n1"), "\"bit\""},
       {"no array", legacy("2 2 2", "POINT_DATA 8\n"), "truncated"},
       {"ends early", "# vtk DataFile Version 3.0\nt\nBINARY\n", "truncated"},
       {"no encoding", "# vtk DataFile Version 3.0\nt\nMAYBE\n", "ASCII"}});
  const auto vti = [](const std::string& extent, const std::string& array, const std::string& behind = "") {
    return "<VTKFile type=\"ImageData\" version=\"1.0\" byte_order=\"LittleEndian\"><ImageData "
           "WholeExtent=\"" +
           extent + "\" Origin=\"0 0 0\" Spacing=\"1 1 1\"><Piece Extent=\"" + extent +
           "\"><PointData Scalars=\"a\">" + array + "</PointData></Piece></ImageData>" + behind +
           "</VTKFile>";
  };
  const std::string text =
      "<DataArray type=\"UInt8\" Name=\"a\" format=\"ascii\">0 1 2 3 4 5 6 7</DataArray>";
  const std::string appended = "<DataArray type=\"UInt8\" Name=\"a\" format=\"appended\" offset=\"0\"/>";
  const auto tail = [](std::uint32_t size, const std::string& data) {
    return "<AppendedData encoding=\"raw\">_" + bytesOf<std::uint32_t>({size}) + data + "</AppendedData>";
  };
  refuseAll(
      ".vti",
      {{"too few numbers", vti("0 1 0 1 0 2", text), "truncated"},
       {"too many numbers", vti("0 1 0 1 0 0", text), "8 numbers"},
       {"negative extent", vti("0 1 0 -5 0 1", text), "negative"},
       {"absurd extent", vti("0 999999 0 999999 0 999999", text), "at most 65535"},
       {"extent beyond 32 bits", vti("0 1 0 1 0 99999999999999", text), "out of range"},
       {"extent of five", vti("0 1 0 1 0", text), "six whole numbers"},
       {"claims 40 GB", vti("0 4095 0 4095 0 2399", appended, tail(8, eight)), "8 bytes"},
       {"appended cut", vti("0 1 0 1 0 1", appended, "<AppendedData encoding=\"raw\">_\x08"),
        "the extent needs 8"},
       {"appended missing", vti("0 1 0 1 0 1", appended), "truncated"},
       {"unknown type",
        vti("0 1 0 1 0 1", "<DataArray type=\"String\" Name=\"a\" format=\"ascii\">0</DataArray>"), "String"},
       {"no array", vti("0 1 0 1 0 1", ""), "no named array"},
       {"another dataset", "<VTKFile type=\"RectilinearGrid\"></VTKFile>", "of volumes ImageData is read"},
       {"tag not closed", "<VTKFile type=\"ImageData\"", "truncated"},
       {"entities", "<!DOCTYPE x><VTKFile type=\"ImageData\"></VTKFile>", "not supported"}});
}

TEST_F(BrokenFiles, PathsThatAreNoVolumes) {
  const auto folder = test::temporaryFolder();
  expectError(folder / "nothing.mhd", "no such file");
  for (const char* name : {"empty.mhd", "empty.nrrd", "empty.nii", "empty.raw", "empty.vti", "empty.tif"}) {
    writeFile(folder / name, "");
    expectError(folder / name, "empty");
  }
  std::filesystem::create_directories(folder / "hollow");
  expectError(folder / "hollow", "neither DICOM nor TIFF");
  expectError("/dev/null", "not a regular file");
  ASSERT_EQ(mkfifo((folder / "pipe.mhd").c_str(), 0600), 0);
  expectError(folder / "pipe.mhd", "not a regular file");
  base::Progress progress;
  EXPECT_THROW(volume::readVolume("", {}, progress), base::Error);
  EXPECT_THROW(volume::readVolume(std::string("a\0b", 3), {}, progress), base::Error);
}

TEST_F(BrokenFiles, FormatsThatAreKnownButNotRead) {
  const auto folder = test::temporaryFolder();
  const auto refuse = [&](const std::string& name, const std::string& bytes, const std::string& reason) {
    writeFile(folder / name, bytes);
    expectError(folder / name, reason);
    EXPECT_FALSE(volume::needsRawDescription(folder / name)) << name;
  };
  const std::string binary(4000, '\3');
  refuse("a.nii.bz2", "BZh9" + binary, "bunzip2");
  refuse("a.nii.xz",
         "\xfd"
         "7zXZ" +
             binary,
         "unxz");
  refuse("a.zip", "PK\3\4" + binary, "unzip");
  refuse("a.raw.gz", test::gzipped(binary), "gunzip");
  refuse("a.gz", test::gzipped(binary), "no format is recognised in it");
  refuse("a.mha.gz", test::gzipped("ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\n"), "unpack it with");
  refuse("a.mz3", test::gzipped(binary), "STL");
  refuse("a.trk.gz", test::gzipped(binary), "tracks");
  refuse("lh.gii", "<?xml version=\"1.0\"?>\n<GIFTI>\n</GIFTI>\n", "mris_convert");
  // Numbers of vertices and their labels, which are not the elements of a DICOM file.
  refuse("lh.annot", bytesOf<std::int32_t>({163842, 0, 0xdc143c, 1, 0x8cb414, 2, 0xa0dc14}, true) + binary,
         "FreeSurfer annotation");
  refuse("a.hdf", "\x0e\x03\x13\x01" + binary, "h4toh5");
  refuse("a.pgm", "P5\n4 4\n255\n" + binary, "TIFF");
  refuse("a.mnc", "CDF\1" + binary, "mincconvert");
  refuse("a.nc", "CDF\2" + binary, "nccopy");
  refuse("a+orig.HEAD", "type = string-attribute\n", "3dAFNItoNIFTI");
  refuse("a+orig.BRIK", binary, "3dAFNItoNIFTI");
  refuse("a.mif", "mrtrix image\ndim: 4,4,4\n" + binary, "mrconvert");
  refuse("a.map", std::string(208, '\0') + "MAP " + binary, "mrc2tif");
  refuse("a.slc", "11111\n4 4 4 8\n" + binary, "SLC");
  refuse("a.cube", "water\ndensity\n3 0 0 0\n4 1 0 0\n4 0 1 0\n4 0 0 1\n", "Gaussian cube");
  refuse("water", "water\ndensity\n1 0 0 0\n4 1 0 0\n4 0 1 0\n4 0 0 1\n8 8 0 0 0\n", "Gaussian cube");
  refuse("a.vrt", "VERTEX\n4020 3 0 0\n1 0 0 0\n2 1 0 0\n3 1 1 0\n4 0 1 0\n", "text file");
  refuse("a.vdb", " BDV" + binary, "OpenVDB");
  refuse("a.pvti", "<VTKFile type=\"PImageData\"></VTKFile>", "Piece Source");
  for (const char* kind : {"RectilinearGrid", "StructuredGrid", "UnstructuredGrid", "PUnstructuredGrid"})
    refuse("grid.vtu", "<VTKFile type=\"" + std::string(kind) + "\"></VTKFile>", "Resample To Image");
  refuse("a.hv", "!INTERFILE :=\nname of data file := a.v\n", "Interfile");
  refuse("a.npy", "\x93NUMPY" + binary, "NumPy");
  refuse("a.png", "\x89PNG" + binary, "TIFF");
  refuse("a.czi", "ZISRAWFILE" + binary, "bfconvert");
  std::filesystem::create_directories(folder / "pictures");
  writeFile(folder / "pictures/1.png", "\x89PNG");
  expectError(folder / "pictures", "mogrify");
}

}  // namespace
}  // namespace isolux
