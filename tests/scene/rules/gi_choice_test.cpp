// The least light that a scene calls for, and the reflectance of an isovalue.
#include "scene/rules/gi_choice.h"

#include <gtest/gtest.h>

#include "scene/albedo.h"
#include "scene/color_maps.h"
#include "tests/support/lamps.h"
#include "tests/support/surfaces.h"

namespace isolux::scene {
namespace {

Scene lit() {
  Scene scene;
  scene.look.mode = LookMode::gi;
  scene.light.environment.constant = glm::dvec3(1.0);
  return scene;
}

Scene underProbe() {
  Scene scene = lit();
  scene.light.environment.file = "probe.hdr";
  return scene;
}

TEST(GiChoice, NoLookReadsLight) {
  for (const LookMode mode : {LookMode::blinn_phong, LookMode::normal, LookMode::kappa1}) {
    Scene scene = underProbe();
    scene.look.mode = mode;
    EXPECT_FALSE(giChoiceOf(scene).wanted);
    EXPECT_EQ(giChoiceOf(scene).sky, GiMode::off);
    EXPECT_EQ(giChoiceOf(scene).reason, "no look reads baked light");
  }
  Scene colored = underProbe();
  colored.look.mode = LookMode::kappa1;
  colored.look.shading = Shading::gi;
  EXPECT_TRUE(giChoiceOf(colored).wanted) << "colours may lie under stored light";
}

TEST(GiChoice, ABuiltInLightIsStoredAsALightProbeIs) {
  Scene probe = underProbe(), builtIn = lit();
  builtIn.light.environment.constant.reset();
  for (const int bounces : {0, 1})
    for (const bool moves : {false, true}) {
      probe.gi.bounces = builtIn.gi.bounces = bounces;
      probe.light.environment.moves = builtIn.light.environment.moves = moves;
      EXPECT_EQ(giChoiceOf(builtIn).sky, giChoiceOf(probe).sky);
      EXPECT_EQ(giChoiceOf(builtIn).channels, giChoiceOf(probe).channels);
      EXPECT_FALSE(giChoiceOf(builtIn).unitSky);
    }
}

TEST(GiChoice, TexelsOfAViewAreLitOnTheOneIsosurfaceShown) {
  Scene scene = underProbe();
  EXPECT_TRUE(giChoiceOf(scene).onShown);
  for (const GiExtent extent : {GiExtent::full, GiExtent::band}) {
    scene.gi.extent = extent;
    scene.gi.texels = GiTexels::automatic;
    EXPECT_FALSE(giChoiceOf(scene).onShown);
    scene.gi.texels = GiTexels::shown;
    EXPECT_TRUE(giChoiceOf(scene).onShown);
  }
  test::surfaceAt(scene, 2).shown = true;
  EXPECT_FALSE(giChoiceOf(scene).onShown) << "whichever is nearest would light the others";
  scene = underProbe();
  scene.gi.texels = GiTexels::own;
  EXPECT_FALSE(giChoiceOf(scene).onShown);
  scene = underProbe();
  scene.look.mode = LookMode::blinn_phong;
  EXPECT_FALSE(giChoiceOf(scene).onShown);
}

TEST(GiChoice, OfTheSky) {
  Scene scene = lit();
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::irradiance);
  EXPECT_TRUE(giChoiceOf(scene).unitSky);
  scene.gi.bounces = 0;
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::vicinity);
  EXPECT_EQ(giChoiceOf(scene).channels, 1);
  scene.light.environment.constant = glm::dvec3(0.0);
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::off);
  EXPECT_FALSE(giChoiceOf(scene).wanted);

  scene = underProbe();
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::irradiance);
  EXPECT_FALSE(giChoiceOf(scene).unitSky);
  EXPECT_EQ(giChoiceOf(scene).channels, 3);
  scene.gi.bounces = 0;
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::shadow);
  EXPECT_EQ(giChoiceOf(scene).channels, 3) << "the probe has colours";
  scene.light.environment.moves = true;
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::transfer);
  EXPECT_EQ(giChoiceOf(scene).channels, 1) << "without bounces no colour enters the transfer";
}

TEST(GiChoice, AConstantSkyWithoutShadowsIsBakedForItsReflectionsOnly) {
  Scene scene = lit();
  const GiChoice shadowed = giChoiceOf(scene);
  scene.light.environment.shadows = false;
  EXPECT_EQ(giChoiceOf(scene).sky, shadowed.sky);
  EXPECT_NE(giChoiceOf(scene).reason, shadowed.reason);
  scene.gi.bounces = 0;
  EXPECT_FALSE(giChoiceOf(scene).wanted);
  EXPECT_TRUE(giChoiceOf(scene).traced) << "gloss and exposure trace rays";
  test::lampAt(scene, 1).shown = true;
  EXPECT_TRUE(giChoiceOf(scene).wanted);
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::off);
  test::lampAt(scene, 1).shown = false;
  scene.gi.mode = GiMode::off;
  EXPECT_FALSE(giChoiceOf(scene).traced);

  scene = underProbe();
  scene.light.environment.shadows = false;
  scene.gi.bounces = 0;
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::shadow) << "nine harmonics are not exact";
  scene.light.environment.moves = true;
  EXPECT_EQ(giChoiceOf(scene).sky, GiMode::transfer);
  scene.gi.mode = GiMode::vicinity;
  EXPECT_FALSE(giChoiceOf(scene).wanted) << "the probe's mean from everywhere";
}

TEST(GiChoice, GreyNeedsOneChannel) {
  Scene scene = underProbe();
  scene.light.environment.moves = true;
  EXPECT_EQ(giChoiceOf(scene).channels, 3);
  scene.surfaces.front().albedo = glm::dvec3(0.7);
  EXPECT_EQ(giChoiceOf(scene).channels, 1);
  test::surfaceAt(scene, 1).shown = true;
  EXPECT_EQ(giChoiceOf(scene).channels, 3) << "the second surface is blue";
  scene.isosurface.albedoSource = AlbedoSource::map;
  scene.isosurface.albedoMap = ColorMap::gray;
  EXPECT_EQ(giChoiceOf(scene).channels, 1);
}

TEST(GiChoice, LampsAndForcedModes) {
  Scene scene = underProbe();
  test::lampAt(scene, 1).shown = true;
  EXPECT_TRUE(giChoiceOf(scene).lamps);
  test::lampAt(scene, 1).intensity = 0.0;
  EXPECT_FALSE(giChoiceOf(scene).lamps) << "a lamp without light";
  scene.gi.bounces = 4;
  EXPECT_EQ(giChoiceOf(scene).bounces, 4);
  scene.gi.mode = GiMode::shadow;
  EXPECT_EQ(giChoiceOf(scene).bounces, 0);
  scene.gi.mode = GiMode::vicinity;
  EXPECT_EQ(giChoiceOf(scene).bounces, 0);
  EXPECT_TRUE(giChoiceOf(scene).unitSky) << "under a probe: its mean";
  scene.gi.mode = GiMode::off;
  EXPECT_FALSE(giChoiceOf(scene).wanted);
}

TEST(AlbedoOfIsovalue, NearestIsosurfaceOrMap) {
  Scene scene;
  scene.surfaces.front().value = 10.0;
  scene.surfaces.front().albedo = glm::dvec3(0.25);
  EXPECT_TRUE(AlbedoOfIsovalue(scene).isConstant());
  EXPECT_EQ(AlbedoOfIsovalue(scene).at(-1e30), glm::vec3(0.25f));

  test::surfaceAt(scene, 2).shown = true;
  test::surfaceAt(scene, 2).value = 4.0;
  test::surfaceAt(scene, 2).albedo = glm::dvec3(0.5);
  const AlbedoOfIsovalue two(scene);
  EXPECT_FALSE(two.isConstant());
  EXPECT_EQ(two.at(6.9), glm::vec3(0.5f));
  EXPECT_EQ(two.at(7.1), glm::vec3(0.25f));

  scene.isosurface.albedoSource = AlbedoSource::map;
  scene.isosurface.albedoMap = ColorMap::gray;
  scene.isosurface.albedoLow = 0.0;
  scene.isosurface.albedoHigh = 20.0;
  const AlbedoOfIsovalue map(scene);
  const std::vector<glm::vec3> samples = colorMapSamples(ColorMap::gray, 256);
  EXPECT_EQ(map.at(-5.0), samples.front());
  EXPECT_EQ(map.at(25.0), samples.back());
  EXPECT_NEAR(map.at(10.0).x, 0.5f * (samples[127].x + samples[128].x), 1e-6f);
  scene.isosurface.albedoHigh = 0.0;  // an empty range is a step
  EXPECT_EQ(AlbedoOfIsovalue(scene).at(-0.1), samples.front());
  EXPECT_EQ(AlbedoOfIsovalue(scene).at(0.1), samples.back());
}

}  // namespace
}  // namespace isolux::scene
