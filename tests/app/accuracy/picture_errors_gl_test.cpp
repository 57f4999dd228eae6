// Bounds of what a picture shows, judged by the view in double precision (app/study/surface_reference.h,
// which knows nothing of them): they hold, and they are no larger than they need be.
#include "app/accuracy/picture_errors.h"

#include <algorithm>
#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "app/ready/ready_fields.h"
#include "app/study/surface_reference.h"
#include "base/number_text.h"
#include "base/quantiles.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/test_data.h"

namespace isolux::app {
namespace {

using scene::Scene;

// Of one quantity: pixels that were judged, and those where the error is at most the bound.
struct Kept {
  std::vector<double> errors, bounds;
  std::size_t held = 0;

  void add(double error, double bound) {
    errors.push_back(error);
    bounds.push_back(bound);
    if (error <= bound) ++held;
  }
  double share() const { return static_cast<double>(held) / static_cast<double>(errors.size()); }
  double medianError() const { return base::median(errors); }
  double medianBound() const { return base::median(bounds); }
  double ratio() const { return medianBound() / medianError(); }
};

struct Judged {
  Kept depth, normal, curvature;
  std::size_t seen = 0, uncertain = 0;
  std::size_t elsewhere = 0;  // drawn further away than the arithmetic allows
  std::size_t wrong = 0;      // certain, and yet another answer than the truth
};

class PictureErrorsGlTest : public test::ExecutorsGlTest {
 protected:
  struct Drawn {
    DrawnHits hits;
    std::vector<float> normal, kappa;
  };
  Drawn draw(const std::shared_ptr<const volume::PreparedVolume>& volume, const Scene& scene,
             glm::ivec2 size) {
    using render::Aov;
    render::FrameRequest request;
    request.size = size;
    request.color = false;
    request.aovs = {Aov::depth, Aov::voxel, Aov::normal, Aov::kappa};
    renderer_->setVolume(volume);
    renderer_->render(scene, request);
    return {{size, renderer_->readAov(Aov::depth).values, renderer_->readAov(Aov::voxel).values,
             GetParam() == std::string("cpu")},
            renderer_->readAov(Aov::normal).values,
            renderer_->readAov(Aov::kappa).values};
  }

  Judged judge(const std::shared_ptr<const volume::PreparedVolume>& volume, Scene scene,
               glm::ivec2 size = {256, 256}) {
    base::Progress progress;
    scene = scene::resolve(pinned(std::move(scene)), volume->facts);
    completeFields(scene, *volume, true, progress);
    const Drawn drawn = draw(volume, scene, size);
    const PictureErrors bounds = pictureErrors(*volume, scene, drawn.hits, progress);
    SurfaceReference reference(volume, scene, size);
    const TrueSurface surface = reference.of(scene.hit.field, scene.derivatives, progress);
    Judged judged;
    for (std::size_t i = 0; i < surface.hits.size(); ++i) {
      const TrueHit& hit = surface.hits[i];
      const float depth = drawn.hits.depthMm[i];
      if (!std::isnan(depth)) ++judged.seen;
      if (!bounds.certain[i]) {
        ++judged.uncertain;
        EXPECT_TRUE(std::isinf(bounds.depthMm[i]));
        continue;
      }
      if (hit.hit != !std::isnan(depth)) ++judged.wrong;
      judged.elsewhere += bounds.elsewhere[i];
      if (!hit.hit || std::isnan(depth)) continue;
      judged.depth.add(std::abs(static_cast<double>(depth) - hit.depthMm), bounds.depthMm[i]);
      const TrueShape& shape = surface.shapes[i];
      const glm::dvec3 n(drawn.normal[3 * i], drawn.normal[3 * i + 1], drawn.normal[3 * i + 2]);
      if (shape.normal != glm::dvec3(0.0) && !std::isnan(n.x))
        judged.normal.add(angleDegrees(n, shape.normal), bounds.normalDegrees[i]);
      const float* const kappa = &drawn.kappa[2 * i];
      if (!std::isnan(bounds.curvature[i]) && !std::isnan(kappa[0]))
        judged.curvature.add(std::max(std::abs(kappa[0] - shape.kappa1), std::abs(kappa[1] - shape.kappa2)),
                             bounds.curvature[i]);
    }
    return judged;
  }

  static std::string textOf(const std::string& name, const Judged& judged) {
    const auto line = [](const char* what, const Kept& kept) {
      return std::string("\n  ") + what + " held " + std::to_string(100.0 * kept.share()) +
             " %, median error " + base::shortText(kept.medianError(), 3) + ", bound " +
             base::shortText(kept.medianBound(), 3);
    };
    return name + ": seen " + std::to_string(judged.seen) + ", not certain " +
           std::to_string(judged.uncertain) + line("depth", judged.depth) + line("normal", judged.normal) +
           line("curvature", judged.curvature);
  }

  static void expectKept(const std::string& name, const Judged& judged) {
    ASSERT_GT(judged.seen, 2000u) << name;
    SCOPED_TRACE(textOf(name, judged));
    EXPECT_EQ(judged.wrong, 0u);
    EXPECT_LE(static_cast<double>(judged.elsewhere), 0.001 * static_cast<double>(judged.seen));
    EXPECT_LT(static_cast<double>(judged.uncertain), 0.01 * static_cast<double>(judged.seen));
    EXPECT_GE(judged.depth.share(), 0.999);
    EXPECT_GE(judged.normal.share(), 0.999);
    EXPECT_GE(judged.curvature.share(), 0.95);
    EXPECT_LE(judged.depth.ratio(), 10.0);
    EXPECT_LE(judged.normal.ratio(), 10.0);
    EXPECT_LE(judged.curvature.ratio(), 10.0);
  }
};
ISOLUX_ON_BOTH_EXECUTORS(PictureErrorsGlTest);

TEST_P(PictureErrorsGlTest, HoldOnPhantomsAndAreUseful) {
  for (const char* const name : {"gyroid", "torus", "head"})
    expectKept(name, judge(test::phantom(name, 64), Scene{}));
}

TEST_P(PictureErrorsGlTest, HoldOnCubicFieldsScalesAndOtherCameras) {
  Scene scene;
  scene.hit.field = scene::Field::cubic_interpolating;
  scene.derivatives.field = scene::Field::cubic_interpolating;
  scene.derivatives.scale = 1.5;
  scene.camera.projection = scene::Projection::orthographic;
  expectKept("gyroid", judge(test::phantom("gyroid", 40), scene, {112, 112}));
}

TEST_P(PictureErrorsGlTest, HoldOnScans) {
  ISOLUX_NEEDS_DATA();
  const auto scan = [&](const char* file, double isovalue) {
    Scene scene;
    scene.source.path = (test::dataFolder() / "volumes" / file).string();
    scene.surfaces.front().value = isovalue;
    base::Progress progress;
    expectKept(file, judge(volume::loadVolume(scene.source, progress), scene, {112, 112}));
  };
  scan("ct_head_pitch.nii.gz", 200.0);
  scan("engine.nii.gz", 80.0);
}

// A ray over the top of a roof that rises above the isovalue by less than a rounding: whether it hits is
// chance.
TEST_P(PictureErrorsGlTest, WhereRoundingDecidesThePixelSaysSo) {
  constexpr int n = 16;
  const volume::GridGeometry geometry = test::unitGeometry({n, n, n});
  const auto volume = test::prepared(test::gridOfVoxels(
      geometry, [](glm::dvec3 p) { return 0.5 - std::abs(p.x - 8.0) - 0.01 * std::abs(p.z - 8.0); }));
  const auto uncertainAt = [&](double isovalue) {
    Scene scene;
    scene.surfaces.front().value = isovalue;
    scene.derivatives.field = scene::Field::trilinear;
    scene.camera.projection = scene::Projection::orthographic;
    scene.camera.eye = glm::dvec3(8.0, 7.5, -50.0);
    scene.camera.target = glm::dvec3(8.0, 7.5, 7.5);
    scene.camera.up = glm::dvec3(0.0, 1.0, 0.0);
    scene.camera.fov = 10.0;
    scene = scene::resolve(scene, volume->facts);
    base::Progress progress;
    completeFields(scene, *volume, true, progress);
    const Drawn drawn = draw(volume, scene, {33, 33});  // the middle column looks along x = 8
    const PictureErrors bounds = pictureErrors(*volume, scene, drawn.hits, progress);
    return std::count(bounds.certain.begin(), bounds.certain.end(), 0);
  };
  EXPECT_GT(uncertainAt(0.5 - 1e-9), 0);  // a blip a thousand millionth high
  EXPECT_EQ(uncertainAt(0.6), 0);         // nothing is near
}

// A wall across the view, and a missing voxel in it: rays along the border of its cells see the wall or
// nothing.
TEST_P(PictureErrorsGlTest, BesideAGapThePixelSaysSo) {
  const auto uncertain = [&](bool gap) {
    const auto volume =
        test::prepared(test::gridOfVoxels(test::unitGeometry({32, 32, 32}), [gap](glm::dvec3 p) {
          return gap && p == glm::dvec3(15.0, 15.0, 11.0) ? std::nan("") : p.z;
        }));
    Scene scene;
    scene.surfaces.front().value = 10.25;
    scene.camera.projection = scene::Projection::orthographic;
    scene.camera.eye = glm::dvec3(14.0 - 1e-6, 15.5, -100.0);  // the middle column is that border
    scene.camera.target = glm::dvec3(14.0 - 1e-6, 15.5, 15.5);
    scene.camera.up = glm::dvec3(0.0, 1.0, 0.0);
    scene.camera.fov = 5.0;
    scene = scene::resolve(scene, volume->facts);
    base::Progress progress;
    completeFields(scene, *volume, true, progress);
    const Drawn drawn = draw(volume, scene, {65, 65});
    const PictureErrors bounds = pictureErrors(*volume, scene, drawn.hits, progress);
    return std::count(bounds.certain.begin(), bounds.certain.end(), 0);
  };
  EXPECT_EQ(uncertain(false), 0);
  EXPECT_GE(uncertain(true), 6);
  EXPECT_LE(uncertain(true), 30);  // of 4225
}

TEST_P(PictureErrorsGlTest, SamplesAtStepsAreBoundedToo) {
  Scene scene;
  scene.hit.method = scene::HitMethod::sampled;
  scene.hit.refinements = 1;
  const Judged judged = judge(test::phantom("torus", 64), scene);
  SCOPED_TRACE(textOf("samples", judged));
  EXPECT_GE(judged.depth.share(), 0.999);
  EXPECT_GE(judged.normal.share(), 0.999);
  EXPECT_EQ(judged.wrong, 0u);
}

}  // namespace
}  // namespace isolux::app
