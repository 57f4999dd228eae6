// Every fast path that computes a gradient against the same field in double precision, also of values like
// 1e6 + small, of which only the small part may be weighted. A new path has its row here; the shaders' are in
// derivatives_gl_test.cpp.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "tests/support/unwatched.h"
#include "tests/support/volumes.h"
#include "volume/cast/surface_derivatives.h"
#include "volume/field/reconstruct.h"
#include "volume/tracer/isosurface_tracer.h"

namespace isolux::volume {
namespace {

constexpr glm::dvec3 kPathsMiddle(23.3, 23.9, 23.1);
constexpr double kPathsRadius = 15.0;

using Points = std::vector<glm::vec3>;
using Gradients = std::vector<glm::dvec3>;

std::shared_ptr<const Grid> ballAt(double offset) {
  return std::make_shared<const Grid>(test::gridOfVoxels(
      test::unitGeometry(glm::ivec3(48)),
      [&](glm::dvec3 p) { return offset + kPathsRadius - glm::distance(p, kPathsMiddle); }));
}

Points surfacePoints() {
  Points points;
  constexpr int count = 2000;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, r = std::sqrt(1.0 - z * z), angle = 2.399963 * i;
    points.emplace_back(kPathsMiddle +
                        kPathsRadius * glm::dvec3(r * std::cos(angle), r * std::sin(angle), z));
  }
  return points;
}

Gradients ofOracle(const Points& points, const std::function<FieldSample(glm::dvec3)>& sample) {
  Gradients result;
  for (const glm::vec3& p : points) result.push_back(sample(glm::dvec3(p)).gradient);
  return result;
}

struct Path {
  std::string name;
  std::function<Gradients(const Points&)> fast, oracle;
};

// surfaceDerivatives() of images that hold the points.
template <class Derive>
std::function<Gradients(const Points&)> castPath(const Derive& derive) {
  return [derive](const Points& points) {
    std::vector<glm::vec4> at, gradient(points.size());
    for (const glm::vec3& p : points) at.emplace_back(p, 1.0f);
    derive(at, PictureArea::whole({static_cast<int>(at.size()), 1}), DerivativeImages{gradient, {}, {}});
    Gradients result;
    for (const glm::vec4& g : gradient) result.emplace_back(g);
    return result;
  };
}

std::vector<Path> pathsOf(const std::shared_ptr<const Grid>& grid) {
  base::Progress progress;
  const auto coefficients = std::make_shared<const Coefficients>(interpolatingCoefficients(*grid));
  const auto scaled = std::make_shared<const ScaledField>(
      scaledField(*grid, scene::Field::cubic_interpolating, 0.8, progress));
  const auto cubic = [grid](const Points& p) {
    return ofOracle(p, [&](glm::dvec3 q) { return sampleCubic(*grid, q); });
  };
  const auto trilinear = [grid](const Points& p) {
    return ofOracle(p, [&](glm::dvec3 q) { return sampleTrilinear(*grid, q); });
  };
  // Splines through the samples: the coefficients that the fast path reads, in double precision.
  const auto interpolating = [grid, coefficients](const Points& p) {
    return ofOracle(p, [&](glm::dvec3 q) { return sampleCubic(*coefficients, *grid, q); });
  };
  const auto atScale = [grid, scaled](const Points& p) {
    return ofOracle(p, [&](glm::dvec3 q) { return sampleScaled(*scaled, *grid, q); });
  };
  std::vector<Path> paths;
  for (const TracerTarget target : IsosurfaceTracer::availableTargets()) {
    const auto tracer =
        std::make_shared<const IsosurfaceTracer>(grid, scene::Inside::above, progress, target);
    paths.push_back({std::string("tracer, ") + tracer->target(),
                     [tracer](const Points& p) {
                       std::vector<glm::vec3> g(p.size());
                       tracer->gradients(p, g);
                       return Gradients(g.begin(), g.end());
                     },
                     cubic});
    if (target == TracerTarget::scalar) continue;
    const std::string name = std::string("cast, ") + tracer->target() + ", ";
    const auto ofField = [=](const DerivedField& field) {  // the oracles keep what it refers to
      return castPath([=](const auto& at, const PictureArea& area, const DerivativeImages& images) {
        surfaceDerivatives(*grid, field, at, area, images, target);
      });
    };
    paths.push_back({name + "trilinear", ofField({.trilinear = true}), trilinear});
    paths.push_back({name + "spline", ofField({}), cubic});
    paths.push_back({name + "prefiltered spline", ofField({coefficients.get()}), interpolating});
    paths.push_back({name + "at a scale", ofField({.scaled = scaled.get()}), atScale});
  }
  return paths;
}

double turnInDegrees(glm::dvec3 a, glm::dvec3 b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)) * 57.29577951308232;
}

TEST(GradientPaths, AreThoseOfTheFieldHoweverFarItsValuesAreFromZero) {
  const Points points = surfacePoints();
  for (const double offset : {0.0, 1e4, 1e5, 1e6, -1e6}) {
    for (const Path& path : pathsOf(ballAt(offset))) {
      const Gradients fast = path.fast(points), oracle = path.oracle(points);
      double worst = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i)
        worst = std::max(worst, turnInDegrees(fast[i], oracle[i]));
      EXPECT_LT(worst, 1e-3) << path.name << ", offset " << offset;
    }
  }
}

}  // namespace
}  // namespace isolux::volume
