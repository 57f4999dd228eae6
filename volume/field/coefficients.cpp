#include "volume/field/coefficients.h"

#include <array>
#include <cmath>

#include <tbb/combinable.h>

#include "volume/field/fill_missing.h"
#include "volume/field/filter_lines.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr const char* kStage = "interpolating";
const double kPole = std::sqrt(3.0) - 2.0;

// Turns samples into cubic B-spline coefficients in place (Unser, Aldroubi & Eden 1993, part II, box 2): one
// causal and one anticausal first-order recursion. Both boundaries are mirrors half a sample beyond the
// border sample, c[-1] = c[0] and c[n] = c[n-1], because that is what clamped lookups see: so the spline
// interpolates at the border samples too.
class Prefilter {
 public:
  explicit Prefilter(std::size_t length) : n_(length), c_(length * kLines) {}

  void operator()(const FilterLines& lines) {
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t r = 0; r < lines.count; ++r)
        c_[k * kLines + r] = static_cast<double>(lines.first[k * lines.stride + r * lines.lineStride]);
    start();
    for (std::size_t k = 1; k < n_; ++k)
      for (std::size_t r = 0; r < kLines; ++r) c_[k * kLines + r] += kPole * c_[(k - 1) * kLines + r];
    for (std::size_t r = 0; r < kLines; ++r) c_[(n_ - 1) * kLines + r] *= kPole / (kPole - 1.0);
    for (std::size_t k = n_ - 1; k-- > 0;)
      for (std::size_t r = 0; r < kLines; ++r)
        c_[k * kLines + r] = kPole * (c_[(k + 1) * kLines + r] - c_[k * kLines + r]);
    for (std::size_t k = 0; k < n_; ++k)
      for (std::size_t r = 0; r < lines.count; ++r)
        lines.first[k * lines.stride + r * lines.lineStride] = static_cast<float>(6.0 * c_[k * kLines + r]);
  }

 private:
  // c+[0] = f[0] + sum_{m>=1} z^m f[-m], the mirrored signal having period 2n.
  void start() {
    std::array<double, kLines> sum{};
    const auto add = [&](double weight, std::size_t k) {
      for (std::size_t r = 0; r < kLines; ++r) sum[r] += weight * c_[k * kLines + r];
    };
    double power = kPole;
    const double wrap = std::pow(kPole, 2.0 * static_cast<double>(n_));
    for (std::size_t k = 0; k < n_ && std::abs(power) >= 1e-30; ++k, power *= kPole) add(power, k);
    if (std::abs(wrap) > 1e-30) {
      double back = wrap;
      for (std::size_t k = 0; k < n_; ++k, back /= kPole) add(back, k);
    }
    for (std::size_t r = 0; r < kLines; ++r) c_[r] += sum[r] / (1.0 - wrap);
  }

  std::size_t n_;
  std::vector<double> c_;  // sample k of line r at k * kLines + r
};

}  // namespace

Coefficients samplesApart(const Grid& grid, base::Progress& progress, base::ProgressRange share) {
  Coefficients result;
  const double middle = 0.5 * grid.storedMinimum() + 0.5 * grid.storedMaximum();
  if (std::abs(middle) > grid.storedMaximum() - grid.storedMinimum()) result.offset = middle;
  resizeStoppably(result.values, grid.geometry().voxelCount(), progress);
  grid.visit([&, offset = result.offset, values = result.values.data()](const auto& voxels) {
    parallelPieces(voxels.size(), std::size_t{1} << 18, progress, share,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i)
                       values[i] = static_cast<float>(static_cast<double>(voxels[i]) - offset);
                   });
  });
  return result;
}

void findRange(Coefficients& coefficients, base::Progress& progress) {
  const std::vector<float>& values = coefficients.values;
  tbb::combinable<Bounds<float>> partial;
  parallelPieces(values.size(), std::size_t{1} << 18, progress, {}, [&](std::size_t begin, std::size_t end) {
    Bounds<float> range;
    for (std::size_t i = begin; i < end; ++i) range.add(values[i]);
    partial.local().add(range);
  });
  Bounds<float> all;
  partial.combine_each([&](const Bounds<float>& range) { all.add(range); });
  coefficients.least = all.low;
  coefficients.most = all.high;
}

Coefficients interpolatingCoefficients(const Grid& grid, base::Progress& progress) {
  base::MemoryBudget::Held held = base::machineMemory().reserve(
      grid.geometry().voxelCount() * sizeof(float), "the field cubic_interpolating",
      "the field cubic of hit.field and derivatives.field needs none");
  Coefficients result = samplesApart(grid, progress, {0.0, 0.1, kStage});
  result.held = std::move(held);
  if (grid.missingCount() > 0) fillMissing(result.values, grid.dims(), progress, {0.1, 0.4, kStage});
  for (int axis = 0; axis < 3; ++axis)
    if (grid.dims()[axis] > 1)
      filterLines(axis, result.values, grid.dims(), progress, {0.4 + 0.2 * axis, 0.6 + 0.2 * axis, kStage},
                  Prefilter(static_cast<std::size_t>(grid.dims()[axis])));
  findRange(result, progress);
  return result;
}

}  // namespace isolux::volume
