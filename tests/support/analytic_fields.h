// Closed forms of the built-in phantoms, derived on their own (nothing here calls
// volume/phantom/phantom.cpp): what the code under test is measured against.
//
// Positions are world mm, derivatives per mm. Placement follows volume/phantom/phantom.h: round the middle of
// the voxel domain, scaled with e, the length of its shortest edge. Inside is f >= isovalue, n = -grad f /
// |grad f|, and curvatures are positive where the surface bends away from n (a ball of radius R: both are
// 1/R).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "volume/grid.h"

namespace isolux::test {

struct Derivatives {
  double value = 0.0;
  glm::dvec3 gradient{0.0};
  glm::dmat3 hessian{0.0};
};

struct Curvature {
  double kappa1 = 0.0, kappa2 = 0.0;  // 1/mm, kappa1 >= kappa2
};

class AnalyticField {
 public:
  virtual ~AnalyticField() = default;
  virtual Derivatives at(glm::dvec3 world) const = 0;
  // Curvature of the isosurface through `world`; where there is no shorter way, curvatureOf(at(world)).
  virtual Curvature curvature(glm::dvec3 world) const;
  // Smallest t > 0 where origin + t direction crosses f = isovalue (direction of unit length): by formula for
  // ball, cylinder, plane and saddle, by steps bounded by a Lipschitz constant (to 1e-10 mm) for the others.
  virtual std::optional<double> firstHit(glm::dvec3 origin, glm::dvec3 direction, double isovalue) const = 0;
  // Unit normal at `world`, pointing outward.
  glm::dvec3 normal(glm::dvec3 world) const;
};

// name: ball, torus, cylinder, plane, saddle, gyroid or marschner_lobb.
std::unique_ptr<AnalyticField> analyticField(const std::string& name, const volume::GridGeometry& geometry);

// Principal curvatures of an isosurface from the derivatives of its field, Hadwiger et al. 2005 eq. (2) to
// (4) with the sign above, by the invariants of the tangential Hessian.
Curvature curvatureOf(const Derivatives& derivatives);

// The same by central differences of the value alone: a check of the formulas.
Derivatives differences(const std::function<double(glm::dvec3)>& value, glm::dvec3 world, double step);

// 128^3 placements of the issue: 1 mm cubes; 0.4 x 0.4 x 2.5 mm; oblique, anisotropic and left-handed.
volume::GridGeometry isotropicGeometry(int size);
volume::GridGeometry anisotropicGeometry(int size);
volume::GridGeometry obliqueLeftHandedGeometry(int size);

}  // namespace isolux::test
