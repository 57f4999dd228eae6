#include "volume/measure/sampling_error.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "volume/field/reconstruct.h"

namespace isolux::volume {

SamplingShift& SamplingShift::operator+=(const SamplingShift& other) {
  volume += other.volume;
  bent += other.bent;
  rough += other.rough;
  measuredArea += other.measuredArea;
  volumeSquares += other.volumeSquares;
  areaSquares += other.areaSquares;
  return *this;
}

double SamplingShift::area() const {
  return std::abs(bent) + rough;
}

SamplingShifts::SamplingShifts(const Grid& grid, double isovalue, double sign)
    : grid_(grid),
      isovalue_(isovalue),
      sign_(sign),
      worldGradient_(glm::transpose(glm::inverse(glm::dmat3(grid.geometry().worldFromVoxel)))),
      voxelMm_(grid.geometry().voxelMm()) {}

SamplingShift SamplingShifts::at(glm::ivec3 cell, const CellPoint& point) const {
  for (int axis = 0; axis < 3; ++axis) {
    const int voxels = grid_.dims()[axis];
    if (voxels >= 4 && (cell[axis] < 1 || cell[axis] + 3 > voxels)) return {};
  }
  const FieldSample cubic = sampleCubic(grid_, glm::dvec3(cell) + point.local);
  const glm::dvec3 gradient = sign_ * (worldGradient_ * cubic.gradient);
  const glm::dvec3 trilinear = worldGradient_ * point.gradient;
  const double steepness = glm::length(gradient), other = glm::length(trilinear);
  if (!(steepness > 0.0 && other > 0.0) || !std::isfinite(cubic.value)) return {};
  const glm::dmat3 hessian = sign_ * (worldGradient_ * cubic.hessian * glm::transpose(worldGradient_));
  const glm::dvec3 up = gradient / steepness;
  const double trace = hessian[0][0] + hessian[1][1] + hessian[2][2];
  const double bend =
      std::clamp((glm::dot(up, hessian * up) - trace) / steepness, -1.0 / voxelMm_, 1.0 / voxelMm_);
  const double offset = std::clamp(sign_ * (cubic.value - isovalue_) / steepness, -voxelMm_, voxelMm_);
  const double cosine = glm::dot(up, trilinear) / other;
  SamplingShift shift;
  shift.measuredArea = point.area;
  shift.volume = point.area * offset * (1.0 + 0.5 * bend * offset);
  shift.bent = point.area * bend * offset;
  shift.rough = point.area * std::max(1.0 - cosine, 0.0);
  return shift;
}

}  // namespace isolux::volume
