// Meshes of isosurfaces against closed forms: how far they lie from the surface, that they are closed and
// turned outward, and what they enclose.
#include "volume/extraction/surface_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/volumes.h"
#include "volume/field/coefficients.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

using volume::SurfaceMesh;
using volume::SurfaceMeshRequest;
using volume::TriangleMesh;

// By the divergence theorem; positive where triangles are seen from outside counter-clockwise.
double enclosed(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const volume::Triangle& t : mesh.triangles)
    sum += glm::dot(mesh.corner(t, 0), glm::cross(mesh.corner(t, 1), mesh.corner(t, 2))) / 6.0;
  return sum;
}

volume::GridGeometry leftHanded(glm::ivec3 dims) {
  volume::GridGeometry geometry = unitGeometry(dims);
  const double c = std::cos(0.4), s = std::sin(0.4);
  const glm::dmat3 turn(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);
  const glm::dmat3 axes = turn * glm::dmat3(-0.4, 0.0, 0.0, 0.0, 0.4, 0.0, 0.0, 0.0, 2.5);
  geometry.worldFromVoxel = glm::dmat4(axes);
  geometry.worldFromVoxel[3] = glm::dvec4(-axes * (0.5 * glm::dvec3(dims - 1)), 1.0);
  return geometry;
}

volume::Grid ballIn(const volume::GridGeometry& geometry, double radius) {
  return gridOfWorld(geometry, [=](glm::dvec3 world) { return radius - glm::length(world); });
}

SurfaceMesh meshOf(const volume::Grid& grid, const SurfaceMeshRequest& request) {
  base::Progress progress;
  return volume::surfaceMesh(grid, request, progress);
}

// The middles of all triangles and edges: how far the surface lies along the gradient there, by bisection. At
// most a little more than how near it comes.
double farthest(const volume::Grid& grid, const TriangleMesh& mesh, double isovalue) {
  const glm::dmat4 toVoxel = grid.geometry().voxelFromWorld();
  double most = 0.0;
  const auto look = [&](const glm::dvec3& world) {
    const glm::dvec3 voxel(toVoxel * glm::dvec4(world, 1.0));
    const volume::FieldSample s = volume::sampleTrilinear(grid, voxel);
    const glm::dvec3 along = glm::normalize(volume::worldGradient(grid.geometry(), s.gradient));
    const auto off = [&](double t) {
      return volume::sampleTrilinear(grid, glm::dvec3(toVoxel * glm::dvec4(world + t * along, 1.0))).value -
             isovalue;
    };
    double low = -1.0, high = 1.0;
    if (!(off(low) < 0.0 && off(high) > 0.0)) return;
    for (int i = 0; i < 60; ++i) (off(0.5 * (low + high)) < 0.0 ? low : high) = 0.5 * (low + high);
    most = std::max(most, std::abs(low));
  };
  for (const volume::Triangle& t : mesh.triangles) {
    look((mesh.corner(t, 0) + mesh.corner(t, 1) + mesh.corner(t, 2)) / 3.0);
    for (int i = 0; i < 3; ++i) look(0.5 * (mesh.corner(t, i) + mesh.corner(t, (i + 1) % 3)));
  }
  return most;
}

}  // namespace

TEST(SurfaceMesh, OfABallIsClosedAndSeenFromOutside) {
  for (const bool oblique : {false, true}) {
    const volume::GridGeometry geometry = oblique ? leftHanded({90, 90, 24}) : unitGeometry({48, 48, 48});
    const double radius = oblique ? 14.0 : 18.0;
    const glm::dvec3 middle(geometry.worldFromVoxel * glm::dvec4(0.5 * glm::dvec3(geometry.dims - 1), 1.0));
    const volume::Grid grid =
        gridOfWorld(geometry, [&](glm::dvec3 world) { return radius - glm::distance(world, middle); });
    const SurfaceMesh found = meshOf(grid, {});
    EXPECT_EQ(found.openEdges, 0u);
    EXPECT_EQ(found.astray, 0u);
    for (const glm::dvec3& p : found.mesh.points) {
      const glm::dvec3 voxel(geometry.voxelFromWorld() * glm::dvec4(p, 1.0));
      EXPECT_NEAR(volume::sampleTrilinear(grid, voxel).value, 0.0, 1e-9);
    }
    const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
    EXPECT_NEAR(enclosed(found.mesh) / volume, 1.0, 0.02);
    EXPECT_NEAR(farthest(grid, found.mesh, 0.0), found.largestDistanceMm, 0.1 * found.largestDistanceMm);
  }
}

TEST(SurfaceMesh, InsideBelowIsTurnedRound) {
  const volume::Grid grid = gridOfWorld(unitGeometry({32, 32, 32}), [](glm::dvec3 world) {
    return glm::distance(world, glm::dvec3(15.5)) - 10.0;
  });
  SurfaceMeshRequest request;
  request.inside = scene::Inside::below;
  EXPECT_NEAR(enclosed(meshOf(grid, request).mesh), 4.0 / 3.0 * std::numbers::pi * 1000.0, 80.0);
}

TEST(SurfaceMesh, TrianglesAreSplitUntilTheyAreNearEnough) {
  const volume::Grid grid = phantomGrid("gyroid", 24);
  const SurfaceMesh coarse = meshOf(grid, {});
  const double tolerance = coarse.largestDistanceMm / 8.0;
  SurfaceMeshRequest request;
  request.toleranceMm = tolerance;
  const SurfaceMesh fine = meshOf(grid, request);
  EXPECT_LE(fine.largestDistanceMm, tolerance);
  EXPECT_LE(farthest(grid, fine.mesh, 0.0), 1.2 * tolerance);
  EXPECT_GT(fine.mesh.triangles.size(), coarse.mesh.triangles.size());
  EXPECT_EQ(fine.openEdges > 0, coarse.openEdges > 0);
}

// Two voxels that touch at an edge: triangles join there what the interpolant parts, and none comes near it.
TEST(SurfaceMesh, AToleranceThatIsMissedIsTold) {
  const volume::Grid grid = gridOfWorld(unitGeometry({8, 8, 8}), [](glm::dvec3 world) {
    const bool high = world == glm::dvec3(3.0, 3.0, 3.0) || world == glm::dvec3(4.0, 4.0, 3.0);
    return high ? 1.0 : -0.9;
  });
  SurfaceMeshRequest request;
  EXPECT_EQ(meshOf(grid, request).beyond, 0u) << "no tolerance was asked for";
  request.toleranceMm = 1e-4;
  const SurfaceMesh found = meshOf(grid, request);
  ASSERT_GT(found.largestDistanceMm, request.toleranceMm);
  EXPECT_GT(found.beyond, 0u);
  EXPECT_EQ(found.toleranceMm, 1e-4);
  EXPECT_LT(glm::distance(found.farthest, glm::dvec3(3.5, 3.5, 3.0)), 1.5);
}

TEST(SurfaceMesh, TheNumberOfTrianglesIsKnownBefore) {
  base::Progress progress;
  const volume::Grid ball = gridOfWorld(unitGeometry({64, 64, 64}), [](glm::dvec3 world) {
    return 25.0 - glm::distance(world, glm::dvec3(31.5));
  });
  const volume::Grid gyroid = phantomGrid("gyroid", 64);
  for (const volume::Grid* grid : {&ball, &gyroid}) {
    const auto triangles = static_cast<double>(meshOf(*grid, {}).mesh.triangles.size());
    const volume::MinMaxBlocks blocks(*grid, 8, progress);
    EXPECT_NEAR(static_cast<double>(volume::estimatedTriangles(*grid, blocks, 0.0)), triangles,
                0.1 * triangles);
    EXPECT_EQ(volume::estimatedTriangles(*grid, blocks, 1e6), 0u);
  }
}

TEST(SurfaceMesh, ASurfaceThatLeavesTheVolumeIsClosedWhereAsked) {
  // Half a ball: its flat side is the border.
  const volume::Grid grid = gridOfWorld(unitGeometry({40, 40, 20}), [](glm::dvec3 world) {
    return 14.0 - glm::distance(world, glm::dvec3(19.5, 19.5, 0.0));
  });
  const SurfaceMesh open = meshOf(grid, {});
  EXPECT_GT(open.openEdges, 50u);
  SurfaceMeshRequest request;
  request.closed = true;
  request.toleranceMm = 0.02;
  const SurfaceMesh closed = meshOf(grid, request);
  EXPECT_EQ(closed.openEdges, 0u);
  EXPECT_LE(closed.largestDistanceMm, 0.02);
  EXPECT_NEAR(enclosed(closed.mesh), 2.0 / 3.0 * std::numbers::pi * 14.0 * 14.0 * 14.0, 30.0);
  for (const glm::dvec3& p : closed.mesh.points) EXPECT_GE(p.z, 0.0);
}

TEST(SurfaceMesh, PointsLieOnTheSplineThroughTheSamples) {
  const volume::Grid grid = phantomGrid("gyroid", 20);
  base::Progress progress;
  const volume::Coefficients coefficients = volume::interpolatingCoefficients(grid, progress);
  SurfaceMeshRequest request;
  request.field = scene::Field::cubic_interpolating;
  request.coefficients = &coefficients;
  const SurfaceMesh found = meshOf(grid, request);
  std::size_t off = 0;
  for (const glm::dvec3& p : found.mesh.points) {
    const glm::dvec3 voxel(grid.geometry().voxelFromWorld() * glm::dvec4(p, 1.0));
    off += std::abs(volume::sampleCubic(coefficients, grid, voxel).value) > 1e-8 ? 1 : 0;
  }
  EXPECT_EQ(off, found.astray);
  EXPECT_LT(found.astray, found.mesh.points.size() / 100);
}

TEST(SurfaceMesh, MissingVoxelsAndHiddenPiecesHaveNoSurface) {
  const glm::ivec3 dims(40, 20, 20);
  const auto field = [](glm::dvec3 world) {
    if (glm::distance(world, glm::dvec3(10.0, 9.5, 3.0)) < 2.0) return std::nan("");
    return 6.0 -
           std::min(glm::distance(world, glm::dvec3(9.5)), glm::distance(world, glm::dvec3(30.0, 9.5, 9.5)));
  };
  const volume::Grid grid = gridOfWorld(unitGeometry(dims), field);
  const SurfaceMesh both = meshOf(grid, {});
  EXPECT_GT(both.openEdges, 5u);  // around the gap
  volume::VoxelMask hidden(dims);
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < 20; ++x)
        if (grid.value(x, y, z) >= 0.0) hidden.hide(x, x + 1, y, z);
  SurfaceMeshRequest request;
  request.hidden = &hidden;
  const SurfaceMesh right = meshOf(grid, request);
  EXPECT_EQ(right.openEdges, 0u);
  for (const glm::dvec3& p : right.mesh.points) EXPECT_GT(p.x, 20.0);
}

TEST(SurfaceMesh, WhereThereIsNoSurfaceThereAreNoTriangles) {
  const volume::Grid grid = ballIn(unitGeometry({8, 8, 8}), 2.0);
  SurfaceMeshRequest request;
  request.isovalue = 1e6;
  EXPECT_TRUE(meshOf(grid, request).mesh.triangles.empty());
}

// Edges that have not two triangles of opposite directions, by places: as files without shared points are
// read.
std::size_t oddEdges(const TriangleMesh& mesh) {
  const auto key = [](const glm::dvec3& p) {
    return std::array<float, 3>{float(p.x), float(p.y), float(p.z)};
  };
  std::map<std::pair<std::array<float, 3>, std::array<float, 3>>, int> directed;
  for (const volume::Triangle& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) ++directed[{key(mesh.corner(t, i)), key(mesh.corner(t, (i + 1) % 3))}];
  std::size_t odd = 0;
  for (const auto& [edge, count] : directed) {
    const auto back = directed.find({edge.second, edge.first});
    odd += count != 1 || back == directed.end() || back->second != 1;
  }
  return odd;
}

TEST(SurfaceMesh, AtAnIsovalueThatVoxelsHaveItIsAManifold) {
  constexpr int n = 48;
  std::vector<std::uint8_t> noisy;
  for (int i = 0; i < n * n * n; ++i) {
    const double r = glm::distance(glm::dvec3(i % n, i / n % n, i / (n * n)), glm::dvec3(0.5 * (n - 1)));
    const double value = 35.0 - r + base::normalNoise(1, static_cast<std::uint64_t>(i));
    noisy.push_back(static_cast<std::uint8_t>(std::clamp(std::round(value), 0.0, 255.0)));
  }
  const volume::Grid grid(unitGeometry(glm::ivec3(n)), volume::VoxelArray(std::move(noisy)));
  for (const double isovalue : {15.0, 18.0, 20.0, 20.5})
    for (const scene::Inside inside : {scene::Inside::above, scene::Inside::below}) {
      SurfaceMeshRequest request;
      request.isovalue = isovalue;
      request.inside = inside;
      request.closed = true;
      const SurfaceMesh found = meshOf(grid, request);
      const double ball = 4.0 / 3.0 * std::numbers::pi * std::pow(35.0 - isovalue, 3.0),
                   block = std::pow(n - 1.0, 3.0);
      EXPECT_EQ(found.openEdges, 0u) << isovalue;
      EXPECT_EQ(oddEdges(found.mesh), 0u) << isovalue;
      std::set<std::array<int, 3>> faces;
      for (const volume::Triangle& t : found.mesh.triangles) {
        std::array<int, 3> corners{t[0], t[1], t[2]};
        std::sort(corners.begin(), corners.end());
        EXPECT_TRUE(faces.insert(corners).second) << isovalue << ": a face twice";
      }
      EXPECT_NEAR(enclosed(found.mesh), inside == scene::Inside::above ? ball : block - ball, 0.05 * ball)
          << isovalue;
    }
}

// Of a mask at its own values: all is inside, and there is no surface, as measureSurface() says; or what is
// not 0 is enclosed.
TEST(SurfaceMesh, OfAMaskAtItsValuesIsNoBlockTurnedInsideOut) {
  const volume::Grid mask = gridOfVoxels(unitGeometry(glm::ivec3(10)), [](glm::dvec3 p) {
    return glm::all(glm::lessThan(glm::abs(p - 4.5), glm::dvec3(2.0))) ? 1.0 : 0.0;
  });
  SurfaceMeshRequest request;
  request.closed = true;
  for (const auto& [isovalue, inside] :
       {std::pair(1.0, scene::Inside::below), std::pair(0.0, scene::Inside::above)}) {
    request.isovalue = isovalue;
    request.inside = inside;
    EXPECT_TRUE(meshOf(mask, request).mesh.triangles.empty()) << isovalue;
  }
  request.isovalue = 1.0;
  request.inside = scene::Inside::above;
  EXPECT_NEAR(enclosed(meshOf(mask, request).mesh), 27.0, 0.1);
  request.isovalue = 0.0;
  request.inside = scene::Inside::below;
  EXPECT_NEAR(enclosed(meshOf(mask, request).mesh), 729.0 - 100.3,
              0.1);  // flying edges cut the cube's edges off
}

}  // namespace isolux::test
