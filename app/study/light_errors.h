// How far irradiance that a picture shows is from path-traced truth: pure functions of numbers.
//
// An error is that of one channel of one pixel, in units of irradiance E (linear RGB, with the environment's
// exposure). The truth is an estimate itself: its own noise is taken out of the root mean square, and every
// figure comes with what it leaves uncertain.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::app {

// Path-traced irradiance of some pixels of a view.
struct LightReference {
  std::vector<std::size_t> pixels;     // row 0 at the top, x fastest
  std::vector<glm::dvec3> irradiance;  // E
  std::vector<glm::dvec3> variance;    // of that estimate of E: the square of its standard error
  std::uint64_t samples = 0;           // paths per pixel
  std::uint64_t rays = 0;
};

struct LightErrors {
  std::size_t pixels = 0;
  double mean = 0.0;                           // of the truth, over pixels and channels
  double truthNoise = 0.0;                     // RMS of the truth's standard errors
  double rmse = 0.0, rmseStandardError = 0.0;  // without the truth's noise
  double bias = 0.0, biasStandardError = 0.0;  // mean of the errors
  double most99 = 0.0, most999 = 0.0;          // 99 and 99.9 % quantile of their size, noise included
  double maximum = 0.0;                        // the largest, signed
  double maximumZ = 0.0;                       // in standard errors of the truth there; NaN: it has none
  std::size_t maximumPixel = 0;

  // In parts of the mean; NaN where that is 0.
  double relative(double error) const;
};

// `drawn`: E of every pixel of the view, three numbers a pixel; pixels where it is NaN are left out. All NaN
// where none is left.
LightErrors lightErrorsOf(const std::vector<float>& drawn, const LightReference& reference);

}  // namespace isolux::app
