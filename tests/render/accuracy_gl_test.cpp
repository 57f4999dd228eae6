// Hits and normals of the GL pipeline against closed forms and against the double-precision intersector.
#include <algorithm>
#include <cmath>
#include <functional>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "tests/render/gl_fixture.h"
#include "tests/support/volumes.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

using volume::GridGeometry;

struct Placement {
  const char* name;
  GridGeometry geometry;
};

GridGeometry centred(int n, glm::dvec3 spacing, const glm::dmat3& directions) {
  const glm::dvec3 half = directions * (spacing * (0.5 * (n - 1)));
  return GridGeometry::make(glm::ivec3(n), spacing, -half, directions);
}

std::vector<Placement> placements(int n) {
  const glm::dmat3 turned(glm::rotate(glm::dmat4(1.0), 0.7, glm::normalize(glm::dvec3(1.0, 2.0, -0.5))));
  glm::dmat3 leftHanded = turned;
  leftHanded[0] = -leftHanded[0];
  return {{"1 x 1 x 1 mm", centred(n, glm::dvec3(1.0), glm::dmat3(1.0))},
          {"0.4 x 0.4 x 2.5 mm", centred(n, {0.4, 0.4, 2.5}, glm::dmat3(1.0))},
          {"1 x 1 x 1 mm, oblique, left-handed", centred(n, glm::dvec3(1.0), leftHanded)},
          {"0.4 x 0.4 x 2.5 mm, oblique, left-handed", centred(n, {0.4, 0.4, 2.5}, leftHanded)}};
}

// A field of voxel space: distance to a ball (or a torus) in voxels, whatever the placement. In the world the
// surface is the image of the ball under worldFromVoxel, and its normal A^-T n.
volume::Grid voxelSpaceField(const GridGeometry& geometry, const std::function<double(glm::dvec3)>& field) {
  const glm::dvec3 centre(glm::dvec3(geometry.dims - 1) * 0.5);
  return gridOfVoxels(geometry, [&](glm::dvec3 voxel) { return field(voxel - centre); });
}

double degrees(glm::dvec3 a, glm::dvec3 b) {
  return glm::degrees(std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)));
}

class AccuracyGlTest : public ExecutorsGlTest {};

TEST_P(AccuracyGlTest, BallHitsWithin0_01VoxelAndNormalsWithin0_1Degree) {
  constexpr int n = 128;
  constexpr double radius = 45.0;
  const glm::ivec2 size(256);
  for (const Placement& placement : placements(n)) {
    const auto volume =
        prepared(voxelSpaceField(placement.geometry, [&](glm::dvec3 q) { return radius - glm::length(q); }));
    const glm::dvec3 centre(63.5);
    const glm::dmat4 voxelFromWorld = placement.geometry.voxelFromWorld();
    const glm::dmat3 normalMatrix = glm::transpose(glm::dmat3(voxelFromWorld));
    for (const auto field : {scene::Field::cubic, scene::Field::cubic_interpolating})
      for (const auto method : {scene::HitMethod::exact, scene::HitMethod::sampled}) {
        scene::Scene scene;
        scene.surfaces.front().value = 0.0;
        scene.hit.method = method;
        scene.derivatives.field = field;
        const Images result = images(volume, scene, size);
        double sumVoxels = 0.0, sumAngle = 0.0;
        int count = 0, disagreements = 0;
        for (int i = 0; i < size.x * size.y; ++i) {
          const auto pixel = static_cast<std::size_t>(i);
          const scene::Ray r = ray({i % size.x, i / size.x}, size);
          // Closed form in voxel space: |o + t d - c| = R.
          const glm::dvec3 o = glm::dvec3(voxelFromWorld * glm::dvec4(r.origin, 1.0)) - centre;
          const glm::dvec3 d = glm::dmat3(voxelFromWorld) * r.direction;
          const double a = glm::dot(d, d), b = glm::dot(o, d), c = glm::dot(o, o) - radius * radius;
          const double discriminant = b * b - a * c;
          const bool expected = discriminant > 0.0, hit = result.hit.values[pixel] == 1.0f;
          if (expected != hit)
            ++disagreements;  // only grazing rays may differ: the sampled field is not the ball
          // The closest approach of a grazing ray moves by sqrt(error): positions are compared where the ray
          // meets the surface at more than about 10 degrees.
          if (!expected || !hit || discriminant < 0.03 * a * radius * radius) continue;
          const double t = (-b - std::sqrt(discriminant)) / a;
          const glm::dvec3 closed = o + t * d;
          const glm::dvec3 found = at(result.voxel, pixel) - centre;
          sumVoxels += glm::dot(found - closed, found - closed);
          const double angle = degrees(normalMatrix * closed, at(result.normal, pixel));
          sumAngle += angle * angle;
          ++count;
        }
        ASSERT_GT(count, 800) << placement.name;
        const double voxels = std::sqrt(sumVoxels / count), angle = std::sqrt(sumAngle / count);
        std::printf(
            "ball, %s, %s hits, %s: %.5f voxel, %.4f degrees RMS, %d pixels, %d silhouette pixels differ\n",
            placement.name, method == scene::HitMethod::exact ? "exact" : "sampled",
            field == scene::Field::cubic ? "cubic" : "cubic_interpolating", voxels, angle, count,
            disagreements);
        EXPECT_LT(voxels, 0.01) << placement.name;
        EXPECT_LT(angle, 0.1) << placement.name;
        EXPECT_LT(disagreements, count / 100) << placement.name;
      }
  }
}

// Values grow by e in three voxels, and samples are four voxels apart: one step of regula falsi is not
// enough.
TEST_P(AccuracyGlTest, RefinementsOfASampledHitFindTheRootOfACurvedField) {
  constexpr double radius = 20.0;
  const glm::ivec2 size(96);
  const auto volume =
      prepared(voxelSpaceField(centred(64, glm::dvec3(1.0), glm::dmat3(1.0)),
                               [&](glm::dvec3 q) { return std::exp((radius - glm::length(q)) / 3.0); }));
  const auto meanDistance = [&](int refinements) {
    scene::Scene scene;
    scene.surfaces.front().value = 1.0;
    scene.hit.method = scene::HitMethod::sampled;
    scene.hit.rate = 0.25;
    scene.hit.nearFactor = 1.0;
    scene.hit.refinements = refinements;
    const Images result = images(volume, scene, size);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
      if (result.hit.values[i] != 1.0f) continue;
      sum += std::abs(glm::length(at(result.voxel, i) - glm::dvec3(31.5)) - radius);
      ++count;
    }
    EXPECT_GT(count, 800);
    return sum / count;
  };
  const double once = meanDistance(1), often = meanDistance(24);
  std::printf("sampled every 4 voxels: %.4f voxel after one refinement, %.4f after 24\n", once, often);
  EXPECT_GT(once, 0.1);
  EXPECT_LT(often, 0.06);  // what trilinear interpolation leaves
}

TEST_P(AccuracyGlTest, TorusNormalsWithin0_1Degree) {
  const glm::ivec2 size(256);
  constexpr double major = 36.0, minor = 18.0;
  for (const Placement& placement : placements(128)) {
    const auto volume = prepared(voxelSpaceField(placement.geometry, [&](glm::dvec3 q) {
      return minor - glm::length(glm::dvec2(std::hypot(q.x, q.y) - major, q.z));
    }));
    const glm::dmat3 normalMatrix = glm::transpose(glm::dmat3(placement.geometry.voxelFromWorld()));
    for (const auto field : {scene::Field::cubic, scene::Field::cubic_interpolating}) {
      scene::Scene scene;
      scene.surfaces.front().value = 0.0;
      scene.derivatives.field = field;
      const Images result = images(volume, scene, size);
      double sumAngle = 0.0, sumDistance = 0.0;
      int count = 0;
      for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
        if (result.hit.values[i] != 1.0f) continue;
        const glm::dvec3 q = at(result.voxel, i) - glm::dvec3(63.5);
        const glm::dvec3 ring = glm::dvec3(q.x, q.y, 0.0) * (major / std::hypot(q.x, q.y));
        const double distance = glm::length(q - ring) - minor;
        const double angle = degrees(normalMatrix * (q - ring), at(result.normal, i));
        sumAngle += angle * angle;
        sumDistance += distance * distance;
        ++count;
      }
      ASSERT_GT(count, 800) << placement.name;
      const double angle = std::sqrt(sumAngle / count), distance = std::sqrt(sumDistance / count);
      std::printf("torus, %s, %s: %.5f voxel from the surface, %.4f degrees RMS, %d pixels\n", placement.name,
                  field == scene::Field::cubic ? "cubic" : "cubic_interpolating", distance, angle, count);
      EXPECT_LT(angle, 0.1) << placement.name;
      EXPECT_LT(distance, 0.01) << placement.name;
    }
  }
}

// The phantom "ball" is a ball of the world; at 0.4 x 0.4 x 2.5 mm its radius is 7 voxels of z only. Linear
// interpolation of a distance field is off by at most the sum over axes of h^2 f_ii / 8, with f_ii = (1 -
// n_i^2) / R: each hit must lie within that, to second order, and the normals of the interpolating spline
// stay exact.
TEST_P(AccuracyGlTest, WorldBallIsAsGoodAsItsSamplingAllows) {
  const glm::ivec2 size(256);
  for (const Placement& placement : placements(128)) {
    const auto volume = phantom("ball", placement.geometry);
    const glm::dvec3 spacing = placement.geometry.spacingMm();
    const double edge = 127.0 * std::min({spacing.x, spacing.y, spacing.z}), radius = 0.35 * edge;
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    scene.derivatives.field = scene::Field::cubic_interpolating;
    scene.camera.eye = glm::dvec3(0.3, -1.0, 0.4) * (6.0 * radius);
    scene.camera.target = glm::dvec3(0.0);
    scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
    const Images result = images(volume, scene, size);
    double sumDistance = 0.0, sumAngle = 0.0, worst = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
      if (result.hit.values[i] != 1.0f) continue;
      const glm::dvec3 p = at(result.position, i);
      const double distance = glm::length(p) - radius, angle = degrees(p, at(result.normal, i));
      const glm::dvec3 n = glm::transpose(placement.geometry.directions()) * glm::normalize(p);
      const double bound = glm::dot(spacing * spacing, 1.0 - n * n) / (8.0 * radius);
      worst = std::max(worst, std::fabs(distance) / bound);
      sumDistance += distance * distance;
      sumAngle += angle * angle;
      ++count;
    }
    ASSERT_GT(count, 4000);
    const double longest = std::max({spacing.x, spacing.y, spacing.z});
    const double voxels = std::sqrt(sumDistance / count) / longest, angle = std::sqrt(sumAngle / count);
    std::printf(
        "world ball, %s: %.5f of the longest spacing (%.4f mm), worst %.2f of the bound, %.4f degrees RMS\n",
        placement.name, voxels, voxels * longest, worst, angle);
    EXPECT_LT(worst, 1.1) << placement.name;
    EXPECT_LT(angle, 0.1) << placement.name;
  }
}

// Pixel by pixel against the exact double-precision intersector, on a surface with many silhouettes.
TEST_P(AccuracyGlTest, ExactHitsAgreeWithTheDoublePrecisionIntersector) {
  const glm::ivec2 size(200, 160);
  for (const char* name : {"gyroid", "noise", "sheet", "two_balls", "head"}) {
    const auto volume = phantom(name, 64);
    const glm::dmat4 voxelFromWorld = volume->grid().geometry().voxelFromWorld();
    for (const auto projection : {scene::Projection::perspective, scene::Projection::orthographic}) {
      scene::Scene scene;
      scene.camera.projection = projection;
      const Images result = images(volume, scene, size);
      int missed = 0, invented = 0, count = 0;
      double sum = 0.0;
      for (int i = 0; i < size.x * size.y; ++i) {
        const scene::Ray r = ray({i % size.x, i / size.x}, size);
        const auto expected = volume::firstHit(
            volume->grid(), *volume->blocks, scene_.surfaces.front().value.value(),
            {glm::dvec3(voxelFromWorld * glm::dvec4(r.origin, 1.0)), glm::dmat3(voxelFromWorld) * r.direction,
             projection == scene::Projection::orthographic ? -1e6 : 0.0});
        const bool hit = result.hit.values[static_cast<std::size_t>(i)] == 1.0f;
        if (expected && !hit) ++missed;
        if (!expected && hit) ++invented;
        if (!expected || !hit) continue;
        ++count;
        const double error = glm::length(at(result.voxel, static_cast<std::size_t>(i)) - expected->voxel);
        if (error > 0.5)
          ++missed;  // another crossing than the first
        else
          sum += error * error;
      }
      ASSERT_GT(count, 1000) << name;
      const double rms = std::sqrt(sum / count);
      std::printf("%s, %s: %d hits, %d missed, %d invented, %.6f voxel RMS\n", name,
                  projection == scene::Projection::perspective ? "perspective" : "orthographic", count,
                  missed, invented, rms);
      // Float rays differ from double ones by about 1e-5 voxel: a ray may pass a silhouette on its other
      // side.
      EXPECT_LE(missed + invented, 3) << name;
      EXPECT_LT(rms, 2e-3) << name;
    }
  }
}

ISOLUX_ON_BOTH_EXECUTORS(AccuracyGlTest);

}  // namespace
}  // namespace isolux::test
