#include "app/study/scale_study.h"

#include <chrono>
#include <cmath>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "base/clock.h"
#include "base/quantiles.h"
#include "base/random.h"
#include "volume/field/curvature.h"
#include "volume/field/reconstruct.h"
#include "volume/field/scale_kernel.h"
#include "volume/field/symmetric_filter.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::app {

namespace {

using volume::Grid;

double medianGradient(const Grid& grid, const std::vector<glm::dvec3>& points) {
  std::vector<double> lengths;
  for (const glm::dvec3& point : points)
    if (const double length = glm::length(volume::sampleCubic(grid, point).gradient); std::isfinite(length))
      lengths.push_back(length);
  return lengths.empty() ? 0.0 : base::median(std::move(lengths));
}

// Of variance 1: white noise blurred along each axis.
std::vector<float> unitNoise(glm::ivec3 dims, const glm::dvec3& blur, std::uint64_t seed,
                             base::Progress& progress) {
  std::vector<float> values;
  volume::resizeStoppably(values, volume::Extent3{dims}.count(), progress);
  volume::parallelPieces(values.size(), std::size_t{1} << 16, progress, {},
                         [&](std::size_t begin, std::size_t end) {
                           for (std::size_t i = begin; i < end; ++i)
                             values[i] = static_cast<float>(base::normalNoise(seed, i));
                         });
  for (int axis = 0; axis < 3; ++axis) {
    if (!(blur[axis] > 0.0)) continue;
    volume::HalfKernel kernel = volume::gaussianKernel(blur[axis]);
    double squares = kernel[0] * kernel[0];
    for (std::size_t k = 1; k < kernel.size(); ++k) squares += 2.0 * kernel[k] * kernel[k];
    for (double& weight : kernel) weight /= std::sqrt(squares);
    const auto length = static_cast<std::size_t>(dims[axis]);
    volume::filterLines(axis, values, dims, progress, {},
                        volume::SymmetricFilter(kernel, length, volume::Beyond::nothing));
  }
  return values;
}

}  // namespace

ScaleStudyRunner::ScaleStudyRunner(std::shared_ptr<const volume::PreparedVolume> volume,
                                   const scene::Scene& resolved, std::vector<glm::dvec3> points,
                                   scene::NoiseModel noise)
    : volume_(std::move(volume)),
      points_(std::move(points)),
      noise_(std::move(noise)),
      field_(resolved.derivatives.field),
      phantom_(resolved.source.path.starts_with("phantom:") && resolved.source.csg == scene::Csg::none),
      outward_(resolved.isosurface.inside == scene::Inside::above ? -1.0 : 1.0),
      flatCurvature_(volume::curvatureScale(volume_->grid().geometry(), field_, 0.0).flatCurvature) {
  if (phantom_) noise_.correlation = glm::dvec3(0.0);
  deviation_ = phantom_ ? kPhantomNoiseVoxels * medianGradient(volume_->grid(), points_)
                        : noise_.at(*resolved.surfaces.front().value);
}

ScaleStudyRunner::Shapes ScaleStudyRunner::shapesOf(const Grid& grid, scene::Field field, double scaleMm,
                                                    std::vector<double>& seconds,
                                                    base::Progress& progress) const {
  std::optional<volume::ScaledField> scaled;
  std::optional<volume::Coefficients> coefficients;
  const auto begin = std::chrono::steady_clock::now();
  if (scaleMm > 0.0)
    scaled = volume::scaledField(grid, field, scaleMm, progress);
  else if (field == scene::Field::cubic_interpolating)
    coefficients = volume::interpolatingCoefficients(grid, progress);
  seconds.push_back(base::secondsSince(begin));
  Shapes shapes(points_.size());
  volume::parallelEach(points_.size(), [&](std::size_t i) {
    const volume::FieldSample sample = volume::sampleField(
        grid, field, coefficients ? &*coefficients : nullptr, points_[i], scaled ? &*scaled : nullptr);
    const volume::PrincipalCurvature curvature =
        volume::principalCurvature(volume::worldGradient(grid.geometry(), sample.gradient),
                                   volume::worldHessian(grid.geometry(), sample.hessian), outward_);
    const bool known = std::isfinite(sample.value) && curvature.normal != glm::dvec3(0.0);
    shapes[i] = {known, known, curvature.normal, curvature.kappa1, curvature.kappa2};
  });
  return shapes;
}

const ScaleStudyRunner::Shapes& ScaleStudyRunner::referenceAt(double scaleMm, base::Progress& progress) {
  const double scale = phantom_ ? 0.0 : scaleMm;
  const scene::Field field = phantom_ ? scene::Field::cubic_interpolating : field_;
  if (const auto found = references_.find(scale); found != references_.end()) return found->second;
  std::vector<double> unused;
  return references_.emplace(scale, shapesOf(volume_->grid(), field, scale, unused, progress)).first->second;
}

Grid ScaleStudyRunner::noisy(int seed, base::Progress& progress) const {
  const Grid& grid = volume_->grid();
  std::vector<float> values =
      unitNoise(grid.dims(), noise_.correlation, static_cast<std::uint64_t>(seed), progress);
  const double storedDeviation = deviation_ / std::abs(grid.slope());
  grid.visit([&](const auto& voxels) {
    volume::parallelPieces(
        values.size(), std::size_t{1} << 16, progress, {}, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            values[i] = static_cast<float>(static_cast<double>(voxels[i]) +
                                           storedDeviation * static_cast<double>(values[i]));
        });
  });
  return Grid(grid.geometry(), std::move(values), grid.slope(), grid.intercept(), progress);
}

ScaleFindings ScaleStudyRunner::at(double scaleMm, base::Progress& progress) {
  const Shapes& reference = referenceAt(scaleMm, progress);
  std::vector<double> normals, curvatures, seconds;
  for (int seed = 0; seed < kNoiseSeeds; ++seed) {
    const Shapes shapes = shapesOf(noisy(seed, progress), field_, scaleMm, seconds, progress);
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      if (!reference[i].hasNormal || !shapes[i].hasNormal) continue;
      normals.push_back(angleDegrees(shapes[i].normal, reference[i].normal));
      curvatures.push_back(curvatureError(shapes[i].kappa1, shapes[i].kappa2, reference[i], flatCurvature_));
    }
  }
  return {{spreadOf(std::move(normals)), spreadOf(std::move(curvatures))},
          scaleMm > 0.0 ? base::median(std::move(seconds)) : 0.0};
}

}  // namespace isolux::app
