// Derivatives at a scale in pictures: against the same field in double precision at the hits of the picture,
// for curvature and normals at scales of their own.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "tests/render/gl_fixture.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/noise_at_border.h"
#include "volume/field/curvature.h"
#include "volume/field/noise_gain.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

using render::Aov;
using VolumePointer = std::shared_ptr<const volume::PreparedVolume>;

constexpr glm::ivec2 kScaledDerivativesSize{112, 96};

double largestPart(const glm::dmat3& m) {
  double most = 0.0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) most = std::max(most, std::abs(m[c][r]));
  return most;
}

render::FrameRequest picture() {
  render::FrameRequest request;
  request.size = kScaledDerivativesSize;
  return request;
}

struct Worst {
  int count = 0;
  double gradient = 0.0, hessian = 0.0, kappa = 0.0, normal = 0.0;  // the first two of a typical step
};

class ScaledDerivativesGlTest : public ExecutorsGlTest {
 protected:
  Worst against(const VolumePointer& volume, const scene::Scene& scene) {
    images(volume, scene, kScaledDerivativesSize);
    const render::AovImage hit = renderer_->readAov(Aov::hit), voxel = renderer_->readAov(Aov::voxel),
                           gradient = renderer_->readAov(Aov::gradient),
                           hessian = renderer_->readAov(Aov::hessian), kappa = renderer_->readAov(Aov::kappa),
                           normal = renderer_->readAov(Aov::normal), scale = renderer_->readAov(Aov::scale);
    const volume::Grid& grid = volume->grid();
    const scene::Derivatives& d = scene.derivatives;
    base::Progress progress;
    const auto curved = volume->cubicFields->make(d.field, *d.scale, progress);
    const auto shaded = volume->cubicFields->make(d.field, *d.normalScale, progress);
    const double typical = volume->facts.typicalStep;
    const double least = glm::length(grid.geometry().spacingMm()) / std::sqrt(3.0);
    Worst worst;
    for (std::size_t i = 0; i < hit.values.size(); ++i) {
      if (hit.values[i] != 1.0f) continue;
      ++worst.count;
      EXPECT_FLOAT_EQ(scale.values[i], static_cast<float>(*d.scale));
      const glm::dvec3 p = at(voxel, i);
      const volume::FieldSample sample = volume::sampleScaled(*curved, grid, p);
      const glm::dvec3 g = volume::worldGradient(grid.geometry(), sample.gradient);
      const glm::dmat3 h = volume::worldHessian(grid.geometry(), sample.hessian);
      const float* s = &hessian.values[6 * i];
      const glm::dmat3 seen(s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2]);
      worst.gradient = std::max(worst.gradient, glm::length(at(gradient, i) - g) * least / typical);
      worst.hessian = std::max(worst.hessian, largestPart(seen - h) * least * least / typical);
      const glm::dvec3 n =
          volume::worldGradient(grid.geometry(), volume::sampleScaled(*shaded, grid, p).gradient);
      if (glm::length(n) * least > 0.2 * typical)
        worst.normal = std::max(worst.normal, glm::length(at(normal, i) + glm::normalize(n)));
      if (glm::length(g) * least < 0.2 * typical) continue;
      const auto k = volume::principalCurvature(g, h);
      const double size = largestPart(h) / glm::length(g);
      worst.kappa = std::max({worst.kappa, std::abs(kappa.values[2 * i] - k.kappa1) / size,
                              std::abs(kappa.values[2 * i + 1] - k.kappa2) / size});
    }
    return worst;
  }
};

TEST_P(ScaledDerivativesGlTest, AgreeWithDoublePrecision) {
  for (const auto& volume : {phantom("head", 48), phantom("torus", obliqueLeftHandedGeometry(48))})
    for (const auto field : {scene::Field::cubic, scene::Field::cubic_interpolating}) {
      scene::Scene scene;
      scene.derivatives.field = field;
      const glm::dvec3 spacing = volume->grid().geometry().spacingMm();
      scene.derivatives.scale = 1.0 * spacing.x;
      scene.derivatives.normalScale = 0.7 * spacing.x;
      const Worst worst = against(volume, scene);
      std::printf(
          "field %d: %d points; gradient %.1e, Hessian %.1e of a typical step; kappa %.1e, normal %.1e\n",
          static_cast<int>(field), worst.count, worst.gradient, worst.hessian, worst.kappa, worst.normal);
      ASSERT_GT(worst.count, 500);
      EXPECT_LT(worst.gradient, 2e-4);
      EXPECT_LT(worst.hessian, 1e-3);
      EXPECT_LT(worst.kappa, 1e-3);
      EXPECT_LT(worst.normal, 2e-4);
    }
}

// A surface that ends at the border of its volume, and one whose axes are shorter than a lookup is wide.
TEST_P(ScaledDerivativesGlTest, AgreeAtBorders) {
  for (const glm::ivec3& dims : {glm::ivec3(20, 24, 17), glm::ivec3(4, 3, 24), glm::ivec3(2, 20, 5)}) {
    const auto geometry = volume::GridGeometry::make(dims, {1.0, 0.8, 1.3});
    const auto volume = prepared(gridOfVoxels(geometry, [&](glm::dvec3 v) {
      const glm::dvec3 p = v / glm::max(glm::dvec3(dims - 1), glm::dvec3(1.0)) - 0.45;
      return static_cast<float>(100.0 * (p.x + 0.7 * p.y - 0.9 * p.z + p.x * p.x - p.y * p.z));
    }));
    scene::Scene scene;
    scene.surfaces.front().value = 1.0;
    scene.derivatives.scale = 1.2;
    scene.derivatives.normalScale = 0.5;
    const Worst worst = against(volume, scene);
    std::printf("%d x %d x %d: %d points; gradient %.1e, Hessian %.1e, normal %.1e\n", dims.x, dims.y, dims.z,
                worst.count, worst.gradient, worst.hessian, worst.normal);
    ASSERT_GT(worst.count, 200);
    EXPECT_LT(worst.gradient, 2e-4);
    EXPECT_LT(worst.hessian, 1e-3);
    EXPECT_LT(worst.normal, 2e-4);
  }
}

// Of values like 1e6 + small the small part is what derivatives are made of.
// Confidences of noisy data, which is noisier still where the volume ends.
TEST_P(ScaledDerivativesGlTest, ConfidencesCountTheNoiseWithinAndAtBorders) {
  const auto volume = phantom("gyroid", 32);
  const volume::Grid& grid = volume->grid();
  scene::Scene scene;
  scene.surfaces.front().value = 0.3;
  scene.derivatives.scale = 1.0;
  scene.derivatives.normalScale = 0.0;
  scene.derivatives.noise = 0.1;
  images(volume, scene, kScaledDerivativesSize);
  const render::AovImage hit = renderer_->readAov(Aov::hit), voxel = renderer_->readAov(Aov::voxel),
                         confidence = renderer_->readAov(Aov::curvature_confidence);
  base::Progress progress;
  const auto field = volume->cubicFields->make(scene.derivatives.field, 1.0, progress);
  const volume::CurvatureScale within =
      volume::curvatureScale(grid.geometry(), scene.derivatives.field, 0.1,
                             volume->derivativeChoices->noise(progress).correlation, 1.0);
  int middling = 0, border = 0;
  for (std::size_t i = 0; i < hit.values.size(); ++i) {
    if (hit.values[i] != 1.0f) continue;
    const glm::dvec3 p = at(voxel, i);
    const volume::FieldSample sample = volume::sampleScaled(*field, grid, p);
    const glm::dvec3 g = volume::worldGradient(grid.geometry(), sample.gradient);
    const double more = test::noiseAtBorder(p, grid.dims(), volume::deviationsInVoxels(grid.geometry(), 1.0));
    volume::CurvatureScale scale = within;
    scale.hessianNoise *= more;
    const double expected = volume::curvatureConfidence(
        volume::principalCurvature(g, volume::worldHessian(grid.geometry(), sample.hessian)), g, scale);
    EXPECT_NEAR(confidence.values[i], expected, 2e-3) << p.x << ' ' << p.y << ' ' << p.z;
    middling += expected > 0.2 && expected < 0.8;
    border += more > 1.5;
  }
  EXPECT_GT(middling, 40);
  EXPECT_GT(border, 50);
}

TEST_P(ScaledDerivativesGlTest, ALargeConstantInTheValuesCostsNothing) {
  const auto reference = phantom("torus", 48);
  std::vector<float> shifted;
  for (const float v : std::get<std::vector<float>>(reference->grid().voxels()))
    shifted.push_back(1e6f + 100.0f * v);
  const auto volume = prepared(volume::Grid(reference->grid().geometry(), shifted));
  scene::Scene scene;
  scene.surfaces.front().value = 1e6;
  scene.derivatives.scale = 1.0 * reference->grid().geometry().spacingMm().x;
  scene.derivatives.normalScale = 0.7 * reference->grid().geometry().spacingMm().x;
  const Worst worst = against(volume, scene);
  ASSERT_GT(worst.count, 500);
  EXPECT_LT(worst.gradient, 2e-4);
  EXPECT_LT(worst.hessian, 1e-3);
  EXPECT_LT(worst.normal, 2e-4);
}

// One scale for both: the Hessian's pass writes the gradients of normals, too, and nothing else is drawn.
TEST_P(ScaledDerivativesGlTest, EqualScalesShareAPass) {
  const auto volume = phantom("head", 48);
  scene::Scene scene;
  scene.look.mode = scene::LookMode::kappa1;
  scene.look.shading = scene::Shading::lambert;
  const auto ran = [&](double scale, double normalScale) {
    scene.derivatives.scale = scale;
    scene.derivatives.normalScale = normalScale;
    scene_ = scene::resolve(scene, volume->facts);
    renderer_->setVolume(volume);
    std::string names;
    for (const render::PassReport& pass : renderer_->render(scene_, picture()).passes)
      if (pass.state == render::PassState::ran && (pass.name == "gradient" || pass.name == "hessian"))
        names += pass.name + " ";
    return names;
  };
  EXPECT_EQ(ran(1.0, 1.0), "hessian ");
  EXPECT_EQ(ran(1.0, 0.0), "gradient ");
  EXPECT_EQ(ran(1.5, 0.0), "hessian ");
  EXPECT_EQ(ran(1.5, 1.5), "");
  EXPECT_EQ(ran(0.0, 0.0), "hessian ");
}

// Pictures that come after others are those of a renderer without memory.
TEST_P(ScaledDerivativesGlTest, NoPictureShowsNormalsOfTheOneBefore) {
  const auto volume = phantom("head", 48);
  scene::Scene scene;
  scene.look.shading = scene::Shading::lambert;
  scene.look.shadow = 0.5;
  const auto draw = [&](render::Renderer& renderer) {
    scene_ = scene::resolve(scene, volume->facts);
    renderer.setVolume(volume);
    renderer.setHostSettings(host_);
    renderer.render(scene_, picture());
    return renderer.readColor().rgba;
  };
  const std::pair<double, double> scales[] = {{2.0, 0.0}, {2.0, 2.0}, {2.0, 0.0}, {0.0, 0.0},
                                              {2.0, 3.0}, {3.0, 3.0}, {2.0, 3.0}, {2.0, 0.0}};
  for (const auto mode : {scene::LookMode::kappa1, scene::LookMode::lambert, scene::LookMode::kappa1})
    for (const auto& [scale, normalScale] : scales) {
      scene.look.mode = mode;
      scene.derivatives.scale = scale;
      scene.derivatives.normalScale = normalScale;
      render::Renderer fresh(context_->gl());
      EXPECT_EQ(draw(*renderer_), draw(fresh)) << scale << ", " << normalScale;
    }
}

ISOLUX_ON_BOTH_EXECUTORS(ScaledDerivativesGlTest);

}  // namespace
}  // namespace isolux::test
