// Several isosurfaces and transparency: every crossing of a ray, in order.
#include <cmath>

#include "base/color.h"
#include "tests/render/gl_fixture.h"
#include "tests/support/surfaces.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {
namespace {

class LayersGlTest : public ExecutorsGlTest {
 protected:
  // Linear-light colour of a pixel of the picture of `scene` over a black background.
  glm::dvec3 colorAt(const std::shared_ptr<const volume::PreparedVolume>& volume, scene::Scene scene,
                     glm::ivec2 pixel) {
    scene.look.backgroundTop = scene.look.backgroundBottom = glm::dvec3(0.0);
    scene.look.mode = scene::LookMode::lambert;
    scene.look.ambient = 1.0;  // nothing but the albedo
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = {96, 96};
    report_ = renderer_->render(scene::resolve(pinned(scene), volume->facts), request);
    const render::ColorImage image = renderer_->readColor();
    glm::dvec3 color;
    for (int c = 0; c < 3; ++c) {
      const double v = image.rgba[static_cast<std::size_t>((pixel.y * 96 + pixel.x) * 4 + c)] / 255.0;
      color[c] = base::decodeSrgb(v);
    }
    return color;
  }
};

// The ball's field rises toward its centre: a ray through the middle meets the outer surface, the inner one,
// and both again on the way out.
TEST_P(LayersGlTest, EveryCrossingCountsOnceAndInOrder) {
  const auto ball = phantom("ball", 64);
  const double middle = 0.5 * (ball->facts.suggestedIsovalue + ball->grid().maximum());
  scene::Scene scene;
  scene.surfaces.front().albedo = {1.0, 0.0, 0.0};
  scene.surfaces.front().opacity = 0.25;
  test::surfaceAt(scene, 1).value = middle;
  test::surfaceAt(scene, 1).albedo = {0.0, 1.0, 0.0};
  for (const auto method : {scene::HitMethod::exact, scene::HitMethod::sampled})
    for (const auto field : {scene::Field::trilinear, scene::Field::cubic}) {
      scene.hit.method = method;
      scene.hit.field = field;
      SCOPED_TRACE(static_cast<int>(method) * 10 + static_cast<int>(field));
      test::surfaceAt(scene, 1).shown = false;
      glm::dvec3 seen = colorAt(ball, scene, {48, 48});
      EXPECT_NEAR(seen.x, 0.25 + 0.75 * 0.25, 0.01);  // in and out of the outer surface
      EXPECT_NEAR(seen.y, 0.0, 0.01);

      test::surfaceAt(scene, 1).shown = true;
      test::surfaceAt(scene, 1).opacity = 0.5;
      seen = colorAt(ball, scene, {48, 48});  // outer, inner, inner, outer
      EXPECT_NEAR(seen.x, 0.25 + 0.75 * 0.25 * 0.25, 0.01);
      EXPECT_NEAR(seen.y, 0.75 * (0.5 + 0.5 * 0.5), 0.01);

      test::surfaceAt(scene, 1).opacity = 1.0;
      seen = colorAt(ball, scene, {48, 48});  // what is opaque ends the ray
      EXPECT_NEAR(seen.x, 0.25, 0.01);
      EXPECT_NEAR(seen.y, 0.75, 0.01);
    }
}

// A ball of radius R under parallel rays: |n·v| = sqrt(1 - (r/R)^2) at the distance r from the middle of its
// disc, and the first crossing alone shows scene/opacity.h's formula.
TEST_P(LayersGlTest, OpacityFollowsTheAngle) {
  constexpr int size = 48;
  constexpr double radius = 18.0, middle = 0.5 * (size - 1), distance = 100.0;
  std::vector<float> values;
  for (int z = 0; z < size; ++z)
    for (int y = 0; y < size; ++y)
      for (int x = 0; x < size; ++x)
        values.push_back(static_cast<float>(radius - glm::length(glm::dvec3(x, y, z) - middle)));
  const auto ball = prepared(
      volume::Grid(volume::GridGeometry::make(glm::ivec3(size), glm::dvec3(1.0)), std::move(values)));
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  scene.surfaces.front().albedo = glm::dvec3(1.0);
  scene.surfaces.front().opacity = 0.8;
  scene.surfaces.front().facingOpacity = 0.25;
  scene.isosurface.layers = 1;
  scene.camera.projection = scene::Projection::orthographic;
  scene.camera.target = glm::dvec3(middle);
  scene.camera.eye = glm::dvec3(middle, middle - distance, middle);
  scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
  const double pixelMm = 2.0 * distance * std::tan(glm::radians(0.5 * scene.camera.fov)) / 96.0;
  colorAt(ball, scene, {0, 0});
  const render::ColorImage image = renderer_->readColor();
  for (const glm::ivec2& pixel :
       {glm::ivec2(48, 48), {60, 48}, {48, 66}, {70, 40}, {30, 30}, {74, 58}, {20, 50}}) {
    const double r = pixelMm * glm::length(glm::dvec2(pixel) + 0.5 - 48.0);
    ASSERT_LT(r, 0.97 * radius);
    const double c = std::sqrt(1.0 - r * r / (radius * radius));
    const double expected = 0.8 * (0.25 + 0.75 * (1.0 - c) * (1.0 - c));
    const double seen =
        base::decodeSrgb(image.rgba[static_cast<std::size_t>((pixel.y * 96 + pixel.x) * 4)] / 255.0);
    EXPECT_NEAR(seen, expected, 0.01) << pixel.x << ' ' << pixel.y;
  }
}

TEST_P(LayersGlTest, TheNumberOfLayersIsRespected) {
  const auto ball = phantom("ball", 64);
  scene::Scene scene;
  scene.surfaces.front().albedo = {1.0, 1.0, 1.0};
  scene.surfaces.front().opacity = 0.25;
  scene.isosurface.layers = 1;
  EXPECT_NEAR(colorAt(ball, scene, {48, 48}).x, 0.25, 0.01);
}

// A noisy field has many crossings on a ray, close to each other: the opacity behind n of them is 1 - (1 -
// a)^n, n from the double-precision intersector.
TEST_P(LayersGlTest, CountsTheCrossingsOfNoise) {
  const auto noise = phantom("noise", 32);
  scene::Scene scene;
  scene.surfaces.front().albedo = {1.0, 1.0, 1.0};
  scene.surfaces.front().opacity = 0.04;
  scene.isosurface.layers = 64;
  int compared = 0, wrong = 0;
  colorAt(noise, scene, {0, 0});
  scene_ = scene::resolve(pinned(scene), noise->facts);
  const render::ColorImage image = renderer_->readColor();
  const glm::dmat4 voxelFromWorld = noise->grid().geometry().voxelFromWorld();
  for (int y = 3; y < 96; y += 6)
    for (int x = 3; x < 96; x += 6) {
      const scene::Ray ray = this->ray({x, y}, {96, 96});
      const glm::dvec3 origin(voxelFromWorld * glm::dvec4(ray.origin, 1.0)),
          direction(glm::dmat3(voxelFromWorld) * ray.direction);
      int crossings = 0;
      double t = 0.0;
      while (crossings < 64) {
        const auto hit = volume::firstHit(noise->grid(), *noise->blocks, *scene_.surfaces.front().value,
                                          {origin, direction, t});
        if (!hit) break;
        ++crossings;
        t = hit->t + 1e-6;
      }
      const double alpha = 1.0 - std::pow(0.96, crossings);
      const double v = image.rgba[static_cast<std::size_t>((y * 96 + x) * 4)] / 255.0;
      const double seen = base::decodeSrgb(v);
      const double counted = std::log(1.0 - std::min(seen, 0.999)) / std::log(0.96);
      ++compared;
      if (std::abs(counted - crossings) > 0.5 && std::abs(seen - alpha) > 0.02) ++wrong;
    }
  EXPECT_GE(compared, 200);
  EXPECT_EQ(wrong, 0);
}

ISOLUX_ON_BOTH_EXECUTORS(LayersGlTest);

}  // namespace
}  // namespace isolux::test
