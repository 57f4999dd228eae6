// Values of a second volume at world points, through its own geometry, in double precision.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include <glm/mat4x4.hpp>

#include "volume/color/second_volume.h"
#include "volume/statistics/curvature_statistics.h"

namespace isolux::volume {

struct SecondValue {
  double value = 0.0;        // data units
  glm::dvec3 gradient{0.0};  // per mm, world
};

class SecondValues {
 public:
  // field: as color.field; coefficients are there where it is cubic_interpolating (SecondVolumes::make).
  SecondValues(std::shared_ptr<const SecondVolume> volume, scene::Field field);

  // None outside of the voxels' box and where a voxel that the value is made of is missing.
  std::optional<SecondValue> at(const glm::dvec3& worldMm) const;
  // The largest on the way of `mm` along the unit vector `inward`, of what there is: the largest of samples
  // half a voxel apart, moved to the top of the parabola with its slope through the neighbour that it rises
  // to, if that is larger. Its gradient is that at that place: along a surface the largest value changes by
  // it.
  std::optional<SecondValue> largestBelow(const glm::dvec3& worldMm, const glm::dvec3& inward,
                                          double mm) const;

 private:
  std::shared_ptr<const SecondVolume> volume_;
  scene::Field field_;
  glm::dmat4 voxelFromWorld_;
};

// The 2 %, 50 % and 98 % quantiles of values; none without any.
std::optional<Quantiles> rangeOf(std::span<const double> values);

}  // namespace isolux::volume
