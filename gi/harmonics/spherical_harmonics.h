// Evaluates, projects and windows real spherical harmonics of order 1 to 8.
//
// Order n means the bands l = 0 .. n - 1 and n^2 terms; Y_l^m has index l (l + 1) + m. The functions are
// those of Wyman et al. 2006 eq. (12): orthonormal on the sphere, z the polar axis, without the
// Condon-Shortley factor (-1)^m. Band 1 is sqrt(3 / (4 pi)) (y, z, x), so its rotation is the rotation matrix
// itself. As the functions are real, eq. (13) needs no conjugate, and the sums of eq. (9) and (15) have n^2
// terms.
//
// Directions are unit vectors. Coefficients are linear in the function: one double, or glm::dvec3 for RGB.
// Spans have at least order^2 values. Pure functions, safe from any thread.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::gi {

constexpr int maxShOrder = 8;
constexpr int shTerms(int order) {
  return order * order;
}

// Evaluate all Y_i(d), i < order^2, as polynomials in x, y, z: no trigonometric functions, no singular
// direction.
void evaluateSh(int order, glm::vec3 d, float* out);
void evaluateSh(int order, glm::dvec3 d, double* out);

// Gauss-Legendre nodes in (-1, 1) and weights that sum to 2, exact to degree 2 count - 1.
struct GaussLegendre {
  explicit GaussLegendre(int count);
  std::vector<double> nodes, weights;
};

// Returns the factor of band l that reduces ringing: Lanczos' sigma factor sinc(strength l / order), sinc(t)
// = sin(pi t) / (pi t). Strength 0 keeps the coefficients; at 1 the factors would reach 0 at the first band
// left out. In between, the window is that of the order / strength first bands. For one light in one
// direction at order 5, the deepest undershoot is 15 % of the peak at strength 0, and 6 % at 1. In the
// irradiance it is 3.2 % and 1.4 %. Light can therefore be negative, and callers that display it must clamp
// it.
double shWindow(int order, double strength, int l);
void windowSh(int order, double strength, std::span<glm::dvec3> coefficients);

// Returns the integral of max(0, cos) P_l(cos) over the sphere: the factor of band l that turns radiance into
// irradiance. The values are pi, 2 pi / 3, pi / 4, 0, -pi / 24, 0, ... (Ramamoorthi & Hanrahan 2001, eq. 19
// without the square root).
double clampedCosine(int l);

}  // namespace isolux::gi
