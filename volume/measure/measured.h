// A number with the error that it has, and what the error is made of.
#pragma once

namespace isolux::volume {

struct Measured {
  double value = 0.0,
         error = 0.0;  // of the same unit; the value is expected within +-error of the object's own
};

// Bounds and two standard deviations, in the unit of what they are of; a Measured states their sum.
struct ErrorParts {
  double quadrature = 0.0;  // of the integral over the trilinear surface
  double sampling = 0.0;    // what it costs that the object is known at the voxels only (sampling_error.h)
  double noise = 0.0;       // of the voxels
  double cut = 0.0;         // at the walls of a box that cut cells of a leaning grid
  double slices = 0.0;      // between slices that are far apart and were resampled
  double sum() const { return quadrature + sampling + noise + cut + slices; }
};

}  // namespace isolux::volume
