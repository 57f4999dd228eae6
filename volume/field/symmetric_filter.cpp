#include "volume/field/symmetric_filter.h"

#include <algorithm>

namespace isolux::volume {

namespace {

// Of odd samples with period 2 (length - 1).
HalfKernel foldedTo(std::size_t length, const HalfKernel& kernel) {
  const std::size_t period = 2 * (length - 1);
  if (kernel.size() <= length) return kernel;
  HalfKernel folded(length);
  for (std::size_t k = 0; k < kernel.size(); ++k) {
    const std::size_t at = k % period, distance = std::min(at, period - at);
    // Weights stand for both sides, but the one at distance 0, where k and -k come together.
    folded[distance] += (distance == 0 && k > 0 ? 2.0 : 1.0) * kernel[k];
  }
  return folded;
}

}  // namespace

SymmetricFilter::SymmetricFilter(const HalfKernel& kernel, std::size_t length, Beyond beyond)
    : length_(length),
      reach_(0),
      beyond_(beyond),
      kernel_(beyond == Beyond::reflected && length > 1 ? foldedTo(length, kernel) : kernel),
      first_(kLines),
      slope_(kLines) {
  if (beyond == Beyond::nothing) kernel_.resize(std::min(kernel_.size(), length));
  reach_ = kernel_.size() - 1;
  samples_.resize((length_ + 2 * reach_) * kLines);
}

void SymmetricFilter::operator()(const FilterLines& lines) {
  if (length_ < 2 && beyond_ == Beyond::reflected) return;
  load(lines);
  if (beyond_ == Beyond::reflected) extend();
  store(lines);
}

void SymmetricFilter::load(const FilterLines& lines) {
  for (std::size_t k = 0; k < length_; ++k)
    for (std::size_t r = 0; r < lines.count; ++r)
      sample(k)[r] = static_cast<double>(lines.first[k * lines.stride + r * lines.lineStride]);
}

// Less their ramp, reflections are odd about both ends.
void SymmetricFilter::extend() {
  const auto last = static_cast<double>(length_ - 1);
  for (std::size_t r = 0; r < kLines; ++r) {
    first_[r] = sample(0)[r];
    slope_[r] = (sample(length_ - 1)[r] - first_[r]) / last;
  }
  for (std::size_t k = 0; k < length_; ++k)
    for (std::size_t r = 0; r < kLines; ++r) sample(k)[r] -= first_[r] + slope_[r] * static_cast<double>(k);
  for (std::size_t k = 1; k <= reach_; ++k) {
    const double *left = sample(k), *right = sample(length_ - 1 - k);
    double *before = sample(0) - k * kLines, *behind = sample(length_ - 1 + k);
    for (std::size_t r = 0; r < kLines; ++r) {
      before[r] = -left[r];
      behind[r] = -right[r];
    }
  }
}

void SymmetricFilter::store(const FilterLines& lines) const {
  for (std::size_t k = 0; k < length_; ++k) {
    const double* const at = sample(k);
    double sum[kLines];
    for (std::size_t r = 0; r < kLines; ++r) sum[r] = kernel_[0] * at[r];
    for (std::size_t m = 1; m <= reach_; ++m) {
      const double weight = kernel_[m], *before = at - m * kLines, *behind = at + m * kLines;
      for (std::size_t r = 0; r < kLines; ++r) sum[r] += weight * (before[r] + behind[r]);
    }
    if (beyond_ == Beyond::reflected)
      for (std::size_t r = 0; r < kLines; ++r) sum[r] += first_[r] + slope_[r] * static_cast<double>(k);
    for (std::size_t r = 0; r < lines.count; ++r)
      lines.first[k * lines.stride + r * lines.lineStride] = static_cast<float>(sum[r]);
  }
}

}  // namespace isolux::volume
