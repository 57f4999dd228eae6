#include "scene/camera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "scene/rules/automatic.h"
#include "tests/support/lamps.h"

namespace isolux::scene {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

Camera someCamera(Projection projection = Projection::perspective) {
  Camera camera;
  camera.eye = glm::dvec3(30, -400, 55);
  camera.target = glm::dvec3(10, 20, -5);
  camera.up = glm::dvec3(0.1, 0, 2);
  camera.fov = 35;
  camera.projection = projection;
  return camera;
}

void expectNear(glm::dvec3 actual, glm::dvec3 expected, double tolerance) {
  EXPECT_LE(glm::length(actual - expected), tolerance)
      << actual.x << ' ' << actual.y << ' ' << actual.z << " instead of " << expected.x << ' ' << expected.y
      << ' ' << expected.z;
}

void expectOrthonormal(const CameraFrame& f) {
  for (const glm::dvec3& v : {f.right, f.up, f.back}) EXPECT_NEAR(glm::length(v), 1.0, 1e-12);
  expectNear(glm::cross(f.right, f.up), f.back, 1e-12);
}

std::array<glm::dvec3, 8> cornersOf(glm::dvec3 low, glm::dvec3 high) {
  std::array<glm::dvec3, 8> corners;
  for (int i = 0; i < 8; ++i)
    corners[static_cast<std::size_t>(i)] = {i & 1 ? high.x : low.x, i & 2 ? high.y : low.y,
                                            i & 4 ? high.z : low.z};
  return corners;
}

// Where a point appears; z > 0 is in front of the eye. The inverse of rayThrough.
glm::dvec3 project(const CameraFrame& f, glm::dvec3 point) {
  const glm::dvec3 d = point - f.eye;
  const double depth = -glm::dot(d, f.back);
  const double scale = f.projection == Projection::perspective ? depth * f.halfHeight : f.halfHeight;
  return {glm::dot(d, f.right) / scale, glm::dot(d, f.up) / scale, depth};
}

TEST(Camera, FrameIsOrthonormalAndLooksAtTheTarget) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const Camera camera = someCamera(projection);
    const CameraFrame f = frameOf(camera);
    expectOrthonormal(f);
    expectNear(f.eye - f.back * f.distance, *camera.target, 1e-9);
    EXPECT_GT(glm::dot(f.up, *camera.up), 0.0);
    const double tangent = std::tan(35.0 / 2 * pi / 180);
    EXPECT_NEAR(f.halfHeight, projection == Projection::perspective ? tangent : tangent * f.distance, 1e-9);
  }
}

TEST(Camera, RayThroughTheCentreHitsTheTarget) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const CameraFrame f = frameOf(someCamera(projection));
    const Ray ray = rayThrough(f, {0, 0}, 1.7);
    expectNear(ray.origin + ray.direction * f.distance, *someCamera().target, 1e-9);
  }
}

TEST(Camera, RaysInvertTheProjection) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const CameraFrame f = frameOf(someCamera(projection));
    for (const glm::dvec2& ndc : {glm::dvec2(-1, 1), glm::dvec2(0.3, -0.8), glm::dvec2(1, 1)}) {
      const Ray ray = rayThrough(f, ndc, 1.5);
      EXPECT_NEAR(glm::length(ray.direction), 1.0, 1e-12);
      const glm::dvec3 seen = project(f, ray.origin + ray.direction * 123.0);
      EXPECT_NEAR(seen.x, ndc.x * 1.5, 1e-9);
      EXPECT_NEAR(seen.y, ndc.y, 1e-9);
      EXPECT_GT(seen.z, 0.0);
    }
  }
}

TEST(Camera, OrbitKeepsDistanceAndTarget) {
  Camera camera = someCamera();
  const double distance = frameOf(camera).distance;
  for (int i = 0; i < 1000; ++i) camera = orbited(camera, 0.1 + i * 0.01, -0.07 * i);
  EXPECT_NEAR(frameOf(camera).distance, distance, distance * 1e-10);
  expectNear(*camera.target, *someCamera().target, 1e-7);
  expectOrthonormal(frameOf(camera));
}

TEST(Camera, OrbitTurnsByTheAngleInCameraAxes) {
  const Camera camera = someCamera();
  const CameraFrame before = frameOf(camera);
  const CameraFrame yawed = frameOf(orbited(camera, pi / 2, 0));
  expectNear(yawed.back, before.right, 1e-9);
  expectNear(yawed.up, before.up, 1e-9);
  const CameraFrame pitched = frameOf(orbited(camera, 0, pi / 2));
  expectNear(pitched.back, before.up, 1e-9);
  expectNear(pitched.right, before.right, 1e-9);
  expectNear(*orbited(camera, 2 * pi, 0).eye, *camera.eye, 1e-9);
  // Over the pole and on: no gimbal lock, no flip.
  Camera over = camera;
  for (int i = 0; i < 100; ++i) over = orbited(over, 0, 2 * pi / 100);
  expectNear(*over.eye, *camera.eye, 1e-8);
}

TEST(Camera, RollTurnsThePictureClockwise) {
  const Camera camera = someCamera();
  const CameraFrame before = frameOf(camera), after = frameOf(rolled(camera, pi / 2));
  expectNear(after.up, -before.right, 1e-9);  // what was up now points to the right of the picture
  expectNear(after.right, before.up, 1e-9);
  expectNear(after.eye, before.eye, 1e-9);
}

TEST(Camera, PanMovesThePictureWithThePointer) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    const Camera camera = someCamera(projection);
    const CameraFrame after = frameOf(panned(camera, {0.25, -0.1}));
    const glm::dvec3 seen = project(after, *camera.target);
    EXPECT_NEAR(seen.x, 0.5, 1e-9) << "a quarter of the height is half an ndc unit";
    EXPECT_NEAR(seen.y, -0.2, 1e-9);
  }
}

TEST(Camera, ZoomDividesTheDistance) {
  const Camera camera = someCamera();
  const double distance = frameOf(camera).distance;
  EXPECT_NEAR(frameOf(zoomed(camera, 2)).distance, distance / 2, 1e-9);
  EXPECT_NEAR(frameOf(zoomed(zoomed(camera, 1.3), 1 / 1.3)).distance, distance, 1e-9);
  expectNear(*zoomed(camera, 3).target, *camera.target, 1e-9);
}

TEST(Camera, StandardViewsHaveTheirLetters) {
  struct Expected {
    StandardView view;
    const char *left, *right, *top, *bottom;
  };
  const glm::dvec3 low(-90, -110, -40), high(80, 95, 130);
  for (const Expected& e :
       {Expected{StandardView::anterior, "R", "L", "S", "I"},
        Expected{StandardView::posterior, "L", "R", "S", "I"},
        Expected{StandardView::left, "A", "P", "S", "I"}, Expected{StandardView::right, "P", "A", "S", "I"},
        Expected{StandardView::superior, "L", "R", "A", "P"},
        Expected{StandardView::inferior, "R", "L", "A", "P"}}) {
    Camera camera = someCamera();
    camera.projection = Projection::orthographic;
    const Camera view = standardView(camera, e.view, WorldAxes::anatomical, low, high);
    const EdgeLetters letters = edgeLetters(frameOf(view), WorldAxes::anatomical);
    const auto name = standardViewName(e.view, WorldAxes::anatomical);
    EXPECT_EQ(letters.left, e.left) << name;
    EXPECT_EQ(letters.right, e.right) << name;
    EXPECT_EQ(letters.top, e.top) << name;
    EXPECT_EQ(letters.bottom, e.bottom) << name;
    EXPECT_EQ(view.fov, camera.fov);
    EXPECT_EQ(view.projection, camera.projection);
  }
}

TEST(Camera, ViewersStandWhereTheViewIsNamed) {
  const glm::dvec3 low(-1), high(1);
  const auto eye = [&](StandardView view) {
    return *standardView({}, view, WorldAxes::anatomical, low, high).eye;
  };
  EXPECT_LT(eye(StandardView::anterior).y, -1.0);  // LPS: +y is posterior
  EXPECT_GT(eye(StandardView::posterior).y, 1.0);
  EXPECT_GT(eye(StandardView::left).x, 1.0);  // +x is the patient's left
  EXPECT_LT(eye(StandardView::right).x, -1.0);
  EXPECT_GT(eye(StandardView::superior).z, 1.0);
  EXPECT_LT(eye(StandardView::inferior).z, -1.0);
}

TEST(Camera, EdgeLettersOfObliqueViews) {
  Camera camera;
  camera.target = glm::dvec3(0);
  camera.eye = glm::dvec3(-std::sin(0.7), -std::cos(0.7), 0);  // between anterior and right, nearer anterior
  camera.up = glm::dvec3(0, 0, 1);
  EXPECT_EQ(edgeLetters(frameOf(camera), WorldAxes::anatomical).right, "LA");
  EXPECT_EQ(edgeLetters(frameOf(camera), WorldAxes::anatomical).left, "RP");
  camera.eye = glm::dvec3(-std::sin(0.2), -std::cos(0.2), 0);
  EXPECT_EQ(edgeLetters(frameOf(camera), WorldAxes::anatomical).right, "L");
}

TEST(Camera, LettersOfAnatomyOnlyWhereTheAxesAreAnatomical) {
  struct Expected {
    StandardView view;
    WorldAxes axes;
    const char *name, *left, *right, *top, *bottom;
  };
  constexpr auto z = WorldAxes::zUp, y = WorldAxes::yUp;
  for (const Expected& e : {Expected{StandardView::anterior, z, "−Y", "−X", "+X", "+Z", "−Z"},
                            Expected{StandardView::posterior, z, "+Y", "+X", "−X", "+Z", "−Z"},
                            Expected{StandardView::left, z, "+X", "−Y", "+Y", "+Z", "−Z"},
                            Expected{StandardView::superior, z, "+Z", "−X", "+X", "+Y", "−Y"},
                            Expected{StandardView::inferior, z, "−Z", "−X", "+X", "−Y", "+Y"},
                            Expected{StandardView::anterior, y, "+Z", "−X", "+X", "+Y", "−Y"},
                            Expected{StandardView::right, y, "−X", "−Z", "+Z", "+Y", "−Y"},
                            Expected{StandardView::superior, y, "+Y", "−X", "+X", "−Z", "+Z"},
                            Expected{StandardView::inferior, y, "−Y", "−X", "+X", "+Z", "−Z"}}) {
    SCOPED_TRACE(e.name);
    const Camera view = standardView({}, e.view, e.axes, glm::dvec3(-1), glm::dvec3(1));
    const EdgeLetters letters = edgeLetters(frameOf(view), e.axes);
    EXPECT_EQ(standardViewName(e.view, e.axes), e.name);
    EXPECT_EQ(letters.left, e.left);
    EXPECT_EQ(letters.right, e.right);
    EXPECT_EQ(letters.top, e.top);
    EXPECT_EQ(letters.bottom, e.bottom);
  }
}

// Shapes of boxes from flat to long, and away from the origin.
const std::vector<std::pair<glm::dvec3, glm::dvec3>> boxes{{{-1, -1, -1}, {1, 1, 1}},
                                                           {{100, 200, 300}, {101, 290, 345}},
                                                           {{0, 0, 0}, {500, 0, 0}},
                                                           {{-3, -3, -900}, {3, 3, 900}},
                                                           {{0, 0, 0}, {1e-3, 2e-3, 1e-3}}};

TEST(Camera, FitEnclosesAllCorners) {
  for (const auto& [low, high] : boxes) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
      for (const double fov : {5.0, 30.0, 120.0}) {
        Camera camera = someCamera(projection);
        camera.fov = fov;
        const Camera fit = fitted(camera, low, high);
        const CameraFrame f = frameOf(fit);
        expectNear(f.back, frameOf(camera).back, 1e-6);
        double largest = 0;
        for (const glm::dvec3& corner : cornersOf(low, high)) {
          const glm::dvec3 seen = project(f, corner);
          EXPECT_GT(seen.z, 0.0) << "behind the eye";
          EXPECT_LE(std::abs(seen.x), 1.0);
          EXPECT_LE(std::abs(seen.y), 1.0);
          largest = std::max({largest, std::abs(seen.x), std::abs(seen.y)});
        }
        if (projection == Projection::perspective || fov < 60) {
          EXPECT_GT(largest, 0.9) << "far too much air";
        }
      }
    }
  }
}

TEST(Camera, FitAndZoomScaleWithTheVolume) {
  for (const Projection projection : {Projection::perspective, Projection::orthographic})
    for (const double scale : {1e-9, 1e-6, 1e7, 1e9}) {
      const glm::dvec3 low(-30, -20, -10), high(20, 40, 60);
      const Camera one = fitted(someCamera(projection), low, high);
      const Camera scaled = fitted(someCamera(projection), scale * low, scale * high);
      expectNear(*scaled.eye / scale, *one.eye, 1e-9);
      expectNear(*scaled.target / scale, *one.target, 1e-9);
      expectNear(*zoomed(scaled, 10.0).eye / scale, *zoomed(one, 10.0).eye, 1e-9);
    }
}

TEST(Camera, ZoomEndsBeforeRoundingsTurnTheView) {
  const Camera camera = zoomed(someCamera(), 1e15);
  expectNear(frameOf(camera).back, frameOf(someCamera()).back, 1e-6);
}

TEST(Camera, DegenerateInputStaysFinite) {
  std::vector<Camera> cameras(1);
  for (const glm::dvec3& odd : {glm::dvec3(0), glm::dvec3(nan), glm::dvec3(infinity), glm::dvec3(1e300),
                                glm::dvec3(1e-300), glm::dvec3(0, 0, 5), glm::dvec3(nan, 1, -infinity)}) {
    for (const int which : {0, 1, 2, 3}) {
      Camera camera = someCamera(which == 3 ? Projection::orthographic : Projection::perspective);
      (which == 0 ? camera.eye : which == 1 ? camera.target : camera.up) = odd;
      cameras.push_back(camera);
    }
  }
  Camera onTarget = someCamera();
  onTarget.eye = onTarget.target;
  cameras.push_back(onTarget);
  Camera alongUp = someCamera();
  alongUp.up = *alongUp.eye - *alongUp.target;
  cameras.push_back(alongUp);
  Camera alongBody;
  alongBody.eye = glm::dvec3(0, 0, 9);
  cameras.push_back(alongBody);
  for (const double fov : {0.0, -10.0, 180.0, 1e9, nan}) {
    Camera camera = someCamera();
    camera.fov = fov;
    cameras.push_back(camera);
  }

  const auto check = [](const Camera& camera) {
    const CameraFrame f = frameOf(camera);
    expectOrthonormal(f);
    EXPECT_TRUE(std::isfinite(f.halfHeight) && f.halfHeight > 0.0);
    EXPECT_TRUE(std::isfinite(f.distance) && f.distance > 0.0);
    const Ray ray = rayThrough(f, {0.5, -1}, 1.3);
    for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(ray.origin[i]) && std::isfinite(ray.direction[i]));
  };
  for (const Camera& camera : cameras) {
    check(camera);
    check(orbited(camera, 1, 2));
    check(rolled(camera, 1));
    check(panned(camera, {0.1, -0.2}));
    check(zoomed(camera, 1e9));
    check(zoomed(camera, 1e-12));
    check(fitted(camera, glm::dvec3(0), glm::dvec3(0)));
    check(fitted(camera, glm::dvec3(nan), glm::dvec3(infinity)));
    check(standardView(camera, StandardView::superior, WorldAxes::anatomical, glm::dvec3(-1), glm::dvec3(1)));
  }
}

TEST(Camera, GesturesWithoutANumberChangeNothing) {
  const Camera camera = someCamera();
  EXPECT_TRUE(orbited(camera, nan, 0) == camera);
  EXPECT_TRUE(rolled(camera, infinity) == camera);
  EXPECT_TRUE(panned(camera, {nan, 0}) == camera);
  for (const double factor : {0.0, -1.0, nan, infinity}) EXPECT_TRUE(zoomed(camera, factor) == camera);
}

VolumeFacts headFacts() {
  return {{-90, -110, -40}, {80, 95, 130}, 300.0};
}

TEST(Automatic, FillsEverythingAndShowsTheWholeBox) {
  const Scene scene = resolve(Scene{}, headFacts());
  EXPECT_EQ(scene.surfaces.front().value, 300.0);
  const CameraFrame f = frameOf(scene.camera);
  EXPECT_LT(f.eye.y, -110.0) << "in front of the patient";
  EXPECT_GT(f.back.z, 0.05) << "slightly above";
  EXPECT_EQ(edgeLetters(f, WorldAxes::anatomical).right, "L");
  EXPECT_EQ(edgeLetters(f, WorldAxes::anatomical).top, "S");
  for (const glm::dvec3& corner : cornersOf(headFacts().boundsMinMm, headFacts().boundsMaxMm)) {
    const glm::dvec3 seen = project(f, corner);
    EXPECT_LE(std::max(std::abs(seen.x), std::abs(seen.y)), 1.0);
  }
}

TEST(Automatic, MeshesStandOnTheirYAxis) {
  VolumeFacts facts = headFacts();
  facts.axes = WorldAxes::yUp;
  Scene given;
  test::lampAt(given, 0).shown = true;
  const Scene scene = resolve(given, facts);
  const CameraFrame f = frameOf(scene.camera);
  EXPECT_GT(f.back.z, 0.9) << "in front, which is +z";
  EXPECT_GT(f.back.y, 0.05) << "slightly above";
  EXPECT_NEAR(f.right.x, 1.0, 1e-9);
  EXPECT_GT(f.up.y, 0.9);
  EXPECT_GT(test::lampAt(scene, 0).position->y, 95.0) << "lamps stand above, too";
}

TEST(Automatic, NeverChangesWhatIsExplicit) {
  for (int bits = 0; bits < 16; ++bits) {
    Scene scene;
    if (bits & 1) scene.camera.eye = glm::dvec3(7, 8, 900);
    if (bits & 2) scene.camera.target = glm::dvec3(1, 2, 3);
    if (bits & 4) scene.camera.up = glm::dvec3(0, 1, 0.5);
    if (bits & 8) scene.surfaces.front().value = -5.0;
    const Scene resolved = resolve(scene, headFacts());
    ASSERT_TRUE(resolved.camera.eye && resolved.camera.target && resolved.camera.up &&
                resolved.surfaces.front().value);
    if (bits & 1) {
      EXPECT_EQ(resolved.camera.eye, scene.camera.eye);
    }
    if (bits & 2) {
      EXPECT_EQ(resolved.camera.target, scene.camera.target);
    }
    if (bits & 4) {
      EXPECT_EQ(resolved.camera.up, scene.camera.up);
    }
    if (bits & 8) {
      EXPECT_EQ(resolved.surfaces.front().value, -5.0);
    }
    EXPECT_TRUE(resolve(resolved, VolumeFacts{}) == resolved) << "resolved once, resolved for good";
  }
}

TEST(Automatic, SurvivesDegenerateFacts) {
  for (const VolumeFacts& facts : {VolumeFacts{}, VolumeFacts{glm::dvec3(nan), glm::dvec3(nan), nan},
                                   VolumeFacts{glm::dvec3(5), glm::dvec3(5), infinity}}) {
    const Scene scene = resolve(Scene{}, facts);
    EXPECT_TRUE(std::isfinite(*scene.surfaces.front().value));
    expectOrthonormal(frameOf(scene.camera));
  }
  Scene centred;
  centred.camera.eye = glm::dvec3(-5, -7.5, 45);  // the centre of the box
  const Scene scene = resolve(centred, headFacts());
  EXPECT_FALSE(scene.camera.eye == scene.camera.target);
}

}  // namespace
}  // namespace isolux::scene
