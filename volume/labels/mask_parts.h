// Holds what both ways to make a mask field share: which voxels are in the set, and the smoothing's kernel.
// Only for the sources of mask_field.h and slice_mask.h.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <type_traits>
#include <vector>

#include "volume/field/scale_kernel.h"
#include "volume/labels/label_blocks.h"

namespace isolux::volume {

inline constexpr float kMaskGuard = 0.04f, kThinBelow = -0.1f, kMaskSteps = 127.0f;

// Returns for each label of the list whether it is one of `labels`.
inline std::vector<bool> membersOf(const LabelBlocks& blocks, std::span<const int> labels) {
  std::vector<bool> isMember(blocks.list().size());
  for (const int label : labels) {
    const auto found = std::ranges::lower_bound(blocks.list(), label, {}, &LabelExtent::label);
    if (found != blocks.list().end() && found->label == label)
      isMember[static_cast<std::size_t>(found - blocks.list().begin())] = true;
  }
  return isMember;
}

// Looks stored values up.
template <class T>
class SetMembers {
 public:
  SetMembers(const LabelBlocks& blocks, const std::vector<bool>& isMember) {
    if constexpr (std::is_integral_v<T>) table_.assign(std::size_t{1} << (8 * sizeof(T)), 0);
    for (std::size_t i = 0; i < isMember.size(); ++i) {
      if (!isMember[i]) continue;
      const T stored = static_cast<T>(blocks.list()[i].stored);
      if constexpr (std::is_integral_v<T>)
        table_[static_cast<std::make_unsigned_t<T>>(stored)] = 1;
      else
        table_.push_back(stored);
    }
    if constexpr (!std::is_integral_v<T>) std::sort(table_.begin(), table_.end());
  }
  bool has(T stored) const {
    if constexpr (std::is_integral_v<T>)
      return table_[static_cast<std::make_unsigned_t<T>>(stored)] != 0;
    else
      return !std::isnan(stored) && std::binary_search(table_.begin(), table_.end(), stored);
  }

 private:
  std::vector<std::conditional_t<std::is_integral_v<T>, std::uint8_t, T>> table_;
};

// The Gaussian along one axis, cut off at ceil(3 smoothing) and of sum 1.
struct MaskWeights {
  std::vector<double> weights;  // of voxels at distance k; at least one
  double sharpening =
      0.0;  // factor of the Laplacian that takes its variance and trilinear interpolation's back

  explicit MaskWeights(double smoothing) : weights(gaussianKernel(smoothing)) {
    constexpr double trilinearVariance = 1.0 / 6.0;
    const auto most = static_cast<std::size_t>(std::ceil(3.0 * smoothing));
    weights.resize(std::min(weights.size(), most + 1));
    const double sum = weights[0] + 2.0 * std::accumulate(weights.begin() + 1, weights.end(), 0.0);
    double variance = 0.0;
    for (std::size_t k = 0; k < weights.size(); ++k) {
      weights[k] /= sum;
      variance += 2.0 * weights[k] * static_cast<double>(k * k);
    }
    sharpening = 0.5 * (variance + trilinearVariance);
  }
  std::size_t radius() const { return weights.size() - 1; }
};

}  // namespace isolux::volume
