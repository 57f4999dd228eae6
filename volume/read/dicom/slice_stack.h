// Orders parallel slices by position and finds the grid they lie on. Positions in mm, LPS.
//
// Even distances give a grid as they are, also when the slices are sheared against each other (gantry tilt):
// worldFromVoxel holds that exactly, so nothing is resampled. Uneven distances and missing slices need
// resampling along the slice axis; the plan says from which slices. What fits neither is refused.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "volume/read/dicom/repeated_slices.h"

namespace isolux::volume {

// The first voxel of each slice, and what all slices share.
struct SlicePlanes {
  std::vector<glm::dvec3> positionsMm;
  glm::dvec3 rowDirection{1, 0, 0};     // along a row: +x of the voxels
  glm::dvec3 columnDirection{0, 1, 0};  // down a column: +y of the voxels
  double spacingXMm = 1.0, spacingYMm = 1.0;
  double thicknessMm = 1.0;     // for a single slice; 0: not stated
  double distanceMm = 0.0;      // of slices, as the file states it, to compare; 0: not stated
  std::vector<ImageTags> tags;  // of each slice, or empty
};

struct SliceStack {
  // One output slice: (1 - fraction) * source[first] + fraction * source[first + 1], indices into `order`
  // of one time step.
  struct Blend {
    std::size_t first = 0;
    double fraction = 0.0;
  };
  std::vector<std::size_t> order;  // time step by time step, each sorted by position; indices of positionsMm
  std::size_t timeSteps = 1;
  std::vector<Blend> resampled;  // empty: the slices as they are
  glm::dmat4 worldFromVoxel{1.0};
  std::vector<std::string> warnings;

  std::size_t sourceSlices() const { return order.size() / timeSteps; }
  std::size_t slices() const { return resampled.empty() ? sourceSlices() : resampled.size(); }
};

// Throws Error{input} for slices that lie beside a line, gaps too wide to fill, directions that span nothing.
SliceStack stackSlices(const SlicePlanes& planes, const std::string& file);

}  // namespace isolux::volume
