// Functions on the sphere: sums of spherical harmonics, their coefficients, and uniform directions.
#pragma once

#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "gi/harmonics/sh_rotation.h"
#include "gi/harmonics/spherical_harmonics.h"
#include "gi/sampling/directions.h"

namespace isolux::test {

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
  const gi::SphereQuadrature quadrature(degree);
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
