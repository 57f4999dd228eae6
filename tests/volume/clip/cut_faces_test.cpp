#include "volume/clip/cut_faces.h"
#include "tests/support/surfaces.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/rays.h"
#include "tests/support/volumes.h"

namespace isolux::volume {
namespace {

// Oblique, anisotropic, left-handed.
GridGeometry slanted(glm::ivec3 dims) {
  GridGeometry geometry = test::unitGeometry(dims);
  geometry.worldFromVoxel =
      glm::dmat4{{0.8, 0.1, 0, 0}, {0.1, -0.7, 0.2, 0}, {0.1, 0, 1.5, 0}, {-3, 40, -60, 1}};
  return geometry;
}

// A bright ball, its values falling from 100 at the middle, and a plane through it.
struct BallScene {
  glm::ivec3 dims{24, 22, 20};
  Grid grid;
  glm::dvec3 middle;
  scene::Scene scene;
  CubicFields fields;
  BallScene()
      : grid(test::gridOfWorld(slanted(dims),
                               [this](glm::dvec3 p) { return 100.0 - 10.0 * glm::distance(p, middleOf()); })),
        middle(middleOf()),
        fields(std::make_shared<Grid>(grid)) {
    scene.surfaces.front().value = 50.0;  // radius 5 mm
    scene.clip.planes = {{middle + glm::dvec3(0, 0, 1), {0.2, -0.3, 1.0}}};
  }
  glm::dvec3 middleOf() const {
    return glm::dvec3(slanted(dims).worldFromVoxel * glm::dvec4(0.5 * glm::dvec3(dims - 1), 1.0));
  }
  CutFaces faces() const { return CutFaces(grid, fields, scene, {}); }
  // From a place in the world to another; t is 1 there.
  Ray ray(glm::dvec3 from, glm::dvec3 to) const {
    const glm::dmat4 voxels = grid.geometry().voxelFromWorld();
    return {glm::dvec3(voxels * glm::dvec4(from, 1)), glm::dmat3(voxels) * (to - from)};
  }
};

// The eight values about a voxel position, weighted by hand.
double trilinearOf(const Grid& grid, glm::dvec3 p) {
  const glm::ivec3 low = glm::min(glm::ivec3(p), grid.dims() - 2);
  const glm::dvec3 w = p - glm::dvec3(low);
  double sum = 0.0;
  for (int i = 0; i < 8; ++i) {
    const glm::ivec3 at(i & 1, i >> 1 & 1, i >> 2);
    double weight = 1.0;
    for (int axis = 0; axis < 3; ++axis) weight *= at[axis] ? w[axis] : 1.0 - w[axis];
    sum += weight * grid.value(low.x + at.x, low.y + at.y, low.z + at.z);
  }
  return sum;
}

TEST(CutFaces, LieOnThePlaneWithTheValuesThatAreThere) {
  for (const scene::ClipCap cap : {scene::ClipCap::inside, scene::ClipCap::whole}) {
    BallScene ball;
    ball.scene.clip.cap = cap;
    const CutFaces faces = ball.faces();
    const scene::ClipPlane plane = ball.scene.clip.planes[0];
    const glm::dvec3 eye = ball.middle + glm::dvec3(3, -4, 40);
    int seen = 0, none = 0;
    for (std::uint64_t i = 0; i < 2000; ++i) {
      const glm::dvec3 to = ball.middle + test::randomPoint(i, glm::dvec3(-8), glm::dvec3(8));
      const Ray ray = ball.ray(eye, to);
      const double t = glm::dot(plane.point - eye, plane.normal) / glm::dot(to - eye, plane.normal);
      const glm::dvec3 at = ray.origin + t * ray.direction;
      const bool within = glm::all(glm::greaterThanEqual(at, glm::dvec3(0))) &&
                          glm::all(glm::lessThanEqual(at, glm::dvec3(ball.dims - 1)));
      const double value = within ? trilinearOf(ball.grid, at) : 0.0;
      const bool expected = within && (cap == scene::ClipCap::whole || value >= 50.0);
      const auto face = faces.at(ray);
      ASSERT_EQ(face.has_value(), expected);
      seen += expected;
      none += !expected;
      if (!face) continue;
      EXPECT_NEAR(face->t, t, 1e-12);
      EXPECT_NEAR(face->value, value, 1e-9);
    }
    EXPECT_GT(seen, 100);
    EXPECT_GT(none, 100);
  }
}

TEST(CutFaces, AreSeenFromTheSideThatIsCutAwayOnly) {
  const BallScene ball;
  const glm::dvec3 above = ball.middle + glm::dvec3(0, 0, 30), below = ball.middle - glm::dvec3(0, 0, 30);
  EXPECT_TRUE(ball.faces().at(ball.ray(above, ball.middle)));
  EXPECT_FALSE(ball.faces().at(ball.ray(below, ball.middle)));
  EXPECT_FALSE(ball.faces().at(ball.ray(ball.middle, above)));  // out of what is kept
  EXPECT_FALSE(ball.faces().at(ball.ray(ball.middle, below)));
  // The eye stands in the volume, in the part that is cut away.
  EXPECT_TRUE(ball.faces().at(ball.ray(ball.middle + glm::dvec3(0, 0, 3), ball.middle)));
}

// The faces of a removed corner: where a ray from it leaves it, through whichever of the three.
TEST(CutFaces, LieOnTheFacesOfARemovedBox) {
  for (const scene::ClipCap cap : {scene::ClipCap::inside, scene::ClipCap::whole}) {
    BallScene ball;
    ball.scene.clip.cap = cap;
    ball.scene.clip.planes.clear();
    ball.scene.clip.removed = {ball.middle, ball.middle + glm::dvec3(1000)};
    const CutFaces faces = ball.faces();
    int seen[3] = {}, none = 0;
    for (std::uint64_t i = 0; i < 3000; ++i) {
      const glm::dvec3 eye = ball.middle + test::randomPoint(2 * i, glm::dvec3(0.5), glm::dvec3(30)),
                       to = ball.middle + test::randomPoint(2 * i + 1, glm::dvec3(-9), glm::dvec3(6));
      const Ray ray = ball.ray(eye, to);
      double t = std::numeric_limits<double>::infinity();
      int through = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const double at = (ball.middle[axis] - eye[axis]) / (to[axis] - eye[axis]);
        if (to[axis] < eye[axis] && at < t) t = at, through = axis;
      }
      const glm::dvec3 at = ray.origin + t * ray.direction;
      const bool within = std::isfinite(t) && glm::all(glm::greaterThanEqual(at, glm::dvec3(0))) &&
                          glm::all(glm::lessThanEqual(at, glm::dvec3(ball.dims - 1)));
      const double value = within ? trilinearOf(ball.grid, at) : 0.0;
      const bool expected = within && (cap == scene::ClipCap::whole || value >= 50.0);
      const auto face = faces.at(ray);
      ASSERT_EQ(face.has_value(), expected) << i;
      none += !expected;
      if (!face) continue;
      ++seen[through];
      EXPECT_NEAR(face->t, t, 1e-9);
      EXPECT_NEAR(face->value, value, 1e-6);
    }
    for (const int count : seen) EXPECT_GT(count, 50);
    EXPECT_GT(none, 100);
  }
}

// Outside of the ball no face is shown; behind a second box there is one.
TEST(CutFaces, TheFirstThatShowsAValueEndsTheRay) {
  BallScene ball;
  ball.scene.clip.planes.clear();
  const glm::dvec3 eye = ball.middle + glm::dvec3(0, 0, 12);
  ball.scene.clip.removed = {ball.middle + glm::dvec3(-9, -9, 7), ball.middle + glm::dvec3(9, 9, 8),
                             ball.middle + glm::dvec3(-9, -9, 2), ball.middle + glm::dvec3(9, 9, 6)};
  const auto face = ball.faces().at(ball.ray(eye, eye - glm::dvec3(0, 0, 1)));
  ASSERT_TRUE(face);
  EXPECT_NEAR(face->t, 10.0, 1e-9);
  ball.scene.clip.cap = scene::ClipCap::whole;
  const auto whole = ball.faces().at(ball.ray(eye, eye - glm::dvec3(0, 0, 1)));
  ASSERT_TRUE(whole);
  EXPECT_NEAR(whole->t, 5.0, 1e-9);
}

TEST(CutFaces, FollowWhatIsInsideOpaqueAndCut) {
  BallScene ball;
  const Ray ray = ball.ray(ball.middle + glm::dvec3(0, 0, 30), ball.middle);
  ball.scene.surfaces.front().opacity = 0.9;
  EXPECT_FALSE(ball.faces().at(ray));
  test::surfaceAt(ball.scene, 1) = {
      .id = "second", .shown = true, .value = 70.0, .albedo = glm::dvec3(0.5), .opacity = 1.0};
  EXPECT_TRUE(ball.faces().at(ray));
  test::surfaceAt(ball.scene, 1).clipped = false;
  EXPECT_FALSE(ball.faces().at(ray));
  ball.scene.surfaces.front().opacity = 1.0;
  EXPECT_TRUE(ball.faces().at(ray));
  ball.scene.isosurface.inside = scene::Inside::below;
  EXPECT_FALSE(ball.faces().at(ray));
  ball.scene.clip.cap = scene::ClipCap::whole;
  EXPECT_TRUE(ball.faces().at(ray));
  ball.scene.surfaces.front().clipped = false;
  EXPECT_FALSE(ball.faces().at(ray));
}

TEST(CutFaces, MissingVoxelsShowNothing) {
  BallScene ball;
  ball.scene.clip.cap = scene::ClipCap::whole;
  std::vector<float> voxels = std::get<std::vector<float>>(ball.grid.voxels());
  std::fill(voxels.begin(), voxels.end(), std::nanf(""));
  voxels[0] = 100.0f;
  const Grid empty(ball.grid.geometry(), std::move(voxels));
  EXPECT_FALSE(CutFaces(empty, ball.fields, ball.scene, {})
                   .at(ball.ray(ball.middle + glm::dvec3(0, 0, 30), ball.middle)));
}

}  // namespace
}  // namespace isolux::volume
