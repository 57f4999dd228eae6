// Stored light at surface points: lattices that are formulas, looked up by the GPU, against the same
// formulas.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "base/color.h"
#include "gi/harmonics/open_sky.h"
#include "gi/harmonics/spherical_harmonics.h"
#include "gi/harmonics/transfer_basis.h"
#include "scene/opacity.h"
#include "scene/rules/tone_curve.h"
#include "scene/settings/settings.h"
#include "tests/render/gl_fixture.h"
#include "tests/render/light/light_support.h"
#include "tests/support/light.h"

namespace isolux::test {
namespace {

using Settings = std::vector<std::string>;
const Settings kHalf = {"gi.precision=half", "gi.interpolation=trilinear"};
constexpr float kHalfStep = 1.0f / 2048.0f;  // relative rounding of half floats

Settings with(Settings settings, const Settings& more) {
  settings.insert(settings.end(), more.begin(), more.end());
  return settings;
}

class LightGlTest : public RenderGlTest {
 protected:
  // Draws `volume` under `light`; keeps what pixels show.
  void draw(const std::shared_ptr<const volume::PreparedVolume>& volume,
            std::shared_ptr<const gi::PictureLight> light, const Settings& settings,
            std::size_t uploadBytes = 0) {
    scene::Scene scene;
    scene.look.mode = scene::LookMode::gi;
    scene.surfaces.front().value = 0.0;
    scene_ = scene::resolve(assigned(settings, scene), volume->facts);
    renderer_->setVolume(volume);
    renderer_->setLight(std::move(light));
    render::FrameRequest request;
    request.size = {96, 96};
    request.aovs = {render::Aov::hit, render::Aov::voxel, render::Aov::normal, render::Aov::irradiance};
    request.lightUploadBytes = uploadBytes;
    report_ = renderer_->render(scene_, request);
    hit_ = renderer_->readAov(render::Aov::hit);
    voxel_ = renderer_->readAov(render::Aov::voxel);
    normal_ = renderer_->readAov(render::Aov::normal);
    irradiance_ = renderer_->readAov(render::Aov::irradiance);
  }
  // `expected(voxel, normal)` at every hit, within `relative` and `absolute`; returns how many were compared.
  template <class Expected>
  std::size_t expectIrradiance(Expected expected, double relative, double absolute = 0.0) {
    std::size_t compared = 0, wrong = 0;
    for (std::size_t i = 0; i < hit_.values.size(); ++i) {
      if (hit_.values[i] == 0.0f) continue;
      const glm::dvec3 e = at(irradiance_, i), want = expected(at(voxel_, i), at(normal_, i));
      for (int c = 0; c < 3; ++c)
        if (!(std::fabs(e[c] - want[c]) <= absolute + relative * std::fabs(want[c])) && ++wrong < 5)
          ADD_FAILURE() << "pixel " << i << " channel " << c << ": " << e[c] << " instead of " << want[c];
      ++compared;
    }
    EXPECT_EQ(wrong, 0u);
    EXPECT_GT(compared, 500u);
    return compared;
  }
  render::PassState stateOf(const char* pass) const {
    for (const render::PassReport& entry : report_.passes)
      if (entry.name == pass) return entry.state;
    ADD_FAILURE() << "no pass " << pass;
    return render::PassState::skipped;
  }
  glm::ivec3 dimsOf(const std::shared_ptr<const volume::PreparedVolume>& volume) {
    return volume->grid().dims();
  }
  render::AovImage hit_, voxel_, normal_, irradiance_;
};

TexelLight constant(glm::vec3 e) {
  return {100, {0.0f, 0.0f, 1.0f}, {e.x, e.y, e.z}};
}

TEST_F(LightGlTest, LightOfOneValueIsFoundEverywhere) {
  const auto volume = phantom("ball", 24);
  for (const char* interpolation : {"closest_isovalue", "nearest", "trilinear", "tricubic", "weighted"})
    for (const char* scale : {"0.5", "1", "2"}) {
      const auto lattice = emptyLattice(dimsOf(volume), std::stod(scale));
      // Texels differ in normals, which only weighted lookups see.
      writeAll(*lattice, [](glm::ivec3 t) {
        TexelLight light = constant({0.5f, 2.0f, 7.0f});
        light.normal = glm::normalize(glm::vec3(t % 3) - glm::vec3(0.9f));
        return light;
      });
      draw(volume, pictureLight(lattice),
           {"gi.precision=half", std::string("gi.interpolation=") + interpolation});
      SCOPED_TRACE(std::string(interpolation) + " at scale " + scale);
      expectIrradiance([](auto, auto) { return glm::dvec3(0.5, 2.0, 7.0); }, 2e-6);
      EXPECT_TRUE(report_.light.stored);
      EXPECT_FALSE(report_.light.pending);
    }
}

// Also across the borders of blocks, and in volumes whose lattice ends within one.
TEST_F(LightGlTest, TrilinearLookupsAreExactForLinearLight) {
  const auto volume = phantom("ball", volume::GridGeometry::make({21, 33, 26}, glm::dvec3(1.0, 0.7, 1.3)));
  for (const double scale : {0.5, 1.0, 2.0}) {
    const auto lattice = emptyLattice(dimsOf(volume), scale);
    const auto formula = [](glm::dvec3 v) {
      return glm::dvec3(1.0 + v.x / 32.0, 2.0 + v.y / 64.0 - v.x / 64.0, 1.0 + v.z / 16.0);
    };
    writeAll(*lattice, [&](glm::ivec3 t) {
      return constant(glm::vec3(formula(glm::dvec3(lattice->geometry().voxelOf(t)))));
    });
    draw(volume, pictureLight(lattice), kHalf);
    SCOPED_TRACE(scale);
    expectIrradiance([&](glm::dvec3 voxel, auto) { return formula(voxel); }, kHalfStep, 1e-5);
  }
}

// The B-spline of the texels, that of the border being repeated beyond it, summed up here in double
// precision.
TEST_F(LightGlTest, TricubicLookupsAreTheSplineOfTheTexels) {
  const auto volume = phantom("ball", volume::GridGeometry::make({21, 33, 26}, glm::dvec3(1.0, 0.7, 1.3)));
  const auto lattice = emptyLattice(dimsOf(volume), 0.15);
  const glm::ivec3 last = lattice->geometry().dims - 1;
  const auto lightOf = [](glm::ivec3 t) {
    return glm::vec3(1 + t.x * t.x, 1 + t.y * t.y, 1 + t.x + 2 * t.y + t.z * t.z);
  };
  writeAll(*lattice, [&](glm::ivec3 t) { return constant(lightOf(t)); });
  draw(volume, pictureLight(lattice), with(kHalf, {"gi.interpolation=tricubic"}));
  int atBorder[2] = {};
  const auto spline = [&](glm::dvec3 voxel, auto) {
    const glm::dvec3 texel = lattice->geometry().texelOf(voxel);
    const glm::ivec3 base(glm::floor(texel));
    for (int axis = 0; axis < 3; ++axis) {
      atBorder[0] += base[axis] == 0;
      atBorder[1] += base[axis] + 2 > last[axis];
    }
    const auto weight = [](double distance) {
      const double d = std::abs(distance);
      return d < 1.0 ? 2.0 / 3.0 - d * d + 0.5 * d * d * d : d < 2.0 ? std::pow(2.0 - d, 3.0) / 6.0 : 0.0;
    };
    glm::dvec3 sum(0.0);
    for (int z = -1; z <= 2; ++z)
      for (int y = -1; y <= 2; ++y)
        for (int x = -1; x <= 2; ++x) {
          const glm::ivec3 at = base + glm::ivec3(x, y, z);
          const glm::dvec3 beside = texel - glm::dvec3(at);
          sum += weight(beside.x) * weight(beside.y) * weight(beside.z) *
                 glm::dvec3(lightOf(glm::clamp(at, glm::ivec3(0), last)));
        }
    return sum;
  };
  expectIrradiance(spline, kHalfStep, 1e-4);
  EXPECT_GT(atBorder[0], 100);
  EXPECT_GT(atBorder[1], 100);
}

// Stored in parts of what an open sky gives each normal, that sky's own light is found between texels of
// other normals: on this ball the light itself differs by up to a quarter among the eight of a lookup.
TEST_F(LightGlTest, WeightedLookupsAreExactForAnOpenSky) {
  const auto volume = phantom("ball", 24);
  const glm::vec3 middle(11.5f);
  auto light = pictureLight(nullptr);
  for (std::size_t i = 0; i < 9; ++i)
    light->irradianceSh[i] =
        i == 0 ? glm::vec3(9.0f) : glm::vec3(0.5f, 1.0f, 0.25f * static_cast<float>(i % 4));
  const gi::OpenSky sky(light->irradianceSh);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [&](glm::ivec3 t) {
    TexelLight texel = constant(glm::vec3(0.0f));
    texel.normal = glm::normalize(glm::vec3(t) - middle);
    const glm::vec3 e = 3.0f * sky.at(texel.normal);
    texel.means = {e.x, e.y, e.z};
    return texel;
  });
  light->sky = lattice;
  draw(volume, light, {"gi.precision=half", "gi.interpolation=weighted"});
  expectIrradiance([&](auto, glm::dvec3 n) { return glm::dvec3(3.0f * sky.at(glm::vec3(n))); }, 1e-3);
}

// Light of the isovalue before is seen until that of the new one is there.
TEST_F(LightGlTest, LightOfTheIsovalueBeforeStandsIn) {
  const auto volume = phantom("ball", 24);
  const auto ofIsovalue = [&](float isovalue) {
    return std::make_shared<gi::LightLattice>(gi::LatticeGeometry::make(dimsOf(volume), 1.0, isovalue),
                                              gi::LightContent{}, "test");
  };
  const auto was = ofIsovalue(0.5f), now = ofIsovalue(0.0f);
  const auto value = [](float e) { return [e](glm::ivec3) { return constant(glm::vec3(e)); }; };
  const auto everywhere = [&](double e) {
    expectIrradiance([e](auto, auto) { return glm::dvec3(e); }, 1e-5);
  };
  writeAll(*was, value(2.0f));
  draw(volume, pictureLight(was), kHalf);
  everywhere(2.0);
  auto light = pictureLight(now, 2);
  light->skyBefore = was;
  draw(volume, light, kHalf);
  everywhere(2.0);
  for (std::uint32_t block = 0; block < now->geometry().blockCount(); ++block)
    writeBlock(*now, block, value(3.0f));
  draw(volume, light, kHalf);
  everywhere(3.0);
  // Left behind by an isovalue that has no light there: dark, as nothing is local here.
  draw(volume, pictureLight(ofIsovalue(-1.0f), 3), kHalf);
  everywhere(0.0);
}

TEST_F(LightGlTest, TricubicLookupsAreExactForLinearLightInside) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3 t) { return constant(1.0f + glm::vec3(t) / 16.0f); });
  draw(volume, pictureLight(lattice), {"gi.precision=half", "gi.interpolation=tricubic"});
  expectIrradiance([](glm::dvec3 voxel, auto) { return 1.0 + voxel / 16.0; }, kHalfStep, 1e-5);
}

TEST_F(LightGlTest, TheNearestTexelIsTheNearest) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3 t) { return constant(glm::vec3(t)); });
  draw(volume, pictureLight(lattice), {"gi.precision=half", "gi.interpolation=nearest"});
  expectIrradiance([](glm::dvec3 voxel, auto) { return glm::floor(voxel + 0.5); }, 1e-6, 1e-6);
}

// Of the eight around the point, in values of the field.
TEST_F(LightGlTest, TheClosestIsovalueIsTheClosest) {
  const auto volume = phantom("ball", 24);
  const volume::Grid& grid = volume->grid();
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3 t) { return constant(glm::vec3(t)); });
  // The isovalue lies behind the lamps' light, whatever room that takes.
  const auto dark = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*dark, [](glm::ivec3) { return constant(glm::vec3(0.0f)); });
  for (const char* precision : {"half", "r11g11b10"})
    for (const bool withLamps : {false, true}) {
      SCOPED_TRACE(std::string(precision) + (withLamps ? " and lamps" : ""));
      const auto light = pictureLight(lattice);
      if (withLamps) light->lamps = dark;
      draw(volume, light, {std::string("gi.precision=") + precision, "gi.interpolation=closest_isovalue"});
      std::size_t compared = 0;
      for (std::size_t i = 0; i < hit_.values.size(); ++i) {
        if (hit_.values[i] == 0.0f) continue;
        const glm::ivec3 base = glm::min(glm::ivec3(at(voxel_, i)), dimsOf(volume) - 2);
        const auto off = [&](glm::ivec3 t) { return std::fabs(grid.value(t.x, t.y, t.z)); };
        double least = 1e30;
        for (int c = 0; c < 8; ++c)
          least = std::min(least, off(base + glm::ivec3(c & 1, c >> 1 & 1, c >> 2)));
        const glm::ivec3 texel(at(irradiance_, i) + 0.5);
        ASSERT_TRUE(glm::all(glm::greaterThanEqual(texel, base)) &&
                    glm::all(glm::lessThanEqual(texel, base + 1)));
        EXPECT_NEAR(off(texel), least, 1e-4 * (1.0 + least));
        ++compared;
      }
      EXPECT_GT(compared, 500u);
    }
}

TEST_F(LightGlTest, OnlyBakedTexelsHaveWeight) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  // Of each pair along x one texel is baked; where it is not, its numbers are nonsense. No light is local.
  writeAll(*lattice, [](glm::ivec3 t) {
    TexelLight light = constant(glm::vec3(3.0f));
    if (t.x % 2 == 1) {
      light.samples = 0;
      light.means = {1e4f, 1e4f, 1e4f};
    }
    return light;
  });
  draw(volume, pictureLight(lattice), kHalf);
  // Blended with local light, here none, by how much of the lookup's weight is baked.
  expectIrradiance(
      [](glm::dvec3 voxel, auto) {
        const double f = voxel.x - std::floor(voxel.x);
        return glm::dvec3(3.0 * (static_cast<int>(std::floor(voxel.x)) % 2 == 0 ? 1.0 - f : f));
      },
      1e-4, 1e-4);
}

TEST_F(LightGlTest, TexelsWithoutANormalAreLeftOutForGood) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3 t) {
    TexelLight light = constant(glm::vec3(3.0f));
    if (t.x % 2 == 1) light = {0, glm::vec3(0.0f), {}, true};
    return light;
  });
  draw(volume, pictureLight(lattice), kHalf);
  expectIrradiance([](auto, auto) { return glm::dvec3(3.0); }, 1e-4);
}

TEST_F(LightGlTest, FewPathsCountLessUntilSixteen) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  for (const auto& [samples, part] : {std::pair{4u, 4.0 / 15.0}, std::pair{16u, 1.0}, std::pair{64u, 1.0}}) {
    writeAll(*lattice, [n = samples](glm::ivec3) {
      TexelLight light = constant(glm::vec3(3.0f));
      light.samples = n;
      return light;
    });
    draw(volume, pictureLight(lattice), kHalf);
    expectIrradiance([p = part](auto, auto) { return glm::dvec3(3.0 * p); }, 1e-5);
  }
}

TEST_F(LightGlTest, WithoutStoredLightTheSkyIsUnoccluded) {
  const auto volume = phantom("ball", 24);
  auto light = pictureLight(nullptr);
  for (std::size_t i = 0; i < 9; ++i)
    light->irradianceSh[i] = glm::vec3(i == 0 ? 20.0f : 1.0f + static_cast<float>(i % 4));
  draw(volume, light, {});
  expectIrradiance(
      [&](auto, glm::dvec3 n) {
        double y[9];
        gi::evaluateSh(3, n, y);
        glm::dvec3 e(0.0);
        for (std::size_t i = 0; i < 9; ++i) e += y[i] * glm::dvec3(light->irradianceSh[i]);
        return glm::max(e, glm::dvec3(0.0));
      },
      2e-4, 2e-4);
  EXPECT_EQ(stateOf("light"), render::PassState::skipped);
}

TEST_F(LightGlTest, LampsWithoutShadowsAreTheirFormulas) {
  const auto volume = phantom("ball", 24);
  auto light = pictureLight(nullptr);
  const glm::dvec3 centre = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
  gi::LampLight point, sphere, sun;
  point.positionMm = centre + glm::dvec3(0.0, -60.0, 0.0);
  point.power = {3000.0, 2000.0, 1000.0};
  sphere.kind = scene::LampKind::sphere;
  sphere.positionMm = centre + glm::dvec3(80.0, -20.0, 0.0);
  sphere.radiusMm = 5.0;
  sphere.power = {1.0, 2.0, 3.0};
  sun.kind = scene::LampKind::directional;
  sun.toward = glm::normalize(glm::dvec3(0.0, -1.0, 2.0));
  sun.power = glm::dvec3(0.5);
  light->lampLights = {point, sphere, sun};
  draw(volume, light, {});
  const glm::dmat4 world = volume->grid().geometry().worldFromVoxel;
  expectIrradiance(
      [&](glm::dvec3 voxel, glm::dvec3 n) {
        const glm::dvec3 x = world * glm::dvec4(voxel, 1.0);
        const glm::dvec3 a = point.positionMm - x, b = sphere.positionMm - x;
        glm::dvec3 e = point.power * std::max(glm::dot(n, a), 0.0) / std::pow(glm::length(a), 3.0);
        e += sphere.power * std::numbers::pi * 25.0 * std::max(glm::dot(n, b), 0.0) /
             std::pow(glm::length(b), 3.0);
        return e + sun.power * std::max(glm::dot(n, sun.toward), 0.0);
      },
      1e-3, 1e-4);
}

// The sky's light and the lamps' lie in one texel and are baked at their own pace.
TEST_F(LightGlTest, SkyAndLampsAddUp) {
  const auto volume = phantom("ball", 24);
  for (const char* precision : {"half", "r11g11b10"})
    for (const int channels : {1, 3}) {
      const auto sky = emptyLattice(dimsOf(volume), 1.0, {gi::LightContent::Kind::irradiance, channels, 0});
      const auto lamps = emptyLattice(dimsOf(volume), 1.0);
      writeAll(*sky, [](glm::ivec3) { return constant({2.0f, 4.0f, 8.0f}); });
      writeAll(*lamps, [](glm::ivec3) { return constant({1.0f, 0.5f, 0.25f}); });
      auto light = pictureLight(sky);
      light->lamps = lamps;
      light->skyScale = {0.5f, 1.0f, 2.0f};
      draw(volume, light, {std::string("gi.precision=") + precision, "gi.interpolation=trilinear"});
      const glm::dvec3 stored = channels == 1 ? glm::dvec3(2.0) : glm::dvec3(2.0, 4.0, 8.0);
      expectIrradiance(
          [&](auto, auto) { return stored * glm::dvec3(0.5, 1.0, 2.0) + glm::dvec3(1.0, 0.5, 0.25); }, 1e-5);
      light = std::make_shared<gi::PictureLight>(*light);
      light->lamps = emptyLattice(dimsOf(volume), 1.0);
      light->version = 2;
      draw(volume, light, {std::string("gi.precision=") + precision, "gi.interpolation=trilinear"});
      expectIrradiance([&](auto, auto) { return stored * glm::dvec3(0.5, 1.0, 2.0); }, 1e-5);
    }
}

// Of light probes and lamps in lux as of those of a night.
TEST_F(LightGlTest, LightOfAnyUnitIsFound) {
  const auto volume = phantom("ball", 24);
  for (const float level : {1e-9f, 3e-7f, 1.0f, 1e5f, 3e6f, 1e12f})
    for (const char* precision : {"half", "r11g11b10"})
      for (const char* interpolation : {"trilinear", "weighted"}) {
        const auto sky = emptyLattice(dimsOf(volume), 1.0), lamps = emptyLattice(dimsOf(volume), 1.0);
        writeAll(*sky, [&](glm::ivec3) { return constant(level * glm::vec3(1.0f, 0.5f, 0.25f)); });
        writeAll(*lamps, [&](glm::ivec3) { return constant(level * glm::vec3(0.25f, 0.5f, 2.0f)); });
        auto light = pictureLight(sky);
        light->lamps = lamps;
        light->irradianceSh[0] = glm::vec3(level / 0.2820948f);
        light->lampsIrradiance = level;
        draw(volume, light,
             {std::string("gi.precision=") + precision, std::string("gi.interpolation=") + interpolation});
        SCOPED_TRACE(std::to_string(level) + " " + precision + " " + interpolation);
        expectIrradiance([&](auto, auto) { return static_cast<double>(level) * glm::dvec3(1.25, 1.0, 2.25); },
                         0.02);
      }
}

TEST_F(LightGlTest, BothPrecisionsRoundToTheirNearest) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  const auto e = [](glm::ivec3 t) {
    return glm::vec3(std::exp2(static_cast<float>(t.x) - 10.3f), 0.37f * static_cast<float>(t.y + 1),
                     1e-3f * static_cast<float>(t.z + 1));
  };
  writeAll(*lattice, [&](glm::ivec3 t) { return constant(e(t)); });
  for (const bool half : {true, false}) {
    draw(volume, pictureLight(lattice),
         {half ? "gi.precision=half" : "gi.precision=r11g11b10", "gi.interpolation=nearest"});
    const glm::dvec3 step =
        half ? glm::dvec3(1.0 / 2048.0) : glm::dvec3(1.0 / 128.0, 1.0 / 128.0, 1.0 / 64.0);
    for (std::size_t i = 0; i < hit_.values.size(); ++i) {
      if (hit_.values[i] == 0.0f) continue;
      const glm::dvec3 want(e(glm::ivec3(at(voxel_, i) + 0.5))), got = at(irradiance_, i);
      for (int c = 0; c < 3; ++c) ASSERT_NEAR(got[c], want[c], want[c] * step[c] * 1.001) << half << " " << c;
    }
  }
}

TEST_F(LightGlTest, ChangesAreTakenOverAndNothingElse) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  const auto light = pictureLight(lattice);
  draw(volume, light, kHalf);
  EXPECT_EQ(report_.light.resident, 0u);
  expectIrradiance([](auto, auto) { return glm::dvec3(0.0); }, 0.0);
  const auto one = [](glm::ivec3) { return constant(glm::vec3(1.0f)); };
  writeAll(*lattice, one);
  const std::size_t blocks = lattice->geometry().blockCount();
  draw(volume, light, kHalf);
  EXPECT_EQ(report_.light.uploaded, blocks);
  EXPECT_EQ(stateOf("light"), render::PassState::ran);
  EXPECT_EQ(stateOf("cast"), render::PassState::cached);
  EXPECT_FALSE(report_.surfaceChanged);
  expectIrradiance([](auto, auto) { return glm::dvec3(1.0); }, 1e-5);
  draw(volume, light, kHalf);
  EXPECT_EQ(stateOf("light"), render::PassState::cached);
  EXPECT_EQ(stateOf("irradiance"), render::PassState::cached);
  for (std::uint32_t block = 0; block < 5; ++block)
    writeBlock(*lattice, block, [](glm::ivec3) { return constant(glm::vec3(2.0f)); });
  draw(volume, light, kHalf);
  EXPECT_EQ(report_.light.uploaded, 5u);
  EXPECT_EQ(report_.light.resident, blocks);
  lattice->clear();
  draw(volume, light, kHalf);
  EXPECT_EQ(report_.light.resident, 0u);
  expectIrradiance([](auto, auto) { return glm::dvec3(0.0); }, 0.0);
  writeAll(*lattice, one);
  draw(volume, light, kHalf);
  expectIrradiance([](auto, auto) { return glm::dvec3(1.0); }, 1e-5);
  draw(volume, light, with(kHalf, {"camera.fov=29"}));
  EXPECT_TRUE(report_.surfaceChanged);
  EXPECT_EQ(stateOf("light"), render::PassState::cached);
  EXPECT_EQ(stateOf("irradiance"), render::PassState::ran);
}

// A look that reads no gradients leaves them to those who do.
TEST_F(LightGlTest, IrradianceIsTheSameUnderEveryLook) {
  const auto volume = phantom("ball", 24);
  auto light = pictureLight(nullptr);
  light->irradianceSh[2] = glm::vec3(0.5f, 1.0f, 2.0f);  // by where the normal looks
  draw(volume, light, {"look.mode=gi"});
  const std::vector<float> expected = irradiance_.values;
  for (const char* look : {"depth", "normal", "lambert", "mean_curvature", "flow"})
    for (const char* opacity : {"1", "0.5"}) {
      draw(volume, light, {std::string("look.mode=") + look, std::string("isosurface.opacity=") + opacity});
      std::size_t differing = 0;
      for (std::size_t i = 0; i < expected.size(); ++i)
        if (std::memcmp(&irradiance_.values[i], &expected[i], sizeof(float)) != 0) ++differing;
      EXPECT_EQ(differing, 0u) << look << " at opacity " << opacity;
    }
}

TEST_F(LightGlTest, LightOfAVolumeGoesWithItUnderAnyLook) {
  auto lattice = emptyLattice(glm::ivec3(24), 1.0);
  writeAll(*lattice, [](glm::ivec3) { return constant(glm::vec3(1.0f)); });
  const std::weak_ptr<gi::LightLattice> watched = lattice;
  draw(phantom("ball", 24), pictureLight(lattice), kHalf);
  lattice.reset();
  ASSERT_FALSE(watched.expired());
  const auto drawLambert = [this](const std::shared_ptr<const volume::PreparedVolume>& volume) {
    scene::Scene scene;
    scene.look.mode = scene::LookMode::lambert;
    scene.surfaces.front().value = 0.0;
    renderer_->setVolume(volume);
    renderer_->setLight(nullptr);
    render::FrameRequest request;
    request.size = {32, 32};
    return renderer_->render(scene::resolve(scene, volume->facts), request).gpuBytes;
  };
  const std::size_t before = report_.light.bytes;
  ASSERT_GT(before, 0u);
  drawLambert(phantom("torus", 24));
  EXPECT_TRUE(watched.expired());
}

// More blocks than the first slots, a few in each frame.
TEST_F(LightGlTest, UploadsAreSpreadOverFramesAndTheAtlasGrows) {
  const auto volume = phantom("ball", 48);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3 t) { return constant(1.0f + glm::vec3(t) / 32.0f); });
  const std::size_t blocks = lattice->geometry().blockCount();
  ASSERT_GT(blocks, 128u);
  const std::size_t slot = 512 * 3 * 4;
  int frames = 0;
  do {
    draw(volume, pictureLight(lattice), kHalf, 40 * slot + 1);
    EXPECT_LE(report_.light.uploaded, 40u);
    ASSERT_LT(++frames, 100);
  } while (report_.light.pending);
  EXPECT_EQ(frames, static_cast<int>((blocks + 39) / 40));
  EXPECT_EQ(report_.light.resident, blocks);
  EXPECT_GE(report_.gpuBytes, blocks * slot);
  expectIrradiance([](glm::dvec3 voxel, auto) { return 1.0 + voxel / 32.0; }, kHalfStep, 1e-5);
}

TEST_F(LightGlTest, WhatDoesNotFitIsLocalAndReported) {
  const auto volume = phantom("ball", 96);
  const auto lattice = emptyLattice(dimsOf(volume), 2.0);
  writeAll(*lattice, [](glm::ivec3) { return constant(glm::vec3(1.0f)); });
  auto light = pictureLight(lattice);
  light->irradianceSh[0] =
      glm::vec3(static_cast<float>(std::sqrt(4.0 * std::numbers::pi)));  // E = 1, as it is stored
  const Settings small = with(kHalf, {"memory.gpu_budget_mb=64", "memory.layout=whole"});
  draw(volume, light, small);
  EXPECT_GT(report_.light.withoutRoom, 0u);
  EXPECT_GT(report_.light.resident, 0u);
  EXPECT_LE(report_.light.bytes, std::size_t{64} << 20);
  EXPECT_FALSE(report_.light.pending);
  expectIrradiance([](auto, auto) { return glm::dvec3(1.0); }, 1e-4);
  draw(volume, light, with(kHalf, {"memory.layout=whole"}));
  EXPECT_EQ(report_.light.withoutRoom, 0u);
  EXPECT_EQ(report_.light.resident, lattice->geometry().blockCount());
}

TEST_F(LightGlTest, AnAxisOfOneTexelIsRead) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 0.01);
  ASSERT_EQ(lattice->geometry().dims, glm::ivec3(1));
  writeAll(*lattice, [](glm::ivec3) { return constant({1.0f, 2.0f, 3.0f}); });
  for (const char* interpolation : {"closest_isovalue", "nearest", "trilinear", "tricubic", "weighted"}) {
    draw(volume, pictureLight(lattice),
         {"gi.precision=half", std::string("gi.interpolation=") + interpolation});
    expectIrradiance([](auto, auto) { return glm::dvec3(1.0, 2.0, 3.0); }, 1e-5);
  }
}

TEST_F(LightGlTest, TheInnerSideHasLocalLight) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3) { return constant(glm::vec3(1.0f)); });
  auto light = pictureLight(lattice);
  light->irradianceSh[0] = glm::vec3(7.0f * static_cast<float>(std::sqrt(4.0 * std::numbers::pi)));
  draw(volume, light, with(kHalf, {"isosurface.inside=below"}));
  expectIrradiance([](auto, auto) { return glm::dvec3(7.0); }, 1e-5);
}

// Bricks change where voxels lie, not where light does.
TEST_F(LightGlTest, BricksShowTheSameLight) {
  const auto volume = phantom("ball", 48);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3 t) { return constant(1.0f + glm::vec3(t) / 32.0f); });
  for (const char* interpolation : {"closest_isovalue", "trilinear", "weighted"}) {
    const Settings settings = {"gi.precision=half", std::string("gi.interpolation=") + interpolation};
    draw(volume, pictureLight(lattice), with(settings, {"picture.executor=gpu"}));
    const std::vector<float> whole = irradiance_.values;
    draw(volume, pictureLight(lattice), with(settings, {"memory.layout=bricks", "picture.executor=gpu"}));
    ASSERT_TRUE(report_.bricks.inUse);
    ASSERT_EQ(whole.size(), irradiance_.values.size());
    for (std::size_t i = 0; i < whole.size(); ++i)
      ASSERT_TRUE(std::isnan(whole[i]) || whole[i] == irradiance_.values[i]) << i;
  }
}

// Codes on the GPU against the same codes decoded here; a turned environment is other coefficients.
TEST_F(LightGlTest, TransferIsTheDotProductOfItsCodes) {
  const auto volume = phantom("ball", 24);
  for (const int channels : {1, 3})
    for (const int bits : {32, 96, 7 * 16}) {
      const gi::LightContent content{gi::LightContent::Kind::transfer, channels, 3};
      const auto components = static_cast<std::size_t>(content.components());
      const auto lattice = emptyLattice(dimsOf(volume), 1.0, content);
      const auto transfer = [&](glm::ivec3 t) {
        std::vector<float> means(components);
        for (std::size_t i = 0; i < components; ++i)
          means[i] =
              (i % 9 == 0 ? 1.0f : 0.0f) +
              0.1f * std::sin(static_cast<float>(i + 1) * 0.3f * static_cast<float>(t.x + 2 * t.y + 3 * t.z));
        return means;
      };
      writeAll(*lattice, [&](glm::ivec3 t) { return TexelLight{100, {0.0f, 0.0f, 1.0f}, transfer(t)}; });
      auto light = pictureLight(lattice);
      light->skyScale = glm::vec3(9.0f);  // the environment's coefficients have it already
      light->basis = test::basisOf(*lattice, 7, bits);
      ASSERT_NE(light->basis, nullptr);
      for (int turn = 0; turn < 2; ++turn) {
        light = std::make_shared<gi::PictureLight>(*light);
        light->environment.assign(9, glm::vec3(0.0f));
        light->environment[0] = glm::vec3(1.0f, 2.0f, 3.0f);
        light->environment[turn == 0 ? 1 : 3] = glm::vec3(0.5f, 0.2f, 0.7f);
        light->version = static_cast<std::uint64_t>(10 + turn);
        draw(volume, light, {"gi.interpolation=nearest"});
        EXPECT_EQ(stateOf("light"), turn == 0 ? render::PassState::ran : render::PassState::cached);
        const gi::TransferBasis& basis = *light->basis;
        expectIrradiance(
            [&](glm::dvec3 voxel, auto) {
              std::vector<std::uint32_t> codes(basis.words());
              basis.encode(transfer(glm::ivec3(voxel + 0.5)), codes);
              const std::vector<float> decoded = test::decoded(basis, codes);
              glm::dvec3 e(0.0);
              for (int c = 0; c < 3; ++c)
                for (std::size_t i = 0; i < 9; ++i)
                  e[c] += static_cast<double>(
                              decoded[(channels == 1 ? 0 : static_cast<std::size_t>(c)) * 9 + i]) *
                          static_cast<double>(light->environment[i][c]);
              return glm::max(e, glm::dvec3(0.0));
            },
            1e-4, 1e-4);
      }
    }
}

// Colour = albedo E / pi 2^exposure.
TEST_F(LightGlTest, TheLookIsReflectedIrradiance) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3) { return constant({0.5f, 1.0f, 2.0f}); });
  auto light = pictureLight(lattice);
  light->automaticExposure = -1.0f;
  for (const char* exposure : {"auto", "2"}) {
    draw(volume, light,
         with(kHalf, {"isosurface.albedo=0.8,0.5,0.2",
                      std::string("picture.exposure=") + (exposure[0] == 'a' ? "auto" : exposure)}));
    const render::LinearImage linear = renderer_->readLinear();
    const double scale = (exposure[0] == 'a' ? 0.5 : 4.0) / std::numbers::pi;
    for (std::size_t i = 0; i < hit_.values.size(); ++i) {
      if (hit_.values[i] == 0.0f) continue;
      const glm::dvec3 want = scale * glm::dvec3(0.8, 0.5, 0.2) * glm::dvec3(0.5, 1.0, 2.0);
      for (int c = 0; c < 3; ++c)
        ASSERT_NEAR(linear.rgba[4 * i + static_cast<std::size_t>(c)], want[c], 2e-3 * want[c]);
    }
    expectIrradiance([](auto, auto) { return glm::dvec3(0.5, 1.0, 2.0); }, 1e-5);  // without exposure
  }
}

// Behind a transparent shell its far side is seen, from inside: local light.
TEST_F(LightGlTest, TransparentSurfacesHaveTheirLight) {
  const auto volume = phantom("ball", 24);
  const auto lattice = emptyLattice(dimsOf(volume), 1.0);
  writeAll(*lattice, [](glm::ivec3) { return constant(glm::vec3(1.0f)); });
  auto light = pictureLight(lattice);
  light->automaticExposure = static_cast<float>(std::log2(std::numbers::pi));  // colour = albedo E
  light->irradianceSh[0] =
      glm::vec3(0.5f * static_cast<float>(std::sqrt(4.0 * std::numbers::pi)));  // E = 0.5
  draw(volume, light, with(kHalf, {"isosurface.albedo=1,1,1", "isosurface.opacity=0.5"}));
  const render::LinearImage linear = renderer_->readLinear();
  const std::size_t middle = (48 * 96 + 48);
  // Its front shows its shadow in part; the rest is local light. A white shell loses none on its inner side.
  const double shadow = scene::shadowShown(scene::meanOpacity(0.5, 1.0));
  EXPECT_NEAR(linear.rgba[4 * middle], 0.5 * (0.5 + 0.5 * shadow) + 0.5 * 0.5 * 0.5, 2e-3);
  const std::size_t both = renderer_->hitVoxels().size();
  const auto front = static_cast<std::size_t>(std::count(hit_.values.begin(), hit_.values.end(), 1.0f));
  EXPECT_GT(both, front + front / 2);
  draw(volume, light, with(kHalf, {"isosurface.albedo=1,1,1"}));
  EXPECT_EQ(renderer_->hitVoxels().size(), front);
}

TEST_F(LightGlTest, HitVoxelsAreTheSurfacePoints) {
  const auto volume = phantom("ball", 24);
  draw(volume, pictureLight(nullptr), {});
  const std::vector<glm::vec3> hits = renderer_->hitVoxels().outer;
  std::size_t next = 0;
  for (int y = 95; y >= 0; --y)  // bottom row first
    for (int x = 0; x < 96; ++x) {
      const auto i = static_cast<std::size_t>(y * 96 + x);
      if (hit_.values[i] == 0.0f) continue;
      ASSERT_LT(next, hits.size());
      EXPECT_EQ(glm::dvec3(hits[next++]), at(voxel_, i));
    }
  EXPECT_EQ(next, hits.size());
}

TEST_F(LightGlTest, WithoutLightTheImageIsUnknown) {
  draw(phantom("ball", 24), nullptr, {});
  EXPECT_TRUE(std::all_of(irradiance_.values.begin(), irradiance_.values.end(),
                          [](float v) { return std::isnan(v); }));
  const render::LinearImage linear = renderer_->readLinear();  // the look itself shows a neutral sky
  EXPECT_GT(linear.rgba[4 * (48 * 96 + 48)], 0.1f);
}

// The picture of a volume out of sight is the environment: what lies ahead is in the middle.
TEST_F(LightGlTest, TheEnvironmentIsBehindTheSurface) {
  std::vector<glm::vec3> pixels(64 * 32, glm::vec3(0.0f));
  const gi::Environment directions = gi::Environment(64, 32, pixels);
  for (int y = 0; y < 32; ++y)
    for (int x = 0; x < 64; ++x)
      pixels[static_cast<std::size_t>(y * 64 + x)] =
          0.2f + 0.1f * glm::vec3(directions.directionOf(x + 0.5, y + 0.5));
  auto light = pictureLight(nullptr);
  light->background = std::make_shared<gi::Environment>(64, 32, pixels);
  light->backgroundScale = 2.0f;
  const glm::dmat3 world = glm::dmat3(gi::worldFromEnvironment(glm::dquat(0.5, 0.3, -0.7, 0.4)));
  light->environmentFromWorld = glm::mat3(glm::transpose(world));
  draw(phantom("ball", 24), light,
       {"camera.eye=0,-900,0", "camera.target=300,-900,40", "camera.up=0,0,1", "camera.fov=60",
        "picture.exposure=1"});
  const render::ColorImage picture = renderer_->readColor();
  for (int y = 2; y < 96; y += 9)
    for (int x = 2; x < 96; x += 9) {
      const auto i = static_cast<std::size_t>(y * 96 + x);
      ASSERT_EQ(hit_.values[i], 0.0f);
      const glm::dvec3 d = glm::transpose(world) * glm::normalize(ray({x, y}, {96, 96}).direction);
      const glm::dvec3 shown = scene::filmic(4.0 * (0.2 + 0.1 * d));
      for (int c = 0; c < 3; ++c) {
        const double srgb = base::encodeSrgb(shown[c]);
        EXPECT_NEAR(picture.rgba[4 * i + static_cast<std::size_t>(c)] / 255.0, srgb, 0.012) << x << " " << y;
      }
    }
}

}  // namespace
}  // namespace isolux::test
