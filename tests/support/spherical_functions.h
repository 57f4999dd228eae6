// Functions on the sphere: their quadrature, sums of spherical harmonics, their coefficients, and uniform
// directions.
#pragma once

#include <cassert>
#include <cmath>
#include <numbers>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/portable_math.h"
#include "gi/harmonics/sh_rotation.h"
#include "gi/harmonics/spherical_harmonics.h"
#include "gi/sampling/directions.h"

namespace isolux::test {

// A quadrature of the sphere, exact for polynomials in x, y, z up to `degree`: Gauss-Legendre in z times
// equal steps about z. The weights sum to 4 pi.
class SphereQuadrature {
 public:
  explicit SphereQuadrature(int degree) {
    assert(degree >= 0);
    const gi::GaussLegendre polar(degree / 2 + 1);
    const int around = degree + 1;
    points_.reserve(polar.nodes.size() * around);
    for (std::size_t i = 0; i < polar.nodes.size(); ++i) {
      const double z = polar.nodes[i], radius = std::sqrt((1.0 - z) * (1.0 + z));
      for (int j = 0; j < around; ++j) {
        const double phi = 2.0 * std::numbers::pi * (j + 0.5) / around;
        points_.push_back({{radius * base::portableCos(phi), radius * base::portableSin(phi), z},
                           polar.weights[i] * 2.0 * std::numbers::pi / around});
      }
    }
  }

  struct Point {
    glm::dvec3 direction;
    double weight;
  };
  const std::vector<Point>& points() const& { return points_; }
  // Deleted for a temporary: a loop over its points would outlive it.
  const std::vector<Point>& points() && = delete;

 private:
  std::vector<Point> points_;
};

// The sum of coefficients[i] * Y_i(d).
template <class Coefficients>
auto reconstructSh(int order, const Coefficients& coefficients, glm::dvec3 d) {
  std::vector<double> y(static_cast<std::size_t>(gi::shTerms(order)));
  gi::evaluateSh(order, d, y.data());
  auto sum = y[0] * coefficients[0];
  for (std::size_t i = 1; i < y.size(); ++i) sum += y[i] * coefficients[i];
  return sum;
}

// The integrals of function * Y_i by SphereQuadrature(degree): exact for a function of degree at most
// degree - order + 1 in x, y, z.
template <class Function>
std::vector<double> projectSh(int order, const Function& function, int degree = 127) {
  std::vector<double> coefficients(static_cast<std::size_t>(gi::shTerms(order)), 0.0), y(coefficients.size());
  const SphereQuadrature quadrature(degree);
  for (const auto& [direction, weight] : quadrature.points()) {
    gi::evaluateSh(order, direction, y.data());
    const double value = weight * function(direction);
    for (std::size_t i = 0; i < y.size(); ++i) coefficients[i] += value * y[i];
  }
  return coefficients;
}

// The irradiance of an unoccluded surface with this normal under radiance of these coefficients.
template <class Value>
Value irradianceSh(int order, const std::vector<Value>& radiance, glm::dvec3 normal) {
  std::vector<double> y(static_cast<std::size_t>(gi::shTerms(order)));
  gi::evaluateSh(order, normal, y.data());
  Value sum(0.0);
  for (int l = 0; l < order; ++l)
    for (auto i = static_cast<std::size_t>(l * l); i < static_cast<std::size_t>((l + 1) * (l + 1)); ++i)
      sum += gi::clampedCosine(l) * y[i] * radiance[i];
  return sum;
}

// The coefficients of one number, turned.
inline std::vector<double> turned(const gi::ShRotation& rotation, const std::vector<double>& coefficients) {
  std::vector<glm::dvec3> values(coefficients.begin(), coefficients.end());
  rotation.apply(values, values);
  std::vector<double> result;
  for (const glm::dvec3& value : values) result.push_back(value.x);
  return result;
}

inline glm::vec3 uniformSphere(glm::vec2 u) {
  return gi::uniformCone(u, 2.0f);
}

}  // namespace isolux::test
