// The ground behind the surface: darkened by the shadow on it, where rays meet it and nothing hides it.
#include <cmath>

#include <glm/geometric.hpp>

#include "base/color.h"
#include "gi/ground/ground_shadow.h"
#include "scene/camera.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/light/light_support.h"

namespace isolux::test {
namespace {

constexpr glm::ivec2 kGroundPicture{96, 72};
constexpr float kGroundLight = 0.4f;  // that reaches the ground
constexpr double kBallRadius = 0.35 * 23.0;

class GroundGlTest : public RenderGlTest {
 protected:
  // Light whose ground lies 14 mm below the volume's middle, dark to its borders.
  static std::shared_ptr<gi::PictureLight> lightWithGround() {
    auto ground = std::make_shared<gi::GroundShadow>();
    ground->key = 7;
    ground->middleMm = {0.0, 0.0, -14.0};
    ground->rightMm = {30.0, 0.0, 0.0};
    ground->backMm = {0.0, 40.0, 0.0};
    ground->light.assign(gi::GroundShadow::kPoints * gi::GroundShadow::kPoints, kGroundLight);
    auto light = pictureLight(nullptr);
    light->irradianceSh[0] = glm::vec3(1.0f);
    light->ground = ground;
    return light;
  }

  render::ColorImage draw(const std::vector<std::string>& settings) {
    scene::Scene scene;
    scene.look.mode = scene::LookMode::gi;
    scene.surfaces.front().value = 0.0;
    scene.look.backgroundTop = scene.look.backgroundBottom = glm::dvec3(0.5);
    std::vector<std::string> all = {"camera.eye=10,-90,40", "camera.target=0,0,-6", "camera.up=0,0,1",
                                    "gi.ground=true"};
    all.insert(all.end(), settings.begin(), settings.end());
    scene_ = scene::resolve(assigned(all, scene), volume_->facts);
    renderer_->setVolume(volume_);
    renderer_->setLight(light_);
    request_.size = kGroundPicture;
    request_.aovs = {render::Aov::hit};
    renderer_->render(scene_, request_);
    hit_ = renderer_->readAov(render::Aov::hit).values;
    return renderer_->readColor();
  }

  scene::Ray rayOf(int x, int y) const {
    const glm::dvec2 ndc(2.0 * (x + 0.5) / kGroundPicture.x - 1.0, 1.0 - 2.0 * (y + 0.5) / kGroundPicture.y);
    return scene::rayThrough(scene::frameOf(scene_.camera), ndc,
                             static_cast<double>(kGroundPicture.x) / kGroundPicture.y);
  }

  // What reaches the place where the pixel's ray meets the ground.
  double lightBehind(int x, int y) const {
    const scene::Ray ray = rayOf(x, y);
    const double t = (-14.0 - ray.origin.z) / ray.direction.z;
    const glm::dvec3 met = ray.origin + t * ray.direction;
    const bool orthographic = scene_.camera.projection == scene::Projection::orthographic;
    const bool meets = ray.direction.z < 0.0 && (orthographic || t > 0.0);
    return meets && std::abs(met.x) < 30.0 && std::abs(met.y) < 40.0 ? static_cast<double>(kGroundLight)
                                                                     : 1.0;
  }

  // Pixels without a surface against the formula; returns how many are dark.
  int expectGround(const render::ColorImage& picture) {
    int dark = 0, wrong = 0;
    for (int y = 0; y < kGroundPicture.y; ++y)
      for (int x = 0; x < kGroundPicture.x; ++x) {
        const auto i = static_cast<std::size_t>(y * kGroundPicture.x + x);
        if (hit_[i] != 0.0f) continue;
        const double light = lightBehind(x, y);
        dark += light < 1.0 ? 1 : 0;
        if (std::abs(picture.rgba[4 * i] / 255.0 - base::encodeSrgb(0.5 * light)) > 0.006) ++wrong;
      }
    EXPECT_LE(wrong, 4);  // pixels whose ray meets the border
    return dark;
  }

  std::shared_ptr<const volume::PreparedVolume> volume_ = phantom("ball", 24);
  std::shared_ptr<gi::PictureLight> light_ = lightWithGround();
  render::FrameRequest request_;
  std::vector<float> hit_;
};

TEST_F(GroundGlTest, DarkensTheBackgroundWhereRaysMeetIt) {
  for (const char* projection : {"perspective", "orthographic"})
    for (const char* executor : {"cpu", "gpu"}) {
      SCOPED_TRACE(std::string(projection) + " " + executor);
      const std::vector<std::string> settings = {std::string("camera.projection=") + projection,
                                                 std::string("picture.executor=") + executor};
      EXPECT_GT(expectGround(draw(settings)), 500);
    }
}

TEST_F(GroundGlTest, IsBehindASurfaceThatLetsLightThrough) {
  const std::string half = "isosurface.opacity=0.5";
  const render::ColorImage without = draw({half, "gi.ground=false"}), with = draw({half});
  // In front of the background's 0.5 are two crossings of a layer at the same angle.
  const auto seenThrough = [&](int x, int y) {
    const scene::Ray ray = rayOf(x, y);
    const double apart = glm::length(glm::cross(ray.origin, glm::normalize(ray.direction))) / kBallRadius;
    return std::pow(0.5, 2.0 / std::sqrt(1.0 - std::min(apart * apart, 0.999)));
  };
  int compared = 0;
  for (int y = 24; y < 48; ++y) {
    const int x = kGroundPicture.x / 2;
    const auto i = static_cast<std::size_t>(y * kGroundPicture.x + x);
    if (hit_[i] == 0.0f || !(lightBehind(x, y) < 1.0)) continue;
    const auto linear = [&](const render::ColorImage& picture) {
      return base::decodeSrgb(picture.rgba[4 * i] / 255.0);
    };
    const double darker = seenThrough(x, y) * 0.5 * (1.0 - static_cast<double>(kGroundLight));
    EXPECT_NEAR(linear(without) - linear(with), darker, 0.01) << y;
    ++compared;
  }
  EXPECT_GT(compared, 3);
}

TEST_F(GroundGlTest, ChangesNothingWhenOffOrSeenFromBelow) {
  const render::ColorImage off = draw({"gi.ground=false"});
  EXPECT_NE(draw({}).rgba, off.rgba);
  EXPECT_NE(draw({"look.mode=lambert"}).rgba, off.rgba);
  const std::vector<std::string> below = {"camera.eye=10,-90,-40"};
  const render::ColorImage fromBelow = draw(below);
  light_ = std::make_shared<gi::PictureLight>(*light_);
  light_->ground.reset();
  EXPECT_EQ(draw(below).rgba, fromBelow.rgba);
  EXPECT_EQ(draw({}).rgba, off.rgba);
}

// Over white, the shadow of a transparent picture darkens as it does in an opaque one: black, of so much
// alpha.
TEST_F(GroundGlTest, IsBlackInTransparentPictures) {
  const render::ColorImage picture = draw({"picture.transparent=true"});
  int dark = 0;
  for (int y = 0; y < kGroundPicture.y; ++y)
    for (int x = 0; x < kGroundPicture.x; ++x) {
      const auto i = static_cast<std::size_t>(y * kGroundPicture.x + x);
      if (hit_[i] != 0.0f) continue;
      if (picture.rgba[4 * i + 3] == 0) continue;
      ++dark;
      EXPECT_LE(picture.rgba[4 * i], 1);
      EXPECT_NEAR(picture.rgba[4 * i + 3] / 255.0, 1.0 - static_cast<double>(kGroundLight), 0.003);
      EXPECT_LT(lightBehind(x, y), 1.0);
    }
  EXPECT_GT(dark, 500);
}

// A turned view moves the shadow although the pixels behind the surface are the look's.
TEST_F(GroundGlTest, FollowsTheView) {
  expectGround(draw({}));
  expectGround(draw({"camera.eye=-60,-50,50"}));
  expectGround(draw({"look.background_top=0.5,0.5,0.5", "camera.eye=-60,50,30"}));
}

}  // namespace
}  // namespace isolux::test
