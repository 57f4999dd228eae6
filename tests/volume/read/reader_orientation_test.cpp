// Letters of anatomy stand only where a file states where the patient lies. DICOM and TIFF are judged beside
// their own readers' tests.
#include "tests/volume/read/reader_support.h"
#include "volume/write/writer.h"

namespace isolux {
namespace {

using scene::WorldAxes;
using test::writeFile;

const std::string voxelBytes = test::bytesOf(test::ramp<std::uint8_t>(8));

std::string metaImage(const std::string& fields) {
  return "ObjectType = Image\nNDims = 3\nDimSize = 2 2 2\nElementSpacing = 1 1 1\n" + fields +
         "ElementType = MET_UCHAR\nElementDataFile = LOCAL\n" + voxelBytes;
}

std::string nrrd(const std::string& fields) {
  return "NRRD0005\ntype: uint8\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n" + fields + "\n" + voxelBytes;
}

std::string nifti(int sform, int qform) {
  test::NiftiFile file;
  file.sformCode = sform;
  file.qformCode = qform;
  file.voxels = voxelBytes;
  return file.bytes();
}

struct Stated {
  const char* file;
  std::string bytes;
  WorldAxes axes;
};

TEST(Orientation, OnlyWhatTheFileStatesIsAnatomical) {
  const std::string identity = "TransformMatrix = 1 0 0 0 1 0 0 0 1\n";
  const std::string directions = "space directions: (1,0,0) (0,1,0) (0,0,1)\n";
  const Stated table[] = {
      {"sform.nii", nifti(1, 0), WorldAxes::anatomical},
      {"qform.nii", nifti(0, 4), WorldAxes::anatomical},
      {"none.nii", nifti(0, 0), WorldAxes::zUp},
      {"strange_code.nii", nifti(77, 0), WorldAxes::zUp},
      {"lps.nrrd", nrrd("space: LPS\n" + directions), WorldAxes::anatomical},
      {"ras.nrrd", nrrd("space: right-anterior-superior\n" + directions), WorldAxes::anatomical},
      {"spacings.nrrd", nrrd("space: LPS\nspacings: 1 1 1\n"), WorldAxes::zUp},
      {"scanner.nrrd", nrrd("space: scanner-xyz\n" + directions), WorldAxes::zUp},
      {"no_space.nrrd", nrrd("space dimension: 3\n" + directions), WorldAxes::zUp},
      {"plain.nrrd", nrrd("spacings: 1 1 1\n"), WorldAxes::zUp},
      {"flat.nrrd", nrrd("space: LPS\nspace directions: (1,0,0) (1,0,0) (0,0,1)\n"), WorldAxes::zUp},
      {"itk.mha", metaImage(identity + "AnatomicalOrientation = RAI\n"), WorldAxes::anatomical},
      {"metaio.mha", metaImage(identity + "AnatomicalOrientation = LPS\n"), WorldAxes::anatomical},
      {"turned.mha", metaImage("TransformMatrix = 0 1 0 0 0 1 1 0 0\nAnatomicalOrientation = AIR\n"),
       WorldAxes::anatomical},
      {"contradiction.mha", metaImage(identity + "AnatomicalOrientation = LAS\n"), WorldAxes::zUp},
      {"unknown.mha", metaImage(identity + "AnatomicalOrientation = ???\n"), WorldAxes::zUp},
      {"matrix_only.mha", metaImage(identity), WorldAxes::zUp},
      {"legacy.vtk",
       "# vtk DataFile Version 3.0\nt\nBINARY\nDATASET STRUCTURED_POINTS\nDIMENSIONS 2 2 2\nORIGIN 0 0 0\n"
       "SPACING 1 1 1\nPOINT_DATA 8\nSCALARS v unsigned_char 1\nLOOKUP_TABLE default\n" +
           voxelBytes + "\n",
       WorldAxes::zUp},
      {"mesh.obj", "v 0 0 0\nv 9 0 0\nv 0 9 0\nv 0 0 9\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
       WorldAxes::yUp},
  };
  const auto folder = test::temporaryFolder();
  for (const Stated& entry : table) {
    SCOPED_TRACE(entry.file);
    writeFile(folder / entry.file, entry.bytes);
    volume::ReadOptions options;
    options.meshVoxels = 16;
    const volume::Volume read = test::readFile(folder / entry.file, options);
    EXPECT_EQ(read.axes, entry.axes);
    EXPECT_EQ(test::warns(read, "do not agree"), std::string(entry.file) == "contradiction.mha");
  }
  writeFile(folder / "v.raw", voxelBytes);
  volume::ReadOptions raw;
  raw.raw = "2x2x2 uint8";
  EXPECT_EQ(test::readFile(folder / "v.raw", raw).axes, WorldAxes::zUp);
}

TEST(Orientation, OfThePhantomsOnlyTheHeadHasSides) {
  EXPECT_EQ(test::readFile("phantom:head:16").axes, WorldAxes::anatomical);
  EXPECT_EQ(test::readFile("phantom:ball:16").axes, WorldAxes::zUp);
}

TEST(Orientation, SurvivesWritingWhereTheFormatHasWordsForIt) {
  const glm::dmat3 turned(glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1), glm::dvec3(-1, 0, 0));
  const volume::Grid grid(volume::GridGeometry::make({2, 2, 2}, glm::dvec3(1.0), glm::dvec3(0.0), turned),
                          test::ramp<std::uint8_t>(8));
  const auto folder = test::temporaryFolder();
  for (const WorldAxes axes : {WorldAxes::anatomical, WorldAxes::zUp})
    for (const char* name : {"v.mhd", "v.mha", "v.nrrd"}) {
      volume::writeVolume(grid, folder / name, axes);
      EXPECT_EQ(test::readFile(folder / name).axes, axes) << name;
    }
  volume::writeVolume(grid, folder / "v.vti", WorldAxes::anatomical);
  EXPECT_EQ(test::readFile(folder / "v.vti").axes, WorldAxes::zUp);
}

}  // namespace
}  // namespace isolux
