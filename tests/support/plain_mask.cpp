#include "tests/support/plain_mask.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <glm/common.hpp>
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
