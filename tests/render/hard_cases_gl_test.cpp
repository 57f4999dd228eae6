// DESIGN's hard cases through the whole GL pipeline: nothing may be NaN where there is a hit, hang, or crash.
#include <cmath>
#include <functional>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "scene/settings/settings.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/surfaces.h"

namespace isolux::test {
namespace {

using volume::Grid;
using volume::GridGeometry;

// Every way to a surface point and its derivatives.
struct Quality {
  scene::HitMethod method;
  scene::Field hits, derivatives;
  scene::Fetch fetch;

  void applyTo(scene::Scene& scene) const {
    scene.hit.method = method;
    scene.hit.field = hits;
    scene.derivatives.field = derivatives;
    scene.derivatives.fetch = fetch;
  }
};

std::vector<Quality> qualities() {
  using scene::Field;
  std::vector<Quality> all;
  for (const auto method : {scene::HitMethod::sampled, scene::HitMethod::exact})
    for (const auto hits : {Field::cubic, Field::cubic_interpolating, Field::trilinear}) {
      for (const auto derivatives : {Field::trilinear, Field::cubic, Field::cubic_interpolating})
        all.push_back({method, hits, derivatives, scene::Fetch::exact});
      all.push_back({method, hits, Field::cubic_interpolating, scene::Fetch::fast});
    }
  return all;
}

class HardCasesGlTest : public ExecutorsGlTest {
 protected:
  using Prepared = std::shared_ptr<const volume::PreparedVolume>;

  // Draws every look, with every hit, field and fetch; checks that hits carry finite numbers and misses NaN.
  // Returns the number of pixels that exact trilinear hits fill.
  std::size_t drawn(const Prepared& volume, scene::Scene scene) {
    std::size_t hits = 0;
    for (const Quality& quality : qualities()) {
      quality.applyTo(scene);
      SCOPED_TRACE("method " + std::to_string(static_cast<int>(quality.method)) + ", hits " +
                   std::to_string(static_cast<int>(quality.hits)) + ", derivatives " +
                   std::to_string(static_cast<int>(quality.derivatives)));
      hits = checkedHits(volume, scene);
    }
    for (const std::string& mode : scene::setting("look.mode").choices) {
      scene::applyAssignment(scene, "look.mode=" + mode);
      // Two of the qualities: a driver compiles each of them anew, which takes most of the time here.
      using scene::Field;
      Quality{scene::HitMethod::exact, Field::trilinear, Field::cubic, scene::Fetch::exact}.applyTo(scene);
      expectFinite(volume, scene, mode);
      Quality{scene::HitMethod::exact, Field::cubic_interpolating, Field::cubic_interpolating,
              scene::Fetch::fast}
          .applyTo(scene);
      expectFinite(volume, withEverything(scene, *volume), mode + " with everything");
    }
    return hits;
  }

  // All deferred images of one scene. Returns the number of pixels with a hit.
  std::size_t checkedHits(const Prepared& volume, const scene::Scene& scene) {
    const Images result = images(volume, scene, {64, 48});
    using render::Aov;
    const render::AovImage gradient = renderer_->readAov(Aov::gradient),
                           hessian = renderer_->readAov(Aov::hessian), kappa = renderer_->readAov(Aov::kappa),
                           direction = renderer_->readAov(Aov::direction1),
                           across = renderer_->readAov(Aov::direction2),
                           confidence = renderer_->readAov(Aov::curvature_confidence);
    std::size_t hits = 0, notFinite = 0, notInside = 0, notUnit = 0, notSure = 0, notEmpty = 0;
    for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
      if (result.hit.values[i] != 1.0f) {
        notEmpty += !(std::isnan(result.depth.values[i]) && std::isnan(result.normal.values[3 * i]));
        continue;
      }
      ++hits;
      const glm::dvec3 voxel = at(result.voxel, i), g = at(gradient, i), n = at(result.normal, i),
                       d = at(direction, i), e = at(across, i);
      notInside += !glm::all(glm::greaterThanEqual(voxel, glm::dvec3(-0.1))) ||
                   !glm::all(glm::lessThanEqual(voxel, glm::dvec3(volume->grid().dims()) - 0.9));
      const auto wrong = [](double v) { return !std::isfinite(v); };
      notFinite += wrong(result.depth.values[i]) || result.depth.values[i] < -1e6f ||
                   wrong(result.error.values[i]) || wrong(g.x + g.y + g.z) ||
                   std::isinf(hessian.values[6 * i]) ||  // NaN: not known
                   wrong(kappa.values[2 * i]) || wrong(kappa.values[2 * i + 1]);
      // NaN where the gradient vanishes, else unit. Directions are unit or 0.
      notUnit += !(std::isnan(n.x) ? glm::length(g) < 1e-30 : std::fabs(glm::length(n) - 1.0) < 1e-4) ||
                 !(d == glm::dvec3(0.0) || std::fabs(glm::length(d) - 1.0) < 1e-3) ||
                 !(e == glm::dvec3(0.0) || std::fabs(glm::length(e) - 1.0) < 1e-3);
      notSure += !(confidence.values[i] >= 0.0f && confidence.values[i] <= 1.0f) ||
                 (confidence.values[i] > 0.0f && d == glm::dvec3(0.0));
    }
    EXPECT_EQ(notFinite, 0u);
    EXPECT_EQ(notInside, 0u);
    EXPECT_EQ(notUnit, 0u);
    EXPECT_EQ(notSure, 0u);
    EXPECT_EQ(notEmpty, 0u);
    return hits;
  }

  // Every overlay at once, and surfaces one behind, one on the other.
  static scene::Scene withEverything(scene::Scene scene, const volume::PreparedVolume& volume) {
    for (const char* setting :
         {"look.shading=blinn_phong", "look.texture=marble", "look.shadow=1", "look.fog=0.5",
          "look.accessibility=1", "look.ridges=1", "look.contours=1", "look.suggestive_contours=1",
          "flow.strength=1", "isosurface.opacity=0.5", "isosurface.layers=2", "light.headlight=0.5",
          "isosurface2.shown=1", "isosurface2.opacity=1", "isosurface3.shown=1", "isosurface3.opacity=0.3"})
      scene::applyAssignment(scene, setting);
    const double value = scene.surfaces.front().value.value_or(volume.facts.suggestedIsovalue);
    test::surfaceAt(scene, 1).value = value + 0.3 * volume.facts.typicalStep;
    test::surfaceAt(scene, 2).value = value;
    return scene;
  }

  // No NaN or infinity in the linear colour, and opacities are such.
  void expectFinite(const Prepared& volume, const scene::Scene& scene, const std::string& what) {
    render::FrameRequest request;
    request.size = {64, 48};
    renderer_->setVolume(volume);
    renderer_->render(scene::resolve(scene, volume->facts), request);
    const render::LinearImage image = renderer_->readLinear();
    ASSERT_EQ(image.rgba.size(), 64u * 48u * 4u);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < image.rgba.size(); ++i) {
      const float v = image.rgba[i];
      if (!(v >= 0.0f && v < (i % 4 == 3 ? 1.001f : 65504.0f))) ++wrong;
    }
    EXPECT_EQ(wrong, 0u) << what;
  }

  template <class T>
  static std::shared_ptr<const volume::PreparedVolume> made(glm::ivec3 dims,
                                                            const std::function<T(int, int, int)>& value,
                                                            glm::dvec3 spacing = glm::dvec3(1.0)) {
    std::vector<T> voxels;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x) voxels.push_back(value(x, y, z));
    return prepared(Grid(GridGeometry::make(dims, spacing), std::move(voxels)));
  }
};

TEST_P(HardCasesGlTest, ConstantVolumeHasNoSurface) {
  const auto volume = made<std::uint8_t>({9, 9, 9}, [](int, int, int) { return std::uint8_t{7}; });
  for (const double isovalue : {6.0, 7.0, 8.0, -1e30, 1e30}) {
    scene::Scene scene;
    scene.surfaces.front().value = isovalue;
    EXPECT_EQ(drawn(volume, scene), 0u) << isovalue;
  }
}

TEST_P(HardCasesGlTest, IsovalueAtMinimumMaximumAndOutside) {
  const auto volume = made<std::uint8_t>({17, 17, 17}, [](int x, int y, int z) {
    return static_cast<std::uint8_t>(x > 4 && x < 12 && y > 4 && y < 12 && z > 4 && z < 12 ? 200 : 0);
  });
  scene::Scene scene;
  for (const double isovalue : {-1.0, 201.0}) {
    scene.surfaces.front().value = isovalue;
    EXPECT_EQ(drawn(volume, scene), 0u) << isovalue;
  }
  scene.surfaces.front().value = 0.0;  // everything is at least the minimum: inside everywhere, no surface
  EXPECT_EQ(drawn(volume, scene), 0u);
  scene.surfaces.front().value = 200.0;  // the inner cube's own voxels
  EXPECT_GT(drawn(volume, scene), 20u);
}

TEST_P(HardCasesGlTest, OneAndTwoVoxelAxes) {
  const auto value = [](int x, int y, int z) { return static_cast<float>(x + y + z); };
  scene::Scene scene;
  scene.surfaces.front().value = 3.5;
  for (const glm::ivec3& dims : {glm::ivec3(8, 8, 1), glm::ivec3(1, 1, 1), glm::ivec3(1, 8, 8)})
    EXPECT_EQ(drawn(made<float>(dims, value), scene), 0u);
  EXPECT_GT(drawn(made<float>({8, 8, 2}, value), scene), 10u);
  EXPECT_GT(drawn(made<float>({2, 8, 8}, value), scene), 10u);
  scene.surfaces.front().value = 1.5;
  EXPECT_GT(drawn(made<float>({2, 2, 2}, value), scene), 10u);
}

TEST_P(HardCasesGlTest, TinyAndOffsetValues) {
  const auto ball = [](int x, int y, int z) { return 7.0 - glm::length(glm::dvec3(x, y, z) - 10.0); };
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  const std::size_t plain =
      drawn(made<float>({21, 21, 21}, [&](int x, int y, int z) { return static_cast<float>(ball(x, y, z)); }),
            scene);
  EXPECT_GT(plain, 200u);
  for (const float scale : {1e-20f, 1e-30f, 1e-37f, 1e20f, 3e37f}) {
    const std::size_t scaled =
        drawn(made<float>({21, 21, 21},
                          [&](int x, int y, int z) { return scale * static_cast<float>(ball(x, y, z)); }),
              scene);
    EXPECT_NEAR(static_cast<double>(scaled), static_cast<double>(plain), 2.0) << scale;
  }
  scene.surfaces.front().value = 1e6;
  const std::size_t offset = drawn(
      made<float>({21, 21, 21}, [&](int x, int y, int z) { return static_cast<float>(1e6 + ball(x, y, z)); }),
      scene);
  EXPECT_NEAR(static_cast<double>(offset), static_cast<double>(plain),
              12.0);  // floats near 1e6 are 1/16 apart
}

TEST_P(HardCasesGlTest, FullRangeIntegers) {
  scene::Scene scene;
  scene.surfaces.front().value = 32766.5;
  EXPECT_GT(
      drawn(made<std::int16_t>(
                {8, 8, 8}, [](int, int y, int) { return static_cast<std::int16_t>(y < 4 ? -32768 : 32767); }),
            scene),
      20u);
  scene.surfaces.front().value = 65534.5;
  EXPECT_GT(
      drawn(made<std::uint16_t>(
                {8, 8, 8}, [](int, int y, int) { return static_cast<std::uint16_t>(y < 4 ? 65534 : 65535); }),
            scene),
      20u);
  scene.surfaces.front().value = -127.5;
  EXPECT_GT(
      drawn(made<std::int8_t>({8, 8, 8},
                              [](int, int y, int) { return static_cast<std::int8_t>(y < 4 ? -128 : -127); }),
            scene),
      20u);
}

TEST_P(HardCasesGlTest, NeighbouringIntegersHitWhereTheyShould) {
  // 16-bit voxels 1000 | 1001 with the isovalue between: exact storage puts the surface at x = 3.25.
  const auto volume = made<std::uint16_t>(
      {8, 8, 8}, [](int x, int, int) { return static_cast<std::uint16_t>(x < 4 ? 1000 : 1001); });
  scene::Scene scene;
  scene.surfaces.front().value = 1000.25;
  scene.camera.eye = glm::dvec3(-40.0, 3.0, 3.0);
  scene.camera.target = glm::dvec3(3.5);
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  const Images result = images(volume, scene, {32, 32});
  const std::size_t middle = 16 * 32 + 16;
  ASSERT_EQ(result.hit.values[middle], 1.0f);
  EXPECT_NEAR(result.voxel.values[3 * middle], 3.25, 2e-3);
}

TEST_P(HardCasesGlTest, MissingVoxelsHoldNoSurface) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto half = [&](bool holes) {
    return made<float>({17, 17, 17}, [=](int x, int y, int z) {
      if (holes && x > 8) return (y + z) % 2 ? nan : std::numeric_limits<float>::infinity();
      return static_cast<float>(5.0 - glm::length(glm::dvec3(x, y, z) - 8.0));
    });
  };
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  const std::size_t whole = drawn(half(false), scene), cut = drawn(half(true), scene);
  EXPECT_GT(cut, 0u);
  EXPECT_LT(cut, whole);
  EXPECT_EQ(drawn(made<float>({9, 9, 9}, [](int, int, int) { return nan; }), scene), 0u);
  scene.camera.eye = glm::dvec3(0.0, -60.0, 20.0);
  scene.camera.target = glm::dvec3(8.0);
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  const Images result = images(half(true), scene, {64, 64});
  for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
    if (result.hit.values[i] == 1.0f) {
      EXPECT_LE(result.voxel.values[3 * i], 8.001f);
      // Also beside the gap, where the cell's own gradient stands in for the spline's.
      EXPECT_LT(glm::length(at(result.normal, i) - glm::normalize(at(result.voxel, i) - 8.0)), 0.2);
    }
  }
}

TEST_P(HardCasesGlTest, VanishingGradient) {
  const auto volume = phantom("two_balls", 33);
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  EXPECT_GT(drawn(volume, scene), 50u);
  // Exactly symmetric about the isovalue: the B-spline's gradient is 0 on the thin sheet.
  const auto sheet = made<float>({9, 9, 9}, [](int, int y, int) { return y == 4 ? 1.0f : 0.0f; });
  scene.surfaces.front().value = 1.0;
  drawn(sheet, scene);
  scene.surfaces.front().value = 0.999;
  EXPECT_GT(drawn(sheet, scene), 20u);
}

// At the ridge of that sheet exactly there is a surface, but neither a normal nor directions.
TEST_P(HardCasesGlTest, WhereTheGradientIsZeroDirectionsAreZero) {
  const auto sheet = made<float>({9, 9, 9}, [](int, int y, int) { return y == 4 ? 1.0f : 0.0f; });
  scene::Scene scene = assigned({"hit.method=exact", "hit.field=trilinear", "derivatives.field=cubic",
                                 "camera.projection=orthographic", "camera.target=4,4,4",
                                 "camera.eye=4,-28,4", "camera.up=0,0,1"});
  scene.surfaces.front().value = 1.0;
  EXPECT_GT(checkedHits(sheet, scene), 20u);
  const render::AovImage gradient = renderer_->readAov(render::Aov::gradient),
                         across = renderer_->readAov(render::Aov::direction2);
  int without = 0;
  for (std::size_t i = 0; i < gradient.values.size() / 3; ++i) {
    if (at(gradient, i) != glm::dvec3(0.0)) continue;  // NaN: no hit
    ++without;
    EXPECT_EQ(at(across, i), glm::dvec3(0.0));
  }
  // The processor hits a rounding before the ridge, and so do cards.
  EXPECT_GT(without, GetParam() == std::string("gpu") && !onCard() ? 20 : -1);
}

// Eye positions: inside the object, inside an active block, on a voxel, on the surface, behind it.
TEST_P(HardCasesGlTest, EyeInsideTheVolume) {
  const auto volume = phantom("ball", 48);
  const auto [low, high] = volume->grid().geometry().worldBounds();
  const double radius = 0.35 * 47.0;
  for (const double distance : {0.0, 0.5, 0.9, 0.999, 1.0, 1.001, 1.1, 1.35}) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    const glm::dvec3 centre = (low + high) * 0.5;
    scene.camera.eye = centre + glm::dvec3(0.0, -distance * radius, 0.0);
    scene.camera.target = centre + glm::dvec3(0.0, 10.0 * radius, 0.0);
    scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
    scene.camera.fov = 60.0;
    const std::size_t hits = drawn(volume, scene);
    const Images result = images(volume, scene, {65, 65});
    const std::size_t middle = 32 * 65 + 32;
    ASSERT_EQ(result.hit.values[middle], 1.0f) << distance;
    // From inside: the far wall. From outside: the near one. On it within a rounding: either.
    const double near = distance * radius - radius, far = distance * radius + radius;
    const double depth = result.depth.values[middle];
    if (distance < 0.9985)
      EXPECT_NEAR(depth, far, 0.02) << distance;
    else if (distance > 1.0015)
      EXPECT_NEAR(depth, near, 0.02) << distance;
    else
      EXPECT_TRUE(std::fabs(depth - near) < 0.05 || std::fabs(depth - far) < 0.05)
          << distance << " " << depth;
    if (distance < 1.0) {
      EXPECT_EQ(hits, 64u * 48u) << "every ray from inside a ball hits it";
    }
  }
}

TEST_P(HardCasesGlTest, OrthographicEyeInsideStillSeesAll) {
  const auto volume = phantom("ball", 48);
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.camera.projection = scene::Projection::orthographic;
  const Images outside = images(volume, scene, {64, 64});
  const glm::dvec3 toTarget = *scene_.camera.target - *scene_.camera.eye;
  // Same frame, eye moved to the middle of the ball: the height of an orthographic view comes from the
  // distance.
  scene::Scene moved = scene_;
  *moved.camera.eye += toTarget * 0.999;
  *moved.camera.target += toTarget * 0.999;
  const Images inside = images(volume, moved, {64, 64});
  std::size_t hits = 0;
  for (std::size_t i = 0; i < inside.hit.values.size(); ++i) {
    EXPECT_EQ(inside.hit.values[i], outside.hit.values[i]);
    hits += inside.hit.values[i] == 1.0f;
    if (inside.hit.values[i] == 1.0f) {
      EXPECT_NEAR(inside.depth.values[i], outside.depth.values[i] - 0.999 * glm::length(toTarget), 0.01);
    }
  }
  EXPECT_GT(hits, 300u);
}

TEST_P(HardCasesGlTest, DegenerateCameras) {
  const auto volume = phantom("ball", 32);
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.camera.eye = glm::dvec3(5.0);
  scene.camera.target = glm::dvec3(5.0);  // no direction
  scene.camera.up = glm::dvec3(0.0);
  drawn(volume, scene);
  scene.camera.eye = glm::dvec3(0.0, 0.0, 100.0);
  scene.camera.target = glm::dvec3(0.0);
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);  // along the view
  EXPECT_GT(drawn(volume, scene), 50u);
  scene.camera.eye = glm::dvec3(1e5, 0.0, 0.0);
  scene.camera.fov = 1.0;
  drawn(volume, scene);
}

// Rays exactly along axes and through voxel corners: an orthographic camera whose pixels fall on voxels.
TEST_P(HardCasesGlTest, RaysAlongAxesThroughCorners) {
  const auto volume = made<float>({33, 33, 33}, [](int x, int y, int z) {
    return static_cast<float>(10.0 - glm::length(glm::dvec3(x, y, z) - 16.0));
  });
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      scene::Scene scene;
      scene.surfaces.front().value = 0.0;
      scene.camera.projection = scene::Projection::orthographic;
      glm::dvec3 direction(0.0), up(0.0);
      direction[axis] = side;
      up[(axis + 1) % 3] = 1.0;
      scene.camera.target = glm::dvec3(16.0);
      scene.camera.eye = glm::dvec3(16.0) + 100.0 * direction;
      scene.camera.up = up;
      scene.camera.fov =
          glm::degrees(2.0 * std::atan(16.0 / 100.0));  // 32 mm high: with 32 pixels, 1 mm each
      const Images result = images(volume, scene, {32, 32});
      std::size_t hits = 0;
      for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
          const double px = x + 0.5 - 16.0, py = y + 0.5 - 16.0, inside = 100.0 - px * px - py * py;
          const bool hit = result.hit.values[static_cast<std::size_t>(y * 32 + x)] == 1.0f;
          if (std::fabs(inside) > 2.0) {
            EXPECT_EQ(hit, inside > 0.0) << axis << " " << side << " " << x << " " << y;
          }
          hits += hit;
        }
      EXPECT_NEAR(static_cast<double>(hits), 314.0, 12.0);
    }
}

// At the ends of the range of floats the texels' power of two is what keeps derivatives in range.
TEST_P(HardCasesGlTest, GradientsAtTheEndsOfTheRangeOfFloats) {
  for (const float scale : {1e-36f, 1e-20f, 2.4e37f}) {
    const auto volume = made<float>({21, 21, 21}, [scale](int x, int y, int z) {
      return scale * static_cast<float>(7.0 - glm::length(glm::dvec3(x, y, z) - 10.0));
    });
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    scene.derivatives.field = scene::Field::cubic;
    const Images result = images(volume, scene, {64, 48});
    const render::AovImage kappa = renderer_->readAov(render::Aov::kappa);
    std::size_t hits = 0;
    double sum = 0.0;
    for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
      if (result.hit.values[i] != 1.0f) continue;
      ++hits;
      EXPECT_GT(glm::dot(at(result.normal, i), glm::normalize(at(result.voxel, i) - 10.0)), 0.98) << scale;
      sum += kappa.values[2 * i];
      if (HasFailure()) return;
    }
    ASSERT_GT(hits, 200u);
    EXPECT_NEAR(sum / static_cast<double>(hits), 1.0 / 7.0, 0.02) << scale;
  }
}

// Behind missing voxels no side is known: + | missing | - along x is no crossing, though the gap is entered
// and left in blocks that are passed in one step. The field's only surfaces are two bars far from the gap.
TEST_P(HardCasesGlTest, AGapIsNoSurface) {
  const auto volume = made<float>({33, 17, 17}, [](int x, int y, int) {
    if (x >= 9 && x < 24) return std::numeric_limits<float>::quiet_NaN();
    return x < 9 ? (x <= 6 && y < 5 ? -1.0f : 1.0f) : (x >= 26 && y < 5 ? 1.0f : -1.0f);
  });
  for (const double side : {-1.0, 1.0}) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    scene.camera.target = glm::dvec3(16.0, 8.0, 8.0);
    scene.camera.eye = glm::dvec3(16.0 + side * 45.0, 8.0, 8.0);
    scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
    for (const Quality& quality : qualities()) {
      quality.applyTo(scene);
      const Images result = images(volume, scene, {64, 48});
      std::size_t hits = 0, elsewhere = 0;
      for (std::size_t i = 0; i < result.hit.values.size(); ++i) {
        if (result.hit.values[i] != 1.0f) continue;
        ++hits;
        const glm::dvec3 p = at(result.voxel, i);
        elsewhere += p.y > 5.5 || (p.x > 7.5 && p.x < 24.5);
      }
      EXPECT_GT(hits, 40u);
      EXPECT_EQ(elsewhere, 0u) << "method " << static_cast<int>(quality.method) << ", field "
                               << static_cast<int>(quality.hits);
    }
  }
}

// Flat and round surfaces, saddles, contacts, sheets thinner than a voxel, in every geometry.
TEST_P(HardCasesGlTest, ShapesInAnyGeometry) {
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  for (const char* name : {"plane", "saddle", "two_balls", "sheet"})
    EXPECT_GT(drawn(phantom(name, 17), scene), 20u) << name;
  const auto slabs = GridGeometry::make({17, 17, 9}, {0.4, 0.4, 5.0});
  for (const GridGeometry& geometry : {slabs, obliqueLeftHandedGeometry(17)})
    EXPECT_GT(drawn(phantom("ball", geometry), scene), 10u);
}

// f = y - 8: rays along and within the plane of voxels that is the surface, and along the isosurface.
TEST_P(HardCasesGlTest, RaysWithinTheSurface) {
  const auto volume = made<float>({17, 17, 17}, [](int, int y, int) { return static_cast<float>(y - 8); });
  scene::Scene scene;
  scene.camera.projection = scene::Projection::orthographic;
  scene.camera.target = glm::dvec3(8.0);
  scene.camera.eye = glm::dvec3(8.0, 8.0, 60.0);
  scene.camera.up = glm::dvec3(0.0, 1.0, 0.0);
  for (const double isovalue : {0.0, 1e-6, -1e-6, 0.5, -8.0, 8.0}) {
    scene.surfaces.front().value = isovalue;
    drawn(volume, scene);
  }
  scene.camera.projection = scene::Projection::perspective;
  scene.camera.eye = glm::dvec3(8.0, 8.0, -20.0);
  scene.surfaces.front().value = 0.0;
  drawn(volume, scene);
}

TEST_P(HardCasesGlTest, LightsAndAlbedosAtTheirEnds) {
  const auto volume = phantom("ball", 17);
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  for (const double intensity : {0.0, 1e-3, 1e5, 1e6})
    for (const double albedo : {0.0, 1.0}) {
      scene.light.intensity = scene.light.headlight = intensity;
      scene.surfaces.front().albedo = glm::dvec3(albedo);
      scene.look.backgroundTop = scene.look.backgroundBottom = glm::dvec3(0.0);
      scene.light.direction = glm::dvec3(0.0);  // none: the viewer's
      for (const char* shading : {"look.mode=blinn_phong", "look.mode=tone", "look.mode=accessibility"}) {
        scene::applyAssignment(scene, shading);
        expectFinite(volume, scene, shading);
      }
    }
}

TEST_P(HardCasesGlTest, OverBudgetIsAnErrorNotACrash) {
  const auto volume = phantom("noise", 128);  // float32: 8 MiB
  scene::Scene scene;
  if (host_.executor == scene::Executor::cpu) {  // nothing of the volume goes to the graphics card
    renderer_->setHostSettings({.memory = {.gpuBudgetMb = 0}, .executor = scene::Executor::cpu});
    images(volume, scene, {16, 16});
    return;
  }
  renderer_->setHostSettings({.memory = {.gpuBudgetMb = 1}, .executor = scene::Executor::gpu});
  try {
    images(volume, scene, {16, 16});
    FAIL() << "no error";
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::memory);
  }
  renderer_->setHostSettings({.memory = {.gpuBudgetMb = 64}, .executor = scene::Executor::gpu});
  images(volume, scene, {16, 16});  // and the renderer still works
}

ISOLUX_ON_BOTH_EXECUTORS(HardCasesGlTest);

}  // namespace
}  // namespace isolux::test
