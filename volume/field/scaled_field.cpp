#include "volume/field/scaled_field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include <glm/matrix.hpp>

#include "volume/field/fill_missing.h"
#include "volume/field/sheared_filter.h"
#include "volume/field/symmetric_filter.h"

namespace isolux::volume {

namespace {

constexpr const char* kSmoothing = "smoothing";
constexpr double kOrthogonal = 1e-6;  // cosine of axes, below which they count as orthogonal
constexpr double kLeastKnown = 1e-6;  // of a kernel's weight on known samples: below, it reaches none
constexpr double kLongest = 4.0;      // a Gaussian of this many axis lengths leaves nothing but the ramp
constexpr double kSplineDeviation = 0.57735026918962576;  // of the cubic B-spline, voxels: variance 1/3

// (A^T A)^-1: the covariance of a Gaussian of deviation 1 mm, voxels^2.
glm::dmat3 unitCovariance(const GridGeometry& geometry) {
  const glm::dmat3 world(geometry.worldFromVoxel);
  return glm::inverse(glm::transpose(world) * world);
}

base::ProgressRange partOf(base::ProgressRange share, double from, double to) {
  return {share.from + (share.to - share.from) * from, share.from + (share.to - share.from) * to,
          share.stage};
}

// The Gaussian of a scale for one grid: kernels of axes that are orthogonal to the others, and lines of the
// lattice for all others together.
class Smoothing {
 public:
  Smoothing(const GridGeometry& geometry, scene::Field field, double scaleMm) : dims_(geometry.dims) {
    const glm::dmat3 covariance = unitCovariance(geometry);
    const glm::dvec3 deviations = deviationsInVoxels(geometry, scaleMm);
    glm::dmat3 correlations(1.0);
    glm::dvec3 together(0.0);  // deviations of axes that are not alone
    for (int i = 0; i < 3; ++i) {
      const double deviation = std::min(deviations[i], kLongest * dims_[i]);
      axes_[static_cast<std::size_t>(i)] = smoothingKernel(field, deviation);
      const double least = field == scene::Field::cubic ? kSplineDeviation : 0.0;
      for (int j = 0; j < 3; ++j) {
        correlations[i][j] = covariance[i][j] / std::sqrt(covariance[i][i] * covariance[j][j]);
        alone_[i] = alone_[i] && (i == j || std::abs(correlations[i][j]) < kOrthogonal);
      }
      if (!alone_[i]) together[i] = std::max(deviation, least);
    }
    if (!separable())
      lines_ = latticeLines(glm::matrixCompMult(correlations, glm::outerProduct(together, together)));
  }

  bool separable() const { return alone_.x && alone_.y && alone_.z; }
  // Of the axis; 1 where alongLines() has it.
  HalfKernel axis(int i) const { return alone_[i] ? axes_[static_cast<std::size_t>(i)] : HalfKernel{1.0}; }

  void alongLines(std::vector<float>& values, Beyond beyond, base::Progress& progress,
                  base::ProgressRange share) const {
    if (!separable()) filterLatticeLines(values, dims_, lines_, beyond, progress, share);
  }
  void operator()(std::vector<float>& values, Beyond beyond, base::Progress& progress,
                  base::ProgressRange share) const {
    alongLines(values, beyond, progress, partOf(share, 0.0, 0.25));
    for (int i = 0; i < 3; ++i)
      filterAxis(values, i, axis(i), beyond, progress, partOf(share, 0.25 * (i + 1), 0.25 * (i + 2)));
  }
  void filterAxis(std::vector<float>& values, int i, const HalfKernel& kernel, Beyond beyond,
                  base::Progress& progress, base::ProgressRange share) const {
    if (kernel.size() > 1)
      filterLines(i, values, dims_, progress, share,
                  SymmetricFilter(kernel, static_cast<std::size_t>(dims_[i]), beyond));
  }

 private:
  glm::ivec3 dims_;
  std::array<HalfKernel, 3> axes_;
  glm::bvec3 alone_{true};
  std::vector<LatticeLine> lines_;
};

// Missing values become the mean of known ones, weighted by the smoothing.
void fillWithMeans(std::vector<float>& values, glm::ivec3 dims, const Smoothing& smoothing,
                   base::Progress& progress, base::ProgressRange share) {
  std::vector<float> sums, known;
  resizeStoppably(sums, values.size(), progress);
  resizeStoppably(known, values.size(), progress);
  constexpr std::size_t kVoxels = std::size_t{1} << 18;
  parallelPieces(values.size(), kVoxels, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      known[i] = std::isnan(values[i]) ? 0.0f : 1.0f;
      sums[i] = std::isnan(values[i]) ? 0.0f : values[i];
    }
  });
  smoothing(sums, Beyond::nothing, progress, partOf(share, 0.0, 0.4));
  smoothing(known, Beyond::nothing, progress, partOf(share, 0.4, 0.8));
  parallelPieces(values.size(), kVoxels, progress, {}, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (std::isnan(values[i]) && static_cast<double>(known[i]) > kLeastKnown)
        values[i] = sums[i] / known[i];
  });
  fillMissing(values, dims, progress, partOf(share, 0.8, 1.0));
}

}  // namespace

glm::dvec3 deviationsInVoxels(const GridGeometry& geometry, double scaleMm) {
  const glm::dmat3 covariance = unitCovariance(geometry);
  return scaleMm *
         glm::dvec3(std::sqrt(covariance[0][0]), std::sqrt(covariance[1][1]), std::sqrt(covariance[2][2]));
}

ScaledField scaledField(const Grid& grid, scene::Field field, double scaleMm, base::Progress& progress) {
  assert(field != scene::Field::trilinear && scaleMm > 0.0);
  progress.report(0.0, kSmoothing);
  const Smoothing smoothing(grid.geometry(), field, scaleMm);
  const std::size_t bytes = grid.geometry().voxelCount() * sizeof(float);
  const bool gaps = grid.missingCount() > 0;
  base::MemoryBudget::Held held = base::machineMemory().reserve(
      bytes * (1 + (gaps ? 2 : 0) + (smoothing.separable() ? 0 : 1)), "derivatives at a scale",
      "derivatives.scale 0 and derivatives.normal_scale 0 need none");
  ScaledField result{field, scaleMm, samplesApart(grid, progress, {0.0, 0.1, kSmoothing})};
  std::vector<float>& values = result.coefficients.values;
  if (gaps) fillWithMeans(values, grid.dims(), smoothing, progress, {0.1, 0.4, kSmoothing});
  smoothing.alongLines(values, Beyond::reflected, progress, {0.4, 0.6, kSmoothing});
  for (int i = 0; i < 3; ++i)
    smoothing.filterAxis(values, i, scaleKernel(smoothing.axis(i)), Beyond::reflected, progress,
                         {0.6 + 0.1 * i, 0.7 + 0.1 * i, kSmoothing});
  findRange(result.coefficients, progress);
  held.shrinkTo(bytes);
  result.coefficients.held = std::move(held);
  return result;
}

}  // namespace isolux::volume
