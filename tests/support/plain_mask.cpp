#include "tests/support/plain_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "base/random.h"

namespace isolux::test {

namespace {

using volume::Extent3;
using volume::Grid;

std::vector<bool> membersOf(const Grid& labels, const std::set<int>& set) {
  std::vector<bool> member;
  const glm::ivec3 dims = labels.dims();
  volume::forEachIn(glm::ivec3(0), dims, [&](glm::ivec3 voxel) {
    const double value = labels.value(voxel);
    member.push_back(!std::isnan(value) && set.contains(static_cast<int>(value)));
  });
  return member;
}

// chi smoothed at any point of the lattice, one sum of three dimensions.
class SmoothedChi {
 public:
  SmoothedChi(const std::vector<bool>& member, glm::ivec3 dims, double smoothing)
      : member_(member),
        extent_{dims},
        reach_(static_cast<int>(std::ceil(3.0 * smoothing))),
        known_(Extent3{dims + 2}.count(), std::nan("")) {
    double sum = 0.0;
    for (int k = -reach_; k <= reach_; ++k) {
      weights_.push_back(std::exp(-0.5 * k * k / (smoothing * smoothing)));
      sum += weights_.back();
    }
    for (int k = -reach_; k <= reach_; ++k) {
      double& weight = weights_[static_cast<std::size_t>(k + reach_)];
      weight /= sum;
      variance_ += weight * k * k;
    }
  }
  double variance() const { return variance_; }

  // p: a voxel, or beside one.
  double at(glm::ivec3 p) {
    double& known = known_[Extent3{extent_.dims + 2}.index(p + 1)];
    if (!std::isnan(known)) return known;
    known = 0.0;
    const auto clamped = [&](int axis, int k) { return std::clamp(p[axis] + k, 0, extent_.dims[axis] - 1); };
    for (int z = -reach_; z <= reach_; ++z)
      for (int y = -reach_; y <= reach_; ++y) {
        const std::size_t row = extent_.index(0, clamped(1, y), clamped(2, z));
        double along = 0.0;
        for (int x = -reach_; x <= reach_; ++x)
          if (member_[row + static_cast<std::size_t>(clamped(0, x))]) along += weight(x);
        known += along * weight(y) * weight(z);
      }
    return known;
  }

 private:
  double weight(int k) const { return weights_[static_cast<std::size_t>(k + reach_)]; }

  const std::vector<bool>& member_;
  Extent3 extent_;
  int reach_;
  std::vector<double> weights_;
  double variance_ = 0.0;
  std::vector<double> known_;  // NaN: not yet
};

// How slices lie whose distance is at least 1.5 times the spacing in them.
struct Slices {
  int across = 0, u = 0, v = 0;
  double ramp = 0.0, half = 0.0;  // mm
};

std::optional<Slices> slicesOf(const Grid& labels) {
  const glm::dvec3 spacing = labels.geometry().spacingMm();
  for (int across = 0; across < 3; ++across) {
    const int u = (across + 1) % 3, v = (across + 2) % 3;
    if (spacing[across] < 1.5 * std::max(spacing[u], spacing[v])) continue;
    const double shorter = std::min(spacing[u], spacing[v]);
    return Slices{across, u, v, std::min(spacing[across], 16.0 * shorter), 0.5 * shorter};
  }
  return std::nullopt;
}

// w of every voxel: the distance to each voxel of its slice that is on the other side.
std::vector<double> rampsOf(const Grid& labels, const std::vector<bool>& member, const Slices& slices) {
  const Extent3 extent = labels.extent();
  const glm::dvec3 spacing = labels.geometry().spacingMm();
  std::vector<double> ramps;
  for (std::size_t i = 0; i < member.size(); ++i) {
    const glm::ivec3 p = extent.at(i);
    glm::ivec3 low(0), end = extent.dims;
    low[slices.across] = p[slices.across];
    end[slices.across] = p[slices.across] + 1;
    double nearest = 1e30;
    volume::forEachIn(low, end, [&](glm::ivec3 other) {
      if (member[extent.index(other)] == member[i]) return;
      nearest = std::min(nearest, glm::length(spacing * glm::dvec3(other - p)));
    });
    const double w = std::min(1.0, (nearest - slices.half) / slices.ramp);
    ramps.push_back(member[i] ? w : -w);
  }
  return ramps;
}

// The definition of volume/labels/slice_mask.h.
PlainMask plainSliceMask(const Grid& labels, PlainMask plain, const Slices& slices, double smoothing) {
  const Extent3 extent = labels.extent();
  const std::vector<double> ramps = rampsOf(labels, plain.member, slices);
  const int reach = static_cast<int>(std::ceil(3.0 * smoothing));
  double sum = 0.0, variance = 0.0;
  for (int k = -reach; k <= reach; ++k) sum += std::exp(-0.5 * k * k / (smoothing * smoothing));
  for (int k = -reach; k <= reach; ++k)
    variance += k * k * std::exp(-0.5 * k * k / (smoothing * smoothing)) / sum;
  const auto smoothed = [&](glm::ivec3 p) {
    double result = 0.0;
    for (int j = -reach; j <= reach; ++j)
      for (int i = -reach; i <= reach; ++i) {
        glm::ivec3 at = p;
        at[slices.u] = std::clamp(p[slices.u] + i, 0, extent.dims[slices.u] - 1);
        at[slices.v] = std::clamp(p[slices.v] + j, 0, extent.dims[slices.v] - 1);
        result += ramps[extent.index(at)] * std::exp(-0.5 * (i * i + j * j) / (smoothing * smoothing));
      }
    return result / (sum * sum);
  };
  const double guard = std::min(0.04, 0.4 * slices.half / slices.ramp);
  std::vector<double> margin(ramps.size());
  std::vector<bool> close(ramps.size()), alone(ramps.size());
  for (std::size_t i = 0; i < ramps.size(); ++i) {
    const glm::ivec3 p = extent.at(i);
    const double g = smoothed(p);
    double laplacian = -4.0 * g;
    for (const int axis : {slices.u, slices.v})
      for (const int step : {-1, 1}) {
        glm::ivec3 beside = p;
        beside[axis] += step;
        laplacian += smoothed(beside);
      }
    margin[i] = (g - 0.5 * (variance + 1.0 / 6.0) * laplacian) * plain.u[i];
    bool isInside = p[slices.across] > 0 && p[slices.across] + 1 < extent.dims[slices.across];
    for (const int step : {-1, 1}) {
      glm::ivec3 beside = p;
      beside[slices.across] += step;
      if (isInside) isInside = ramps[extent.index(beside)] * plain.u[i] <= -1.0;
    }
    alone[i] = isInside;
    plain.thin[i] = alone[i] || margin[i] < 0.25 * guard;
    close[i] = std::abs(margin[i] - 0.25 * guard) < 1e-5;
  }
  for (std::size_t i = 0; i < ramps.size(); ++i) {
    const glm::ivec3 p = extent.at(i);
    glm::ivec3 low = glm::max(p - 1, 0), end = glm::min(p + 2, extent.dims);
    low[slices.across] = p[slices.across];
    end[slices.across] = p[slices.across] + 1;
    double least = guard;
    volume::forEachIn(low, end, [&](glm::ivec3 beside) {
      if (plain.thin[extent.index(beside)]) least = std::max(least, std::abs(ramps[i]));
      if (alone[extent.index(beside)]) least = 1.0;
      plain.undecided[i] = plain.undecided[i] || close[extent.index(beside)];
    });
    plain.u[i] *= std::clamp(margin[i], least, 1.0);
  }
  return plain;
}

std::string textOfVoxel(glm::ivec3 v) {
  return std::to_string(v.x) + "," + std::to_string(v.y) + "," + std::to_string(v.z);
}

// Whether the point is within half a voxel along each axis of a face between members and others.
bool liesAtAFace(const glm::dvec3& point, const std::vector<bool>& member, const Extent3& extent) {
  constexpr double most = 0.5 + 1e-9;
  const glm::ivec3 at(glm::floor(point));
  const glm::ivec3 low = glm::max(at - 1, 0), end = glm::min(at + 3, extent.dims);
  bool found = false;
  volume::forEachIn(low, end, [&](glm::ivec3 voxel) {
    for (int axis = 0; axis < 3 && !found; ++axis) {
      glm::ivec3 next = voxel;
      ++next[axis];
      if (!extent.contains(next) || member[extent.index(voxel)] == member[extent.index(next)]) continue;
      glm::dvec3 away = glm::max(glm::abs(point - glm::dvec3(voxel)) - 0.5, 0.0);
      away[axis] = std::abs(point[axis] - (voxel[axis] + 0.5));
      found = away.x <= most && away.y <= most && away.z <= most;
    }
  });
  return found;
}

}  // namespace

PlainMask plainMask(const Grid& labels, const std::set<int>& set, double smoothing) {
  const Extent3 extent = labels.extent();
  PlainMask plain;
  plain.member = membersOf(labels, set);
  const std::size_t count = plain.member.size();
  plain.thin.resize(count);
  plain.undecided.resize(count);
  for (std::size_t i = 0; i < count; ++i) plain.u.push_back(plain.member[i] ? 1.0 : -1.0);
  if (smoothing == 0.0) return plain;
  if (const auto slices = slicesOf(labels))
    return plainSliceMask(labels, std::move(plain), *slices, smoothing);

  SmoothedChi g(plain.member, extent.dims, smoothing);
  std::vector<double> margin(count);
  std::vector<bool> close(count);
  for (std::size_t i = 0; i < count; ++i) {
    const glm::ivec3 p = extent.at(i);
    double laplacian = -6.0 * g.at(p);
    for (int axis = 0; axis < 3; ++axis)
      for (const int step : {-1, 1}) {
        glm::ivec3 beside = p;
        beside[axis] += step;
        laplacian += g.at(beside);
      }
    const double s = g.at(p) - 0.5 * (g.variance() + 1.0 / 6.0) * laplacian;
    margin[i] = (2.0 * s - 1.0) * plain.u[i];
    plain.thin[i] = margin[i] < -0.1;
    close[i] = std::abs(margin[i] + 0.1) < 1e-5;
  }
  for (std::size_t i = 0; i < count; ++i) {
    const glm::ivec3 p = extent.at(i);
    bool whole = false;
    volume::forEachIn(glm::max(p - 1, 0), glm::min(p + 2, extent.dims), [&](glm::ivec3 beside) {
      whole = whole || plain.thin[extent.index(beside)];
      plain.undecided[i] = plain.undecided[i] || close[extent.index(beside)];
    });
    plain.u[i] *= whole ? 1.0 : std::clamp(margin[i], 0.04, 1.0);
  }
  return plain;
}

std::string brokenPromise(const Grid& labels, const std::set<int>& set, const Grid& mask,
                          std::uint64_t seed) {
  const Extent3 extent = labels.extent();
  const std::vector<bool> member = membersOf(labels, set);
  for (std::size_t i = 0; i < member.size(); ++i)
    if (const double u = mask.value(extent.at(i)); member[i] ? !(u > 0.0) : !(u < 0.0))
      return "voxel " + textOfVoxel(extent.at(i)) + " changes its side";
  std::uint64_t drawn = 0;
  std::string wrong;
  volume::forEachIn(glm::ivec3(0), extent.dims - 1, [&](glm::ivec3 cell) {
    double corner[8];
    for (int i = 0; i < 8; ++i) corner[i] = mask.value(cell + volume::cornerStep(i));
    for (int axis = 0; axis < 3; ++axis) {
      const int one = 1 << axis, u = 1 << (axis + 1) % 3, v = 1 << (axis + 2) % 3;
      const double a = base::uniformNoise(seed, drawn++), b = base::uniformNoise(seed, drawn++);
      const auto face = [&](int first) {
        return (1.0 - b) * ((1.0 - a) * corner[first] + a * corner[first + u]) +
               b * ((1.0 - a) * corner[first + v] + a * corner[first + u + v]);
      };
      const double from = face(0), to = face(one);
      if ((from < 0.0) == (to < 0.0)) continue;
      glm::dvec3 point(cell);
      point[axis] += from / (from - to);
      point[(axis + 1) % 3] += a;
      point[(axis + 2) % 3] += b;
      if (wrong.empty() && !liesAtAFace(point, member, extent))
        wrong = "a point of the surface in cell " + textOfVoxel(cell) + " lies at no face";
    }
  });
  return wrong;
}

}  // namespace isolux::test
