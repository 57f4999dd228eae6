// Meshes as distance fields: distance against closed forms and brute force, sign against winding numbers.
#include "volume/mesh/mesh_distance.h"

#include <cmath>
#include <random>

#include <glm/geometric.hpp>

#include "tests/support/analytic_fields.h"
#include "tests/volume/mesh/mesh_shapes.h"
#include "tests/volume/read/reader_support.h"
#include "volume/mesh/mesh_repair.h"
#include "volume/mesh/triangle_tree.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux {
namespace {

using volume::Grid;
using volume::GridGeometry;
using volume::TriangleMesh;
using volume::Volume;

Volume volumeOf(const TriangleMesh& mesh, int voxels = 48) {
  const auto path = test::temporaryFolder() / "mesh.obj";
  test::writeFile(path, test::asObj(mesh));
  volume::ReadOptions options;
  options.meshVoxels = voxels;
  return test::readFile(path, options);
}

glm::dvec3 worldAt(const Grid& grid, const glm::ivec3& voxel) {
  return glm::dvec3(grid.geometry().worldFromVoxel * glm::dvec4(glm::dvec3(voxel), 1.0));
}

template <typename F>
void forEachVoxel(const Grid& grid, F&& f) {
  for (int z = 0; z < grid.dims().z; ++z)
    for (int y = 0; y < grid.dims().y; ++y)
      for (int x = 0; x < grid.dims().x; ++x)
        f(glm::ivec3(x, y, z), worldAt(grid, {x, y, z}), grid.value(x, y, z));
}

std::vector<glm::ivec3> randomVoxels(const Grid& grid, int count, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<glm::ivec3> voxels;
  for (int i = 0; i < count; ++i) {
    glm::ivec3 voxel;
    for (int axis = 0; axis < 3; ++axis)
      voxel[axis] = std::uniform_int_distribution(0, grid.dims()[axis] - 1)(random);
    voxels.push_back(voxel);
  }
  return voxels;
}

// Wherever the surface is nearer than the band: the closed form to `bound` voxels, the right sign beyond a
// tenth of a voxel, and a gradient of length 1 where `smooth(p)`.
template <typename F, typename Smooth>
void expectDistance(const Grid& grid, double bound, F&& exact, Smooth&& smooth) {
  const double h = grid.geometry().spacingMm().x;
  double worst = 0.0, steepest = 0.0, flattest = 2.0;
  int wrongSigns = 0;
  forEachVoxel(grid, [&](const glm::ivec3& v, const glm::dvec3& p, double f) {
    const double d = exact(p);
    wrongSigns += std::abs(d) > 0.1 * h && (d > 0.0) != (f > 0.0);
    if (std::abs(d) > (volume::kDistanceBand - 1.5) * h) return;
    worst = std::max(worst, std::abs(f - d) / h);
    if (glm::any(glm::lessThan(v, glm::ivec3(1))) || glm::any(glm::greaterThan(v, grid.dims() - 2)) ||
        !smooth(p))
      return;
    const glm::dvec3 gradient(grid.value(v.x + 1, v.y, v.z) - grid.value(v.x - 1, v.y, v.z),
                              grid.value(v.x, v.y + 1, v.z) - grid.value(v.x, v.y - 1, v.z),
                              grid.value(v.x, v.y, v.z + 1) - grid.value(v.x, v.y, v.z - 1));
    const double length = glm::length(gradient) / (2.0 * h);
    steepest = std::max(steepest, length);
    flattest = std::min(flattest, length);
  });
  EXPECT_EQ(wrongSigns, 0);
  EXPECT_LT(worst, bound);
  EXPECT_LT(steepest, 1.02);
  EXPECT_GT(flattest, 0.98);
  testing::Test::RecordProperty("worst", std::to_string(worst));
}

TEST(MeshDistance, OfABallIsTheClosedForm) {
  const double radius = 7.0;
  const Volume v = volumeOf(test::icosphere(radius, 5, {100.0, -20.0, 3.0}), 64);
  EXPECT_EQ(v.unit, "mm");
  EXPECT_EQ(v.isovalue, 0.0);
  const auto toMiddle = [](const glm::dvec3& p) { return glm::distance(p, glm::dvec3(100.0, -20.0, 3.0)); };
  // Facets of 2 degrees lie at most 0.0003 R inside of the ball: 0.007 voxel.
  expectDistance(
      *v.grid, 0.012, [&](const glm::dvec3& p) { return radius - toMiddle(p); },
      [&](const glm::dvec3& p) { return toMiddle(p) > 0.5 * radius; });
}

TEST(MeshDistance, OfATorusIsTheClosedForm) {
  const Volume v = volumeOf(test::torus(10.0, 4.0, 200, 100), 72);
  const auto toRing = [](const glm::dvec3& p) {
    return glm::length(glm::dvec2(glm::length(glm::dvec2(p)) - 10.0, p.z));
  };
  expectDistance(
      *v.grid, 0.012, [&](const glm::dvec3& p) { return 4.0 - toRing(p); },
      [&](const glm::dvec3& p) { return toRing(p) > 2.0 && glm::length(glm::dvec2(p)) > 3.0; });
}

TEST(MeshDistance, IsExactInTheBandAndClampedBeyond) {
  const TriangleMesh mesh =
      test::joined(test::box({0, 0, 0}, {30, 40, 50}), test::icosphere(3.0, 2, {36.0, 20.0, 25.0}));
  const Volume v = volumeOf(mesh, 96);
  const double h = v.grid->geometry().spacingMm().x, band = volume::kDistanceBand * h;
  int near = 0;
  for (const glm::ivec3& voxel : randomVoxels(*v.grid, 4000, 7)) {
    const double brute = test::distanceTo(mesh, worldAt(*v.grid, voxel));
    const double got = std::abs(v.grid->value(voxel.x, voxel.y, voxel.z));
    if (brute < 0.95 * band) {
      ++near;
      EXPECT_NEAR(got, brute, 1e-5 * h);
    } else if (brute > 1.1 * band) {
      EXPECT_NEAR(got, band, 1e-5 * h);
    }
  }
  EXPECT_GT(near, 2000);
}

TEST(MeshDistance, GridKeepsTheSurfaceOffItsBorder) {
  for (const int voxels : {16, 33, 128}) {
    const GridGeometry geometry = volume::gridAround({{1, 2, 3}, {11, 4, 8}}, voxels);
    EXPECT_EQ(geometry.dims.x, voxels);
    glm::dvec3 low, high;
    geometry.worldBounds(low, high);
    const double h = geometry.spacingMm().x;
    for (int axis = 0; axis < 3; ++axis) {
      EXPECT_GE(glm::dvec3(1, 2, 3)[axis] - low[axis], 3.999 * h);
      EXPECT_GE(high[axis] - glm::dvec3(11, 4, 8)[axis], 3.999 * h);
    }
  }
  // A flat mesh has a grid, too.
  EXPECT_EQ(volume::gridAround({{0, 0, 5}, {1, 1, 5}}, 32).dims.z, 11);
}

TEST(MeshDistance, FollowsAnObliqueLeftHandedGrid) {
  GridGeometry geometry = test::obliqueLeftHandedGeometry(24);
  const glm::dmat3 axes = geometry.directions();
  const bool atRightAngles = std::abs(glm::dot(axes[0], axes[1])) < 1e-9;
  ASSERT_TRUE(atRightAngles && geometry.leftHanded());
  EXPECT_FALSE(volume::hasCubicVoxels(geometry));
  geometry = GridGeometry::make(glm::ivec3(24), glm::dvec3(0.5), {3.0, -1.0, 2.0}, axes);
  ASSERT_TRUE(volume::hasCubicVoxels(geometry));
  const glm::dvec3 middle(geometry.worldFromVoxel * glm::dvec4(11.0, 12.0, 11.5, 1.0));
  base::Progress progress;
  const Grid grid = volume::signedDistance(test::icosphere(3.0, 5, middle), geometry, progress);
  forEachVoxel(grid, [&](const glm::ivec3&, const glm::dvec3& p, double f) {
    const double d = 3.0 - glm::distance(p, middle);
    if (std::abs(d) < 7.0) {
      EXPECT_NEAR(f, d, 0.003);
    }
  });
}

TEST(MeshDistance, SignSurvivesFacesOnGridLines) {
  // Faces exactly on voxel planes, edges along grid lines, corners on voxels.
  const TriangleMesh mesh = test::box({4, 5, 6}, {12, 13, 14});
  const GridGeometry geometry = GridGeometry::make(glm::ivec3(20), glm::dvec3(1.0));
  base::Progress progress;
  const Grid grid = volume::signedDistance(mesh, geometry, progress);
  forEachVoxel(grid, [&](const glm::ivec3&, const glm::dvec3& p, double f) {
    const glm::dvec3 out = glm::max(glm::dvec3(4, 5, 6) - p, p - glm::dvec3(12, 13, 14));
    const double largest = std::max({out.x, out.y, out.z});
    const double d = largest < 0.0 ? -largest : -glm::length(glm::max(out, glm::dvec3(0.0)));
    EXPECT_NEAR(f, d, 1e-5);
  });
}

TEST(MeshDistance, SignOfTheSharedMeshesIsThatOfTheWindingNumber) {
  ISOLUX_NEEDS_DATA();
  for (const char* name : {"rocker-arm", "fandisk", "spot", "stanford-bunny"}) {
    SCOPED_TRACE(name);
    const auto path = test::dataFolder() / "mesh" / (std::string(name) + ".obj");
    volume::ReadOptions options;
    options.meshVoxels = 64;
    const Volume v = test::readFile(path, options);
    const bool open = std::string(name) == "stanford-bunny";
    EXPECT_EQ(test::warns(v, "223 boundary edges in 5 loops"), open);
    EXPECT_EQ(test::warns(v, "holes"), open);
    // An independent reading, and the mesh as it is: holes and all.
    const TriangleMesh mesh = test::parsedObj(path);
    int compared = 0;
    for (const glm::ivec3& voxel : randomVoxels(*v.grid, 250, 3)) {
      const double winding = test::windingNumber(mesh, worldAt(*v.grid, voxel));
      if (open && std::abs(winding - 0.5) < 0.3) continue;  // in a hole's mouth, where it says neither
      ++compared;
      EXPECT_EQ(v.grid->value(voxel.x, voxel.y, voxel.z) > 0.0, winding > 0.5);
    }
    EXPECT_GT(compared, 200);
  }
}

TEST(MeshRepair, HolesAreCountedAndClosed) {
  TriangleMesh mesh = test::icosphere(10.0, 3);
  const Volume whole = volumeOf(mesh);
  EXPECT_FALSE(test::warns(whole, "holes"));
  std::erase_if(mesh.triangles, [&](const volume::Triangle& t) {  // both caps
    return std::abs(mesh.corner(t, 0).z + mesh.corner(t, 1).z + mesh.corner(t, 2).z) > 28.5;
  });
  const Volume open = volumeOf(mesh);
  EXPECT_TRUE(test::warns(open, "boundary edges in 2 loops"));
  // The caps cut the ball nearly flat, and nothing leaks.
  forEachVoxel(*open.grid, [&](const glm::ivec3&, const glm::dvec3& p, double f) {
    const bool inBall = glm::length(p) < 9.8, between = std::abs(p.z) < 9.0;
    if (inBall && between) {
      EXPECT_GT(f, 0.0);
    }
    if (glm::length(p) > 10.0 || std::abs(p.z) > 9.95) {
      EXPECT_LT(f, 0.0);
    }
  });
}

TEST(MeshRepair, OrientationDoesNotMatter) {
  const TriangleMesh mesh = test::icosphere(10.0, 2);
  const std::uint64_t hash = volumeOf(mesh).grid->hash();
  EXPECT_EQ(volumeOf(test::turned(mesh)).grid->hash(), hash);
  TriangleMesh mixed = mesh;
  for (std::size_t i = 0; i < mixed.triangles.size(); i += 3)
    std::swap(mixed.triangles[i].y, mixed.triangles[i].z);
  const Volume v = volumeOf(mixed);
  EXPECT_TRUE(test::warns(v, "107 triangles faced the other way"));
  EXPECT_FALSE(test::warns(v, "holes"));
  EXPECT_EQ(v.grid->hash(), hash);
}

TEST(MeshRepair, CavitiesAreEmptyAndOverlapsAreFull) {
  const auto at = [](const Volume& v, const glm::dvec3& p) {
    const glm::ivec3 voxel(glm::round(glm::dvec3(v.grid->geometry().voxelFromWorld() * glm::dvec4(p, 1.0))));
    return v.grid->value(voxel.x, voxel.y, voxel.z);
  };
  const Volume shell =
      volumeOf(test::joined(test::icosphere(10.0, 3), test::turned(test::icosphere(5.0, 3))));
  EXPECT_LT(at(shell, {0, 0, 0}), -4.0);
  EXPECT_GT(at(shell, {7.5, 0, 0}), 2.0);
  const Volume both = volumeOf(test::joined(test::icosphere(10.0, 3), test::icosphere(10.0, 3, {8, 0, 0})));
  EXPECT_GT(at(both, {4, 0, 0}), 3.0);
  EXPECT_GT(at(both, {-4, 0, 0}), 1.0);  // 2 mm from the other ball, whose surface is still one
}

TEST(MeshRepair, SaysWhatItFound) {
  TriangleMesh mesh = test::icosphere(10.0, 2);
  mesh.triangles.push_back({3, 3, 5});
  mesh.points.push_back(mesh.points[0]);
  mesh.triangles.push_back({0, static_cast<int>(mesh.points.size()) - 1, 1});
  EXPECT_TRUE(test::warns(volumeOf(mesh), "2 triangles without area"));
  // A wall inside: its edges on the ball have three triangles.
  TriangleMesh wall = test::box({0, 0, 0}, {10, 10, 10});
  wall.triangles.push_back({0, 1, 7});
  const Volume v = volumeOf(wall);
  EXPECT_TRUE(test::warns(v, "with more than two triangles"));
  const glm::ivec3 middle = v.grid->dims() / 2;
  EXPECT_GT(v.grid->value(middle.x, middle.y + 3, middle.z - 3), 0.0);
  EXPECT_GT(v.grid->value(middle.x, middle.y - 3, middle.z + 3), 0.0);
}

TEST(MeshRepair, ASheetHasNoInside) {
  TriangleMesh sheet;
  sheet.points = {{0, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}};
  sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
  const Volume v = volumeOf(sheet);
  EXPECT_TRUE(test::warns(v, "4 boundary edges in 1 loop"));
  EXPECT_TRUE(test::warns(v, "no voxel inside"));
  ASSERT_TRUE(v.isovalue);
  EXPECT_DOUBLE_EQ(*v.isovalue, -2.0 * v.grid->geometry().spacingMm().x);
  base::Progress progress;
  EXPECT_EQ(volume::prepareVolume(v, progress)->facts.suggestedIsovalue, *v.isovalue);
}

TEST(MeshRepair, AMoebiusStripIsSaidToHaveOneSide) {
  TriangleMesh strip;
  const int n = 30;
  for (int i = 0; i < n; ++i) {
    const double u = 2.0 * 3.141592653589793 * i / n;
    for (const double side : {-1.0, 1.0}) {
      const double r = 5.0 + side * std::cos(0.5 * u);
      strip.points.emplace_back(r * std::cos(u), r * std::sin(u), side * std::sin(0.5 * u));
    }
  }
  for (int i = 0; i < n; ++i) {
    const int a = 2 * i, b = a + 1;
    const int c = i + 1 < n ? a + 2 : 1, d = i + 1 < n ? a + 3 : 0;
    strip.triangles.push_back({a, c, b});
    strip.triangles.push_back({b, c, d});
  }
  EXPECT_TRUE(test::warns(volumeOf(strip, 32), "only one side"));
}

TEST(MeshDistance, StopsWhenAsked) {
  const auto path = test::temporaryFolder() / "ball.stl";
  test::writeFile(path, test::asStlBinary(test::icosphere(5.0, 5)));
  base::Progress progress;
  progress.requestStop();
  try {
    volume::readVolume(path.string(), {}, progress);
    ADD_FAILURE() << "was not stopped";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::interrupted);
  }
}

// Boxes of large triangles that cross overlap: 33 ms a triangle before they were cut into pieces.
TEST(MeshDistance, LargeTrianglesThatCrossAreCutAndHaveTheirDistances) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(0.0, 100.0);
  TriangleMesh mesh;
  for (int i = 0; i < 3000; ++i) mesh.points.emplace_back(place(random), place(random), place(random));
  for (int i = 0; i < 3000; i += 3) mesh.triangles.emplace_back(i, i + 1, i + 2);
  const Volume volume = volumeOf(mesh, 128);
  const double h = volume.grid->geometry().spacingMm().x;
  EXPECT_GT(volume::TriangleTree::piecesOf(mesh, 8.0 * h, 1u << 25u, base::Progress()),
            10 * mesh.triangles.size());
  for (const glm::ivec3& voxel : randomVoxels(*volume.grid, 50, 2)) {
    double nearest = volume::kDistanceBand * h;
    for (const volume::Triangle& t : mesh.triangles)
      nearest = std::min(nearest,
                         glm::distance(worldAt(*volume.grid, voxel),
                                       volume::closestPoint(worldAt(*volume.grid, voxel), mesh.corner(t, 0),
                                                            mesh.corner(t, 1), mesh.corner(t, 2))));
    EXPECT_NEAR(std::abs(volume.grid->value(voxel.x, voxel.y, voxel.z)), nearest, 1e-5 * h + 1e-6 * nearest);
  }
}

}  // namespace
}  // namespace isolux
