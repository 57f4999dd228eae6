// Ridges and valleys of a noisy head against those of the same head without noise.
#include <vector>

#include "base/progress.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/passes/line_points.h"
#include "volume/phantom/phantom.h"

namespace isolux::test {
namespace {

struct LinePoints {
  std::vector<glm::dvec3> ridges, valleys;  // surface points that lines cover by half, mm
};

class NoisyLinesGlTest : public RenderGlTest {
 protected:
  // The skull of a head of `voxels` per axis, with lines in red and blue on black.
  LinePoints linesOf(int voxels, double noise, const std::vector<std::string>& settings) {
    base::Progress progress;
    volume::PhantomRequest phantom;
    phantom.size = voxels;
    phantom.noise = noise;
    const auto volume = prepared(volume::makePhantom(phantom, progress));
    spacing_ = volume->grid().geometry().spacingMm().x;
    const scene::Scene scene =
        assigned({"isosurface.value=300", "look.mode=lambert", "look.ambient=1", "isosurface.albedo=0,0,0",
                  "look.ridges=1", "look.ridge_color=1,0,0", "look.valley_color=0,0,1",
                  "camera.eye=120,-620,130", "camera.target=0,0,20", "camera.up=0,0,1", "camera.fov=22"});
    scene_ = scene::resolve(assigned(settings, scene), volume->facts);
    volume->derivativeChoices->complete(scene_, progress);
    completedScale_ = scene_.derivatives.scale.value();
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = {384, 384};
    request.aovs = {render::Aov::hit, render::Aov::position};
    renderer_->render(scene_, request);
    const render::LinearImage color = renderer_->readLinear();
    const render::AovImage hit = renderer_->readAov(render::Aov::hit);
    const render::AovImage position = renderer_->readAov(render::Aov::position);
    LinePoints points;
    for (std::size_t i = 0; i < hit.values.size(); ++i) {
      if (hit.values[i] != 1.0f) continue;
      if (color.rgba[4 * i] >= 0.5f) points.ridges.push_back(at(position, i));
      if (color.rgba[4 * i + 2] >= 0.5f) points.valleys.push_back(at(position, i));
    }
    return points;
  }

  static constexpr int kVoxels = 128;
  double spacing_ = 1.0, completedScale_ = 0.0;
};

}  // namespace

TEST_F(NoisyLinesGlTest, AreThoseOfTheCleanHead) {
  const LinePoints clean = linesOf(kVoxels, 0.0, {});
  ASSERT_GT(clean.ridges.size(), 300u);
  ASSERT_GT(clean.valleys.size(), 300u);
  const LinePoints noisy = linesOf(kVoxels, 40.0, {});  // HU
  const double reach = 1.5 * spacing_;
  EXPECT_GT(shareNear(noisy.ridges, clean.ridges, reach), 0.8) << "precision";
  EXPECT_GT(shareNear(clean.ridges, noisy.ridges, reach), 0.8) << "recall";
  EXPECT_GT(shareNear(noisy.valleys, clean.valleys, reach), 0.8) << "precision";
  EXPECT_GT(shareNear(clean.valleys, noisy.valleys, reach), 0.8) << "recall";
}

// 5 % of the contrast; the automatic scale is a voxel, which weak lines do not survive.
TEST_F(NoisyLinesGlTest, AtAScaleHoldFewThatAreNone) {
  const LinePoints clean = linesOf(kVoxels, 0.0, {});
  const LinePoints noisy = linesOf(kVoxels, 50.0, {});
  ASSERT_GT(completedScale_, 0.0);
  const double reach = 1.5 * spacing_;
  EXPECT_GT(shareNear(noisy.ridges, clean.ridges, reach), 0.85) << "precision";
  EXPECT_GT(shareNear(clean.ridges, noisy.ridges, reach), 0.7) << "recall";
  EXPECT_GT(shareNear(noisy.valleys, clean.valleys, reach), 0.85) << "precision";
  EXPECT_GT(shareNear(clean.valleys, noisy.valleys, reach), 0.7) << "recall";
}

}  // namespace isolux::test
