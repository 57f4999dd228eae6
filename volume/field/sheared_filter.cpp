#include "volume/field/sheared_filter.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/scale_kernel.h"
#include "volume/voxels/extent.h"

namespace isolux::volume {

namespace {

constexpr double kLeastVariance = 1e-9;  // voxels^2

// A weight at an offset of voxels.
struct KernelTap {
  glm::ivec3 offset{0};
  double weight = 0.0;
};

// A sample of an axis, and the factor by which it contributes.
struct Part {
  int at;
  double factor;
};

// What the sample `k` of an axis of n samples is made of.
std::vector<Part> extendedSample(int k, int n, Beyond beyond) {
  std::vector<Part> parts;
  if (beyond == Beyond::reflected || (k >= 0 && k < n))
    addReflected(k, n, [&](int at, double factor) { parts.push_back({at, factor}); });
  return parts;
}

class DirectFilter {
 public:
  DirectFilter(const std::vector<float>& values, glm::ivec3 dims, const std::vector<KernelTap>& taps,
               Beyond beyond)
      : values_(values), dims_(dims), beyond_(beyond), taps_(taps) {
    for (const KernelTap& tap : taps) reach_ = std::max(reach_, std::abs(tap.offset.x));
    for (int k = 1; k <= reach_; ++k) {
      before_.push_back(extendedSample(-k, dims.x, beyond));
      behind_.push_back(extendedSample(dims.x - 1 + k, dims.x, beyond));
    }
  }

  void operator()(int y, int z, float* result) const {
    const auto width = static_cast<std::size_t>(dims_.x), reach = static_cast<std::size_t>(reach_);
    std::vector<double> sum(width), row(width + 2 * reach);
    const KernelTap* fetched = nullptr;
    for (const KernelTap& tap : taps_) {
      if (!fetched || fetched->offset.y != tap.offset.y || fetched->offset.z != tap.offset.z)
        fetchRow(y + tap.offset.y, z + tap.offset.z, row);
      fetched = &tap;
      const double* const from = row.data() + reach_ + tap.offset.x;
      for (std::size_t x = 0; x < width; ++x) sum[x] += tap.weight * from[x];
    }
    for (std::size_t x = 0; x < width; ++x) result[x] = static_cast<float>(sum[x]);
  }

 private:
  void fetchRow(int y, int z, std::vector<double>& row) const {
    const auto width = static_cast<std::size_t>(dims_.x), reach = static_cast<std::size_t>(reach_);
    std::fill(row.begin(), row.end(), 0.0);
    double* const middle = row.data() + reach;
    for (const Part& inZ : extendedSample(z, dims_.z, beyond_))
      for (const Part& inY : extendedSample(y, dims_.y, beyond_)) {
        const float* const from = values_.data() + Extent3{dims_}.index(0, inY.at, inZ.at);
        for (std::size_t x = 0; x < width; ++x)
          middle[x] += inZ.factor * inY.factor * static_cast<double>(from[x]);
      }
    for (std::size_t k = 1; k <= reach; ++k) {
      for (const auto& [at, factor] : before_[k - 1]) row[reach - k] += factor * middle[at];
      for (const auto& [at, factor] : behind_[k - 1]) row[reach + width - 1 + k] += factor * middle[at];
    }
  }

  const std::vector<float>& values_;
  glm::ivec3 dims_;
  Beyond beyond_;
  std::vector<KernelTap> taps_;
  int reach_ = 0;
  // Samples beyond the ends of a row, by their distance.
  std::vector<std::vector<Part>> before_, behind_;
};

// Of a Gaussian with this variance: sampled, or, where sampling changes it, that of which the response has
// the same powers of u = 2 - 2 cos, the second difference, up to the third.
HalfKernel lineKernel(double variance) {
  if (variance >= 1.0) return gaussianKernel(std::sqrt(variance));
  const double v = variance, c1 = -v / 2.0, c2 = v * v / 8.0 - v / 24.0,
               c3 = -v * v * v / 48.0 + v * v / 48.0 - v / 180.0;
  return {1.0 + 2.0 * c1 + 6.0 * c2 + 20.0 * c3, -c1 - 4.0 * c2 - 15.0 * c3, c2 + 6.0 * c3, -c3};
}

std::vector<KernelTap> tapsAlong(const LatticeLine& line) {
  const HalfKernel kernel = lineKernel(line.variance);
  const int reach = static_cast<int>(kernel.size()) - 1;
  std::vector<KernelTap> taps;
  for (int k = -reach; k <= reach; ++k)
    taps.push_back({k * line.step, kernel[static_cast<std::size_t>(std::abs(k))]});
  return taps;
}

}  // namespace

// Selling's reduction: a superbase of the lattice, of four vectors that sum to 0, is changed until all of its
// products are at most 0; those are the variances then, along what is perpendicular to the other two.
std::vector<LatticeLine> latticeLines(const glm::dmat3& covariance) {
  constexpr int mostSteps = 1000;
  std::array<glm::dvec3, 4> base{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1),
                                 glm::dvec3(-1, -1, -1)};
  constexpr std::array<std::array<std::size_t, 4>, 6> pairs{
      {{0, 1, 2, 3}, {0, 2, 1, 3}, {0, 3, 1, 2}, {1, 2, 0, 3}, {1, 3, 0, 2}, {2, 3, 0, 1}}};
  const auto product = [&](std::size_t i, std::size_t j) { return glm::dot(base[i], covariance * base[j]); };
  for (int step = 0; step < mostSteps; ++step) {
    const auto obtuse = std::find_if(pairs.begin(), pairs.end(),
                                     [&](const auto& p) { return product(p[0], p[1]) > kLeastVariance; });
    if (obtuse == pairs.end()) break;
    const auto [i, j, k, l] = *obtuse;
    base[k] += base[i];
    base[l] += base[i];
    base[i] = -base[i];
  }
  std::vector<LatticeLine> lines;
  for (const auto& [i, j, k, l] : pairs)
    if (const double variance = -product(i, j); variance > kLeastVariance)
      lines.push_back({glm::ivec3(glm::round(glm::cross(base[k], base[l]))), variance});
  return lines;
}

void filterLatticeLines(std::vector<float>& values, glm::ivec3 dims, const std::vector<LatticeLine>& lines,
                        Beyond beyond, base::Progress& progress, base::ProgressRange share) {
  std::vector<float> result;
  resizeStoppably(result, values.size(), progress);
  const Extent3 extent{dims};
  const double part = (share.to - share.from) / static_cast<double>(std::max<std::size_t>(lines.size(), 1));
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const DirectFilter filter(values, dims, tapsAlong(lines[i]), beyond);
    const double from = share.from + part * static_cast<double>(i);
    parallelSteps(extent.rows(), progress, {from, from + part, share.stage}, [&](std::size_t row) {
      const glm::ivec3 first = extent.firstOfRow(row);
      filter(first.y, first.z, result.data() + extent.index(first));
    });
    values.swap(result);
  }
}

}  // namespace isolux::volume
