// Light of inner sides in pictures: lattices that are formulas, and a ball that the volume's border cuts
// open, whose two sides have closed forms.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "app/light/light_controller.h"
#include "gi/reference/reference.h"
#include "scene/opacity.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/light/light_support.h"
#include "tests/support/cut_ball.h"
#include "tests/support/volumes.h"

namespace isolux::test {
namespace {

constexpr double kPi = std::numbers::pi;

using Settings = std::vector<std::string>;

class InnerLightGlTest : public RenderGlTest {
 protected:
  void use(const Settings& settings) {
    scene::Scene scene;
    scene.look.mode = scene::LookMode::gi;
    scene.surfaces.front().value = ball_.isovalue;
    scene.light.environment.constant = glm::dvec3(1.0);
    scene.picture.exposure = 0.0;
    // Into the opening from above: the wall within, the rim, and the outer side around it.
    scene.camera.eye = ball_.middle + glm::dvec3(3.0, -2.0, 60.0);
    scene.camera.target = ball_.middle;
    scene.camera.up = glm::dvec3(0.0, 1.0, 0.0);
    scene_ = scene::resolve(assigned(settings, scene), volume_->facts);
  }
  void draw(std::shared_ptr<const gi::PictureLight> light) {
    renderer_->setVolume(volume_);
    renderer_->setLight(std::move(light));
    renderer_->render(scene_, request());
    hit_ = renderer_->readAov(render::Aov::hit);
    voxel_ = renderer_->readAov(render::Aov::voxel);
    irradiance_ = renderer_->readAov(render::Aov::irradiance);
  }
  static render::FrameRequest request() {
    render::FrameRequest request;
    request.size = {128, 128};
    request.aovs = {render::Aov::hit, render::Aov::voxel, render::Aov::irradiance};
    return request;
  }
  // From this eye the inner side is what lies below the rim's cone; by the ray's way through the ball.
  bool isInner(std::size_t pixel) const {
    const glm::dvec3 eye = *scene_.camera.eye, hit = at(voxel_, pixel);
    return glm::dot(hit - ball_.middle, hit - eye) > 0.0;  // the ray leaves the ball here
  }
  // each(inner, E) for all hits; how many of either side.
  template <class Each>
  std::pair<int, int> forEachHit(const Each& each) const {
    std::pair<int, int> seen{0, 0};
    for (std::size_t i = 0; i < hit_.values.size(); ++i) {
      if (hit_.values[i] == 0.0f) continue;
      ++(isInner(i) ? seen.second : seen.first);
      each(isInner(i), at(irradiance_, i));
    }
    return seen;
  }
  void expectLight(double outer, double inner) {
    const auto seen = forEachHit([&](bool isInner, glm::dvec3 e) {
      EXPECT_NEAR(e.x, isInner ? inner : outer, 1e-3 * (isInner ? inner : outer) + 1e-6);
    });
    EXPECT_GT(seen.first, 300);
    EXPECT_GT(seen.second, 1500);
  }
  std::shared_ptr<gi::LightLattice> latticeOf(float e, std::optional<float> isovalue = std::nullopt) const {
    auto lattice = std::make_shared<gi::LightLattice>(gi::LatticeGeometry::make(ball_.dims, 1.0, isovalue),
                                                      gi::LightContent{}, "test");
    fill(*lattice, e);
    return lattice;
  }
  static void fill(gi::LightLattice& lattice, float e) {
    writeAll(lattice, [e](glm::ivec3) { return TexelLight{100, {0.0f, 0.0f, 1.0f}, {e, e, e}}; });
  }
  // Local light: E = 1 whatever the normal.
  static std::shared_ptr<gi::PictureLight> lightOf(std::shared_ptr<const gi::LightLattice> outer,
                                                   std::shared_ptr<const gi::LightLattice> inner) {
    static std::uint64_t version = 0;
    auto light = pictureLight(std::move(outer), ++version);
    light->irradianceSh[0] = glm::vec3(1.0f / 0.2820948f);
    light->inner.sky = std::move(inner);
    return light;
  }
  // Bakes what the view shows.
  std::shared_ptr<const gi::PictureLight> baked() {
    app::LightController controller{{}};
    controller.setScene(scene_, volume_);
    renderer_->setVolume(volume_);
    renderer_->render(scene_, request());
    controller.setVisible(renderer_->hitVoxels());
    base::Progress progress;
    EXPECT_TRUE(controller.finish(progress, 240.0));
    return controller.light();
  }

  CutBall ball_;
  std::shared_ptr<const volume::PreparedVolume> volume_ = ball_.volume();
  render::AovImage hit_, voxel_, irradiance_;
};

const Settings kExactLookups = {"gi.interpolation=trilinear", "gi.precision=half"};

// The inner side's light comes, goes and is replaced while the outer side's stays.
TEST_F(InnerLightGlTest, EachSideHasItsOwn) {
  for (const char* interpolation : {"closest_isovalue", "nearest", "trilinear", "tricubic", "weighted"}) {
    SCOPED_TRACE(interpolation);
    use({std::string("gi.interpolation=") + interpolation, "gi.precision=half"});
    const auto outer = latticeOf(2.0f), inner = latticeOf(3.0f);
    draw(lightOf(outer, nullptr));
    expectLight(2.0, 1.0);
    draw(lightOf(outer, inner));
    expectLight(2.0, 3.0);
    fill(*inner, 5.0f);
    draw(lightOf(outer, inner));
    expectLight(2.0, 5.0);
    draw(lightOf(outer, latticeOf(7.0f)));  // nothing stands in
    expectLight(2.0, 7.0);
    draw(lightOf(outer, nullptr));
    expectLight(2.0, 1.0);
    draw(lightOf(outer, inner));
    expectLight(2.0, 5.0);
    draw(lightOf(latticeOf(4.0f), inner));
    expectLight(4.0, 5.0);
  }
}

// Each keeps that of the isovalue before until there is its own.
TEST_F(InnerLightGlTest, LightOfTheIsovalueBeforeStandsInOnBothSides) {
  use(kExactLookups);
  const auto outerWas = latticeOf(2.0f, 0.5f), innerWas = latticeOf(3.0f, 0.5f);
  draw(lightOf(outerWas, innerWas));
  expectLight(2.0, 3.0);
  const auto empty = [&] {
    return std::make_shared<gi::LightLattice>(gi::LatticeGeometry::make(ball_.dims, 1.0, 0.0f),
                                              gi::LightContent{}, "test");
  };
  const auto outer = empty(), inner = empty();
  const auto light = lightOf(outer, inner);
  light->skyBefore = outerWas;
  light->inner.skyBefore = innerWas;
  draw(light);
  expectLight(2.0, 3.0);
  fill(*inner, 5.0f);
  draw(light);
  expectLight(2.0, 5.0);
  draw(lightOf(outer, empty()));  // another, and no light yet
  expectLight(1.0, 1.0);
}

// A transparent surface shows its own shadow in part: the rest is local light, on the inner side as much as
// comes through.
TEST_F(InnerLightGlTest, TransparentSurfacesShowTheirShadowInPart) {
  use(kExactLookups);
  scene_.surfaces.front().albedo = glm::dvec3(0.6);
  scene_.clip = {};
  for (const double opacity : {0.1, 0.5, 0.75, 1.0}) {
    scene_.surfaces.front().opacity = opacity;
    const double mean = scene::meanOpacity(opacity, 1.0),
                 shown = opacity < 1.0 ? std::max(2.0 * mean - 1.0, 0.0) : 1.0;
    draw(lightOf(latticeOf(2.0f), latticeOf(3.0f)));
    const double through = opacity < 1.0 ? (1.0 - mean) / (1.0 - 0.6 * mean) : 1.0;
    expectLight(1.0 + shown, (1.0 - shown) * through + shown * 3.0);
  }
}

// Bit for bit, and in the same bytes.
TEST_F(InnerLightGlTest, WhereNoInnerSideIsSeenNothingIsStoredOfAny) {
  use({"camera.eye=18,-60,16", "camera.up=0,0,1"});
  const auto light = baked();
  ASSERT_TRUE(light && light->sky && light->sky->bakedTexels() > 0);
  EXPECT_EQ(light->inner, gi::StoredSide());
  draw(light);
  const std::size_t bytes = renderer_->render(scene_, request()).light.bytes;
  const auto seen = forEachHit([](bool inner, glm::dvec3) { EXPECT_FALSE(inner); });
  EXPECT_GT(seen.first, 1000);
  const render::ColorImage without = renderer_->readColor();
  auto with = std::make_shared<gi::PictureLight>(*light);
  const auto dark = std::make_shared<gi::LightLattice>(light->sky->geometry(), light->sky->content(), "test");
  with->inner.sky = dark;
  ++with->version;
  draw(with);
  EXPECT_EQ(renderer_->readColor().rgba, without.rgba);
  EXPECT_GT(renderer_->render(scene_, request()).light.bytes, bytes) << "its pages";
}

// Both sides of a gyroid against paths traced at the pixels' own hits: the inner side errs no more than the
// outer one.
TEST_F(InnerLightGlTest, TheErrorIsThatOfTheOuterSide) {
  volume_ = phantom("gyroid", 48);
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  scene.light.environment.constant = glm::dvec3(1.0);
  scene_ = scene::resolve(scene, volume_->facts);
  draw(baked());
  base::Progress progress;
  const auto tracer = std::make_shared<const volume::IsosurfaceTracer>(volume_->volume.grid,
                                                                       scene_.isosurface.inside, progress);
  gi::Reference reference(volume_, tracer, gi::loadEnvironment(scene_.light.environment), scene_,
                          {request().size, 2}, progress);
  ASSERT_TRUE(reference.refineTo(512, progress));
  const gi::ReferenceImage truth = reference.image();
  const gi::PrimaryHits hits(volume_, scene_, request().size, progress);
  double squares[2] = {}, sum[2] = {}, count[2] = {};
  for (std::size_t i = 0; i < truth.hit.size(); ++i) {
    const auto hit = hits.at({static_cast<int>(i) % 128, static_cast<int>(i) / 128});
    if (!hit || hit_.values[i] == 0.0f) continue;
    const std::size_t side = hit->outer ? 0 : 1;
    const double e = truth.irradiance[i].x, off = at(irradiance_, i).x - e;
    squares[side] += off * off;
    sum[side] += e;
    ++count[side];
  }
  double rms[2];
  for (const std::size_t side : {0u, 1u}) {
    ASSERT_GT(count[side], 1000.0);
    rms[side] = std::sqrt(squares[side] / count[side]) / (sum[side] / count[side]);
  }
  // Measured: 3.6 % and 3.4 %, with 100 paths a texel.
  EXPECT_LT(rms[1], 0.05);
  EXPECT_LT(rms[1], 1.25 * rms[0]);
}

struct InnerCase {
  const char* name;
  Settings settings;
};

class BakedInnerLightGlTest : public InnerLightGlTest, public ::testing::WithParamInterface<InnerCase> {};

// At every pixel, up to the rim, where the sides lie a texel apart: light of one must not be seen on the
// other. The inner side has a quarter of the outer's light, and what bounces.
TEST_P(BakedInnerLightGlTest, BothSidesOfACutBallHaveTheirClosedForms) {
  Settings settings = {"gi.samples=1024", "isosurface.albedo=0.6,0.6,0.6"};
  settings.insert(settings.end(), GetParam().settings.begin(), GetParam().settings.end());
  use(settings);
  volume_ = ball_.volume(scene_.isosurface.inside == scene::Inside::above ? 1.0 : -1.0);
  const auto light = baked();
  ASSERT_TRUE(light && light->inner.sky);
  draw(light);
  const double expected[2] = {kPi, ball_.innerIrradiance(0.6, scene_.gi.bounces)};
  double least[2] = {1e9, 1e9}, most[2] = {}, sum[2] = {};
  const auto seen = forEachHit([&](bool inner, glm::dvec3 e) {
    const auto side = static_cast<std::size_t>(inner);
    least[side] = std::min(least[side], e.x);
    most[side] = std::max(most[side], e.x);
    sum[side] += e.x;
  });
  ASSERT_GT(seen.first, 300);
  ASSERT_GT(seen.second, 1500);
  for (const std::size_t side : {0u, 1u}) {
    SCOPED_TRACE(side);
    EXPECT_NEAR(sum[side] / (side == 0 ? seen.first : seen.second) / expected[side], 1.0, 0.02);
    EXPECT_GT(least[side] / expected[side], 0.9);
    EXPECT_LT(most[side] / expected[side], 1.1);
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, BakedInnerLightGlTest,
                         ::testing::Values(InnerCase{"shader", {"picture.executor=gpu"}},
                                           InnerCase{"processor", {"picture.executor=cpu"}},
                                           InnerCase{"below", {"isosurface.inside=below"}},
                                           InnerCase{"trilinear", {"gi.interpolation=trilinear"}},
                                           InnerCase{"bounces", {"gi.bounces=3"}},
                                           InnerCase{"noBounces", {"gi.bounces=0"}},
                                           InnerCase{"fine", {"gi.lattice_scale=2", "gi.samples=256"}},
                                           InnerCase{"transfer", {"gi.mode=transfer"}}),
                         [](const auto& way) { return std::string(way.param.name); });

}  // namespace
}  // namespace isolux::test
