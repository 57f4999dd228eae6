// Curvatures and normals of a surface at one scale after another, and what noise does to them.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "volume/grid.h"
#include "volume/statistics/points_at_scale.h"
#include "volume/statistics/scale_errors.h"

namespace isolux::volume {

class ScaleLadder {
 public:
  // points: on the surface, voxel coordinates. noiseBlur as in scene::NoiseModel.
  ScaleLadder(const Grid& grid, std::vector<glm::dvec3> points, const glm::dvec3& noiseBlur);

  std::size_t points() const { return points_.size(); }

  // 0, then steps of sqrt 2 from the first that smooths more than the spline does, to about 4 voxels.
  bool complete() const { return steps_.size() == scalesMm_.size(); }
  // Above 0 missing voxels have the numbers of fill_missing.h, where memory has room for them. Throws
  // Error{interrupted}.
  void addScale(base::Progress& progress);
  double scaleMm(std::size_t step) const { return scalesMm_[step]; }

  // Of the scales that have been added; points without a missing voxel among the spline's samples at which
  // all of them have a clear gradient, weighted by its square. The squared sum of both principal curvatures'
  // errors, 1/mm^2; of the normal's, radians^2.
  struct Measures {
    std::vector<ScaleStep> curvature, normal;
    std::vector<double> meanSquareCurvature;  // of kappa1^2 + kappa2^2, with their noise
    std::size_t points = 0;
  };
  Measures measures() const;
  // The same of the half of these points whose curvature changes least from 1 to 2 voxels. Requires five
  // scales.
  Measures evenMeasures() const;

  // The share of all points whose curvature at scale 0 has a confidence below one half (curvature.h), at this
  // noise of a voxel.
  double unknownShare(double noise) const;
  // How much of what scale 0 bends more than a voxel's does, across slices, repeats every `period` voxels
  // along an axis: power at that frequency (interpolated_slices.h). Requires three scales.
  double repetition(int axis, double period) const;

 private:
  struct AtPoint {
    double slope = 0.0;  // |g|
    glm::dvec3 normal{0.0};
    glm::dmat3 shape{0.0};  // P H P / |g|: its eigenvalues are 0 and the curvatures
  };
  struct Step {
    std::vector<AtPoint> points;
    double medianSlope = 0.0;
    PointNoise noise, noiseWithNext;  // variances; covariances with the next scale's
  };
  std::vector<char> clearPoints() const;
  Measures measuresOf(const std::vector<char>& chosen) const;
  void fill(base::Progress& progress);

  const Grid& grid_;
  std::vector<glm::dvec3> points_;
  glm::dvec3 noiseBlur_;
  std::vector<double> scalesMm_;
  std::vector<float> filled_;  // stored voxels, where some are missing
  base::MemoryBudget::Held held_;
  std::vector<Step> steps_;
};

}  // namespace isolux::volume
