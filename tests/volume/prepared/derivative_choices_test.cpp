#include "volume/prepared/derivative_choices.h"
#include "tests/support/volumes.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"

namespace isolux::volume {
namespace {

DerivativeChoice chosen(Grid grid, const DerivativeQuestion& question) {
  base::Progress progress;
  return test::prepared(std::move(grid))->derivativeChoices->choose(question, progress);
}

TEST(DerivativeChoices, NoiseFreeDataHaveNoScale) {
  for (const char* name : {"ball", "torus", "gyroid"}) {
    const DerivativeChoice choice = chosen(test::phantomGrid(name, 64), {0.0});
    EXPECT_EQ(choice.scaleMm, 0.0) << name << ": " << choice.scaleReason;
    EXPECT_EQ(choice.normalScaleMm, 0.0) << name << ": " << choice.normalReason;
  }
  for (const double isovalue : {-300.0, 300.0}) {
    const DerivativeChoice choice = chosen(test::phantomGrid("head", 128), {isovalue});
    EXPECT_EQ(choice.scaleMm, 0.0) << isovalue << ": " << choice.scaleReason;
    EXPECT_EQ(choice.normalScaleMm, 0.0) << isovalue << ": " << choice.normalReason;
  }
  EXPECT_EQ(chosen(test::phantomGrid("torus", test::anisotropicGeometry(64)), {0.0}).scaleMm, 0.0);
}

TEST(DerivativeChoices, ScalesGrowWithTheNoise) {
  const Grid head = test::phantomGrid("head", 128);
  double scale = 0.0, normalScale = 0.0;
  for (const double noise : {0.0, 10.0, 40.0, 80.0}) {
    const DerivativeChoice choice = chosen(test::withNoise(head, noise, glm::dvec3(0.0), 5), {-300.0});
    EXPECT_GE(choice.scaleMm, scale) << noise;
    EXPECT_GE(choice.normalScaleMm, normalScale) << noise;
    EXPECT_LE(choice.normalScaleMm, choice.scaleMm) << noise;
    EXPECT_LE(choice.curvatureNoise[1], choice.curvatureNoise[0]);
    EXPECT_NEAR(choice.noise, noise, 0.15 * noise + 0.3);
    scale = choice.scaleMm;
    normalScale = choice.normalScaleMm;
  }
  EXPECT_GT(scale, head.geometry().spacingMm().x);
  EXPECT_GT(normalScale, 0.0);
}

// Millimetres, not voxels; the same whatever the unit of values is.
TEST(DerivativeChoices, AreThoseOfTheWorld) {
  const glm::ivec3 dims(72);
  const auto torus = [&](double spacing, double unit) {
    const GridGeometry geometry = GridGeometry::make(dims, glm::dvec3(spacing));
    const Grid clean = test::phantomGrid("torus", geometry);
    std::vector<float> values = test::blurredNoise(dims, glm::dvec3(0.0), 2);
    std::size_t i = 0;
    for (int z = 0; z < dims.z; ++z)
      for (int y = 0; y < dims.y; ++y)
        for (int x = 0; x < dims.x; ++x, ++i)
          values[i] = static_cast<float>(unit * (clean.value(x, y, z) / spacing + 0.3 * values[i]));
    return chosen(Grid(geometry, std::move(values)), {0.0});
  };
  const DerivativeChoice one = torus(1.0, 1.0), large = torus(4.0, 1e4);
  EXPECT_GT(one.scaleMm, 0.0);
  EXPECT_DOUBLE_EQ(large.scaleMm, 4.0 * one.scaleMm);
  EXPECT_DOUBLE_EQ(large.normalScaleMm, 4.0 * one.normalScaleMm);
  EXPECT_NEAR(large.noise, 1e4 * one.noise, 1.0 * one.noise);
}

TEST(DerivativeChoices, ThickSlicesAskForHalfOfTheirDistance) {
  const GridGeometry geometry = test::anisotropicGeometry(64);
  const Grid grid = test::withNoise(test::phantomGrid("torus", geometry), 0.1, glm::dvec3(0.0), 1);
  EXPECT_GE(chosen(grid, {0.0}).scaleMm, 1.25);
}

// A head whose slices are those of a scanner 2.5 voxels apart, interpolated linearly. The noise asks for no
// scale, nor does it where each slice was measured.
TEST(DerivativeChoices, InterpolatedSlicesAskForSixTenthsOfTheirDistance) {
  constexpr double distance = 2.5;
  const Grid head = test::phantomGrid("head", 128);
  const Grid slices = test::gridOfVoxels(head.geometry(), [&](glm::dvec3 p) {
    const auto valueAt = [&](double slice) {
      const double z = std::min(slice * distance, 126.0), part = z - std::floor(z);
      const glm::ivec3 at(p.x, p.y, z);
      return std::lerp(head.value(at.x, at.y, at.z), head.value(at.x, at.y, at.z + 1), part);
    };
    const double slice = p.z / distance, before = std::floor(slice);
    return std::lerp(valueAt(before), valueAt(before + 1.0), slice - before);
  });
  for (const double isovalue : {300.0, 500.0}) {
    const auto choose = [&](const Grid& grid) {
      return chosen(test::withNoise(grid, 5.0, glm::dvec3(0.0), 3), {isovalue});
    };
    const DerivativeChoice terraces = choose(slices), smooth = choose(head);
    EXPECT_NEAR(terraces.scaleMm, 0.6 * distance * head.geometry().spacingMm().z, 0.02)
        << terraces.scaleReason;
    EXPECT_NE(terraces.scaleReason.find("interpolated"), std::string::npos) << terraces.scaleReason;
    EXPECT_EQ(smooth.scaleMm, 0.0) << smooth.scaleReason;
    EXPECT_EQ(terraces.normalScaleMm, 0.0) << terraces.normalReason;
  }
}

// A head whose noise hides much of it at scale 0, though its edges are clear: the truth (the head without
// noise) says that the scale has less error, in all and in the median.
TEST(DerivativeChoices, MuchWithoutConfidenceRefusesZeroWhereAScaleHasLessError) {
  const Grid head = test::phantomGrid("head", 128);
  const DerivativeChoice skin = chosen(test::withNoise(head, 10.0, glm::dvec3(0.0), 1), {-300.0});
  EXPECT_NEAR(skin.scaleMm, std::sqrt(0.5) * head.geometry().spacingMm().x, 1e-3) << skin.scaleReason;
  EXPECT_NE(skin.scaleReason.find("of the visible surface"), std::string::npos) << skin.scaleReason;
  // Bone has detail everywhere: a scale loses more of it than it gains, and that is said.
  const DerivativeChoice bone = chosen(test::withNoise(head, 10.0, glm::dvec3(0.0), 1), {300.0});
  EXPECT_EQ(bone.scaleMm, 0.0);
  EXPECT_NE(bone.scaleReason.find("of the visible surface, any scale loses more"), std::string::npos)
      << bone.scaleReason;
}

TEST(DerivativeChoices, CompleteOnlyWhatIsEmpty) {
  const auto volume = test::prepared(test::phantomGrid("torus", 48, 0.5));
  scene::Scene scene;
  scene.surfaces.front().value = 0.0;
  EXPECT_FALSE(volume->derivativeChoices->completeIfChosen(scene));
  EXPECT_FALSE(scene.derivatives.noise.has_value());
  base::Progress progress;
  scene::Scene full = scene;
  volume->derivativeChoices->complete(full, progress);
  const DerivativeChoice choice = volume->derivativeChoices->choose({0.0}, progress);
  EXPECT_EQ(full.derivatives.noise, choice.noise);
  EXPECT_EQ(full.derivatives.scale, choice.scaleMm);
  EXPECT_EQ(full.derivatives.normalScale, choice.normalScaleMm);
  EXPECT_TRUE(volume->derivativeChoices->completeIfChosen(scene));
  EXPECT_TRUE(scene == full);

  scene::Scene set;
  set.surfaces.front().value = 0.0;
  set.derivatives.noise = 0.0;
  set.derivatives.normalScale = 3.0;
  volume->derivativeChoices->complete(set, progress);
  EXPECT_EQ(set.derivatives.noise, 0.0);
  EXPECT_EQ(set.derivatives.scale, 0.0);  // what is called free of noise needs none
  EXPECT_EQ(set.derivatives.normalScale, 3.0);
}

TEST(DerivativeChoices, WithoutASurfaceThereIsNoScale) {
  const DerivativeChoice choice = chosen(test::phantomGrid("ball", 24, 0.5), {1e6});
  EXPECT_EQ(choice.scaleMm, 0.0);
  EXPECT_EQ(choice.normalScaleMm, 0.0);
  EXPECT_GT(choice.noise, 0.0);
  EXPECT_EQ(chosen(test::phantomGrid("torus", 48, 0.5), {0.0, scene::Field::trilinear}).scaleMm, 0.0);
}

TEST(DerivativeChoices, ASpikeOfMissingVoxelsIsNoTrouble) {
  const GridGeometry geometry = test::isotropicGeometry(48);
  auto voxels = std::get<std::vector<float>>(test::phantomGrid("ball", geometry).voxels());
  for (std::size_t i = 0; i < voxels.size(); i += 97) voxels[i] = std::numeric_limits<float>::quiet_NaN();
  const DerivativeChoice choice = chosen(Grid(geometry, voxels), {0.0});
  EXPECT_TRUE(std::isfinite(choice.noise) && std::isfinite(choice.scaleMm));
}

// Missing voxels that are out of the spline's reach change nothing: outside of a field of view, or a single
// one.
TEST(DerivativeChoices, MissingVoxelsSomeWayOffChangeNoScale) {
  const GridGeometry geometry = test::unitGeometry(glm::ivec3(64));
  const auto noisy = [&](double missingFrom, bool one) {
    std::vector<float> voxels =
        std::get<std::vector<float>>(test::gridOfVoxels(geometry, [&](glm::dvec3 p) {
                                       const double r = glm::distance(p, glm::dvec3(31.5));
                                       return r > missingFrom ? std::nan("") : 20.0 - r;
                                     }).voxels());
    for (std::size_t i = 0; i < voxels.size(); ++i)
      voxels[i] += static_cast<float>(0.3 * base::normalNoise(1, i));
    if (one) voxels[static_cast<std::size_t>((31 * 64 + 31) * 64 + 31 + 6)] = std::nanf("");
    return Grid(geometry, voxels);
  };
  const DerivativeChoice whole = chosen(noisy(1e9, false), {0.0});
  ASSERT_GT(whole.scaleMm, 0.0);
  for (const DerivativeChoice& choice :
       {chosen(noisy(27.0, false), {0.0}), chosen(noisy(1e9, true), {0.0})}) {
    EXPECT_GT(choice.scaleMm, whole.scaleMm / 1.5) << choice.scaleReason;
    EXPECT_LT(choice.scaleMm, whole.scaleMm * 1.5) << choice.scaleReason;
  }
}

TEST(DerivativeChoices, MissingVoxelsAllAroundTheSurfaceAreTheReason) {
  const DerivativeChoice choice = chosen(test::gridOfVoxels(test::unitGeometry(glm::ivec3(48)),
                                                            [](glm::dvec3 p) {
                                                              const double r =
                                                                  glm::distance(p, glm::dvec3(23.5));
                                                              return r > 16.5 ? std::nan("") : 15.0 - r;
                                                            }),
                                         {0.0});
  EXPECT_NE(choice.scaleReason.find("missing voxels"), std::string::npos) << choice.scaleReason;
}

}  // namespace
}  // namespace isolux::volume
