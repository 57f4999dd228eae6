// What a scene says about its light: lamps in physical units, shares, and the key of stored light.
#include "gi/light_scene.h"
#include "tests/support/lamps.h"
#include "tests/support/surfaces.h"
#include "tests/support/volumes.h"

#include <cmath>
#include <numbers>
#include <set>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/number_text.h"
#include "gi/light_key.h"
#include "gi/sampling/lamp_sampling.h"
#include "scene/rules/automatic.h"
#include "tests/gi/light_fixture.h"
#include "tests/support/test_data.h"

namespace isolux::gi {
namespace {

using namespace isolux::test;

using std::numbers::pi;

scene::Scene giScene(const volume::PreparedVolume& volume) {
  scene::Scene scene;
  scene.look.mode = scene::LookMode::gi;
  scene.surfaces.front().value = 0.0;
  lampAt(scene, scene::kLamps - 1);  // all are there, switched off
  return scene::resolve(scene, volume.facts);
}

std::shared_ptr<const LightScene> lightOf(const scene::Scene& scene,
                                          const std::shared_ptr<const volume::PreparedVolume>& volume,
                                          std::shared_ptr<const Environment> environment = nullptr) {
  base::Progress progress;
  auto tracer = std::make_shared<const volume::IsosurfaceTracer>(volume->volume.grid, scene.isosurface.inside,
                                                                 progress);
  if (!environment) environment = loadEnvironment(scene.light.environment);
  return makeLightScene(scene, volume, tracer, environment);
}

// E = pi * intensity * color on a surface at the volume's centre that faces the lamp.
TEST(LightScene, LampsAreAsBrightAsTheirSettingsSay) {
  const auto volume = volumeOf(volume::GridGeometry::make({20, 24, 28}, {1.0, 0.8, 0.5}, {100.0, -50.0, 7.0}),
                               [](glm::dvec3 p) { return p.x; });
  scene::Scene scene = giScene(*volume);
  const auto [low, high] = volume->grid().geometry().worldBounds();
  const glm::dvec3 centre = 0.5 * (low + high);
  test::lampAt(scene, 0).shown = true;
  test::lampAt(scene, 0).color = {1.0, 0.5, 0.25};
  test::lampAt(scene, 0).intensity = 1.7;
  const auto check = [&](const char* what) {
    const std::vector<LampLight> lamps = lampsOf(scene, volume->grid().geometry());
    ASSERT_EQ(lamps.size(), 1u);
    const glm::dvec3 toward = test::lampAt(scene, 0).kind == scene::LampKind::directional
                                  ? glm::normalize(test::lampAt(scene, 0).direction)
                                  : glm::normalize(*test::lampAt(scene, 0).position - centre);
    const LampSampler sampler(lamps, volume->grid().geometry());
    const glm::vec3 voxel(volume->grid().geometry().voxelFromWorld() * glm::dvec4(centre, 1.0));
    glm::dvec3 mean(0.0);
    constexpr int steps = 256;  // midpoints: off by the square of their distance
    for (int i = 0; i < steps * steps; ++i) {
      const glm::vec2 u((static_cast<float>(i % steps) + 0.5f) / steps,
                        (static_cast<float>(i / steps) + 0.5f) / steps);
      mean += glm::dvec3(sampler.sample(0, voxel, glm::vec3(toward), u).irradiance) / double(steps * steps);
    }
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(mean[channel], pi * 1.7 * test::lampAt(scene, 0).color[channel], 2e-4) << what;
  };
  for (const double distance : {0.5, 5.0, 500.0}) {
    test::lampAt(scene, 0).position = centre + distance * glm::normalize(glm::dvec3(1.0, 2.0, -2.0));
    test::lampAt(scene, 0).kind = scene::LampKind::point;
    check("point");
    test::lampAt(scene, 0).kind = scene::LampKind::sphere;
    test::lampAt(scene, 0).radius = 3.0;  // at 0.5 the centre is inside
    check("sphere");
  }
  test::lampAt(scene, 0).kind = scene::LampKind::directional;
  for (const double angle : {0.0, 1e-9, 0.53, 60.0}) {
    test::lampAt(scene, 0).angle = angle;
    check("directional");
  }
}

TEST(LightScene, OnlyLampsThatShineAreThere) {
  const auto volume = test::phantom("ball", 12);
  scene::Scene scene = giScene(*volume);
  test::lampAt(scene, 0).shown = test::lampAt(scene, 1).shown = true;
  test::lampAt(scene, 1).intensity = 0.0;
  test::lampAt(scene, 2).shown = true;
  test::lampAt(scene, 2).color = glm::dvec3(0.0);
  EXPECT_EQ(lampsOf(scene, volume->grid().geometry()).size(), 1u);
}

TEST(LightScene, DirectionsAreDrawnFromAProbeThatHasAny) {
  const auto volume = test::phantom("ball", 12);
  scene::Scene scene = giScene(*volume);
  scene.light.environment.file = "probe.hdr";
  const auto probe = environmentOf(8, 4, [](glm::dvec3 d) { return 1.0 + d.z; });
  EXPECT_GT(lightOf(scene, volume, probe)->environmentShare, 0.0);
  EXPECT_EQ(lightOf(scene, volume, environmentOf(8, 4, [](glm::dvec3) { return 2.0; }))->environmentShare,
            0.0);
  scene.gi.environmentShare = 0.125;
  EXPECT_EQ(lightOf(scene, volume, probe)->environmentShare, 0.125);
  scene.gi.mode = scene::GiMode::vicinity;
  EXPECT_TRUE(lightOf(scene, volume, probe)->choice.unitSky);
  EXPECT_EQ(lightOf(scene, volume, probe)->environmentShare, 0.0);
}

TEST(LightScene, AnUnreadableProbeIsRefusedByName) {
  try {
    scene::Environment settings;
    settings.file = (temporaryFolder() / "none.hdr").string();
    (void)loadEnvironment(settings);
    FAIL();
  } catch (const base::Error& error) {
    EXPECT_EQ(error.kind(), base::ErrorKind::input);
    EXPECT_NE(std::string(error.what()).find("none.hdr"), std::string::npos);
  }
}

// The keys of the sky and of the lamps after a change of the scene.
class LightKey : public ::testing::Test {
 protected:
  LightKey() {
    scene_.light.environment.file = "probe.hdr";
    test::lampAt(scene_, 0).shown = true;
  }
  std::string key(const scene::Scene& scene, LightPart part) const {
    return lightKey(scene, *lightOf(scene, volume_, probe_), part);
  }
  // Which of the keys change: "sky", "lamps", "both" or "none".
  template <class Edit>
  std::string changed(const Edit& edit) const {
    scene::Scene edited = scene_;
    edit(edited);
    const bool sky = key(scene_, LightPart::sky) != key(edited, LightPart::sky);
    const bool lamps = key(scene_, LightPart::lamps) != key(edited, LightPart::lamps);
    return sky ? (lamps ? "both" : "sky") : (lamps ? "lamps" : "none");
  }

  std::shared_ptr<const volume::PreparedVolume> volume_ = test::phantom("ball", 12);
  std::shared_ptr<const Environment> probe_ = environmentOf(8, 4, [](glm::dvec3 d) { return 1.0 + d.z; });
  scene::Scene scene_ = giScene(*volume_);
};

TEST_F(LightKey, IsJson) {
  for (const LightPart part : {LightPart::sky, LightPart::lamps}) {
    const auto json = nlohmann::json::parse(key(scene_, part));
    EXPECT_EQ(json.at("volume").get<std::string>().size(), 16u);
  }
  EXPECT_NE(key(scene_, LightPart::sky), key(scene_, LightPart::lamps));
}

TEST_F(LightKey, KeepsWhatOnlyThePictureDependsOn) {
  scene_.gi.texels = scene::GiTexels::own;
  EXPECT_EQ(changed([](scene::Scene& s) { s.surfaces.front().value = 3.0; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.samples = 4; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.exposure = 3.0; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.visible = true; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.camera.fov = 12.0; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.interpolation = scene::GiInterpolation::nearest; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.extent = scene::GiExtent::full; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.shOrder = 3; }), "none");  // of transfer only
  EXPECT_EQ(changed([](scene::Scene& s) { test::lampAt(s, 1).intensity = 7.0; }), "none");  // is not shown
  EXPECT_EQ(changed([](scene::Scene& s) {
              s.gi.rouletteDepth = 9;
              s.gi.bounces = 1;
            }),
            changed([](scene::Scene& s) { s.gi.bounces = 1; }));
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.rotation = {-2.0, 0.0, 0.0, 0.0}; }), "none");
}

// Light of the shown isosurface alone is of that isovalue; of all, and of several, it is of none.
TEST_F(LightKey, IsOfTheIsovalueWhereTexelsAreLitOnIt) {
  const auto otherValue = [](scene::Scene& s) { s.surfaces.front().value = 3.0; };
  EXPECT_EQ(changed(otherValue), "both");
  EXPECT_EQ(nlohmann::json::parse(key(scene_, LightPart::sky)).at("isovalue"),
            *scene_.surfaces.front().value);
  scene_.gi.extent = scene::GiExtent::full;
  EXPECT_EQ(changed(otherValue), "none");
  scene_.gi.texels = scene::GiTexels::shown;
  EXPECT_EQ(changed(otherValue), "both");
  test::surfaceAt(scene_, 1).shown = true;
  test::surfaceAt(scene_, 1).value = 2.0;
  EXPECT_FALSE(nlohmann::json::parse(key(scene_, LightPart::sky)).contains("isovalue"));
}

TEST_F(LightKey, FollowsWhatLightDependsOn) {
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.bounces = 4; }), "both");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.sequence = scene::DirectionSequence::random; }), "both");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.latticeScale = 0.5; }), "both");
  EXPECT_EQ(changed([](scene::Scene& s) { s.isosurface.inside = scene::Inside::below; }), "both");
  EXPECT_EQ(changed([](scene::Scene& s) { s.surfaces.front().albedo = {0.9, 0.8, 0.7}; }), "both");
  EXPECT_EQ(changed([](scene::Scene& s) { s.isosurface.albedoSource = scene::AlbedoSource::map; }), "both");
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.rotation = {1.0, 1.0, 0.0, 0.0}; }), "sky");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.environmentShare = 0.1; }), "sky");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.mode = scene::GiMode::transfer; }), "sky");
  EXPECT_EQ(changed([](scene::Scene& s) { test::lampAt(s, 0).intensity = 2.0; }), "lamps");
  EXPECT_EQ(changed([](scene::Scene& s) { test::lampAt(s, 0).kind = scene::LampKind::sphere; }), "lamps");
  EXPECT_EQ(changed([](scene::Scene& s) { test::lampAt(s, 1).shown = true; }), "lamps");
}

TEST_F(LightKey, WithoutBouncesTheSurfacesColourDoesNotMatter) {
  scene_.gi.bounces = 0;
  EXPECT_EQ(changed([](scene::Scene& s) { s.surfaces.front().albedo = {0.9, 0.8, 0.7}; }), "none");
}

TEST_F(LightKey, TransferAndAUnitSkyDoNotDependOnTheEnvironment) {
  scene_.gi.mode = scene::GiMode::transfer;
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.rotation = {1.0, 1.0, 0.0, 0.0}; }), "none");
  EXPECT_EQ(changed([](scene::Scene& s) { s.gi.shOrder = 3; }), "sky");
  scene_.gi.mode = scene::GiMode::automatic;
  scene_.light.environment.file.clear();
  scene_.light.environment.constant = glm::dvec3(1.0);
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.constant = glm::dvec3(3.0, 2.0, 1.0); }),
            "none");
}

// Files of stored light say which light they are of: what they say must not change.
TEST_F(LightKey, IsThatOfFilesOfBefore) {
  auto json = nlohmann::json::parse(key(scene_, LightPart::sky));
  EXPECT_EQ(json.at("format"), 2);
  EXPECT_EQ(json.at("environment"), nlohmann::json({{"hash", base::hexText(probe_->hash())},
                                                    {"rotation", {1.0, 0.0, 0.0, 0.0}},
                                                    {"share", 0.75}}));
  scene_.light.environment.file.clear();
  scene_.light.environment.constant = glm::dvec3(1.0);
  EXPECT_EQ(nlohmann::json::parse(key(scene_, LightPart::sky)).at("environment"), "unit");
}

TEST_F(LightKey, NamesABuiltInLightAndTakesTheRotationAsAWhole) {
  scene_.light.environment.file.clear();
  EXPECT_EQ(
      nlohmann::json::parse(key(scene_, LightPart::sky)).at("environment"),
      nlohmann::json(
          {{"built_in", "studio"}, {"version", 2}, {"rotation", {1.0, 0.0, 0.0, 0.0}}, {"share", 0.75}}));
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.builtIn = scene::BuiltInLight::window; }),
            "sky");
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.elevation = 5.0; }), "sky");
  scene::Scene azimuth = scene_, quaternion = scene_;
  azimuth.light.environment.azimuth = 180.0;
  quaternion.light.environment.rotation = {0.0, 0.0, 0.0, 2.0};
  const auto rotation = [&](const scene::Scene& scene) {
    return nlohmann::json::parse(key(scene, LightPart::sky)).at("environment").at("rotation");
  };
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(rotation(azimuth)[i].get<double>(), rotation(quaternion)[i].get<double>(), 1e-15);
}

TEST_F(LightKey, ShadowsAreOfTheirOwnLattice) {
  const auto withoutSky = [](scene::Scene& s) { s.light.environment.shadows = false; };
  EXPECT_EQ(changed(withoutSky), "sky");
  EXPECT_EQ(changed([](scene::Scene& s) { test::lampAt(s, 0).shadows = false; }), "lamps");
  EXPECT_EQ(changed([](scene::Scene& s) { test::lampAt(s, 1).shadows = false; }), "none") << "is not shown";
  scene_.light.environment.moves = true;
  EXPECT_EQ(changed(withoutSky), "sky") << "transfer";
  scene_.light.environment.file.clear();
  scene_.light.environment.constant = glm::dvec3(1.0);
  EXPECT_EQ(changed(withoutSky), "sky") << "a unit sky";
}

TEST_F(LightKey, ARotationOfLengthZeroIsNone) {
  EXPECT_EQ(changed([](scene::Scene& s) { s.light.environment.rotation = {0.0, 0.0, 0.0, 0.0}; }), "none");
}

TEST_F(LightKey, AnotherProbeIsAnotherLight) {
  const std::string before = key(scene_, LightPart::sky);
  probe_ = environmentOf(8, 4, [](glm::dvec3 d) { return 1.0 + d.x; });
  EXPECT_NE(key(scene_, LightPart::sky), before);
}

}  // namespace
}  // namespace isolux::gi
