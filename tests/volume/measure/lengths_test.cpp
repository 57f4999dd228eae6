// Distances, angles, circles, thicknesses and ways along surfaces, against closed forms.
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/volumes.h"
#include "tests/volume/measure/shapes.h"
#include "volume/hit/exact_hit.h"
#include "volume/measure/geodesic.h"
#include "volume/measure/points.h"
#include "volume/measure/surface_graph.h"
#include "volume/measure/thickness.h"
#include "volume/read/input/spacing_reliability.h"

namespace isolux::test {
namespace {

using volume::Measured;
using volume::SurfaceOf;
using volume::SurfacePoint;

// A solid's voxels and all that measuring needs of them.
struct Sampled {
  Sampled(const volume::GridGeometry& geometry, const KnownSolid& solid)
      : grid(gridOfWorld(geometry, solid.field)),
        blocks(grid, 8, progress),
        graph(surfaceGraph(grid, blocks, 0.0, progress)) {}

  base::Progress progress;
  volume::Grid grid;
  volume::MinMaxBlocks blocks;
  volume::SurfaceGraph graph;
  SurfaceOf surface() const { return {grid, 0.0, scene::Inside::above, {}}; }
};

std::vector<volume::GridGeometry> everyGeometry(int size) {
  return {isotropicGeometry(size), obliqueLeftHandedGeometry(size), thickObliqueSlices(size)};
}

class RandomDirections {
 public:
  glm::dvec3 operator()() {
    const double z = uniform_(random_), angle = std::numbers::pi * uniform_(random_),
                 r = std::sqrt(1.0 - z * z);
    return {r * std::cos(angle), r * std::sin(angle), z};
  }

 private:
  std::mt19937_64 random_{5};
  std::uniform_real_distribution<double> uniform_{-1.0, 1.0};
};

void expectWithin(const Measured& measure, double reference, const std::string& what) {
  EXPECT_LE(std::abs(measure.value - reference), measure.error)
      << what << ": " << measure.value << " for " << reference;
}

// Of many, the stated errors are at most ten times the true ones on average: single ones may be right by
// luck.
struct Honesty {
  double stated = 0.0, made = 0.0;
  void add(const Measured& measure, double reference, const std::string& what) {
    expectWithin(measure, reference, what);
    stated += measure.error;
    made += std::abs(measure.value - reference);
  }
  ~Honesty() { EXPECT_LE(stated, 10.0 * made); }
};

TEST(PointMeasures, DistancesAnglesAndCircles) {
  using volume::UncertainPoint;
  const UncertainPoint a{{3.0, 0.0, 0.0}, 0.01}, b{{0.0, 0.0, 0.0}, 0.02}, c{{0.0, 4.0, 0.0}, 0.03},
      d{{0.0, 4.0, 5.0}, 0.0};
  EXPECT_DOUBLE_EQ(straightDistance(a, c).value, 5.0);
  EXPECT_DOUBLE_EQ(straightDistance(a, c).error, 0.04);
  EXPECT_NEAR(angleDegrees(a, b, c)->value, 90.0, 1e-12);
  const double degrees = 180.0 / std::numbers::pi;
  EXPECT_NEAR(angleDegrees(a, b, c)->error,
              (0.01 / 3.0 + 0.03 / 4.0 + 0.02 * std::hypot(1.0 / 3.0, 0.25)) * degrees, 1e-6);
  EXPECT_NEAR(dihedralDegrees(a, b, c, d)->value, 90.0, 1e-12);
  EXPECT_NEAR(dihedralDegrees(a, b, c, {{-1.0, 2.0, 0.0}, 0.0})->value, 180.0, 1e-12);
  EXPECT_NEAR(dihedralDegrees(a, b, c, {{1.0, 2.0, 0.0}, 0.0})->value, 0.0, 1e-12);
  const auto circle = circleThrough(a, b, c);
  EXPECT_NEAR(circle->radiusMm.value, 2.5, 1e-12);
  EXPECT_NEAR(glm::length(circle->centre - glm::dvec3(1.5, 2.0, 0.0)), 0.0, 1e-12);
  EXPECT_GT(circle->radiusMm.error, 0.0);
  EXPECT_FALSE(angleDegrees(a, a, c));
  EXPECT_FALSE(circleThrough(a, b, {{6.0, 0.0, 0.0}, 0.0}));
  EXPECT_FALSE(dihedralDegrees(a, b, {{6.0, 0.0, 0.0}, 0.0}, d));
}

// Hits of random rays with a ball, in pairs: the distance of the true points is within what is stated.
TEST(PointMeasures, DistancesOfHitsAreWithinWhatIsStated) {
  for (const volume::GridGeometry& geometry : everyGeometry(64)) {
    const SolidPlace at(geometry);
    const double radius = 0.35 * at.edge;
    const Sampled ball(geometry, knownSolids(geometry)[0]);
    const glm::dmat4 voxelFromWorld = geometry.voxelFromWorld();
    RandomDirections direction;
    Honesty honesty;
    const auto hitFrom = [&](glm::dvec3 towards) {
      const glm::dvec3 origin = at.centre + 3.0 * radius * towards;
      const auto hit = firstHit(ball.grid, ball.blocks, 0.0,
                                {glm::dvec3(voxelFromWorld * glm::dvec4(origin, 1.0)),
                                 glm::dvec3(voxelFromWorld * glm::dvec4(-towards, 0.0))});
      EXPECT_TRUE(hit);
      const auto point = surfacePoint(ball.surface(), origin - towards * (hit ? hit->t : 0.0));
      EXPECT_TRUE(point);
      return volume::UncertainPoint{point->world, offsetError(*point)};
    };
    for (int i = 0; i < 1000; ++i) {
      const glm::dvec3 a = direction(), b = direction();
      honesty.add(straightDistance(hitFrom(a), hitFrom(b)), radius * glm::length(a - b), std::to_string(i));
    }
  }
}

TEST(GeodesicTest, GreatCirclesOfABall) {
  for (const int size : {64, 128})
    for (const volume::GridGeometry& geometry : everyGeometry(size)) {
      const SolidPlace at(geometry);
      const double radius = 0.35 * at.edge;
      Sampled ball(geometry, knownSolids(geometry)[0]);
      RandomDirections direction;
      Honesty honesty;
      for (int i = 0; i < 8; ++i) {
        const glm::dvec3 a = direction(), b = direction();
        const auto from = nearestPoint(ball.surface(), at.centre + radius * a),
                   to = nearestPoint(ball.surface(), at.centre + radius * b);
        ASSERT_TRUE(from && to);
        const auto way = geodesic(ball.surface(), ball.graph, from->world, to->world, ball.progress);
        ASSERT_TRUE(way);
        const double reference = radius * std::acos(glm::dot(glm::normalize(from->world - at.centre),
                                                             glm::normalize(to->world - at.centre)));
        honesty.add(way->lengthMm, reference, std::to_string(i));
        for (const glm::dvec3& p : way->path)
          EXPECT_NEAR(glm::length(p - at.centre), radius, 0.1 * geometry.spacingMm().z);
      }
    }
}

// A helix: unrolled, a straight line.
TEST(GeodesicTest, HelicesOfACylinder) {
  for (const volume::GridGeometry& geometry : everyGeometry(96)) {
    const SolidPlace at(geometry);
    const double radius = 0.25 * at.edge;
    Sampled cylinder(geometry, knownSolids(geometry)[2]);
    for (const auto& [turn, rise] : {std::pair(1.0, 0.3), std::pair(2.5, 0.1), std::pair(0.4, 0.4)}) {
      const auto pointAt = [&](double angle, double z) {
        return nearestPoint(
            cylinder.surface(),
            at.centre + glm::dvec3(radius * std::cos(angle), radius * std::sin(angle), z * at.edge));
      };
      const auto from = pointAt(0.3, -0.5 * rise), to = pointAt(0.3 + turn, 0.5 * rise);
      ASSERT_TRUE(from && to);
      const auto way =
          geodesic(cylinder.surface(), cylinder.graph, from->world, to->world, cylinder.progress);
      ASSERT_TRUE(way);
      const glm::dvec3 a = from->world - at.centre, b = to->world - at.centre;
      const double angle = std::abs(std::atan2(a.x * b.y - a.y * b.x, a.x * b.x + a.y * b.y));
      expectWithin(way->lengthMm, std::hypot(radius * angle, b.z - a.z), "helix");
      EXPECT_LT(way->lengthMm.error, 0.1 * way->lengthMm.value);
    }
  }
}

// Over an edge of a cube: straight when its two faces are laid flat.
TEST(GeodesicTest, OverTheEdgeOfACube) {
  for (const volume::GridGeometry& geometry : everyGeometry(96)) {
    const SolidPlace at(geometry);
    const double half = 0.3 * at.edge;
    Sampled cube(geometry, knownSolids(geometry)[3]);
    const glm::dvec3 a = at.centre + glm::dvec3(half, 0.2 * half, -0.3 * half),
                     b = at.centre + glm::dvec3(0.4 * half, half, 0.5 * half);
    const auto from = nearestPoint(cube.surface(), a), to = nearestPoint(cube.surface(), b);
    ASSERT_TRUE(from && to);
    const auto way = geodesic(cube.surface(), cube.graph, from->world, to->world, cube.progress);
    ASSERT_TRUE(way);
    expectWithin(way->lengthMm, std::hypot(0.8 * half + 0.6 * half, 0.8 * half), "cube");
  }
}

TEST(GeodesicTest, NoWayLeadsFromOnePieceToAnother) {
  const auto geometry = unitGeometry(glm::ivec3(32, 16, 16));
  const KnownSolid two{"two", [](glm::dvec3 p) {
                         return 5.0 - std::min(glm::length(p - glm::dvec3(8.0)),
                                               glm::length(p - glm::dvec3(24.0, 8.0, 8.0)));
                       }};
  Sampled balls(geometry, two);
  const auto a = nearestPoint(balls.surface(), {3.0, 8.0, 8.0}),
             b = nearestPoint(balls.surface(), {29.0, 8.0, 8.0});
  ASSERT_TRUE(a && b);
  EXPECT_FALSE(geodesic(balls.surface(), balls.graph, a->world, b->world, balls.progress));
  EXPECT_FALSE(nearestPoint(balls.surface(), {1000.0, 0.0, 0.0}));
  EXPECT_FALSE(nearestPoint(balls.surface(), {16.0, 1.0, 1.0}));
}

// Closed nets: every edge of a triangle has a partner. (Two cells may cut loops along the same diagonal.)
TEST(SurfaceGraphTest, IsClosed) {
  for (const char* name : {"ball", "noise"}) {
    const volume::Grid grid = phantomGrid(name, 16);
    base::Progress progress;
    const volume::SurfaceGraph graph =
        surfaceGraph(grid, volume::MinMaxBlocks(grid, 8, progress), 0.0123, progress);
    std::map<std::pair<int, int>, int> edges;
    for (const glm::ivec3& t : graph.triangles)
      for (int k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
    const glm::dvec3 last = glm::dvec3(grid.dims() - 1);
    for (const auto& [edge, count] : edges) {
      if (count % 2 == 0) continue;
      bool border = true;  // an open net ends at the volume's border only
      for (const int end : {edge.first, edge.second}) {
        const glm::dvec3 voxel(grid.geometry().voxelFromWorld() *
                               glm::dvec4(graph.points[static_cast<std::size_t>(end)], 1.0));
        const glm::dvec3 off = glm::min(glm::abs(voxel), glm::abs(last - voxel));
        border = border && std::min({off.x, off.y, off.z}) < 1e-9;
      }
      EXPECT_TRUE(border) << name;
    }
  }
}

struct ThicknessCase {
  std::size_t solid;
  glm::dvec3 at;  // on the surface
  double byRay, byBall;
};

TEST(ThicknessTest, SolidsAreAsThickAsTheyAre) {
  for (const int size : {64, 128})
    for (const volume::GridGeometry& geometry : everyGeometry(size)) {
      const SolidPlace at(geometry);
      const double e = at.edge, ball = 0.35 * e, ring = 0.27 * e, tube = 0.12 * e, radius = 0.25 * e,
                   half = 0.3 * e;
      const glm::dvec3 c = at.centre;
      std::vector<ThicknessCase> cases;
      RandomDirections direction;
      for (int i = 0; i < 6; ++i) {
        const glm::dvec3 d = direction();
        const double angle = std::atan2(d.y, d.x), round = std::numbers::pi * d.z;
        const glm::dvec3 out(std::cos(angle), std::sin(angle), 0.0);
        cases.push_back({0, c + ball * d, 2.0 * ball, 2.0 * ball});
        cases.push_back({1,
                         c + (ring + tube * std::cos(round)) * out + glm::dvec3(0, 0, tube * std::sin(round)),
                         2.0 * tube, 2.0 * tube});
        cases.push_back({2, c + radius * out, 2.0 * radius, 2.0 * radius});
        cases.push_back({3, c + glm::dvec3(half, 0.0, 0.0), 2.0 * half, 2.0 * half});
      }
      const std::vector<KnownSolid> solids = knownSolids(geometry);
      for (std::size_t solid = 0; solid < solids.size(); ++solid) {
        const Sampled sampled(geometry, solids[solid]);
        for (const ThicknessCase& one : cases) {
          if (one.solid != solid) continue;
          const auto point = nearestPoint(sampled.surface(), one.at);
          ASSERT_TRUE(point) << solids[solid].name;
          const auto ray = thicknessByRay(sampled.surface(), sampled.blocks, *point);
          const auto inscribed = inscribedBall(sampled.surface(), sampled.graph, *point);
          ASSERT_TRUE(ray && inscribed) << solids[solid].name;
          const std::string what = solids[solid].name + " " + std::to_string(size);
          expectWithin(ray->mm, one.byRay, what + " ray");
          expectWithin(inscribed->diameterMm, one.byBall, what + " ball");
          EXPECT_LT(ray->mm.error, 0.25 * one.byRay) << what;
        }
      }
    }
}

// At a side of a slab with another size than its thickness the ball is the slab's, the ray too.
TEST(ThicknessTest, ABallIsStoppedByTheNearestWall) {
  const auto geometry = unitGeometry(glm::ivec3(48));
  const KnownSolid box{
      "box", [](glm::dvec3 p) { return -roundedBox(glm::abs(p - 23.4) - glm::dvec3(18.0, 10.0, 6.0)); }};
  const Sampled sampled(geometry, box);
  const auto point = nearestPoint(sampled.surface(), {41.4, 23.4, 23.4});
  ASSERT_TRUE(point);
  expectWithin(thicknessByRay(sampled.surface(), sampled.blocks, *point)->mm, 36.0, "ray");
  expectWithin(inscribedBall(sampled.surface(), sampled.graph, *point)->diameterMm, 12.0, "ball");
}

TEST(SpacingReliability, NamesTheWarning) {
  const std::vector<std::string> fine{"the origin is not finite; 0 assumed"};
  EXPECT_FALSE(volume::spacingDoubt(fine));
  const std::vector<std::string> assumed{fine[0], "ElementSpacing is missing; 1 mm assumed"};
  EXPECT_EQ(volume::spacingDoubt(assumed), assumed[1]);
  const std::vector<std::string> uneven{
      "slice distances are uneven (1.081 to 6.999 mm): resampled linearly from 28 onto 37 slices"};
  EXPECT_FALSE(volume::spacingDoubt(uneven)) << "where the slices lie is stated";
  EXPECT_EQ(volume::widestSlicesMm(uneven), 6.999);
  EXPECT_FALSE(volume::widestSlicesMm(assumed));
}

TEST(InventedData, IsNamedWorstFirst) {
  const std::vector<std::string> warnings{
      "gantry tilt of 18.5 degrees, kept so",
      "slice distances are uneven (1.081 to 6.999 mm): resampled linearly from 28 onto 37 slices",
      "slices are missing in 13 places; these are interpolated"};
  EXPECT_EQ(volume::inventedData(warnings),
            (std::vector<std::string>{"13 gaps interpolated", "uneven slices resampled"}));
  const std::vector<std::string> one{"slices are missing in 1 place; these are interpolated"};
  EXPECT_EQ(volume::inventedData(one), std::vector<std::string>{"1 gap interpolated"});
  const std::vector<std::string> assumed{"ElementSpacing is missing; 1 mm assumed"};
  EXPECT_TRUE(volume::inventedData(assumed).empty());
}

}  // namespace
}  // namespace isolux::test
