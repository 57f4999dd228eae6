// Two volumes as solids on one grid: against min and max written out, and against the solids themselves.
#include "volume/prepared/csg.h"
#include "tests/support/volumes.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "tests/volume/mesh/mesh_shapes.h"
#include "tests/volume/read/reader_support.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux {
namespace {

using scene::Csg;
using volume::Grid;
using volume::GridGeometry;
using volume::Volume;

constexpr Csg kOperations[] = {Csg::unite, Csg::intersection, Csg::difference};

bool solid(Csg op, bool a, bool b) {
  return op == Csg::unite ? a || b : op == Csg::intersection ? a && b : a && !b;
}

template <typename F>
Volume volumeOf(const GridGeometry& geometry, const std::string& unit, double isovalue, F&& field) {
  Volume volume;
  volume.grid = std::make_shared<Grid>(test::gridOfWorld(geometry, field));
  volume.unit = unit;
  volume.isovalue = isovalue;
  return volume;
}

const GridGeometry cube = GridGeometry::make(glm::ivec3(24), glm::dvec3(1.0), glm::dvec3(-11.5));
double ball(const glm::dvec3& p) {
  return 8.0 - glm::length(p);
}
double otherBall(const glm::dvec3& p) {
  return 6.0 - glm::length(p - glm::dvec3(5.0, 0.5, 0.25));
}

TEST(Csg, OfDistancesIsMinimumAndMaximum) {
  const Volume a = volumeOf(cube, "mm", 0.0, ball), b = volumeOf(cube, "mm", 0.0, otherBall);
  for (const Csg op : kOperations) {
    base::Progress progress;
    const auto result = volume::combined(a, b, {op}, progress);
    EXPECT_EQ(result.volume.isovalue, 0.0);
    EXPECT_EQ(result.secondIsovalue, 0.0);
    const auto f1 = test::valuesOf(a), f2 = test::valuesOf(b), f = test::valuesOf(result.volume);
    for (std::size_t i = 0; i < f.size(); ++i) {
      const double wanted = op == Csg::unite          ? std::max(f1[i], f2[i])
                            : op == Csg::intersection ? std::min(f1[i], f2[i])
                                                      : std::min(f1[i], -f2[i]);
      ASSERT_EQ(f[i], wanted);
    }
    EXPECT_TRUE(result.volume.warnings.empty());
  }
}

TEST(Csg, AtItsIsovalueIsTheCombinedSolidWhateverTheUnits) {
  const Volume scan = volumeOf(cube, "HU", 300.0, [](const glm::dvec3& p) { return 300.0 + 80.0 * ball(p); });
  const Volume cut = volumeOf(cube, "", 0.5, [](const glm::dvec3& p) { return 0.5 + 0.01 * otherBall(p); });
  for (const Csg op : kOperations)
    for (const double value : {0.5, 0.47}) {
      base::Progress progress;
      const auto result = volume::combined(scan, cut, {op, value}, progress);
      const auto f1 = test::valuesOf(scan), f2 = test::valuesOf(cut), f = test::valuesOf(result.volume);
      for (std::size_t i = 0; i < f.size(); ++i)
        ASSERT_EQ(f[i] >= 300.0,
                  solid(op, f1[i] >= 300.0, op == Csg::difference ? f2[i] > value : f2[i] >= value));
    }
}

TEST(Csg, ABlendGoesFromTheFirstToTheSecondVoxelByVoxel) {
  const Volume a = volumeOf(cube, "mm", 0.0, ball), b = volumeOf(cube, "mm", 1.0, otherBall);
  const auto f1 = test::valuesOf(a), f2 = test::valuesOf(b);
  for (const double weight : {0.0, 0.25, 1.0}) {
    base::Progress progress;
    const auto result = volume::combined(a, b, {Csg::blend, std::nullopt, weight}, progress);
    EXPECT_EQ(result.volume.isovalue, 0.0);
    const auto f = test::valuesOf(result.volume);
    for (std::size_t i = 0; i < f.size(); ++i)
      ASSERT_EQ(f[i], static_cast<float>((1.0 - weight) * f1[i] + weight * (f2[i] - 1.0)));
  }
}

TEST(Csg, WhereTheSecondEndsABlendTakesItsMinimum) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  Volume a, b;
  a.grid = std::make_shared<Grid>(GridGeometry::make({3, 1, 1}, glm::dvec3(1.0)),
                                  std::vector<float>{nan, 2.0F, 4.0F});
  b.grid =
      std::make_shared<Grid>(GridGeometry::make({2, 1, 1}, glm::dvec3(1.0)), std::vector<float>{3.0F, -6.0F});
  a.unit = b.unit = "mm";
  a.isovalue = b.isovalue = 0.0;
  base::Progress progress;
  const auto f = test::valuesOf(volume::combined(a, b, {Csg::blend, std::nullopt, 0.5}, progress).volume);
  EXPECT_TRUE(std::isnan(f[0]));
  EXPECT_EQ(f[1], -2.0);
  EXPECT_EQ(f[2], -1.0);
}

TEST(Csg, AStepOfTheIsovalueMovesBothSurfacesAlike) {
  const Volume scan = volumeOf(cube, "HU", 300.0, [](const glm::dvec3& p) { return 300.0 + 80.0 * ball(p); });
  const Volume cut = volumeOf(cube, "", 0.5, [](const glm::dvec3& p) { return 0.5 + 0.01 * otherBall(p); });
  base::Progress progress;
  const auto result = volume::combined(scan, cut, {Csg::unite}, progress);
  // 80 HU less is 1 mm outward, for both balls (the steepness is measured along the axes: to 5 %).
  const auto f = test::valuesOf(result.volume);
  std::size_t i = 0, wrong = 0;
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x, ++i) {
        const glm::dvec3 p = glm::dvec3(x, y, z) - 11.5;
        const double d = std::max(ball(p), otherBall(p)) + 1.0;
        wrong += std::abs(d) > 0.05 && (f[i] >= 220.0) != (d >= 0.0);
      }
  EXPECT_EQ(wrong, 0U);
}

TEST(Csg, OnAnotherGridTheSecondIsInterpolated) {
  const GridGeometry other = GridGeometry::make({20, 18, 16}, {1.3, 1.7, 2.1}, {-12.0, -13.0, -10.0},
                                                glm::dmat3(0.8, 0.6, 0.0, -0.6, 0.8, 0.0, 0.0, 0.0, 1.0));
  const auto plane = [](const glm::dvec3& p) { return 0.3 * p.x - 0.5 * p.y + 0.2 * p.z; };
  const Volume a = volumeOf(cube, "mm", 0.0, [](const glm::dvec3&) { return 100.0; });
  const Volume b = volumeOf(other, "mm", 0.0, plane);
  base::Progress progress;
  const auto result = volume::combined(a, b, {Csg::intersection}, progress);
  EXPECT_TRUE(test::warns(result.volume, "another grid"));
  const glm::dmat4 voxelFromWorld = other.voxelFromWorld();
  int inside = 0, outside = 0;
  for (int z = 0; z < 24; ++z)
    for (int y = 0; y < 24; ++y)
      for (int x = 0; x < 24; ++x) {
        const glm::dvec3 p = glm::dvec3(x, y, z) - 11.5;
        const glm::dvec3 voxel(voxelFromWorld * glm::dvec4(p, 1.0));
        const bool reached = glm::all(glm::greaterThanEqual(voxel, glm::dvec3(0.0))) &&
                             glm::all(glm::lessThanEqual(voxel, glm::dvec3(other.dims - 1)));
        const double f = result.volume.grid->value(x, y, z);
        (reached ? inside : outside) += 1;
        if (reached) {
          EXPECT_NEAR(f, plane(p), 1e-5);
        } else {
          EXPECT_LT(f, 0.0);  // there is none of the second
        }
      }
  EXPECT_GT(inside, 1000);
  EXPECT_GT(outside, 1000);
  EXPECT_FALSE(test::warns(result.volume, "cut off"));
  EXPECT_TRUE(test::warns(volume::combined(a, b, {Csg::unite}, progress).volume, "cut off"));
}

TEST(Csg, MissingVoxels) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const GridGeometry two = GridGeometry::make({3, 1, 1}, glm::dvec3(1.0));
  Volume a, b;
  a.grid = std::make_shared<Grid>(two, std::vector<float>{nan, 1.0F, 1.0F});
  b.grid = std::make_shared<Grid>(two, std::vector<float>{1.0F, nan, -2.0F});
  a.isovalue = b.isovalue = 0.0;
  a.unit = b.unit = "mm";
  base::Progress progress;
  for (const Csg op : kOperations) {
    const auto f = test::valuesOf(volume::combined(a, b, {op}, progress).volume);
    EXPECT_TRUE(std::isnan(f[0]));
    EXPECT_EQ(f[1] >= 0.0, op != Csg::intersection);  // nothing of the second there
    EXPECT_EQ(f[2] >= 0.0, op != Csg::intersection);
  }
}

scene::Source sourceOf(const std::string& path, Csg op, const std::string& second) {
  scene::Source source;
  source.path = path;
  source.csg = op;
  source.csgPath = second;
  source.meshVoxels = 40;
  return source;
}

TEST(Csg, PhantomsWithoutSizeAreMadeOnTheFirstGrid) {
  base::Progress progress;
  const auto v = volume::loadVolume(sourceOf("phantom:ball:32", Csg::difference, "phantom:torus"), progress);
  EXPECT_EQ(v->grid().dims(), glm::ivec3(32));
  EXPECT_FALSE(test::warns(v->volume, "another grid"));
  const auto sized =
      volume::loadVolume(sourceOf("phantom:ball:32", Csg::difference, "phantom:torus:48"), progress);
  EXPECT_TRUE(test::warns(sized->volume, "another grid"));
  EXPECT_EQ(v->facts.suggestedIsovalue, 0.0);
  EXPECT_EQ(v->facts.csgIsovalue, 0.0);
  EXPECT_EQ(v->volume.name, "ball − torus");
}

TEST(Csg, TwoMeshesShareAGridThatHoldsBoth) {
  const auto folder = test::temporaryFolder();
  test::writeFile(folder / "a.obj", test::asObj(test::icosphere(5.0, 3)));
  test::writeFile(folder / "b.stl", test::asStlBinary(test::icosphere(3.0, 3, {7.0, 0.0, 0.0})));
  const auto load = [&](Csg op) {
    base::Progress progress;
    return volume::loadVolume(sourceOf((folder / "a.obj").string(), op, (folder / "b.stl").string()),
                              progress);
  };
  const auto both = load(Csg::unite);
  glm::dvec3 low, high;
  both->grid().geometry().worldBounds(low, high);
  EXPECT_LT(low.x, -5.0);
  EXPECT_GT(high.x, 10.0);
  EXPECT_FALSE(test::warns(both->volume, "cut off"));
  EXPECT_FALSE(test::warns(both->volume, "another grid"));
  for (const Csg op : kOperations) {
    const auto v = load(op);
    const Grid& grid = v->grid();
    const double h = grid.geometry().spacingMm().x;
    for (int z = 0; z < grid.dims().z; ++z)
      for (int y = 0; y < grid.dims().y; ++y)
        for (int x = 0; x < grid.dims().x; ++x) {
          const glm::dvec3 p(grid.geometry().worldFromVoxel * glm::dvec4(x, y, z, 1.0));
          const double a = 5.0 - glm::length(p), b = 3.0 - glm::distance(p, glm::dvec3(7.0, 0.0, 0.0));
          if (std::min(std::abs(a), std::abs(b)) < 0.2 * h) continue;  // facets
          ASSERT_EQ(grid.value(x, y, z) >= 0.0, solid(op, a >= 0.0, b >= 0.0));
        }
  }
}

TEST(Csg, OfAScanAndAMeshOnAnAnisotropicGrid) {
  const auto folder = test::temporaryFolder();
  test::writeFile(folder / "a.obj", test::asObj(test::icosphere(6.0, 3)));
  std::string voxels(20 * 20 * 10, '\0');
  test::writeFile(folder / "scan.mhd",
                  "NDims = 3\nDimSize = 20 20 10\nElementSpacing = 1 1 2\nOffset = -9.5 -9.5 -9\n"
                  "ElementType = MET_UCHAR\nElementDataFile = scan.raw\n");
  std::size_t i = 0;
  for (int z = 0; z < 10; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x, ++i) voxels[i] = static_cast<char>(x < 10 ? 10 : 200);
  test::writeFile(folder / "scan.raw", voxels);
  base::Progress progress;
  const auto v = volume::loadVolume(
      sourceOf((folder / "scan.mhd").string(), Csg::intersection, (folder / "a.obj").string()), progress);
  EXPECT_EQ(v->grid().dims(), glm::ivec3(20, 20, 10));
  EXPECT_TRUE(test::warns(v->volume, "another grid"));
  const double isovalue = v->facts.suggestedIsovalue;
  for (int z = 0; z < 10; ++z)
    for (int y = 0; y < 20; ++y)
      for (int x = 0; x < 20; ++x) {
        const double d = 6.0 - glm::length(glm::dvec3(x - 9.5, y - 9.5, 2.0 * z - 9.0));
        if (std::abs(d) < 0.3) continue;
        EXPECT_EQ(v->grid().value(x, y, z) >= isovalue, x >= 10 && d > 0.0);
      }
}

TEST(Csg, ErrorsNameTheSecondVolumeAndAnEmptyPathIsSaid) {
  base::Progress progress;
  const std::string missing = (test::temporaryFolder() / "nothing.stl").string();
  try {
    volume::loadVolume(sourceOf("phantom:ball:16", Csg::unite, missing), progress);
    ADD_FAILURE();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.file(), missing);
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
  }
  const auto v = volume::loadVolume(sourceOf("phantom:ball:16", Csg::unite, ""), progress);
  EXPECT_TRUE(test::warns(v->volume, "source.csg_path is empty"));
  EXPECT_FALSE(v->facts.csgIsovalue);
}

}  // namespace
}  // namespace isolux
