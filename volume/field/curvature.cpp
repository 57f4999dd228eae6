#include "volume/field/curvature.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/field/noise_gain.h"
#include "volume/field/scaled_field.h"

namespace isolux::volume {

namespace {

double largestComponent(glm::dvec3 v) {
  return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double smoothstep(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace

PrincipalCurvature principalCurvature(glm::dvec3 worldGradient, const glm::dmat3& worldHessian,
                                      double outward) {
  PrincipalCurvature out;
  // Both are brought to size 1 before anything is squared: values may be 1e-20 or 1e20.
  const double g = largestComponent(worldGradient);
  const double h = std::max({largestComponent(worldHessian[0]), largestComponent(worldHessian[1]),
                             largestComponent(worldHessian[2])});
  if (!(g > 0.0) || !std::isfinite(g) || !std::isfinite(h)) return out;
  const glm::dvec3 scaled = worldGradient / g;
  const double length = glm::length(scaled);
  const glm::dvec3 n = scaled * (outward / length);

  const double sign = std::copysign(1.0, n.z), a = -1.0 / (sign + n.z), b = n.x * n.y * a;
  const glm::dvec3 u(1.0 + sign * n.x * n.x * a, sign * b, -sign * n.x);
  const glm::dvec3 v(b, sign + n.y * n.y * a, -n.y);

  const glm::dmat3 hessian = h > 0.0 ? worldHessian / h : glm::dmat3(0.0);
  const glm::dvec3 hu = hessian * u, hv = hessian * v;
  const double factor = outward / length;
  const double a11 = factor * glm::dot(u, hu), a12 = factor * glm::dot(u, hv), a22 = factor * glm::dot(v, hv);
  const double mean = 0.5 * (a11 + a22), difference = 0.5 * (a11 - a22), r = std::hypot(difference, a12);
  const double kappa1 = (mean + r) * (h / g), kappa2 = (mean - r) * (h / g);
  if (!std::isfinite(kappa1) || !std::isfinite(kappa2)) return out;
  const glm::dvec3 hn = hessian * n;
  out.flowline = std::hypot(glm::dot(u, hn), glm::dot(v, hn)) / length * (h / g);
  out.kappa1 = kappa1;
  out.kappa2 = kappa2;

  double cosine = 1.0, sine = 0.0;
  if (r > 0.0) {
    const double twice = difference / r;
    const double larger = std::sqrt(0.5 * (1.0 + std::abs(twice))), smaller = 0.5 * (a12 / r) / larger;
    cosine = twice >= 0.0 ? larger : std::abs(smaller);
    sine = twice >= 0.0 ? smaller : std::copysign(larger, a12);
  }
  out.normal = n;
  out.direction1 = glm::normalize(cosine * u + sine * v);
  out.direction2 = glm::cross(n, out.direction1);
  return out;
}

CurvatureScale curvatureScale(const GridGeometry& geometry, scene::Field field, double noise,
                              const glm::dvec3& noiseBlur, double scaleMm) {
  const NoiseGain gain = noiseGain(field, noiseBlur, deviationsInVoxels(geometry, scaleMm));
  const glm::dmat3 worldFromGradient = glm::transpose(glm::inverse(glm::dmat3(geometry.worldFromVoxel)));
  const glm::dvec3 squares(glm::dot(worldFromGradient[0], worldFromGradient[0]),
                           glm::dot(worldFromGradient[1], worldFromGradient[1]),
                           glm::dot(worldFromGradient[2], worldFromGradient[2]));
  // The mean over unit vectors n of n_i^2 is 1/3, of n_i^4 1/5, of n_i^2 n_j^2 1/15.
  const double gradient = glm::dot(gain.gradient, squares) / 3.0;
  const glm::dvec3 pairs(squares.x * squares.y, squares.x * squares.z, squares.y * squares.z);
  const double hessian = glm::dot(gain.pure, squares * squares) / 5.0 +
                         glm::dot(4.0 * gain.mixed + 2.0 * gain.covariance, pairs) / 15.0;
  const glm::dvec3 edges = glm::dvec3(glm::max(geometry.dims - 1, glm::ivec3(1))) * geometry.spacingMm();
  return {noise * std::sqrt(gradient), 0.1 / glm::length(edges), noise * std::sqrt(hessian)};
}

double curvatureConfidence(const PrincipalCurvature& curvature, glm::dvec3 worldGradient,
                           const CurvatureScale& scale) {
  const double gradient = largestComponent(worldGradient);
  if (!(gradient > 0.0) || curvature.normal == glm::dvec3(0.0)) return 0.0;
  const double length = gradient * glm::length(worldGradient / gradient);
  const double fromGradient = scale.gradientNoise > 0.0
                                  ? smoothstep(kNoisyGradient, kClearGradient, length / scale.gradientNoise)
                                  : 1.0;
  const double difference = curvature.kappa1 - curvature.kappa2;
  const double size = std::abs(curvature.kappa1) + std::abs(curvature.kappa2) + scale.flatCurvature;
  const double fromDifference = smoothstep(kRoundCurvature, kClearCurvature, difference / size);
  const double againstNoise = scale.hessianNoise > 0.0 ? smoothstep(kNoisyDifference, kClearDifference,
                                                                    difference * length / scale.hessianNoise)
                                                       : 1.0;
  const double most = std::max(std::abs(curvature.kappa1), std::abs(curvature.kappa2));
  const double sure =
      scale.hessianNoise > 0.0 ? smoothstep(kUnsureSize, kSureSize, most * length / scale.hessianNoise) : 1.0;
  const double fromSize = 1.0 - kUnsure * (1.0 - sure);
  return fromGradient * fromDifference * againstNoise * fromSize;
}

}  // namespace isolux::volume
