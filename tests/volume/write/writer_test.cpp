#include <cmath>
#include <fstream>
#include <iterator>

#include <glm/geometric.hpp>

#include "tests/volume/read/reader_support.h"
#include "volume/write/writer.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using volume::Grid;
using volume::GridGeometry;
using volume::VoxelType;

// Oblique and left-handed.
GridGeometry geometry() {
  const glm::dvec3 x = glm::normalize(glm::dvec3(1, 2, 0.5));
  const glm::dvec3 y = glm::normalize(glm::cross(x, glm::dvec3(0, 0, 1)));
  const glm::dvec3 z = -glm::cross(x, y);
  return GridGeometry::make({3, 2, 2}, {0.4, 1.0 / 3.0, 5.0}, {-12.25, 1e-3, 7e3}, glm::dmat3(x, y, z));
}

template <typename T>
void roundTrip(std::vector<T> voxels, double slope = 1.0, double intercept = 0.0,
               std::optional<VoxelType> fileType = {}) {
  const Grid grid(geometry(), std::move(voxels), slope, intercept);
  const auto folder = test::temporaryFolder();
  for (const char* name : {"v.mhd", "v.mha", "v.nrrd", "v.vti"}) {
    SCOPED_TRACE(name);
    volume::writeVolume(grid, folder / name);
    const auto read = test::readFile(folder / name);
    EXPECT_EQ(read.fileType, fileType.value_or(grid.storedType()));
    EXPECT_THAT(read.warnings, testing::Each(testing::HasSubstr("missing")));
    for (int column = 0; column < 4; ++column)
      for (int row = 0; row < 4; ++row)
        EXPECT_NEAR(read.grid->geometry().worldFromVoxel[column][row],
                    grid.geometry().worldFromVoxel[column][row],
                    1e-12 * std::max(1.0, std::abs(grid.geometry().worldFromVoxel[column][row])));
    ASSERT_EQ(read.grid->dims(), grid.dims());
    for (int i = 0; i < 12; ++i) {
      const double wanted = grid.value(i % 3, i / 3 % 2, i / 6),
                   got = read.grid->value(i % 3, i / 3 % 2, i / 6);
      if (std::isnan(wanted))
        EXPECT_TRUE(std::isnan(got));
      else
        EXPECT_NEAR(got, wanted, 1e-12 * std::abs(wanted));
    }
  }
  for (const auto& entry : fs::directory_iterator(folder))
    EXPECT_EQ(entry.path().string().find(".part"), std::string::npos) << "left behind";
}

TEST(Writer, EveryStoredTypeSurvives) {
  roundTrip(test::ramp<std::int8_t>(12, -128, 20));
  roundTrip(test::ramp<std::uint8_t>(12, 0, 23));
  roundTrip(test::ramp<std::int16_t>(12, -32768, 5900));
  roundTrip(test::ramp<std::uint16_t>(12, 9, 5900));
  auto floats = test::ramp<float>(12, -1e-20f, 0.3f);
  floats[5] = std::numeric_limits<float>::quiet_NaN();
  roundTrip(floats);
}

TEST(Writer, SlopeAndInterceptAreApplied) {
  roundTrip(test::ramp<std::int16_t>(12, 0, 100), 1.0, -1024.0, VoxelType::int16);
  roundTrip(test::ramp<std::uint8_t>(12, 0, 20), 1.0, -5.0, VoxelType::int16);
  roundTrip(test::ramp<std::uint8_t>(12, 0, 21), 0.5, 0.0, VoxelType::float32);
  roundTrip(test::ramp<std::uint8_t>(12, 0, 20), 0.5, 0.0, VoxelType::uint8);  // whole again
  roundTrip(test::ramp<float>(12, 0.0f, 1e-3f), 1.0, 1e6, VoxelType::float64);
  roundTrip(test::ramp<std::uint16_t>(12, 0, 3), 1.0, 9e9, VoxelType::float64);
}

TEST(Writer, RefusesAndLeavesNothingBehind) {
  const Grid grid(geometry(), test::ramp<std::uint8_t>(12));
  const auto folder = test::temporaryFolder();
  const auto kindOf = [&](const fs::path& path) {
    try {
      volume::writeVolume(grid, path);
    } catch (const base::Error& error) {
      return error.kind();
    }
    return base::ErrorKind::graphics;
  };
  EXPECT_EQ(kindOf(folder / "v.jpg"), base::ErrorKind::usage);
  EXPECT_EQ(kindOf(folder / "missing" / "v.mha"), base::ErrorKind::input);
  fs::create_directories(folder / "v.nrrd" / "full");
  EXPECT_EQ(kindOf(folder / "v.nrrd"), base::ErrorKind::input);  // a folder is in the way
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST(Writer, ReplacesOnlyWhenComplete) {
  const Grid grid(geometry(), test::ramp<std::uint8_t>(12));
  const auto path = test::temporaryFolder() / "v.mha";
  test::writeFile(path, "old");
  volume::writeVolume(grid, path);
  EXPECT_EQ(test::readFile(path).grid->hash(), test::readFile(path).grid->hash());
  EXPECT_EQ(test::readFile(path).grid->value(2, 1, 1), 11.0);
}

}  // namespace
}  // namespace isolux
