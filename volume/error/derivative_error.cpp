#include "volume/error/derivative_error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/error/hit_error.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"

namespace isolux::volume {

namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kFilterRounding = 0x1p-9 / 1.7320508;  // of a weight of 8 bits of the texture unit

// Roundings of a derivative per voxel in parts of the samples' root mean square about the cell's first, and
// what it makes of a rounding of each sample (docs/explanation/numerics.md).
struct RoundingCounts {
  int before, behind;  // samples of a lookup along an axis, about the cell's first
  double gradient, hessian;
  double gradientOfSamples, hessianOfSamples;
};
RoundingCounts countsOf(const DerivedShape& shape) {
  if (shape.scaled) return {-2, 3, 2.0, 3.0, 0.0, 0.0};
  if (shape.field == scene::Field::trilinear) return {0, 1, 2.0, 4.0, 1.5, 3.0};
  return {-1, 2, 2.0, 4.0, 0.6, 1.8};
}

// Root mean squares of the samples of a lookup: about the first of the cell, and themselves where they are
// rounded before anything is taken off (integers become texels of [0, 1]).
struct SampleSizes {
  double spread = 0.0, size = 0.0;
};
SampleSizes sizesOf(const DerivedShape& shape, const RoundingCounts& counts, const glm::dvec3& voxel) {
  const Grid& grid = shape.grid;
  const Coefficients* const coefficients = shape.scaled ? &shape.scaled->coefficients : shape.coefficients;
  const auto sample = [&](const glm::ivec3& at) {
    return coefficients ? static_cast<double>(coefficients->values[grid.index(at)]) : grid.stored(at);
  };
  const glm::ivec3 last = grid.dims() - 1;
  const glm::ivec3 cell = grid.geometry().cellOf(voxel);
  const double reference = sample(cell);
  const double lowest = lowestStored(grid);
  double spread = 0.0, size = 0.0;
  int count = 0;
  forEachIn(cell + counts.before, cell + counts.behind + 1, [&](glm::ivec3 at) {
    const double value = sample(glm::clamp(at, glm::ivec3(0), last));
    if (!std::isfinite(value)) return;
    spread += (value - reference) * (value - reference);
    size += (value - lowest) * (value - lowest);
    ++count;
  });
  const bool rounded =
      !shape.exactSamples && !coefficients && !std::holds_alternative<std::vector<float>>(grid.voxels());
  const double slope = std::abs(grid.slope()), n = std::max(count, 1);
  return {slope * std::sqrt(spread / n), rounded ? slope * std::sqrt(size / n) : 0.0};
}

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

struct ShapeChange {
  double angle, curvature;
};
ShapeChange changeOf(const ShapeAt& from, const ShapeAt& to) {
  ShapeChange change{kInfinite, kInfinite};
  if (from.normal != glm::dvec3(0.0) && to.normal != glm::dvec3(0.0))
    change.angle = angleBetween(from.normal, to.normal);
  if (from.hasCurvature && to.hasCurvature)
    change.curvature = std::max(std::abs(from.kappa1 - to.kappa1), std::abs(from.kappa2 - to.kappa2));
  return change;
}

}  // namespace

ShapeAt shapeAt(const DerivedShape& shape, const glm::dvec3& voxel) {
  const Grid& grid = shape.grid;
  FieldSample sample = sampleField(grid, shape.field, shape.coefficients, voxel, shape.scaled);
  const bool known = shape.scaled || std::isfinite(sample.value);
  if (!known) sample = sampleTrilinear(grid, voxel);
  const glm::dvec3 gradient = worldGradient(grid.geometry(), sample.gradient);
  const glm::dmat3 hessian = worldHessian(grid.geometry(), sample.hessian);
  const PrincipalCurvature curvature = principalCurvature(gradient, hessian, shape.outward);
  ShapeAt out;
  out.normal = curvature.normal;
  out.kappa1 = curvature.kappa1;
  out.kappa2 = curvature.kappa2;
  out.hasCurvature = known && curvature.normal != glm::dvec3(0.0);
  out.gradient = glm::length(gradient);
  out.bend = std::sqrt(glm::dot(hessian[0], hessian[0]) + glm::dot(hessian[1], hessian[1]) +
                       glm::dot(hessian[2], hessian[2]));
  const glm::dvec3 turned = hessian * out.normal;
  out.lean = glm::length(turned - glm::dot(turned, out.normal) * out.normal);
  return out;
}

ShapeRounding shapeRounding(const DerivedShape& shape, const glm::dvec3& voxel, const ShapeAt& at) {
  const RoundingCounts counts = countsOf(shape);
  const SampleSizes sizes = sizesOf(shape, counts, voxel);
  const double weight = shape.fetch == scene::Fetch::fast && !shape.scaled ? kFilterRounding : kFloatRounding;
  const double least = shape.grid.geometry().leastSpacingMm();
  const double gradient = std::hypot(weight * counts.gradient * sizes.spread,
                                     kFloatRounding * counts.gradientOfSamples * sizes.size) /
                          least;
  const double hessian = std::hypot(weight * counts.hessian * sizes.spread,
                                    kFloatRounding * counts.hessianOfSamples * sizes.size) /
                         (least * least);
  // To the world: products and sums of three; the normal as it is handed on, and its length.
  const double ofTurn = std::hypot(gradient / at.gradient, 2.0 * kFloatRounding);
  ShapeRounding out;
  out.normal = ofTurn;
  // |dkappa| <= |dH|/|g| in the tangent plane, 2 |lean| dn/|g| by its turning, kappa d|g|/|g|; and the
  // roundings of the 2x2 form.
  const double most = std::max(std::abs(at.kappa1), std::abs(at.kappa2)), form = at.bend / at.gradient;
  out.curvature = std::hypot(std::hypot(hessian / at.gradient, 2.0 * at.lean / at.gradient * ofTurn),
                             std::hypot(most * gradient / at.gradient, 3.0 * kFloatRounding * form));
  return out;
}

ShapeBound boundShape(const DerivedShape& shape, const glm::dvec3& voxel, const glm::dvec3& shifted,
                      std::span<const glm::dvec3> ends, const glm::dvec3& deviation) {
  ShapeBound out;
  out.at = shapeAt(shape, voxel);
  const ShapeChange known = changeOf(out.at, shapeAt(shape, shifted));
  ShapeChange along{0.0, 0.0};
  for (const glm::dvec3& end : ends) {
    const ShapeChange change = changeOf(out.at, shapeAt(shape, end));
    along = {std::max(along.angle, change.angle), std::max(along.curvature, change.curvature)};
  }
  // Toward the nearer face of the cell: where derivatives jump, it is there.
  double angle2 = along.angle * along.angle, curvature2 = along.curvature * along.curvature;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 beside = voxel;
    const double step = kErrorLevel * deviation[axis];
    beside[axis] += voxel[axis] - std::floor(voxel[axis]) < 0.5 ? -step : step;
    const ShapeChange change = changeOf(out.at, shapeAt(shape, beside));
    angle2 += change.angle * change.angle;
    curvature2 += change.curvature * change.curvature;
  }
  const ShapeRounding rounding = shapeRounding(shape, voxel, out.at);
  const double angle = known.angle + std::hypot(std::sqrt(angle2), kErrorLevel * rounding.normal);
  const double curvature =
      known.curvature + std::hypot(std::sqrt(curvature2), kErrorLevel * rounding.curvature);
  const bool hasNormal = out.at.normal != glm::dvec3(0.0);
  out.normalDegrees = hasNormal ? std::min(angle, std::numbers::pi) * (180.0 / std::numbers::pi) : kInfinite;
  if (!(angle < std::numbers::pi)) out.normalDegrees = kInfinite;
  out.curvature = out.at.hasCurvature ? curvature : kInfinite;
  return out;
}

}  // namespace isolux::volume
