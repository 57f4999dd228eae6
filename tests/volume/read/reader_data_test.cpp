// Every volume of the shared data folder opens and is what that folder's README says.
#include "tests/volume/read/reader_support.h"

namespace isolux {
namespace {

using volume::VoxelType;

struct Row {
  const char* file;
  glm::ivec3 dims;
  VoxelType type;
  glm::dvec3 spacing;
  double low, high;
  double rangeTolerance = 0.5;  // of the table
};

const Row rows[] = {
    {"volumes/ct_cranium.mhd", {256, 256, 108}, VoxelType::int16, {0.957, 0.957, 1.5}, -1024, 2986},
    {"volumes/ct_head_skin_bone.nii.gz",
     {208, 256, 225},
     VoxelType::uint8,
     {1, 1, 1},
     0,
     255 * 0.00392,
     1e-3},
    {"volumes/ct_head_pitch.nii.gz", {175, 248, 58}, VoxelType::uint8, {0.8125, 0.8125, 2.397}, 0, 255},
    {"volumes/ct_avm.nii.gz", {256, 242, 154}, VoxelType::uint8, {0.72, 0.721, 1}, 0, 255 * 2.2086, 0.1},
    {"volumes/mra_head.nii.gz", {200, 256, 120}, VoxelType::uint8, {0.521, 0.521, 0.65}, 0, 254},
    {"volumes/engine.nii.gz", {256, 256, 128}, VoxelType::uint8, {1, 1, 1}, 0, 255},
    {"volumes/engine_crop.mhd", {149, 208, 110}, VoxelType::uint8, {1, 1, 1}, 0, 255},
    {"volumes/bonsai.nii.gz", {256, 256, 256}, VoxelType::uint8, {1, 1, 1}, 0, 255},
    {"volumes/teapot.mhd", {256, 256, 178}, VoxelType::uint8, {1, 1, 1}, 0, 255},
    {"volumes/tooth.mhd", {103, 94, 161}, VoxelType::uint16, {1, 1, 1}, 0, 1300},
    {"volumes/hydrogen_atom.mhd", {128, 128, 128}, VoxelType::uint8, {1, 1, 1}, 0, 250},
    {"volumes/fuel.nii.gz", {64, 33, 32}, VoxelType::uint8, {1, 1, 1}, 0, 255},
    {"volumes/heptane.nii.gz", {302, 302, 302}, VoxelType::uint8, {1, 1, 1}, 0, 255},
    {"volumes/viscous_fingers_030.mhd", {64, 64, 64}, VoxelType::float32, {1, 1, 1}, 0, 108.5},
    {"volumes/viscous_fingers_060.mhd", {64, 64, 64}, VoxelType::float32, {1, 1, 1}, 0, 111},
    {"volumes/viscous_fingers_090.mhd", {64, 64, 64}, VoxelType::float32, {1, 1, 1}, 0, 124.5},
    {"volumes/viscous_fingers_060.vti", {64, 64, 64}, VoxelType::float32, {1, 1, 1}, 0, 111},
    {"volumes/mri_colin27.nii.gz", {181, 217, 181}, VoxelType::uint8, {1, 1, 1}, 0, 254},
    {"volumes/mri_head_t1.nii.gz", {188, 256, 190}, VoxelType::uint8, {0.88, 0.88, 0.88}, 0, 255},
    {"dicom/ct_head_64", {64, 64, 93}, VoxelType::int16, {3.2, 3.2, 1.5}, 0, 3926},
};

TEST(SharedData, EveryVolumeAgreesWithTheReadme) {
  ISOLUX_NEEDS_DATA();
  for (const Row& row : rows) {
    SCOPED_TRACE(row.file);
    const auto v = test::readFile(test::dataFolder() / row.file);
    EXPECT_EQ(v.grid->dims(), row.dims);
    EXPECT_EQ(v.fileType, row.type);
    test::expectNear(v.grid->geometry().spacingMm(), row.spacing, 5e-4);
    EXPECT_NEAR(v.grid->minimum(), row.low, row.rangeTolerance);
    EXPECT_NEAR(v.grid->maximum(), row.high, row.rangeTolerance);
    EXPECT_EQ(v.grid->missingCount(), 0u);
    EXPECT_THAT(v.warnings, testing::IsEmpty());
  }
}

TEST(SharedData, NoVolumeIsForgotten) {
  ISOLUX_NEEDS_DATA();
  std::size_t volumes = 1;  // the DICOM folder
  for (const auto& entry : std::filesystem::directory_iterator(test::dataFolder() / "volumes")) {
    const auto extension = entry.path().extension();
    volumes += extension == ".mhd" || extension == ".gz" || extension == ".vti";
  }
  EXPECT_EQ(volumes, std::size(rows));
}

TEST(SharedData, TwoFormatsOfOneVolumeAreEqual) {
  ISOLUX_NEEDS_DATA();
  const auto folder = test::dataFolder() / "volumes";
  EXPECT_EQ(test::readFile(folder / "viscous_fingers_060.mhd").grid->hash(),
            test::readFile(folder / "viscous_fingers_060.vti").grid->hash());
}

}  // namespace
}  // namespace isolux
