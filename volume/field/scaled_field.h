// The field at a scale: a grid's samples smoothed by a Gaussian that is isotropic in the world, and the
// tri-quintic B-spline that takes their values at the voxels.
//
// Derivatives of a scale above 0 come from it (derivatives.scale, derivatives.normal_scale). Quintic, because
// the second derivatives of a cubic spline are piecewise linear, wrong by (omega h)^2 / 12 whatever its
// coefficients are. Along axes that are orthogonal the Gaussian is separable, with the deviation scaleMm /
// spacing in voxels (scale_kernel.h has the kernels, and what `cubic` means here); in a sheared grid its
// covariance is scaleMm^2 (A^T A)^-1 (sheared_filter.h).
//
// Beyond the border samples and coefficients go on by point reflection, f(-k) = 2 f(0) - f(k): a ramp stays
// one. Lookups fold the weights of taps beyond the border (quintic_weights.h). Missing voxels become the mean
// of the known ones about them with the Gaussian's weights (normalised convolution); where the Gaussian
// reaches none, what fill_missing.h gives. No coefficient is NaN: where there is a surface is for hits to
// say.
#pragma once

#include "base/progress.h"
#include "scene/choices.h"
#include "volume/field/coefficients.h"
#include "volume/grid.h"

namespace isolux::volume {

struct ScaledField {
  scene::Field field = scene::Field::cubic;
  double scaleMm = 0.0;
  Coefficients coefficients;  // of the quintic B-spline
};

// `field`: cubic or cubic_interpolating; scaleMm > 0. Multithreaded, float result, double arithmetic. Throws
// Error{interrupted}; Error{memory} before anything is made.
ScaledField scaledField(const Grid& grid, scene::Field field, double scaleMm, base::Progress& progress);

// Standard deviation of the Gaussian along each axis, voxels: the square roots of the diagonal of
// scaleMm^2 (A^T A)^-1, which is scaleMm / spacing where the axes are orthogonal.
glm::dvec3 deviationsInVoxels(const GridGeometry& geometry, double scaleMm);

}  // namespace isolux::volume
