// Principal curvatures and directions of an isosurface, and how far to trust them.
//
// From the world gradient g and Hessian H of the field (per mm, per mm^2) by the 2x2 form in the tangent
// plane, Hadwiger et al. 2005 eq. (3) and (4), in the order of steps that the shader follows too:
//   n = outward g / |g|; outward is -1 where inside is f >= isovalue, 1 where it is f <= isovalue;
//   u, v: orthonormal tangents with u x v = n (Duff et al. 2017, "Building an orthonormal basis, revisited");
//   a_ij = outward (u,v)^T H (u,v) / |g|;
//   m = (a11 + a22) / 2, d = (a11 - a22) / 2, r = hypot(d, a12); kappa1, kappa2 = m + r, m - r;
//   e1 = cos(w) u + sin(w) v with (cos 2w, sin 2w) = (d, a12) / r, by half-angle formulas without
//   cancellation; e2 = n x e1.
// The flowlines of the gradient have the curvature |P H n| / |g|, P = I - n n^T, 1/mm: how fast the normal
// turns along itself (Kindlmann et al. 2003, "Curvature-based transfer functions for direct volume
// rendering": the third column of their G). Where it is large, another isovalue moves the surface sideways.
//
// kappa1 >= kappa2, in 1/mm, positive where the surface bends away from n: a bright ball of radius R has both
// +1/R. No square root of a negative number can occur. Eq. (5) of the paper is not used: it is an eigenvector
// only of special matrices. Where r = 0 (umbilics) every tangent is principal; u is given, with confidence 0.
//
// Confidence = c_g c_d c_n c_s in [0, 1], with the constants below:
//   c_g = smoothstep(3, 6, |g| / gradientNoise): gradients of noise alone seldom exceed 4 of its deviations;
//   c_d = smoothstep(0.02, 0.1, (kappa1 - kappa2) / (|kappa1| + |kappa2| + flatCurvature));
//   c_n = smoothstep(2, 5, (kappa1 - kappa2) |g| / hessianNoise): noise alone bends a flat face this way and
//   that;
//   c_s = 3/4 + smoothstep(3, 16, max(|kappa1|, |kappa2|) |g| / hessianNoise) / 4: above 0.9 noise is less
//   than a tenth of a curvature, so that 95 % of those are right within a fifth
//   (docs/records/2026-11-derivative-scales.md);
// flatCurvature = 0.1 / the diagonal of the volume, mm. Exactly 0 at umbilic and flat points and where the
// gradient vanishes.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "volume/grid.h"

namespace isolux::volume {

inline constexpr double kNoisyGradient = 3.0, kClearGradient = 6.0;      // deviations of the noise
inline constexpr double kNoisyDifference = 2.0, kClearDifference = 5.0;  // deviations of a curvature's noise
inline constexpr double kUnsureSize = 3.0, kSureSize = 16.0, kUnsure = 0.25;  // of c_s
inline constexpr double kRoundCurvature = 0.02, kClearCurvature = 0.1;        // relative differences of kappa

struct PrincipalCurvature {
  double kappa1 = 0.0, kappa2 = 0.0;                         // 1/mm
  double flowline = 0.0;                                     // of the gradient's flowline, 1/mm
  glm::dvec3 normal{0.0}, direction1{0.0}, direction2{0.0};  // unit, right-handed (e1, e2, n)
};

// All zero where the gradient is zero or not finite, or the curvature would not be finite. Any scale of
// values.
PrincipalCurvature principalCurvature(glm::dvec3 worldGradient, const glm::dmat3& worldHessian,
                                      double outward = -1.0);

// What a confidence is measured against, the same for a whole volume.
struct CurvatureScale {
  double gradientNoise = 0.0;  // standard deviation of a component of the world gradient, data units per mm
  double flatCurvature = 0.0;  // 1/mm
  double hessianNoise = 0.0;   // standard deviation of a normal second derivative, data units per mm^2
};
// `noise`: standard deviation of a voxel's value, and the blur that its neighbours correlate by
// (scene::NoiseModel), propagated through the field's derivative weights (mean square over positions) and the
// spacing of voxels (root mean square over directions). scaleMm: of the field at a scale (scaled_field.h); 0:
// the field itself.
CurvatureScale curvatureScale(const GridGeometry& geometry, scene::Field field, double noise,
                              const glm::dvec3& noiseBlur = glm::dvec3(0.0), double scaleMm = 0.0);

double curvatureConfidence(const PrincipalCurvature& curvature, glm::dvec3 worldGradient,
                           const CurvatureScale& scale);

}  // namespace isolux::volume
