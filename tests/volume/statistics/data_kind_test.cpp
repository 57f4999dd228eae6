// What kind of data a volume is, by its file and by its values.
#include "volume/statistics/data_kind.h"

#include <algorithm>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/progress.h"
#include "tests/support/test_data.h"
#include "volume/phantom/phantom.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::volume {
namespace {

using Kind = scene::DataKind;

std::shared_ptr<const PreparedVolume> opened(const std::string& path, Kind kind = Kind::automatic) {
  scene::Source source;
  source.path = path;
  source.kind = kind;
  base::Progress progress;
  return loadVolume(source, progress);
}

// Of the head phantom in other units: value = 0.0005 (HU + 1000), of a patient.
Volume ctInOtherUnits() {
  const auto head = opened("phantom:head:64");
  std::vector<float> values;
  const glm::ivec3 dims = head->grid().dims();
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        values.push_back(
            static_cast<float>(0.0005 * (std::max(head->grid().value(x, y, z), -1000.0) + 1000.0)));
  Volume volume;
  volume.grid = std::make_shared<Grid>(head->grid().geometry(), VoxelArray(std::move(values)));
  volume.axes = scene::WorldAxes::anatomical;
  return volume;
}

TEST(DataKind, FilesOfTheTestDataAreWhatTheyAre) {
  ISOLUX_NEEDS_DATA();
  const struct {
    const char* file;
    Kind kind;
  } files[] = {{"ct_cranium.mhd", Kind::ct_hu},
               {"ct_head_skin_bone.nii.gz", Kind::ct},
               {"mri_head_t1.nii.gz", Kind::mr},
               {"mri_colin27.nii.gz", Kind::mr},
               {"mra_head.nii.gz", Kind::mr},
               {"fuel.nii.gz", Kind::simulation},
               {"heptane.nii.gz", Kind::simulation},
               {"hydrogen_atom.mhd", Kind::simulation},
               {"viscous_fingers_060.mhd", Kind::simulation},
               {"tooth.mhd", Kind::other},
               {"bonsai.nii.gz", Kind::other},
               {"engine.nii.gz", Kind::other}};
  for (const auto& [file, kind] : files) {
    const auto volume = opened((test::dataFolder() / "volumes" / file).string());
    EXPECT_EQ(volume->kind.kind, kind) << file << ": " << volume->kind.reason;
  }
}

TEST(DataKind, PhantomsAreKnown) {
  EXPECT_EQ(opened("phantom:head:32")->kind.kind, Kind::ct_hu);
  EXPECT_EQ(opened("phantom:torus:32")->kind.kind, Kind::distance);
  EXPECT_EQ(opened("phantom:gyroid:32")->kind.kind, Kind::simulation);
  EXPECT_EQ(opened("phantom:noise:32")->kind.kind, Kind::other);
}

TEST(DataKind, ACtInOtherUnitsTellsHounsfieldUnits) {
  base::Progress progress;
  const auto volume = prepareVolume(ctInOtherUnits(), progress);
  ASSERT_EQ(volume->kind.kind, Kind::ct) << volume->kind.reason;
  ASSERT_TRUE(volume->kind.hounsfield);
  const auto valueOf = [&](double hu) {
    return volume->kind.hounsfield->x + hu * volume->kind.hounsfield->y;
  };
  for (const double hu : {-300.0, 300.0}) EXPECT_NEAR(valueOf(hu) / 0.0005 - 1000.0, hu, 60.0);
}

TEST(DataKind, WhoSaysItHasTheLastWord) {
  for (const Kind kind : {Kind::ct, Kind::mr, Kind::microscopy, Kind::other}) {
    const auto volume = opened("phantom:head:32", kind);
    EXPECT_EQ(volume->kind.kind, kind);
    EXPECT_EQ(volume->kind.reason, "source.kind is set");
    EXPECT_EQ(volume->volume.unit, "");
  }
  EXPECT_EQ(opened("phantom:torus:32", Kind::ct_hu)->volume.unit, "HU");
}

TEST(DataKind, LabelsAreTakenForThoseOnlyWhereTheyMayBe) {
  const auto volumeOf = [](Kind kind) {
    std::vector<std::uint8_t> values(32 * 32 * 32);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto x = static_cast<int>(i % 32), y = static_cast<int>(i / 32 % 32),
                 z = static_cast<int>(i / 1024);
      const bool inside = x > 4 && x < 28 && y > 4 && y < 28 && z > 4 && z < 28;
      values[i] = static_cast<std::uint8_t>(inside ? (x < 16 ? 3 : 7) + (z < 16 ? 0 : 10) : 0);
    }
    Volume volume;
    volume.grid =
        std::make_shared<Grid>(GridGeometry::make({32, 32, 32}, {1, 1, 1}), VoxelArray(std::move(values)));
    volume.kind = kind;
    base::Progress progress;
    return prepareVolume(std::move(volume), progress);
  };
  EXPECT_EQ(volumeOf(Kind::automatic)->kind.kind, Kind::labels);
  EXPECT_EQ(volumeOf(Kind::automatic)->volume.labels, 4);
  EXPECT_EQ(volumeOf(Kind::other)->volume.labels, 0);
  const auto head = opened("phantom:head:32", Kind::labels);
  EXPECT_GT(head->volume.labels, 0) << "whole numbers are taken for labels where somebody says so";
}

TEST(DataKind, VoxelsOfAMicroscopeAreSmall) {
  Volume volume;
  volume.grid = std::make_shared<Grid>(GridGeometry::make({8, 8, 8}, {0.0005, 0.0005, 0.002}),
                                       VoxelArray(std::vector<std::uint8_t>(512, 3)));
  base::Progress progress;
  EXPECT_EQ(prepareVolume(std::move(volume), progress)->kind.kind, Kind::microscopy);
}

}  // namespace
}  // namespace isolux::volume
