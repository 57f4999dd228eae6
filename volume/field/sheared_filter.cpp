#include "volume/field/sheared_filter.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace isolux::volume {

namespace {

constexpr double kShearedReach = 6.5;  // deviations
constexpr double kLeastTap = 1e-9;     // of the largest

struct Tap1D {
  int at;
  double weight;
};

// What the sample `k` of an axis of n samples is made of.
std::vector<Tap1D> extendedSample(int k, int n, Beyond beyond) {
  if (k >= 0 && k < n) return {{k, 1.0}};
  if (beyond == Beyond::nothing) return {};
  if (n == 1) return {{0, 1.0}};
  std::vector<Tap1D> parts;
  double sign = 1.0;
  while (k < 0 || k > n - 1) {
    const int border = k < 0 ? 0 : n - 1;
    parts.push_back({border, 2.0 * sign});
    sign = -sign;
    k = 2 * border - k;
  }
  parts.push_back({k, sign});
  return parts;
}

// Taps whose rows are the same.
struct RowTaps {
  int dy, dz;
  std::vector<Tap1D> along;  // x
};

std::vector<RowTaps> byRow(const std::vector<KernelTap>& taps) {
  std::vector<RowTaps> rows;
  for (const KernelTap& tap : taps) {
    if (rows.empty() || rows.back().dy != tap.offset.y || rows.back().dz != tap.offset.z)
      rows.push_back({tap.offset.y, tap.offset.z, {}});
    rows.back().along.push_back({tap.offset.x, tap.weight});
  }
  return rows;
}

class DirectFilter {
 public:
  DirectFilter(const std::vector<float>& values, glm::ivec3 dims, const std::vector<KernelTap>& taps,
               Beyond beyond)
      : values_(values), dims_(dims), beyond_(beyond), rows_(byRow(taps)) {
    for (const KernelTap& tap : taps) reach_ = std::max(reach_, std::abs(tap.offset.x));
    for (int k = 1; k <= reach_; ++k) {
      before_.push_back(extendedSample(-k, dims.x, beyond));
      behind_.push_back(extendedSample(dims.x - 1 + k, dims.x, beyond));
    }
  }

  void operator()(int y, int z, float* result) const {
    const auto width = static_cast<std::size_t>(dims_.x), reach = static_cast<std::size_t>(reach_);
    std::vector<double> sum(width), row(width + 2 * reach);
    for (const RowTaps& taps : rows_) {
      fetchRow(y + taps.dy, z + taps.dz, row);
      for (const Tap1D& tap : taps.along) {
        const double* const from = row.data() + reach_ + tap.at;
        for (std::size_t x = 0; x < width; ++x) sum[x] += tap.weight * from[x];
      }
    }
    for (std::size_t x = 0; x < width; ++x) result[x] = static_cast<float>(sum[x]);
  }

 private:
  void fetchRow(int y, int z, std::vector<double>& row) const {
    const auto width = static_cast<std::size_t>(dims_.x), reach = static_cast<std::size_t>(reach_);
    std::fill(row.begin(), row.end(), 0.0);
    double* const middle = row.data() + reach;
    for (const Tap1D& inZ : extendedSample(z, dims_.z, beyond_))
      for (const Tap1D& inY : extendedSample(y, dims_.y, beyond_)) {
        const float* const from =
            values_.data() + (static_cast<std::size_t>(inZ.at) * static_cast<std::size_t>(dims_.y) +
                              static_cast<std::size_t>(inY.at)) *
                                 width;
        for (std::size_t x = 0; x < width; ++x)
          middle[x] += inZ.weight * inY.weight * static_cast<double>(from[x]);
      }
    for (std::size_t k = 1; k <= reach; ++k) {
      for (const Tap1D& part : before_[k - 1]) row[reach - k] += part.weight * middle[part.at];
      for (const Tap1D& part : behind_[k - 1]) row[reach + width - 1 + k] += part.weight * middle[part.at];
    }
  }

  const std::vector<float>& values_;
  glm::ivec3 dims_;
  Beyond beyond_;
  std::vector<RowTaps> rows_;
  int reach_ = 0;
  std::vector<std::vector<Tap1D>> before_, behind_;  // samples beyond the ends of a row, by their distance
};

}  // namespace

std::vector<KernelTap> shearedGaussian(glm::dvec3 deviations, const glm::dmat3& correlations,
                                       glm::bvec3 alone) {
  glm::dmat3 covariance(1.0);
  glm::ivec3 reach(0);
  for (int i = 0; i < 3; ++i) {
    if (alone[i]) continue;
    reach[i] = static_cast<int>(std::ceil(kShearedReach * deviations[i]));
    for (int j = 0; j < 3; ++j)
      if (!alone[j]) covariance[i][j] = deviations[i] * deviations[j] * correlations[i][j];
  }
  const glm::dmat3 inverse = glm::inverse(covariance);
  std::vector<KernelTap> taps;
  double sum = 0.0;
  for (int z = -reach.z; z <= reach.z; ++z)
    for (int y = -reach.y; y <= reach.y; ++y)
      for (int x = -reach.x; x <= reach.x; ++x) {
        const glm::dvec3 at(x, y, z);
        const double weight = std::exp(-0.5 * glm::dot(at, inverse * at));
        if (weight < kLeastTap) continue;
        taps.push_back({{x, y, z}, weight});
        sum += weight;
      }
  for (KernelTap& tap : taps) tap.weight /= sum;
  return taps;
}

std::vector<float> filteredDirectly(const std::vector<float>& values, glm::ivec3 dims,
                                    const std::vector<KernelTap>& taps, Beyond beyond,
                                    base::Progress& progress, base::ProgressRange share) {
  std::vector<float> result;
  resizeStoppably(result, values.size(), progress);
  const DirectFilter filter(values, dims, taps, beyond);
  const auto width = static_cast<std::size_t>(dims.x), height = static_cast<std::size_t>(dims.y);
  parallelSteps(height * static_cast<std::size_t>(dims.z), progress, share, [&](std::size_t row) {
    filter(static_cast<int>(row % height), static_cast<int>(row / height), result.data() + row * width);
  });
  return result;
}

}  // namespace isolux::volume
