#include "volume/field/curvature.h"
#include "tests/support/volumes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <tbb/blocked_range.h>
#include <tbb/parallel_reduce.h>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include "base/random.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/rays.h"
#include "tests/support/unwatched.h"
#include "volume/field/reconstruct.h"
#include "volume/hit/exact_cubic_hit.h"
#include "volume/statistics/noise_estimate.h"

namespace isolux::volume {
namespace {

using glm::dmat3;
using glm::dvec3;

dvec3 toWorld(const GridGeometry& geometry, dvec3 voxel) {
  return dvec3(geometry.worldFromVoxel * glm::dvec4(voxel, 1.0));
}

// What holds wherever there is a gradient at all.
void expectFrame(const PrincipalCurvature& k) {
  EXPECT_GE(k.kappa1, k.kappa2);
  EXPECT_NEAR(glm::length(k.normal), 1.0, 1e-12);
  EXPECT_NEAR(glm::length(k.direction1), 1.0, 1e-12);
  EXPECT_NEAR(glm::dot(k.direction1, k.normal), 0.0, 1e-12);
  EXPECT_LT(glm::distance(k.direction2, glm::cross(k.normal, k.direction1)), 1e-12);
}

dmat3 randomSymmetric(std::uint64_t i) {
  const dvec3 a = test::randomVector(i, 31) - 0.5, b = test::randomVector(i, 32) - 0.5;
  return dmat3(a.x, b.x, b.y, b.x, a.y, b.z, b.y, b.z, a.z);
}

TEST(PrincipalCurvature, FollowsClosedFormDerivativesOfEveryShape) {
  for (const char* name : {"ball", "torus", "cylinder", "plane", "saddle", "gyroid", "marschner_lobb"}) {
    const GridGeometry geometry = test::obliqueLeftHandedGeometry(64);
    const auto field = test::analyticField(name, geometry);
    for (std::uint64_t i = 0; i < 500; ++i) {
      const dvec3 p = toWorld(geometry, 63.0 * test::randomVector(i, 1));
      const test::Derivatives d = field->at(p);
      if (!(glm::length(d.gradient) > 1e-6)) continue;
      const PrincipalCurvature k = principalCurvature(d.gradient, d.hessian);
      const test::Curvature reference = field->curvature(p);
      const double scale = std::abs(reference.kappa1) + std::abs(reference.kappa2) + 1e-6;
      EXPECT_NEAR(k.kappa1, reference.kappa1, 1e-7 * scale) << name;
      EXPECT_NEAR(k.kappa2, reference.kappa2, 1e-7 * scale) << name;
      expectFrame(k);
      EXPECT_LT(glm::distance(k.normal, field->normal(p)), 1e-12);
    }
  }
}

// f = x y: its flowlines are the hyperbolas x^2 - y^2 = c, of curvature |c| / (x^2 + y^2)^(3/2).
TEST(PrincipalCurvature, FlowlinesOfXyAreHyperbolasAndOfABallStraight) {
  for (std::uint64_t i = 0; i < 1000; ++i) {
    const dvec3 p = 20.0 * (test::randomVector(i, 5) - 0.5);
    const double r = std::hypot(p.x, p.y), reference = std::abs(p.x * p.x - p.y * p.y) / (r * r * r);
    for (const double outward : {-1.0, 1.0}) {
      const PrincipalCurvature k =
          principalCurvature({p.y, p.x, 0.0}, dmat3(0, 1, 0, 1, 0, 0, 0, 0, 0), outward);
      EXPECT_NEAR(k.flowline, reference, 1e-12 * (1.0 + reference));
    }
    EXPECT_NEAR(principalCurvature(2.0 * p, dmat3(2.0)).flowline, 0.0, 1e-12);
  }
}

// By its definition: how fast the unit gradient turns along itself.
TEST(PrincipalCurvature, TheFlowlineCurvatureIsTheTurnOfTheGradientAlongItself) {
  const auto field = test::analyticField("gyroid", test::isotropicGeometry(64));
  for (std::uint64_t i = 0; i < 500; ++i) {
    const dvec3 p = toWorld(test::isotropicGeometry(64), 63.0 * test::randomVector(i, 6));
    const test::Derivatives d = field->at(p);
    if (!(glm::length(d.gradient) > 1e-2)) continue;
    const dvec3 along = glm::normalize(d.gradient);
    const double step = 1e-5;
    const dvec3 turn = glm::normalize(field->at(p + step * along).gradient) -
                       glm::normalize(field->at(p - step * along).gradient);
    const double reference = glm::length(turn) / (2.0 * step);
    EXPECT_NEAR(principalCurvature(d.gradient, d.hessian).flowline, reference, 1e-5 * (1.0 + reference));
  }
}

// The directions by their definition: the normal turns along them, dn = kappa e, and not sideways.
TEST(PrincipalCurvature, DirectionsAreThoseInWhichTheNormalTurns) {
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const dvec3 g = test::randomVector(i, 1) - 0.5;
    const dmat3 h = randomSymmetric(i);
    const PrincipalCurvature k = principalCurvature(g, h);
    expectFrame(k);
    const auto turn = [&](dvec3 direction) {  // of -g/|g| along a tangent, by the quotient rule
      const dvec3 dg = h * direction;
      return -(dg - g * (glm::dot(g, dg) / glm::dot(g, g))) / glm::length(g);
    };
    EXPECT_LT(glm::distance(turn(k.direction1), k.kappa1 * k.direction1), 1e-9 * (1.0 + std::abs(k.kappa1)));
    EXPECT_LT(glm::distance(turn(k.direction2), k.kappa2 * k.direction2), 1e-9 * (1.0 + std::abs(k.kappa2)));
  }
}

TEST(PrincipalCurvature, IsInvariantUnderRotationMirroringAndScale) {
  for (std::uint64_t i = 0; i < 2000; ++i) {
    const dvec3 g = test::randomVector(i, 1) - 0.5;
    const dmat3 h = randomSymmetric(i);
    const PrincipalCurvature k = principalCurvature(g, h);
    const double size = std::abs(k.kappa1) + std::abs(k.kappa2);
    // A rotation, and a reflection on top of it for every second.
    dmat3 q(glm::rotate(glm::dmat4(1.0), 6.0 * base::uniformNoise(3, i),
                        glm::normalize(test::randomVector(i, 4) - 0.5)));
    if (i % 2) q = q * dmat3(dvec3(-1, 0, 0), dvec3(0, 1, 0), dvec3(0, 0, 1));
    const PrincipalCurvature turned = principalCurvature(q * g, q * h * glm::transpose(q));
    EXPECT_NEAR(turned.kappa1, k.kappa1, 1e-12 * size);
    EXPECT_NEAR(turned.kappa2, k.kappa2, 1e-12 * size);
    EXPECT_LT(glm::distance(turned.normal, q * k.normal), 1e-12);
    if (k.kappa1 - k.kappa2 > 1e-3 * size) {
      EXPECT_NEAR(std::abs(glm::dot(turned.direction1, q * k.direction1)), 1.0, 1e-12);
    }
    // Values of any unit, and lengths in another one.
    for (const double unit : {1e-20, 1e20, 1e-150}) {
      const PrincipalCurvature same = principalCurvature(unit * g, unit * h);
      EXPECT_NEAR(same.kappa1, k.kappa1, 1e-12 * size);
      EXPECT_NEAR(same.kappa2, k.kappa2, 1e-12 * size);
    }
    const PrincipalCurvature larger = principalCurvature(g / 5.0, h / 25.0);
    EXPECT_NEAR(larger.kappa1, k.kappa1 / 5.0, 1e-12 * size);
    // The other side of the surface: -kappa, the largest becoming the smallest.
    const PrincipalCurvature inner = principalCurvature(g, h, 1.0);
    EXPECT_NEAR(inner.kappa1, -k.kappa2, 1e-12 * size);
    EXPECT_NEAR(inner.kappa2, -k.kappa1, 1e-12 * size);
    EXPECT_LT(glm::distance(inner.normal, -k.normal), 1e-15);
  }
}

TEST(PrincipalCurvature, EveryNormalHasABasis) {
  for (const dvec3& n : {dvec3(0, 0, 1), dvec3(0, 0, -1), dvec3(1, 0, 0), dvec3(0, -1, 0), dvec3(1e-9, 0, -1),
                         dvec3(0, 1e-200, -1), dvec3(0.0, 0.0, -0.0) + dvec3(1, 1, 0)}) {
    // A cylinder of radius 2 with this normal, along the first of two tangents.
    const dvec3 unit = glm::normalize(n);
    const dvec3 along = glm::normalize(glm::cross(unit, dvec3(0.3, -0.5, 0.8))),
                across = glm::cross(unit, along);
    const PrincipalCurvature k =
        principalCurvature(-n, -glm::length(n) * 0.5 * glm::outerProduct(across, across));
    expectFrame(k);
    EXPECT_NEAR(k.kappa1, 0.5, 1e-12);
    EXPECT_NEAR(k.kappa2, 0.0, 1e-12);
    EXPECT_NEAR(std::abs(glm::dot(k.direction1, across)), 1.0, 1e-12);
  }
}

TEST(PrincipalCurvature, IsFiniteWhereThereIsNone) {
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const dvec3& g : {dvec3(0.0), dvec3(nan, 0, 1), dvec3(infinity, 0, 0), dvec3(1e-320, 0, 0)}) {
    const PrincipalCurvature k = principalCurvature(g, dmat3(1.0));
    EXPECT_EQ(k.kappa1, 0.0);
    EXPECT_EQ(k.direction1, dvec3(0.0));
    EXPECT_EQ(curvatureConfidence(k, g, {1.0, 0.1}), 0.0);
  }
  const PrincipalCurvature broken = principalCurvature(dvec3(1, 0, 0), dmat3(nan));
  EXPECT_EQ(broken.kappa1, 0.0);
  const PrincipalCurvature unbounded = principalCurvature(dvec3(1, 0, 0), dmat3(infinity));
  EXPECT_EQ(unbounded.kappa1, 0.0);
  EXPECT_EQ(unbounded.normal, dvec3(0.0));
}

// Squares of such derivatives are none: what is squared has been brought to size 1 before.
TEST(PrincipalCurvature, IsThatOfDerivativesOfAnySize) {
  const dvec3 g(0.3, -0.5, 0.9);
  const dmat3 h(0.4, -0.1, 0.2, -0.1, -0.3, 0.5, 0.2, 0.5, 0.1);
  const PrincipalCurvature k = principalCurvature(g, h);
  for (const double unit : {1e-200, 1e200}) {
    const PrincipalCurvature other = principalCurvature(g * unit, h * unit);
    EXPECT_NEAR(other.kappa1, k.kappa1, 1e-12) << unit;
    EXPECT_NEAR(other.kappa2, k.kappa2, 1e-12) << unit;
    EXPECT_LT(glm::distance(other.direction1, k.direction1), 1e-12) << unit;
  }
}

TEST(CurvatureConfidence, IsZeroAtUmbilicsFlatsAndGradientsWithinNoiseAndOneWhereAllIsClear) {
  const GridGeometry geometry = test::isotropicGeometry(64);
  const CurvatureScale scale = curvatureScale(geometry, scene::Field::cubic, 0.001);
  const auto at = [&](const char* name, dvec3 p) {
    const test::Derivatives d = test::analyticField(name, geometry)->at(p);
    return curvatureConfidence(principalCurvature(d.gradient, d.hessian), d.gradient, scale);
  };
  const dvec3 centre(5.0, -7.0, 11.0);
  for (std::uint64_t i = 0; i < 200; ++i) {
    const dvec3 p = centre + 40.0 * (test::randomVector(i, 1) - 0.5);
    EXPECT_EQ(at("ball", p), 0.0);
    EXPECT_EQ(at("plane", p), 0.0);
    EXPECT_EQ(at("cylinder", p + dvec3(15, 0, 0)), 1.0);
    EXPECT_EQ(at("torus", p), 1.0);
  }
  const PrincipalCurvature ridge = principalCurvature(dvec3(0, 0, -1), dmat3(-1, 0, 0, 0, 0, 0, 0, 0, 0));
  double before = 1.0;
  for (double noise = 0.0; noise < 1.0; noise += 0.01) {
    const double c = curvatureConfidence(ridge, dvec3(0, 0, -1), {noise, 0.01});
    EXPECT_LE(c, before);
    EXPECT_EQ(c, noise <= 1.0 / 6.0 ? 1.0 : noise >= 1.0 / 3.0 ? 0.0 : c);
    before = c;
  }
}

// A saddle, whose two curvatures differ by twice their size: only c_s is less than 1 here.
TEST(CurvatureConfidence, GrowsWithACurvaturesSizeFromThreeToSixteenDeviations) {
  const PrincipalCurvature saddle = principalCurvature(dvec3(0, 0, -1), dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 0));
  for (const double size : {2.5, 3.0, 4.0, 6.0, 9.5, 13.0, 16.0, 20.0}) {
    const double s = std::clamp((size - 3.0) / 13.0, 0.0, 1.0);
    EXPECT_NEAR(curvatureConfidence(saddle, dvec3(0, 0, -1), {0.0, 0.01, 1.0 / size}),
                0.75 + 0.25 * s * s * (3.0 - 2.0 * s), 1e-12)
        << size;
  }
}

TEST(CurvatureConfidence, OfDataWithoutNoiseIsANumber) {
  for (const dmat3& hessian : {dmat3(0.0), dmat3(1.0), dmat3(-1.0)})
    EXPECT_EQ(curvatureConfidence(principalCurvature(dvec3(0, 0, -1), hessian), dvec3(0, 0, -1), {0.0, 0.01}),
              0.0);
}

TEST(CurvatureScale, OfAVolumeOfOneVoxelIsANumber) {
  GridGeometry geometry = test::isotropicGeometry(4);
  geometry.dims = glm::ivec3(1);
  const CurvatureScale scale = curvatureScale(geometry, scene::Field::cubic, 1.0);
  EXPECT_TRUE(std::isfinite(scale.flatCurvature));
  EXPECT_GT(scale.flatCurvature, 0.0);
}

TEST(CurvatureScale, FlatIsATenthOverTheVolumesDiagonal) {
  const GridGeometry geometry = test::isotropicGeometry(64);
  const double diagonal = 63.0 * std::sqrt(3.0) * geometry.spacingMm().x;
  EXPECT_NEAR(curvatureScale(geometry, scene::Field::cubic, 1.0).flatCurvature, 0.1 / diagonal, 1e-12);
}

// A volume of noise of standard deviation 3, seen as each of the fields.
class FieldsOfNoise {
 public:
  static constexpr int kSize = 80;
  static constexpr scene::Field kFields[3] = {scene::Field::trilinear, scene::Field::cubic,
                                              scene::Field::cubic_interpolating};

  FieldsOfNoise(const GridGeometry& geometry, std::uint64_t seed, const dvec3& blur = dvec3(0.0))
      : grid_(geometry, noise(geometry.dims, blur, seed)), coefficients_(interpolatingCoefficients(grid_)) {}

  // The mean over random places of measure(i, sample), field by field.
  template <class Measure>
  std::array<double, 3> means(const Measure& measure) const {
    std::array<double, 3> sums{};
    constexpr int count = 20000;
    for (std::uint64_t i = 0; i < count; ++i) {
      const dvec3 p = 5.0 + (kSize - 11.0) * test::randomVector(i, 1);
      const FieldSample samples[3] = {sampleTrilinear(grid_, p), sampleCubic(grid_, p),
                                      sampleCubic(coefficients_, grid_, p)};
      for (std::size_t f = 0; f < 3; ++f) sums[f] += measure(i, samples[f]) / count;
    }
    return sums;
  }

 private:
  static std::vector<float> noise(glm::ivec3 dims, const dvec3& blur, std::uint64_t seed) {
    std::vector<float> voxels = test::blurredNoise(dims, blur, seed);
    for (float& voxel : voxels) voxel *= 3.0f;
    return voxels;
  }

  Grid grid_;
  Coefficients coefficients_;
};

const dvec3 kNoiseBlurs[] = {dvec3(0.0), dvec3(0.7), dvec3(0.0, 0.4, 1.1)};

// The propagated noise against derivatives of volumes of noise.
TEST(CurvatureScale, GradientNoiseIsThatOfFieldsOfNoise) {
  for (const GridGeometry& geometry :
       {test::isotropicGeometry(FieldsOfNoise::kSize), test::obliqueLeftHandedGeometry(FieldsOfNoise::kSize)})
    for (const dvec3& blur : kNoiseBlurs) {
      const auto squares =
          FieldsOfNoise(geometry, 5, blur).means([&](std::uint64_t, const FieldSample& sample) {
            const dvec3 world = worldGradient(geometry, sample.gradient);
            return glm::dot(world, world) / 3.0;
          });
      for (std::size_t f = 0; f < 3; ++f) {
        const double measured = std::sqrt(squares[f]);
        EXPECT_NEAR(curvatureScale(geometry, FieldsOfNoise::kFields[f], 3.0, blur).gradientNoise, measured,
                    0.03 * measured)
            << f << ' ' << blur.z;
      }
    }
}

TEST(CurvatureScale, HessianNoiseIsThatOfFieldsOfNoise) {
  for (const dvec3& spacing : {dvec3(0.8), dvec3(0.8, 0.8, 2.4)})
    for (const dvec3& blur : kNoiseBlurs) {
      const GridGeometry geometry = GridGeometry::make(glm::ivec3(FieldsOfNoise::kSize), spacing);
      const auto squares =
          FieldsOfNoise(geometry, 6, blur).means([&](std::uint64_t i, const FieldSample& sample) {
            const double z = 2.0 * test::randomVector(i, 2).x - 1.0,
                         angle = 6.283185307 * test::randomVector(i, 2).y;
            const dvec3 direction(std::sqrt(1.0 - z * z) * std::cos(angle),
                                  std::sqrt(1.0 - z * z) * std::sin(angle), z);
            return std::pow(glm::dot(direction, worldHessian(geometry, sample.hessian) * direction), 2);
          });
      for (std::size_t f = 0; f < 3; ++f) {
        const double measured = std::sqrt(squares[f]);
        EXPECT_NEAR(curvatureScale(geometry, FieldsOfNoise::kFields[f], 3.0, blur).hessianNoise, measured,
                    0.04 * measured)
            << f << ' ' << blur.z << ' ' << spacing.z;
      }
    }
}

// Fields of noise at a scale: mean squares over several volumes, because smooth noise has few independent
// places.
TEST(CurvatureScale, NoiseAtAScaleIsThatOfFieldsOfNoise) {
  base::Progress progress;
  for (const dvec3& spacing : {dvec3(0.8), dvec3(0.8, 0.8, 2.4)})
    for (const dvec3& blur : kNoiseBlurs)
      for (const double scale : {0.3, 0.9, 1.5})
        for (const scene::Field field : {scene::Field::cubic, scene::Field::cubic_interpolating}) {
          const GridGeometry geometry = GridGeometry::make(glm::ivec3(64), spacing);
          double gradients = 0.0, hessians = 0.0;
          constexpr std::uint64_t volumes = 3, points = 6000;
          for (std::uint64_t seed = 0; seed < volumes; ++seed) {
            const Grid grid(geometry, test::blurredNoise(geometry.dims, blur, seed));
            const ScaledField scaled = scaledField(grid, field, scale, progress);
            for (std::uint64_t i = 0; i < points; ++i) {
              const dvec3 p = 10.0 + 43.0 * test::randomVector(i, seed);
              const FieldSample sample = sampleScaled(scaled, grid, p);
              const dvec3 g = worldGradient(geometry, sample.gradient);
              gradients += glm::dot(g, g) / 3.0 / (volumes * points);
              const dvec3 random = test::randomVector(i, seed + 50);
              const double z = 2.0 * random.x - 1.0, angle = 6.283185307 * random.y;
              const dvec3 direction(std::sqrt(1.0 - z * z) * std::cos(angle),
                                    std::sqrt(1.0 - z * z) * std::sin(angle), z);
              hessians +=
                  std::pow(glm::dot(direction, worldHessian(geometry, sample.hessian) * direction), 2) /
                  (volumes * points);
            }
          }
          const CurvatureScale expected = curvatureScale(geometry, field, 1.0, blur, scale);
          EXPECT_NEAR(expected.gradientNoise, std::sqrt(gradients), 0.03 * std::sqrt(gradients))
              << scale << ' ' << blur.z << ' ' << spacing.z;
          EXPECT_NEAR(expected.hessianNoise, std::sqrt(hessians), 0.04 * std::sqrt(hessians))
              << scale << ' ' << blur.z << ' ' << spacing.z;
        }
}

// A flat face under noise has no direction, though it bends everywhere a little.
TEST(CurvatureConfidence, NoiseOnAFlatFaceIsNoShape) {
  const GridGeometry geometry = test::isotropicGeometry(40);
  std::vector<float> voxels;
  for (int z = 0; z < 40; ++z)
    for (int y = 0; y < 40; ++y)
      for (int x = 0; x < 40; ++x)
        voxels.push_back(static_cast<float>(20.0 * z + base::normalNoise(9, voxels.size())));
  const Grid grid(geometry, std::move(voxels));
  const CurvatureScale scale = curvatureScale(geometry, scene::Field::cubic, estimateNoise(grid).at(0.0));
  double sum = 0.0;
  for (std::uint64_t i = 0; i < 3000; ++i) {
    const FieldSample sample = sampleCubic(grid, 5.0 + 29.0 * test::randomVector(i, 1));
    const dvec3 g = worldGradient(geometry, sample.gradient);
    sum += curvatureConfidence(principalCurvature(g, worldHessian(geometry, sample.hessian)), g, scale);
  }
  EXPECT_LT(sum / 3000, 0.1);
}

// From the volume's own noise, as the program does it: of noise alone next to nothing is trusted, of a clear
// edge under the same noise nearly all.
TEST(CurvatureConfidence, TellsNoiseFromEdgesByTheVolumesOwnNoise) {
  const GridGeometry geometry = test::isotropicGeometry(48);
  const double noise = 1.0, steepness = 200.0;  // data units, data units per mm
  std::vector<float> nothing(geometry.voxelCount()), edge = nothing;
  const auto cylinder = test::analyticField("cylinder", geometry);
  std::size_t i = 0;
  for (int z = 0; z < 48; ++z)
    for (int y = 0; y < 48; ++y)
      for (int x = 0; x < 48; ++x, ++i) {
        nothing[i] = static_cast<float>(noise * base::normalNoise(7, i));
        const double distance = cylinder->at(toWorld(geometry, dvec3(x + 1e-9, y, z))).value;
        edge[i] = nothing[i] + static_cast<float>(steepness * std::clamp(distance, -3.0, 3.0));
      }
  const auto confidences = [&](std::vector<float> voxels) {
    const Grid grid(geometry, std::move(voxels));
    base::Progress progress;
    const MinMaxBlocks blocks(grid, 8, progress);
    const CurvatureScale scale = curvatureScale(geometry, scene::Field::cubic, estimateNoise(grid).at(0.0));
    std::vector<double> found;
    for (std::uint64_t k = 0; k < 4000; ++k) {
      const Ray ray = test::randomRay(8 * k, grid.dims());
      const auto hit = firstHit(grid, blocks, 0.0, ray);
      if (!hit) continue;
      const FieldSample f = sampleCubic(grid, hit->voxel);
      const dvec3 g = worldGradient(geometry, f.gradient);
      found.push_back(
          curvatureConfidence(principalCurvature(g, worldHessian(geometry, f.hessian)), g, scale));
    }
    std::sort(found.begin(), found.end());
    EXPECT_GT(found.size(), 1000u);
    return found;
  };
  const std::vector<double> ofNoise = confidences(nothing), ofEdge = confidences(edge);
  EXPECT_EQ(ofNoise[ofNoise.size() * 80 / 100], 0.0);
  EXPECT_LT(ofNoise[ofNoise.size() * 95 / 100], 0.05);
  EXPECT_GT(ofEdge[ofEdge.size() * 20 / 100], 0.9);
}

struct Errors {
  double rms1 = 0.0, rms2 = 0.0;  // relative to the root mean square of the curvatures themselves
  double confident = 0.0;         // mean confidence
  int points = 0;
};

// Relative errors of the curvatures that the interpolating spline has on the surface of a closed form, at
// points found by rays, away from the border, where the repeated samples bend the field.
Errors curvatureErrors(const std::string& name, const GridGeometry& geometry, double borderVoxels,
                       double isovalue = 0.0) {
  base::Progress progress;
  const Grid grid = test::phantomGrid(name, geometry);
  const Coefficients coefficients = interpolatingCoefficients(grid);
  const MinMaxBlocks blocks = MinMaxBlocks::ofCubic(grid, &coefficients, 8, progress);
  const auto reference = test::analyticField(name, geometry);
  const CurvatureScale scale = curvatureScale(geometry, scene::Field::cubic_interpolating, 1e-6);
  struct Sum {
    double error1 = 0, error2 = 0, size = 0, confident = 0;
    int points = 0;
  };
  const Sum sum = tbb::parallel_deterministic_reduce(
      tbb::blocked_range<std::uint64_t>(0, 6000, 500), Sum(),
      [&](const tbb::blocked_range<std::uint64_t>& range, Sum s) {
        for (std::uint64_t i = range.begin(); i != range.end(); ++i) {
          const auto hit = firstHitOfField(grid, scene::Field::cubic_interpolating, &coefficients, blocks,
                                           isovalue, test::randomRay(8 * i, geometry.dims))
                               .hit;
          if (!hit) continue;
          const dvec3 fromBorder = glm::min(hit->voxel, dvec3(geometry.dims - 1) - hit->voxel);
          if (std::min({fromBorder.x, fromBorder.y, fromBorder.z}) < borderVoxels) continue;
          const FieldSample f = sampleCubic(coefficients, grid, hit->voxel);
          const dvec3 g = worldGradient(geometry, f.gradient);
          const PrincipalCurvature k = principalCurvature(g, worldHessian(geometry, f.hessian));
          const test::Curvature expected = reference->curvature(toWorld(geometry, hit->voxel));
          s.error1 += std::pow(k.kappa1 - expected.kappa1, 2);
          s.error2 += std::pow(k.kappa2 - expected.kappa2, 2);
          s.size += 0.5 * (std::pow(expected.kappa1, 2) + std::pow(expected.kappa2, 2));
          s.confident += curvatureConfidence(k, g, scale);
          ++s.points;
        }
        return s;
      },
      [](Sum a, const Sum& b) {
        return Sum{a.error1 + b.error1, a.error2 + b.error2, a.size + b.size, a.confident + b.confident,
                   a.points + b.points};
      });
  Errors errors;
  errors.rms1 = std::sqrt(sum.error1 / sum.size);
  errors.rms2 = std::sqrt(sum.error2 / sum.size);
  errors.confident = sum.confident / sum.points;
  errors.points = sum.points;
  const dvec3 spacing = geometry.spacingMm();
  std::printf(
      "%-8s %3d, %.2f x %.2f x %.2f mm: kappa1 off by %.3f %%, kappa2 by %.3f %% RMS; confidence %.3f (%d "
      "points)\n",
      name.c_str(), geometry.dims.x, spacing.x, spacing.y, spacing.z, 100.0 * errors.rms1,
      100.0 * errors.rms2, errors.confident, errors.points);
  return errors;
}

TEST(CurvatureAccuracy, ErrorsFallWithTheSquareOfTheSpacing) {
  for (const char* name : {"ball", "torus", "cylinder", "saddle"}) {
    constexpr double border = 0.19;  // the same part of the surface in all three
    const Errors coarse = curvatureErrors(name, test::isotropicGeometry(64), border * 64);
    const Errors middle = curvatureErrors(name, test::isotropicGeometry(128), border * 128);
    const Errors fine = curvatureErrors(name, test::isotropicGeometry(256), border * 256);
    EXPECT_GT(std::min({coarse.points, middle.points, fine.points}), 500) << name;
    // The saddle is a polynomial of degree 2, which the spline holds: nothing but rounding of the samples to
    // float is left of it.
    if (std::string(name) == "saddle") {
      EXPECT_LT(std::max(coarse.rms1, fine.rms1), 1e-3);
      continue;
    }
    EXPECT_GT(std::log2(coarse.rms1 / fine.rms1) / 2.0, 1.8) << name;
    // (kappa2 of a cylinder is 0, exactly so but for rounding.)
    EXPECT_TRUE(coarse.rms2 < 1e-6 || std::log2(coarse.rms2 / fine.rms2) / 2.0 > 1.8) << name;
    EXPECT_LT(fine.rms1, middle.rms1);
    EXPECT_LT(middle.rms1, 0.02) << name;
    EXPECT_LT(middle.rms2, 0.02) << name;
  }
}

TEST(CurvatureAccuracy, IsInMillimetresUnderAnisotropicAndObliqueGeometry) {
  const Errors oblique = curvatureErrors("torus", test::obliqueLeftHandedGeometry(128), 12.0);
  EXPECT_LT(std::max(oblique.rms1, oblique.rms2), 0.02);
  EXPECT_GT(oblique.confident, 0.99);
  // Slices of 2.5 mm against curvatures of 100 mm and more.
  const Errors ball =
      curvatureErrors("ball", test::anisotropicGeometry(128), 12.0, 0.35 * 127.0 * 0.4 - 100.0);
  EXPECT_LT(std::max(ball.rms1, ball.rms2), 0.02);
  EXPECT_EQ(ball.confident, 0.0);
  const Errors saddle = curvatureErrors("saddle", test::anisotropicGeometry(64), 12.0);
  EXPECT_LT(std::max(saddle.rms1, saddle.rms2), 0.02);
}

TEST(CurvatureAccuracy, AnAddedConstantChangesNothing) {
  const GridGeometry geometry = test::isotropicGeometry(32);
  const auto voxels = std::get<std::vector<float>>(test::phantomGrid("torus", geometry).voxels());
  const Grid plain(geometry, voxels, 0.25, 0.0), shifted(geometry, voxels, 0.25, 1000.0);
  for (std::uint64_t i = 0; i < 500; ++i) {
    const dvec3 p = 31.0 * test::randomVector(i, 1);
    const FieldSample a = sampleCubic(plain, p), b = sampleCubic(shifted, p);
    EXPECT_EQ(principalCurvature(a.gradient, a.hessian).kappa1,
              principalCurvature(b.gradient, b.hessian).kappa1);
  }
}

TEST(CurvatureConfidence, OfNoScaleNothingIsFlatNorNoise) {
  const PrincipalCurvature slight{.kappa1 = 1e-9, .kappa2 = -1e-9, .normal = {0.0, 0.0, 1.0}};
  EXPECT_EQ(curvatureConfidence(slight, {0.0, 0.0, 1e-9}, CurvatureScale()), 1.0);
}

}  // namespace
}  // namespace isolux::volume
