#include "volume/prepared/prepared_volume.h"
#include "tests/support/volumes.h"

#include <chrono>
#include <limits>

#include <gtest/gtest.h>

#include "tests/support/analytic_fields.h"
#include "tests/support/stop_latency.h"
#include "volume/phantom/phantom.h"
#include "volume/prepared/csg.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume {
namespace {

Volume volumeOf(Grid grid, std::string unit = "") {
  Volume volume;
  volume.grid = std::make_shared<const Grid>(std::move(grid));
  volume.unit = std::move(unit);
  return volume;
}

TEST(PreparedVolume, HoldsBlocksHistogramBoundsAndIsovalue) {
  base::Progress progress;
  Volume volume = volumeOf(test::phantomGrid("ball", test::obliqueLeftHandedGeometry(20)));
  const auto start = std::chrono::steady_clock::now();
  const auto prepared = prepareVolume(std::move(volume), progress);
  const std::chrono::duration<double> around = std::chrono::steady_clock::now() - start;
  EXPECT_EQ(prepared->blocks->blockCells(), kBlockCells);
  EXPECT_EQ(prepared->blocks->dims(), glm::ivec3(3));
  EXPECT_FALSE(prepared->histogram.counts.empty());
  glm::dvec3 low, high;
  prepared->grid().geometry().worldBounds(low, high);
  EXPECT_EQ(prepared->facts.boundsMinMm, low);
  EXPECT_EQ(prepared->facts.boundsMaxMm, high);
  EXPECT_LT(prepared->grid().minimum(), prepared->facts.suggestedIsovalue);
  EXPECT_LT(prepared->facts.suggestedIsovalue, prepared->grid().maximum());
  EXPECT_EQ(progress.fraction(), 1.0);
  EXPECT_GT(prepared->prepareSeconds, 0.0);
  EXPECT_LE(prepared->prepareSeconds, around.count());  // measured within it, so also on a busy machine
}

// A block of `tissue` in `air`, a tenth of it `bone`.
Grid scan(std::int16_t air, std::int16_t tissue, std::int16_t bone) {
  std::vector<std::int16_t> voxels;
  for (int i = 0; i < 1000; ++i) voxels.push_back(i % 2 ? air : i % 20 ? tissue : bone);
  return {GridGeometry::make(glm::ivec3(10), glm::dvec3(1)), voxels};
}

TEST(PreparedVolume, ValuesOffsetBy1024AreNoHounsfieldUnits) {
  struct Case {
    std::int16_t air, tissue, bone;
    bool offset;
  };
  for (const Case& c :
       {Case{0, 1060, 2400, true}, Case{24, 1000, 2000, true}, Case{-1000, 40, 1400, false},
        Case{-1024, 1000, 2000, false}, Case{0, 40, 1400, false} /* masked */, Case{0, 500, 1000, false}}) {
    base::Progress progress;
    const auto prepared = prepareVolume(volumeOf(scan(c.air, c.tissue, c.bone), "HU"), progress);
    EXPECT_EQ(prepared->volume.unit, c.offset ? "" : "HU") << c.air << ' ' << c.tissue;
    EXPECT_EQ(prepared->volume.warnings.size(), c.offset ? 1U : 0U);
  }
  base::Progress progress;  // who claims nothing is not corrected
  EXPECT_TRUE(prepareVolume(volumeOf(scan(0, 1060, 2400)), progress)->volume.warnings.empty());
}

TEST(PreparedVolume, TheTypicalStepIsFoundAlongEveryAxis) {
  // A ramp of 3 per voxel along one axis.
  for (int axis = 0; axis < 3; ++axis) {
    const GridGeometry geometry = GridGeometry::make({9, 10, 11}, glm::dvec3(1));
    std::vector<float> voxels;
    for (int z = 0; z < 11; ++z)
      for (int y = 0; y < 10; ++y)
        for (int x = 0; x < 9; ++x) voxels.push_back(static_cast<float>(3 * glm::ivec3(x, y, z)[axis]));
    base::Progress progress;
    EXPECT_EQ(prepareVolume(volumeOf(Grid(geometry, voxels)), progress)->facts.typicalStep, 3.0) << axis;
  }
}

TEST(PreparedVolume, APhantomBringsItsOwnIsovalue) {
  for (const auto& [path, isovalue] :
       {std::pair("phantom:head:32", 300.0), std::pair("phantom:marschner_lobb:24", 0.5)}) {
    base::Progress progress;
    scene::Source source;
    source.path = path;
    EXPECT_EQ(loadVolume(source, progress)->facts.suggestedIsovalue, isovalue) << path;
  }
}

TEST(PreparedVolume, BoundsOfASliceOrASingleVoxelAreNotEmpty) {
  for (const glm::ivec3& dims : {glm::ivec3(5, 4, 1), glm::ivec3(1, 1, 1)}) {
    base::Progress progress;
    const GridGeometry geometry = GridGeometry::make(dims, {0.5, 1.0, 3.0});
    const auto prepared =
        prepareVolume(volumeOf(Grid(geometry, std::vector<float>(geometry.voxelCount()))), progress);
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_GT(prepared->facts.boundsMaxMm[axis] - prepared->facts.boundsMinMm[axis], 0.1);
    EXPECT_EQ(prepared->blocks->count(), 0u);
  }
}

TEST(PreparedVolume, VolumesWithoutAnyValueArePreparedToo) {
  base::Progress progress;
  const GridGeometry geometry = GridGeometry::make({4, 4, 4}, glm::dvec3(1));
  const Grid grid(geometry, std::vector<float>(64, std::numeric_limits<float>::quiet_NaN()));
  EXPECT_EQ(prepareVolume(volumeOf(grid, "HU"), progress)->facts.suggestedIsovalue, 0.0);
}

TEST(PreparedVolume, StopsWhenAsked) {
  base::Progress progress;
  progress.requestStop();
  const GridGeometry geometry = GridGeometry::make({40, 40, 40}, glm::dvec3(1));
  EXPECT_THROW(prepareVolume(volumeOf(Grid(geometry, std::vector<std::uint8_t>(64000))), progress),
               base::Error);
}

// Each step on its own.
TEST(PreparedVolume, AStopLeavesMostOfTheRestOfEveryStepUndone) {
  base::Progress unwatched;
  PhantomRequest request;
  request.name = "gyroid";
  request.size = 192;
  const auto grid = std::make_shared<const Grid>(makePhantom(request, unwatched));
  const auto step = [](const char* name, const std::function<void(base::Progress&)>& work) {
    SCOPED_TRACE(name);
    test::expectStopsSoon(work, 5);
  };
  step("phantom", [&](base::Progress& progress) { makePhantom(request, progress); });
  step("grid", [&](base::Progress& progress) {
    Grid(grid->geometry(), std::get<std::vector<float>>(grid->voxels()), 1.0, 0.0, progress);
  });
  step("preparation", [&](base::Progress& progress) {
    Volume volume;
    volume.grid = grid;
    prepareVolume(std::move(volume), progress);
  });
  for (const scene::Field field : {scene::Field::cubic, scene::Field::cubic_interpolating})
    step("cubic field", [&](base::Progress& progress) { CubicFields(grid).make(field, progress); });
  step("tracer", [&](base::Progress& progress) { IsosurfaceTracer(grid, scene::Inside::above, progress); });
  step("csg", [&](base::Progress& progress) {
    Volume first, second;
    first.grid = second.grid = grid;
    first.unit = "HU";
    combined(first, second, {scene::Csg::unite}, progress);
  });
}

}  // namespace
}  // namespace isolux::volume
