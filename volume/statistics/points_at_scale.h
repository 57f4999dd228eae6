// Derivatives at single points of a volume smoothed by a Gaussian, by direct sums: for a few hundred points
// quicker than making the smoothed field.
//
// The field is the tri-cubic B-spline of the samples smoothed by what the spline's own variance (1/3 voxel^2
// along each axis) lacks of the Gaussian's: that of volume/field/scaled_field.h but for the last digits. An
// axis along which the spline is as smooth already is left as it is; scale 0 is `sampleCubic`.
#pragma once

#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "volume/grid.h"

namespace isolux::volume {

struct PointDerivatives {
  glm::dvec3 gradient{0.0};  // world, data units per mm; NaN where a voxel is missing
  glm::dmat3 hessian{0.0};   // per mm^2
};

// points: voxel coordinates. scaleMm: deviation of the Gaussian. Samples beyond the border go on by
// point reflection. filled: the stored voxels with numbers in place of missing ones (fill_missing.h); null:
// those of the grid. On all cores.
std::vector<PointDerivatives> derivativesAtScale(const Grid& grid, std::span<const glm::dvec3> points,
                                                 double scaleMm, const std::vector<float>* filled = nullptr);

// What a scale smooths by in all along each axis, voxels^2.
glm::dvec3 smoothingAtScale(const GridGeometry& geometry, double scaleMm);

// Variances that noise of variance 1 leaves in them, mean over positions and directions.
struct PointNoise {
  double gradient = 0.0;  // of a component
  double hessian = 0.0;   // of a normal second derivative; of a mixed one a third
};
// noiseBlur as in scene::NoiseModel. The covariance of derivatives at two scales is that at the mean of
// their smoothings: the autocorrelation of a Gaussian is one of twice its variance.
PointNoise pointNoise(const GridGeometry& geometry, const glm::dvec3& smoothing, const glm::dvec3& noiseBlur);

}  // namespace isolux::volume
