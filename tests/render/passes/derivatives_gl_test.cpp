// Derivatives and curvature of the GL pipeline: against the same arithmetic in double, against closed forms,
// and against what no change of coordinates may change.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "tests/render/gl_fixture.h"
#include "tests/support/analytic_fields.h"
#include "tests/support/unwatched.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"

namespace isolux::test {
namespace {

constexpr glm::ivec2 kDerivativesSize{112, 96};

struct CurvatureImages {
  render::AovImage hit, voxel, position, gradient, hessian, kappa, direction1, direction2, confidence,
      flowline;
  std::size_t pixels() const { return hit.values.size(); }
  bool isHit(std::size_t i) const { return hit.values[i] == 1.0f; }
};

class DerivativesGlTest : public ExecutorsGlTest {
 protected:
  CurvatureImages curvatureImages(const std::shared_ptr<const volume::PreparedVolume>& volume,
                                  const scene::Scene& scene) {
    images(volume, scene, kDerivativesSize);
    using render::Aov;
    const auto read = [&](Aov aov) { return renderer_->readAov(aov); };
    return {read(Aov::hit),
            read(Aov::voxel),
            read(Aov::position),
            read(Aov::gradient),
            read(Aov::hessian),
            read(Aov::kappa),
            read(Aov::direction1),
            read(Aov::direction2),
            read(Aov::curvature_confidence),
            read(Aov::flowline_curvature)};
  }
  static glm::dmat3 hessianAt(const render::AovImage& image, std::size_t pixel) {
    const float* h = &image.values[6 * pixel];
    return {h[0], h[3], h[4], h[3], h[1], h[5], h[4], h[5], h[2]};
  }
};

double largest(const glm::dmat3& m) {
  double most = 0.0;
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) most = std::max(most, std::abs(m[c][r]));
  return most;
}

// The shaders' gradients, Hessians and curvatures at their own hits against volume/field/reconstruct.h and
// volume/field/curvature.h, for every field and fetch, in any geometry.
TEST_P(DerivativesGlTest, AgreeWithDoublePrecision) {
  const auto oblique = obliqueLeftHandedGeometry(48);
  for (const auto& volume : {phantom("head", 48), phantom("torus", oblique)})
    for (const auto field : {scene::Field::trilinear, scene::Field::cubic, scene::Field::cubic_interpolating})
      for (const auto fetch : {scene::Fetch::exact, scene::Fetch::fast}) {
        scene::Scene scene;
        scene.derivatives.field = field;
        scene.derivatives.fetch = fetch;
        scene.derivatives.scale = scene.derivatives.normalScale = 0.0;
        const CurvatureImages seen = curvatureImages(volume, scene);
        const volume::Grid& grid = volume->grid();
        const volume::Coefficients coefficients = volume::interpolatingCoefficients(grid);
        const double typical = volume->facts.typicalStep;  // per voxel
        int count = 0;
        double worstGradient = 0.0, worstHessian = 0.0, worstKappa = 0.0, worstDirection = 0.0;
        for (std::size_t i = 0; i < seen.pixels(); ++i) {
          if (!seen.isHit(i)) continue;
          const glm::dvec3 p = at(seen.voxel, i);
          const volume::FieldSample sample =
              field == scene::Field::trilinear ? volume::sampleTrilinear(grid, p)
              : field == scene::Field::cubic   ? volume::sampleCubic(grid, p)
                                               : volume::sampleCubic(coefficients, grid, p);
          const double least = glm::length(grid.geometry().spacingMm()) / std::sqrt(3.0);
          const glm::dvec3 g = volume::worldGradient(grid.geometry(), sample.gradient);
          const glm::dmat3 h = volume::worldHessian(grid.geometry(), sample.hessian);
          worstGradient = std::max(worstGradient, glm::length(at(seen.gradient, i) - g) * least / typical);
          worstHessian =
              std::max(worstHessian, largest(hessianAt(seen.hessian, i) - h) * least * least / typical);
          if (glm::length(g) * least < 0.2 * typical) continue;  // where a gradient says something
          ++count;
          const auto k = volume::principalCurvature(g, h);
          const double scale = largest(h) / glm::length(g);
          worstKappa = std::max({worstKappa, std::abs(seen.kappa.values[2 * i] - k.kappa1) / scale,
                                 std::abs(seen.kappa.values[2 * i + 1] - k.kappa2) / scale,
                                 std::abs(seen.flowline.values[i] - k.flowline) / scale});
          if (seen.confidence.values[i] < 0.5f) continue;
          worstDirection =
              std::max({worstDirection, 1.0 - std::abs(glm::dot(at(seen.direction1, i), k.direction1)),
                        1.0 - std::abs(glm::dot(at(seen.direction2, i), k.direction2))});
        }
        std::printf(
            "field %d, %s: %d points; gradient %.1e, Hessian %.1e of a typical step; kappa %.1e of |H|/|g|\n",
            static_cast<int>(field), fetch == scene::Fetch::fast ? "fast" : "exact", count, worstGradient,
            worstHessian, worstKappa);
        ASSERT_GT(count, 500);
        // The fast scheme is as good as the driver's filter: 8 bits of fraction are allowed by the standard,
        // and cards have no more.
        const bool filtered = fetch == scene::Fetch::fast && field != scene::Field::trilinear;
        const double fraction = onCard() ? 2.0 : 1.0;
        EXPECT_LT(worstGradient, filtered ? 2e-2 * fraction : 2e-4);
        EXPECT_LT(worstHessian, filtered ? 8e-2 : 1e-3);
        EXPECT_LT(worstKappa, filtered ? 8e-2 * fraction : 1e-3);
        EXPECT_LT(worstDirection, filtered ? 0.1 : 1e-3);
      }
}

// Values like 1e6 + small keep few digits of the small part; what they keep is what normals and second
// derivatives show. The bound is the same arithmetic in double on the same float32 voxels.
TEST_P(DerivativesGlTest, ALargeConstantInTheValuesCostsNoDerivatives) {
  const auto reference = phantom("torus", 48);
  std::vector<float> shifted, withBackground;
  for (const float v : std::get<std::vector<float>>(reference->grid().voxels())) {
    shifted.push_back(1e6f + 100.0f * v);
    withBackground.push_back(v < -12.0f ? 0.0f : 1e6f + 100.0f * v);  // no offset of all values is exact
  }
  for (const std::vector<float>* const values : {&shifted, &withBackground}) {
    const auto volume = prepared(volume::Grid(reference->grid().geometry(), *values));
    const volume::Grid& grid = volume->grid();
    const volume::Coefficients coefficients = volume::interpolatingCoefficients(grid);
    for (const auto field : {scene::Field::trilinear, scene::Field::cubic, scene::Field::cubic_interpolating})
      for (const auto fetch : {scene::Fetch::exact, scene::Fetch::fast}) {
        if (fetch == scene::Fetch::fast && values == &withBackground)
          continue;  // the texture unit's own sums
        scene::Scene scene;
        scene.surfaces.front().value = 1e6;
        scene.derivatives.field = field;
        scene.derivatives.fetch = fetch;
        const CurvatureImages seen = curvatureImages(volume, scene);
        const render::AovImage normals = renderer_->readAov(render::Aov::normal);
        double worst = 0.0, worstHessian = 0.0;
        int count = 0;
        for (std::size_t i = 0; i < seen.pixels(); ++i) {
          if (!seen.isHit(i)) continue;
          const glm::dvec3 p = at(seen.voxel, i);
          const volume::FieldSample sample =
              field == scene::Field::trilinear ? volume::sampleTrilinear(grid, p)
              : field == scene::Field::cubic   ? volume::sampleCubic(grid, p)
                                               : volume::sampleCubic(coefficients, grid, p);
          const glm::dvec3 g = volume::worldGradient(grid.geometry(), sample.gradient);
          const glm::dmat3 h = volume::worldHessian(grid.geometry(), sample.hessian);
          const double sine = glm::length(glm::cross(at(normals, i), glm::normalize(-g)));
          worst = std::max(worst, std::asin(std::min(sine, 1.0)) * 180.0 / std::numbers::pi);
          worstHessian = std::max(worstHessian, largest(hessianAt(seen.hessian, i) - h) / glm::length(g));
          ++count;
        }
        std::printf("field %d, %s: %d points, normals %.1e degrees, Hessian %.1e of |g| per mm\n",
                    static_cast<int>(field), fetch == scene::Fetch::fast ? "fast" : "exact", count, worst,
                    worstHessian);
        ASSERT_GT(count, 500);
        const bool filtered = fetch == scene::Fetch::fast && field != scene::Field::trilinear;
        EXPECT_LT(worst, filtered ? 1.0 : 0.01);
        EXPECT_LT(worstHessian, filtered ? 8e-2 : 1e-3);
      }
  }
}

// Closed forms, all in mm: a torus has curvatures of both signs and no umbilic. Interpolating coefficients of
// analytic samples; away from block edges there is nothing special, so all hits count.
TEST_P(DerivativesGlTest, TorusCurvatureWithin2Percent) {
  for (const auto& geometry :
       {isotropicGeometry(128), anisotropicGeometry(128), obliqueLeftHandedGeometry(128)}) {
    const auto torus = phantom("torus", geometry);
    const auto reference = analyticField("torus", geometry);
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    scene.hit.field = scene.derivatives.field = scene::Field::cubic_interpolating;
    const CurvatureImages seen = curvatureImages(torus, scene);
    double sum1 = 0.0, sum2 = 0.0, size1 = 0.0, size2 = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < seen.pixels(); ++i) {
      if (!seen.isHit(i)) continue;
      const Curvature k = reference->curvature(at(seen.position, i));
      sum1 += std::pow(seen.kappa.values[2 * i] - k.kappa1, 2);
      sum2 += std::pow(seen.kappa.values[2 * i + 1] - k.kappa2, 2);
      size1 += k.kappa1 * k.kappa1;
      size2 += k.kappa2 * k.kappa2;
      ++count;
    }
    ASSERT_GT(count, 30);
    const double error1 = std::sqrt(sum1 / size1), error2 = std::sqrt(sum2 / size2);
    const glm::dvec3 spacing = geometry.spacingMm();
    std::printf("torus %.2f x %.2f x %.2f mm: kappa1 %.4f %%, kappa2 %.4f %% RMS over %d pixels\n", spacing.x,
                spacing.y, spacing.z, 100.0 * error1, 100.0 * error2, count);
    EXPECT_LT(error1, 0.02);
    EXPECT_LT(error2, 0.02);
  }
}

TEST_P(DerivativesGlTest, UmbilicsFlatsAndVanishingGradientsHaveNoConfidence) {
  for (const char* name : {"ball", "plane"}) {
    scene::Scene scene;
    scene.surfaces.front().value = 0.0;
    scene.derivatives.field = scene::Field::cubic_interpolating;
    const auto volume = phantom(name, 64);
    const CurvatureImages seen = curvatureImages(volume, scene);
    int hits = 0;
    for (std::size_t i = 0; i < seen.pixels(); ++i) {
      if (!seen.isHit(i)) continue;
      // The spline bends near the border, where its coefficients are mirrored: a plane is flat only within.
      const glm::dvec3 p = at(seen.voxel, i);
      if (std::min({p.x, p.y, p.z}) < 8.0 || std::max({p.x, p.y, p.z}) > 55.0) continue;
      ++hits;
      EXPECT_TRUE(std::isfinite(seen.kappa.values[2 * i]) && std::isfinite(seen.kappa.values[2 * i + 1]));
      EXPECT_NEAR(glm::length(at(seen.direction1, i)), 1.0, 1e-3);
      EXPECT_EQ(seen.confidence.values[i], 0.0f)
          << name << ' ' << seen.kappa.values[2 * i] << ' ' << seen.kappa.values[2 * i + 1];
      if (HasFailure()) return;
    }
    EXPECT_GT(hits, 500) << name;
  }
}

// Within a voxel of the border the spline's samples are repeated ones: its curvature there is no shape of the
// data.
TEST_P(DerivativesGlTest, TheBorderHasNoConfidence) {
  const auto volume = phantom("gyroid", 32);
  scene::Scene scene;
  scene.surfaces.front().value = 0.3;
  const CurvatureImages seen = curvatureImages(volume, scene);
  int border = 0, trusted = 0, besideLow = 0, besideHigh = 0;
  for (std::size_t i = 0; i < seen.pixels(); ++i) {
    if (!seen.isHit(i)) continue;
    const glm::dvec3 p = at(seen.voxel, i);
    const bool atBorder = std::min({p.x, p.y, p.z}) < 0.99 || std::max({p.x, p.y, p.z}) > 30.01;
    if (atBorder) {
      ++border;
      EXPECT_EQ(seen.confidence.values[i], 0.0f);
    } else if (seen.confidence.values[i] > 0.9f) {
      ++trusted;
      besideLow += std::min({p.x, p.y, p.z}) < 1.99;  // of the next cells the samples are all there
      besideHigh += std::max({p.x, p.y, p.z}) > 29.01;
    }
  }
  EXPECT_GT(border, 50);
  EXPECT_GT(trusted, 500);
  EXPECT_GT(besideLow, 20);
  EXPECT_GT(besideHigh, 20);
}

// A smooth random field with structures of a few voxels.
volume::Grid randomField(const volume::GridGeometry& geometry, unsigned seed, double offset, bool mirrored) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  struct Wave {
    glm::dvec3 k;
    double phase, amplitude;
  };
  std::vector<Wave> waves(12);
  for (Wave& wave : waves)
    wave = {0.35 * glm::dvec3(uniform(random), uniform(random), uniform(random)), 3.0 * uniform(random),
            uniform(random)};
  std::vector<float> voxels;
  for (int z = 0; z < geometry.dims.z; ++z)
    for (int y = 0; y < geometry.dims.y; ++y)
      for (int x = 0; x < geometry.dims.x; ++x) {
        const glm::dvec3 p(mirrored ? geometry.dims.x - 1 - x : x, y, z);
        double sum = 0.0;
        for (const Wave& wave : waves) sum += wave.amplitude * std::sin(glm::dot(wave.k, p) + wave.phase);
        voxels.push_back(static_cast<float>(sum + offset));
      }
  return {geometry, std::move(voxels)};
}

struct Moved {
  const char* name;
  glm::dmat3 world{1.0};  // applied to the world of volume and camera alike
  double offset = 0.0;    // added to all values and to the isovalue
  bool mirrored = false;  // voxels stored in the opposite order along x, geometry mirrored back
};

// Curvature belongs to the surface: it does not change under rotation, mirroring of the world or of the
// storage order, or adding a constant, and scales as 1/length. Pixel by pixel, with the camera moved along.
TEST_P(DerivativesGlTest, CurvatureIsOfTheSurfaceAlone) {
  const double c = std::cos(0.7), s = std::sin(0.7);
  const glm::dmat3 turn = glm::dmat3(c, s, 0, -s, c, 0, 0, 0, 1) * glm::dmat3(1, 0, 0, 0, c, s, 0, -s, c);
  const Moved cases[] = {{"rotated", turn},
                         {"mirrored", glm::dmat3(-1, 0, 0, 0, 1, 0, 0, 0, 1)},
                         {"3.7 times larger", glm::dmat3(3.7)},
                         {"constant added", glm::dmat3(1.0), 2.5},
                         {"stored the other way", glm::dmat3(1.0), 0.0, true}};
  const glm::ivec3 dims(30, 26, 28);
  for (unsigned seed = 1; seed <= 3; ++seed) {
    const auto plainGeometry = volume::GridGeometry::make(dims, {1.0, 1.2, 0.8});
    const auto plain = prepared(randomField(plainGeometry, seed, 0.0, false));
    scene::Scene scene;
    scene.surfaces.front().value = 0.1 * seed;
    scene.camera.eye = glm::dvec3(70.0, -60.0, 45.0);
    scene.camera.target = glm::dvec3(14.0, 15.0, 11.0);
    scene.camera.up = glm::dvec3(0.0, 0.0, 1.0);
    scene.derivatives.noise = 1e-4;
    const CurvatureImages before = curvatureImages(plain, scene);
    for (const Moved& moved : cases) {
      volume::GridGeometry geometry = plainGeometry;
      if (moved.mirrored) {
        geometry.worldFromVoxel[0] *= -1.0;
        geometry.worldFromVoxel[3] += (dims.x - 1.0) * plainGeometry.worldFromVoxel[0];
      }
      geometry.worldFromVoxel = glm::dmat4(moved.world) * geometry.worldFromVoxel;
      const auto volume = prepared(randomField(geometry, seed, moved.offset, moved.mirrored));
      scene::Scene other = scene;
      *other.surfaces.front().value += moved.offset;
      other.camera.eye = moved.world * *scene.camera.eye;
      other.camera.target = moved.world * *scene.camera.target;
      other.camera.up = moved.world * *scene.camera.up;
      const CurvatureImages after = curvatureImages(volume, other);
      const bool flipped = glm::determinant(moved.world) < 0.0;
      const double length = std::cbrt(std::abs(glm::determinant(moved.world)));
      int compared = 0, differ = 0, hitsDiffer = 0;
      for (int y = 0; y < kDerivativesSize.y; ++y)
        for (int x = 0; x < kDerivativesSize.x; ++x) {
          const auto i = static_cast<std::size_t>(y * kDerivativesSize.x + x);
          const auto j =
              static_cast<std::size_t>(y * kDerivativesSize.x + (flipped ? kDerivativesSize.x - 1 - x : x));
          if (before.isHit(i) != after.isHit(j)) ++hitsDiffer;
          if (!before.isHit(i) || !after.isHit(j)) continue;
          ++compared;
          const double scale =
              std::abs(before.kappa.values[2 * i]) + std::abs(before.kappa.values[2 * i + 1]) + 0.01;
          for (std::size_t k = 0; k < 2; ++k)
            if (std::abs(after.kappa.values[2 * j + k] * length - before.kappa.values[2 * i + k]) >
                0.01 * scale) {
              ++differ;
              break;
            }
        }
      ASSERT_GT(compared, 1000) << moved.name;
      // A pixel at a silhouette may see another part of the surface.
      EXPECT_LE(differ, compared / 200) << moved.name << ", seed " << seed;
      EXPECT_LE(hitsDiffer, compared / 500) << moved.name << ", seed " << seed;
    }
  }
}

// Random fields, cameras and isovalues: what is called a hit lies on the surface within its stated error.
TEST_P(DerivativesGlTest, HitsLieOnTheSurfaceWithinTheirStatedError) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (int trial = 0; trial < 8; ++trial) {
    const auto geometry =
        volume::GridGeometry::make({24, 22, 26}, glm::dvec3(1.0, 1.0 + 0.5 * uniform(random), 1.0));
    const auto volume =
        prepared(randomField(geometry, 100 + static_cast<unsigned>(trial), 5.0 * uniform(random), false));
    scene::Scene scene;
    scene.surfaces.front().value =
        0.5 * (volume->grid().minimum() + volume->grid().maximum()) + uniform(random);
    const glm::dvec3 middle = 0.5 * (volume->facts.boundsMinMm + volume->facts.boundsMaxMm);
    scene.camera.target = middle;
    scene.camera.eye = middle + 40.0 * glm::dvec3(uniform(random), uniform(random), uniform(random));
    if (trial % 2) scene.camera.projection = scene::Projection::orthographic;
    const volume::Coefficients coefficients = volume::interpolatingCoefficients(volume->grid());
    for (const auto field : {scene::Field::trilinear, scene::Field::cubic, scene::Field::cubic_interpolating})
      for (const auto method : {scene::HitMethod::exact, scene::HitMethod::sampled}) {
        scene.hit.field = field;
        scene.hit.method = method;
        const Images seen = images(volume, scene, kDerivativesSize);
        int hits = 0;
        for (std::size_t i = 0; i < seen.hit.values.size(); ++i) {
          if (seen.hit.values[i] != 1.0f) continue;
          ++hits;
          const glm::dvec3 p = at(seen.voxel, i);
          const double value =
              field == scene::Field::trilinear ? volume::sampleTrilinear(volume->grid(), p).value
              : field == scene::Field::cubic   ? volume::sampleCubic(volume->grid(), p).value
                                               : volume::sampleCubic(coefficients, volume->grid(), p).value;
          const double error = std::abs(value - *scene.surfaces.front().value);
          EXPECT_NEAR(error, seen.error.values[i],
                      2e-5 * (volume->grid().maximum() - volume->grid().minimum()));
          EXPECT_LT(error, method == scene::HitMethod::exact ? 2e-3 : 0.5);
          if (HasFailure()) return;
        }
        EXPECT_GT(hits, 100) << "trial " << trial;
      }
  }
}

ISOLUX_ON_BOTH_EXECUTORS(DerivativesGlTest);

}  // namespace
}  // namespace isolux::test
