// What looks show, against formulas: colours at known normals, curvatures and depths; where shadows fall; how
// wide lines are; which way streaks run.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "scene/color_maps.h"
#include "scene/looks.h"
#include "scene/settings/settings.h"
#include "tests/render/gl_fixture.h"

namespace isolux::test {
namespace {

using scene::LookMode;

class LooksGlTest : public RenderGlTest {
 protected:
  using Settings = std::vector<std::string>;

  // Draws and keeps what pixels show. Orthographic along +y (patient axes: from the front), `mmPerPixel`.
  void draw(const std::shared_ptr<const volume::PreparedVolume>& volume, const Settings& settings,
            double mmPerPixel = 0.5, glm::ivec2 size = {128, 128}) {
    scene::Scene scene = pinned({});
    scene.surfaces.front().value = 0.0;
    scene.camera.projection = scene::Projection::orthographic;
    const glm::dvec3 centre = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
    scene.camera.target = centre;
    scene.camera.eye = centre - glm::dvec3(0.0, 400.0, 0.0);
    scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);  // settings may look from elsewhere
    scene.camera.fov = 2.0 * std::atan(0.5 * size.y * mmPerPixel / 400.0) * 180.0 / std::numbers::pi;
    for (const std::string& setting : settings) scene::applyAssignment(scene, setting);
    scene_ = scene::resolve(scene, volume->facts);
    renderer_->setVolume(volume);
    render::FrameRequest request;
    request.size = size;
    request.aovs = {render::Aov::hit, render::Aov::normal, render::Aov::position, render::Aov::depth};
    request.aovs.insert(request.aovs.end(), more_.begin(), more_.end());
    report_ = renderer_->render(scene_, request);
    linear_ = renderer_->readLinear();
    hit_ = renderer_->readAov(render::Aov::hit);
    normal_ = renderer_->readAov(render::Aov::normal);
    position_ = renderer_->readAov(render::Aov::position);
    centre_ = centre;
  }
  glm::dvec3 color(std::size_t i) const {
    return {linear_.rgba[4 * i], linear_.rgba[4 * i + 1], linear_.rgba[4 * i + 2]};
  }
  double grey(std::size_t i) const { return color(i).y; }
  bool hit(std::size_t i) const { return hit_.values[i] == 1.0f; }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(linear_.size.x) +
           static_cast<std::size_t>(x);
  }
  std::size_t pixels() const { return hit_.values.size(); }
  // Applies `expected(normal, position)` to every hit and compares colours.
  template <class Expected>
  void expectColors(Expected expected, double tolerance) {
    std::size_t compared = 0;
    double worst = 0.0;
    for (std::size_t i = 0; i < pixels(); ++i) {
      if (!hit(i)) continue;
      const glm::dvec3 off =
          glm::abs(color(i) - expected(RenderGlTest::at(normal_, i), RenderGlTest::at(position_, i)));
      worst = std::max({worst, off.x, off.y, off.z});
      ++compared;
    }
    EXPECT_GT(compared, 1000u);
    EXPECT_LT(worst, tolerance);
  }

  std::vector<render::Aov> more_;  // images to read
  render::LinearImage linear_;
  render::AovImage hit_, normal_, position_;
  glm::dvec3 centre_{0.0};
};

// Shortest edge of a phantom, which its shape scales with, mm.
double edgeOf(const volume::PreparedVolume& volume) {
  const volume::GridGeometry& geometry = volume.grid().geometry();
  const glm::dvec3 extent = geometry.spacingMm() * glm::dvec3(geometry.dims - 1);
  return std::min({extent.x, extent.y, extent.z});
}

const glm::dvec3 kAlbedo(0.8, 0.5, 0.2);
const std::vector<std::string> kWorldLight = {"isosurface.albedo=0.8,0.5,0.2", "light.space=world",
                                              "light.direction=1,-2,2", "light.color=1,0.8,0.5",
                                              "light.intensity=0.9"};
const glm::dvec3 kToLight = glm::dvec3(1.0, -2.0, 2.0) / 3.0, kToEye(0.0, -1.0, 0.0);
const glm::dvec3 kLightColor = glm::dvec3(1.0, 0.8, 0.5) * 0.9;
constexpr double kHalfStepNearOne = 2e-3;  // half floats near 1

std::vector<std::string> withMore(std::vector<std::string> settings, const std::vector<std::string>& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

TEST_F(LooksGlTest, LambertIsItsFormula) {
  draw(phantom("ball", 48), withMore(kWorldLight, {"look.mode=lambert", "look.ambient=0.2",
                                                   "look.ambient_variation=0.5", "light.headlight=0.3"}));
  expectColors(
      [](const glm::dvec3& n, const glm::dvec3&) {
        const double ambient = 0.2 * (1.0 + 0.5 * n.z);  // the picture's up is +z
        return kAlbedo * (ambient + 0.8 * (kLightColor * std::max(glm::dot(n, kToLight), 0.0) +
                                           0.3 * std::max(glm::dot(n, kToEye), 0.0)));
      },
      kHalfStepNearOne);
}

TEST_F(LooksGlTest, BlinnPhongIsItsFormula) {
  draw(phantom("ball", 48),
       withMore(kWorldLight, {"look.specular=0.4", "look.shininess=20", "light.headlight=0.2"}));
  const glm::dvec3 halfway = glm::normalize(kToLight + kToEye);
  expectColors(
      [&](const glm::dvec3& n, const glm::dvec3&) {
        const double facing = glm::dot(n, kToLight), eye = std::max(glm::dot(n, kToEye), 0.0);
        const glm::dvec3 diffuse = kLightColor * std::max(facing, 0.0) + 0.2 * eye;
        const double key = facing > 0.0 ? std::pow(std::max(glm::dot(n, halfway), 0.0), 20.0) : 0.0;
        return kAlbedo * (0.12 + 0.88 * diffuse) + 0.4 * (kLightColor * key + 0.2 * std::pow(eye, 20.0));
      },
      kHalfStepNearOne);
}

TEST_F(LooksGlTest, ToneGoesFromCoolToWarm) {
  draw(phantom("ball", 48),
       withMore(kWorldLight, {"look.mode=tone", "look.contours=0", "look.tone_cool=0.1,0.2,0.6",
                              "look.tone_warm=0.9,0.6,0.1"}));
  const glm::dvec3 cool = glm::mix(glm::dvec3(0.1, 0.2, 0.6), kAlbedo, 0.1);
  const glm::dvec3 warm = glm::mix(glm::dvec3(0.9, 0.6, 0.1), kAlbedo, 0.4);
  expectColors(
      [&](const glm::dvec3& n, const glm::dvec3&) {
        const double warmth = 0.5 + 0.5 * glm::dot(n, kToLight);
        return glm::mix(cool, warm, warmth * warmth * warmth);
      },
      kHalfStepNearOne);
}

TEST_F(LooksGlTest, ACameraLightTurnsWithTheCamera) {
  const auto ball = phantom("ball", 48);
  draw(ball, {"look.mode=lambert", "light.direction=1,0,1"});
  const double first = grey(at(80, 64));
  draw(ball,
       {"look.mode=lambert", "light.direction=1,0,1", "camera.up=0,0,-1"});  // upside down: the same view
  EXPECT_NEAR(grey(at(80, 64)), first, 0.01);
  draw(ball, {"look.mode=lambert", "light.space=world", "light.direction=1,-1,0"});
  const double fixed = grey(at(80, 64));
  draw(ball, {"look.mode=lambert", "light.space=world", "light.direction=1,-1,0", "camera.up=0,0,-1"});
  EXPECT_GT(std::fabs(grey(at(80, 64)) - fixed), 0.1);
}

TEST_F(LooksGlTest, ALightOfNoDirectionShinesAlongTheView) {
  const auto ball = phantom("ball", 48);
  draw(ball, {"look.mode=lambert"});
  scene::Scene scene = scene_;
  render::FrameRequest request;
  request.size = {128, 128};
  const auto drawnBy = [&](scene::LightSpace space, const glm::dvec3& direction) {
    scene.light.space = space;
    scene.light.direction = direction;
    renderer_->render(scene, request);
    return renderer_->readLinear().rgba;
  };
  const std::vector<float> fromViewer = drawnBy(scene::LightSpace::camera, {0.0, 0.0, 1.0});
  EXPECT_EQ(drawnBy(scene::LightSpace::camera, glm::dvec3(0.0)), fromViewer);
  EXPECT_EQ(drawnBy(scene::LightSpace::world, glm::dvec3(0.0)), fromViewer);
  EXPECT_NE(drawnBy(scene::LightSpace::camera, {0.0, 1.0, 0.0}), fromViewer);
}

// The ball's field is its distance: kappa1 = kappa2 = 1/R on the surface, and gradients are far above noise.
TEST_F(LooksGlTest, MeasuresOfABallAreTheMapsColors) {
  const auto ball = phantom("ball", 96);
  const double radius = 0.35 * edgeOf(*ball), kappa = 1.0 / radius;
  for (const scene::LookInfo& look : scene::looks()) {
    if (!look.measure) continue;
    SCOPED_TRACE(look.name);
    const double value = look.measure(kappa, kappa);
    const bool unit = look.range == scene::LookRange::unit;
    const double reach = unit ? 1.0 : 2.0 * std::max(std::abs(value), 0.01 * kappa);
    const double low = look.range == scene::LookRange::fromZero ? 0.0 : -reach;
    draw(
        ball,
        {"look.mode=" + std::string(look.name), "look.shading=unlit", "look.range_low=" + std::to_string(low),
         "look.range_high=" + std::to_string(reach), "derivatives.field=cubic_interpolating"},
        1.0);
    const auto map = scene::colorMapSamples(scene::ColorMap::automatic, 256, look.colors);
    const double t = (value - low) / (reach - low) * 255.0;
    const auto i = static_cast<std::size_t>(std::min(t, 254.0));
    const glm::dvec3 expected = glm::mix(glm::dvec3(map[i]), glm::dvec3(map[i + 1]),
                                         glm::clamp(t - static_cast<double>(i), 0.0, 1.0));
    expectColors([&](const glm::dvec3&, const glm::dvec3&) { return expected; }, 0.03);
  }
}

// Quantities go through the user's points, as they stand in the range.
TEST_F(LooksGlTest, AnOwnTransferFunctionColoursTheMeasure) {
  draw(phantom("ball", 48),
       {"look.mode=mean_curvature", "look.shading=unlit", "look.legend=false",
        "derivatives.field=cubic_interpolating", "look.range_low=-10", "look.range_high=-9",
        "look.colormap_points=[[0,1,0,0],[0.5,0,1,0],[1,0.25,0.5,0.75]]"});
  expectColors([](const glm::dvec3&, const glm::dvec3&) { return glm::dvec3(0.25, 0.5, 0.75); }, 1e-3);
}

TEST_F(LooksGlTest, AccessibilityPointsOfTheAutomaticFactorsChangeNothing) {
  const std::vector<std::string> crevices = {"look.mode=accessibility", "derivatives.noise=0"};
  draw(phantom("gyroid", 48), crevices);
  const render::LinearImage automatic = linear_;
  draw(phantom("gyroid", 48),
       withMore(crevices, {"look.accessibility_points=[[0,0.1,0.075,0.06],[1,1,1,1]]"}));
  for (std::size_t i = 0; i < automatic.rgba.size(); ++i)
    ASSERT_NEAR(automatic.rgba[i], linear_.rgba[i], kHalfStepNearOne);
  draw(phantom("gyroid", 48), withMore(crevices, {"look.accessibility_points=[[0,0,1,0],[1,1,1,1]]"}));
  std::size_t green = 0;
  for (std::size_t i = 0; i < pixels(); ++i) green += color(i).y > 1.5 * color(i).x;
  EXPECT_GT(green, 100u);
}

// |e1| of a cylinder: across its axis, along the circle.
TEST_F(LooksGlTest, DirectionsOfCurvatureAreTheirPartsAlongTheAxes) {
  more_ = {render::Aov::direction1, render::Aov::curvature_confidence};
  draw(phantom("cylinder", 64), {"look.mode=curvature_direction", "derivatives.noise=0",
                                 "derivatives.field=cubic_interpolating", "derivatives.scale=0"});
  std::size_t compared = 0;
  const render::AovImage confidence = renderer_->readAov(render::Aov::curvature_confidence),
                         direction = renderer_->readAov(render::Aov::direction1);
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (!hit(i) || confidence.values[i] < 1.0f) continue;
    const glm::dvec3 expected = glm::pow(glm::abs(RenderGlTest::at(direction, i)), glm::dvec3(2.2));
    EXPECT_LT(glm::length(glm::cross(RenderGlTest::at(direction, i), RenderGlTest::at(normal_, i))) - 1.0,
              1e-3);
    EXPECT_LT(glm::distance(color(i), expected), 5e-3);
    ++compared;
  }
  EXPECT_GT(compared, 500u);
}

// The range's upper end is seen nowhere on a ball, whose flowlines are straight.
TEST_F(LooksGlTest, FlowlinesOfABallAreStraight) {
  more_ = {render::Aov::flowline_curvature};
  draw(phantom("ball", 64), {"look.mode=flowline_curvature", "look.shading=unlit", "look.colormap=gray",
                             "look.range_low=0", "look.range_high=1", "derivatives.field=cubic_interpolating",
                             "derivatives.noise=0", "derivatives.scale=0"});
  const render::AovImage flowline = renderer_->readAov(render::Aov::flowline_curvature);
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (!hit(i)) continue;
    EXPECT_LT(flowline.values[i], 2e-3);
  }
}

// Blocks of 8 cells: the colours change at their faces, and nothing is drawn of what there is not.
TEST_F(LooksGlTest, TheOverlayShowsBlocksAndWhatIsMissingIsNotDrawn) {
  const auto ball = phantom("ball", 48);
  draw(ball, {"look.mode=lambert"});
  const render::LinearImage plain = linear_;
  draw(ball, {"look.mode=lambert", "look.overlay=bricks"});
  EXPECT_EQ(linear_.rgba, plain.rgba);
  draw(ball, {"look.mode=lambert", "look.overlay=texels"});
  EXPECT_EQ(linear_.rgba, plain.rgba);
  draw(ball, {"look.mode=lambert", "look.overlay=blocks"});
  const double blockMm = ball->blocks->blockCells() * ball->grid().geometry().spacingMm().x;
  const glm::dvec3 origin(ball->grid().geometry().worldFromVoxel[3]);
  std::size_t edges = 0, inner = 0;
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (!hit(i)) continue;
    const glm::dvec3 place = (RenderGlTest::at(position_, i) - origin) / blockMm;
    const glm::dvec3 off = glm::abs(place - glm::round(place)) * blockMm;
    const double before = plain.rgba[4 * i + 1], now = linear_.rgba[4 * i + 1];
    const double least = std::min({off.x, off.y, off.z});
    if (least < 0.1) edges += now < 0.65 * before;  // dark lines
    if (least > 1.5) {
      ++inner;
      EXPECT_NE(now, before);
    }
  }
  EXPECT_GT(edges, 50u);
  EXPECT_GT(inner, 200u);
}

TEST_F(LooksGlTest, AutomaticRangesAndTheLegendFollowTheSurface) {
  const auto torus = phantom("torus", 64);
  draw(torus, {"look.mode=kappa2", "look.shading=unlit", "camera.eye=0,-250,250"}, 0.6);
  double bluest = 0.0, reddest = 0.0;
  for (std::size_t i = 0; i < pixels(); ++i)
    if (hit(i)) {
      bluest = std::max(bluest, color(i).z - color(i).x);
      reddest = std::max(reddest, color(i).x - color(i).z);
    }
  EXPECT_GT(bluest, 0.3);    // the inside of the ring is hollow
  EXPECT_GT(reddest, 0.05);  // the outside bends away
  const auto picture = renderer_->readColor();
  draw(torus, {"look.mode=kappa2", "look.shading=unlit", "camera.eye=0,-250,250", "look.legend=false"}, 0.6);
  const auto without = renderer_->readColor();
  std::size_t differ = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) differ += picture.rgba[i] != without.rgba[i];
  EXPECT_GT(differ, 500u);
}

TEST_F(LooksGlTest, FogFollowsDepth) {
  const auto ball = phantom("ball", 48);
  const Settings plain = {"look.mode=lambert", "look.ambient=1", "isosurface.albedo=0.5,0.5,0.5"};
  draw(ball, withMore(plain, {"look.fog=0.8", "look.fog_color=0,0,1"}));
  const double near = ball->facts.boundsMinMm.y, far = ball->facts.boundsMaxMm.y;
  expectColors(
      [&](const glm::dvec3&, const glm::dvec3& p) {
        return glm::mix(glm::dvec3(0.5), glm::dvec3(0.0, 0.0, 1.0), 0.8 * (p.y - near) / (far - near));
      },
      kHalfStepNearOne);
  draw(ball, withMore(plain, {"look.fog=1", "look.background_top=0.2,0.4,0.6",
                              "look.background_bottom=0.2,0.4,0.6"}));
  expectColors(
      [&](const glm::dvec3&, const glm::dvec3& p) {
        return glm::mix(glm::dvec3(0.5), glm::dvec3(0.2, 0.4, 0.6), (p.y - near) / (far - near));
      },
      kHalfStepNearOne);
}

// A ball over a wall; light falls along a slant, so the shadow on the wall is the ball's projection: an
// ellipse.
class ShadowsGlTest : public LooksGlTest, public ::testing::WithParamInterface<const char*> {
 protected:
  void SetUp() override {
    LooksGlTest::SetUp();
    scene::applyAssignment(host_, std::string("picture.executor=") + GetParam());
    renderer_->setHostSettings(host_);
  }
};
ISOLUX_ON_BOTH_EXECUTORS(ShadowsGlTest);

TEST_P(ShadowsGlTest, OfABallIsAnEllipse) {
  const glm::ivec3 dims(96, 64, 96);
  const glm::dvec3 centre(40.0, 20.0, 48.0);
  const double radius = 10.0, wall = 50.0;
  std::vector<float> voxels;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        voxels.push_back(static_cast<float>(
            std::max(radius - glm::length(glm::dvec3(x, y, z) - centre), static_cast<double>(y) - wall)));
  const auto volume =
      prepared(volume::Grid(volume::GridGeometry::make(dims, glm::dvec3(1.0)), std::move(voxels)));
  const glm::dvec3 toLight = glm::normalize(glm::dvec3(-0.6, -1.0, 0.2));
  for (const std::string hits : {"exact", "sampled"})
    for (const std::string field : {"trilinear", "cubic"}) {
      if (hits == "sampled" && field == "cubic") continue;  // as exact ones but for where they start
      draw(volume,
           {"look.mode=lambert", "look.ambient=0", "look.shadow=1", "light.space=world", "isosurface.value=0",
            "light.direction=-0.6,-1,0.2", "hit.method=" + hits, "hit.field=" + field},
           0.75);
      SCOPED_TRACE(hits + " " + field);
      std::size_t onWall = 0, wrong = 0, inShadow = 0;
      for (std::size_t i = 0; i < pixels(); ++i) {
        if (!hit(i)) continue;
        const glm::dvec3 p = RenderGlTest::at(position_, i) - (centre_ - 0.5 * glm::dvec3(dims - 1));
        if (p.y < wall - 0.5) {
          // The ball itself: lit all over the side that faces the light, dark on the other; no acne, no
          // leaks.
          const double facing = glm::dot(RenderGlTest::at(normal_, i), toLight);
          if (facing > 0.03) {
            EXPECT_NEAR(grey(i), 0.62 * facing, 0.01) << facing;
          }
          if (facing < 0.0) {
            EXPECT_EQ(grey(i), 0.0);
          }
          continue;
        }
        ++onWall;
        const glm::dvec3 toCentre = centre - p;
        const double miss = glm::length(toCentre - glm::dot(toCentre, toLight) * toLight) - radius;
        const bool dark = grey(i) < 0.01;
        inShadow += dark;
        if (std::fabs(miss) > 0.75 && dark != (miss < 0.0)) ++wrong;  // a pixel's width is between
      }
      EXPECT_GT(onWall, 8000u);
      EXPECT_GT(inShadow, 400u);
      EXPECT_EQ(wrong, 0u);
    }
}

// Mean width over the rows through the middle of the ball's left and right outlines, in pixels.
double silhouetteWidth(const render::LinearImage& image, const render::AovImage& hit) {
  double covered = 0.0;
  int rows = 0;
  const int w = image.size.x, middle = image.size.y / 2;
  for (int y = middle - 5; y <= middle + 5; ++y, ++rows)
    for (int x = 0; x < w; ++x) {
      const auto i = static_cast<std::size_t>(y * w + x);
      if (hit.values[i] == 1.0f) covered += 1.0 - static_cast<double>(image.rgba[4 * i + 1]);
    }
  return covered / (2.0 * rows);
}

TEST_F(LooksGlTest, SilhouettesKeepTheirWidthOnScreen) {
  const auto ball = phantom("ball", 64);
  const double radiusMm = 0.35 * edgeOf(*ball);
  for (const double radiusPixels : {20.0, 35.0, 60.0}) {
    draw(ball,
         {"look.mode=lambert", "look.ambient=1", "isosurface.albedo=1,1,1", "look.contours=1",
          "look.contour_width=2"},
         radiusMm / radiusPixels);
    EXPECT_NEAR(silhouetteWidth(linear_, hit_), 2.0, 0.5) << radiusPixels;
  }
}

// Waves along x, 21 mm long: crests are ridges, troughs valleys, alike in curvature; inflections lie between.
std::shared_ptr<const volume::PreparedVolume> waves() {
  const glm::ivec3 dims(64, 24, 24);
  std::vector<float> voxels;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x)
        voxels.push_back(
            static_cast<float>(y - 12.0 - 3.0 * std::cos(2.0 * std::numbers::pi * (x - 31.5) / 21.0)));
  return prepared(volume::Grid(volume::GridGeometry::make(dims, glm::dvec3(1.0)), std::move(voxels)));
}

TEST_F(LooksGlTest, LinesLieOnRidgesAndValleysOnly) {
  const auto volume = waves();
  draw(volume,
       {"isosurface.value=0", "look.mode=lambert", "look.ambient=1", "isosurface.albedo=0.5,0.5,0.5",
        "look.ridges=1", "look.ridge_width=3", "look.ridge_color=1,0,0", "look.valley_color=0,0,1"},
       0.5);
  std::size_t red = 0, blue = 0, wrong = 0;
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (!hit(i)) continue;
    const double phase =
        std::cos(2.0 * std::numbers::pi * (RenderGlTest::at(position_, i).x - centre_.x) / 21.0);
    const bool isRed = color(i).x > 0.8,
               isBlue = color(i).z > 0.8;  // the viewer looks along +y: crests are at -1
    red += isRed;
    blue += isBlue;
    if ((isRed && phase > -0.6) || (isBlue && phase < 0.6)) ++wrong;
  }
  EXPECT_GT(red, 100u);
  EXPECT_GT(blue, 100u);
  EXPECT_EQ(wrong, 0u);
}

// From the side, a suggestive contour lies on one of the two inflections around each trough, and nowhere
// else; a ball has none, since it is hollow from nowhere.
TEST_F(LooksGlTest, SuggestiveContoursLieWhereTheRadialCurvatureVanishes) {
  const Settings look = {"look.mode=lambert", "look.ambient=1", "isosurface.albedo=1,1,1",
                         "look.suggestive_contours=1"};
  draw(waves(), withMore(look, {"camera.eye=-150,-300,0"}), 0.4);
  std::size_t lines = 0, wrong = 0;
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (!hit(i) || grey(i) > 0.4) continue;
    ++lines;
    const double angle = 2.0 * std::numbers::pi * (RenderGlTest::at(position_, i).x - centre_.x) / 21.0;
    if (std::fabs(std::cos(angle)) > 0.5) ++wrong;
  }
  EXPECT_GT(lines, 50u);
  EXPECT_EQ(wrong, 0u);
  draw(phantom("ball", 64), look, 0.5);
  for (std::size_t i = 0; i < pixels(); ++i)
    if (hit(i)) {
      ASSERT_GT(grey(i), 0.95);
    }
}

// Angle of the streaks on screen from the structure tensor of the middle of the picture, degrees from
// horizontal; coherence 1: all alike.
struct Streaks {
  double angle, coherence;
};
Streaks streaksOf(const render::LinearImage& image) {
  double xx = 0.0, xy = 0.0, yy = 0.0;
  const int w = image.size.x, h = image.size.y;
  const auto g = [&](int x, int y) {
    return static_cast<double>(image.rgba[static_cast<std::size_t>(4 * (y * w + x) + 1)]);
  };
  for (int y = h / 4; y < 3 * h / 4; ++y)
    for (int x = w / 2 - w / 16; x < w / 2 + w / 16; ++x) {
      const double dx = g(x + 1, y) - g(x - 1, y), dy = g(x, y + 1) - g(x, y - 1);
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
    }
  // Along the streaks there is least change.
  const double angle = 0.5 * std::atan2(2.0 * xy, xx - yy) * 180.0 / std::numbers::pi + 90.0;
  return {angle > 90.0 ? angle - 180.0 : angle, std::hypot(xx - yy, 2.0 * xy) / (xx + yy)};
}

// A cylinder along z, seen from the side with z up: kappa1 runs around it, kappa2 along it.
TEST_F(LooksGlTest, StreaksFollowThePrincipalDirections) {
  const auto cylinder = phantom("cylinder", 64);
  const Settings flow = {"look.mode=flow", "look.shading=unlit"};
  draw(cylinder, withMore(flow, {"flow.direction=maximum"}), 0.35);
  const Streaks around = streaksOf(linear_);
  EXPECT_NEAR(around.angle, 0.0, 3.0);
  EXPECT_GT(around.coherence, 0.5);
  draw(cylinder, withMore(flow, {"flow.direction=minimum"}), 0.35);
  const Streaks along = streaksOf(linear_);
  EXPECT_NEAR(std::fabs(along.angle), 90.0, 3.0);
  EXPECT_GT(along.coherence, 0.5);
}

TEST_F(LooksGlTest, FlowMovesAndComesBackAndIsOffWhereThereIsNoDirection) {
  const auto cylinder = phantom("cylinder", 48);
  const Settings flow = {"look.mode=flow", "look.shading=unlit", "isosurface.albedo=0.4,0.4,0.4"};
  draw(cylinder, flow, 0.5);
  const auto first = linear_.rgba;
  draw(cylinder, withMore(flow, {"flow.time=0.5"}), 0.5);
  double moved = 0.0, back = 0.0;
  for (std::size_t i = 0; i < first.size(); ++i)
    moved = std::max(moved, static_cast<double>(std::fabs(first[i] - linear_.rgba[i])));
  EXPECT_GT(moved, 0.1);
  draw(cylinder, withMore(flow, {"flow.time=3"}), 0.5);  // whole periods later
  for (std::size_t i = 0; i < first.size(); ++i)
    back = std::max(back, static_cast<double>(std::fabs(first[i] - linear_.rgba[i])));
  EXPECT_LT(back, 1e-2);
  draw(phantom("ball", 48), flow, 0.5);  // umbilic everywhere: smooth
  double least = 1.0, most = 0.0;
  for (std::size_t i = 0; i < pixels(); ++i)
    if (hit(i)) {
      least = std::min(least, grey(i));
      most = std::max(most, grey(i));
    }
  EXPECT_LT(most - least, 0.08);
}

// A texture is carved from space: the same point has the same colour from any side and at any size of the
// picture.
TEST_F(LooksGlTest, TexturesLieInSpaceAndDoNotAlias) {
  const auto ball = phantom("ball", 48);
  for (const char* texture : {"marble", "wood", "checker"}) {
    SCOPED_TRACE(texture);
    const Settings look = {"look.mode=lambert", "look.ambient=1", "look.texture=" + std::string(texture)};
    draw(ball, withMore(look, {"look.texture_scale=12"}), 0.25);
    const render::LinearImage large = linear_;
    const render::AovImage place = position_, hits = hit_;
    double least = 1.0, most = 0.0;
    for (std::size_t i = 0; i < pixels(); ++i)
      if (hit(i)) {
        least = std::min(least, grey(i));
        most = std::max(most, grey(i));
      }
    EXPECT_GT(most - least, 0.15);
    // Features far below a pixel: the texture has turned into its mean.
    draw(ball, withMore(look, {"look.texture_scale=0.01"}), 0.25);
    for (int y = 40; y < 88; ++y)
      for (int x = 40; x < 88; ++x) EXPECT_NEAR(grey(at(x, y)), grey(at(64, 64)), 0.02);
  }
}

TEST_F(LooksGlTest, HollowsDarken) {
  const auto torus = phantom("torus", 64);
  const Settings base = {"look.mode=lambert", "look.ambient=1"};
  draw(torus, base, 0.6);
  const auto plain = linear_.rgba;
  draw(torus, withMore(base, {"look.accessibility=1"}), 0.6);
  std::size_t darker = 0, same = 0;
  for (std::size_t i = 0; i < pixels(); ++i) {
    if (!hit(i)) continue;
    const glm::dvec3 q = RenderGlTest::at(position_, i) - centre_;
    const double ring = glm::length(glm::dvec2(q)) -
                        0.27 * edgeOf(*torus);  // < 0: the side toward the hole, hollow around it
    if (ring > 1.0) {
      EXPECT_NEAR(linear_.rgba[4 * i], plain[4 * i], 5e-3);
      ++same;
    }
    darker += linear_.rgba[4 * i] < 0.9f * plain[4 * i];
  }
  EXPECT_GT(same, 300u);
  draw(torus, withMore(base, {"look.accessibility=1", "camera.up=0,1,0.1", "camera.eye=0,0,-300"}), 0.6);
  for (std::size_t i = 0; i < pixels(); ++i) darker += hit(i) && color(i).x < 0.9 * 0.7;
  EXPECT_GT(darker, 50u);
}

TEST_F(LooksGlTest, LinesAreOpaqueOnTransparentSurfaces) {
  draw(phantom("ball", 48), {"isosurface.opacity=0.3", "isosurface.layers=1", "look.contours=1"}, 0.4);
  double most = 0.0;
  for (std::size_t i = 0; i < pixels(); ++i)
    most = std::max(most, static_cast<double>(linear_.rgba[4 * i + 3]));
  EXPECT_GT(most, 0.9);
  EXPECT_NEAR(linear_.rgba[4 * at(64, 64) + 3], 0.3f, 1e-2f);
}

}  // namespace
}  // namespace isolux::test
