// The nearest maximum of |grad f| along the normal of a surface point: the walk that the double precision
// reference and the processor's pictures share. resources/shaders/derivatives/edge.frag.glsl has the same.
//
// With g and H the derivatives of the field at derivatives.scale, n the outward normal by g at the hit and
// u = g / |g|, |g| changes along the line x + s n by d|g| / ds = n^T H u. Steps of half a voxel go both ways
// at once, up to `search`. Where the change turns from rising to falling, walked away from the hit, a root of
// d ln|g| / ds lies between (linear in s where the profile is a Gaussian). It is an edge of this surface if
// the field falls outward there as it does at the hit, |g| stands `contrast` times above its noise, and it is
// a peak and no rounding: |g| falls by kLeastPeak to the further end of its step. A side ends at the border
// of the volume, at a missing voxel, and where the field turns round by more than noise: behind is another
// surface.
//
// Smoothing moves the edge of a curved surface towards its centres of curvature, by half the trace of its
// covariance times the shape operator (a ball of radius R at scale s: s^2 / R; a cylinder: s^2 / 2R). That of
// the field is known and taken back; the blur that the data came with is not, and stays.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>

namespace isolux::volume {

template <class Real>
struct EdgeSearch {
  using Vec = glm::vec<3, Real>;
  using Mat = glm::mat<3, 3, Real>;
  Vec low{0}, high{0};    // where the field is the volume's own, voxels: walks end there
  Mat voxelFromWorld{1};  // A^-1
  Mat smoothing{0};       // covariance of the field's smoothing, mm^2
  Mat noise{0};           // covariance of the noise of the samples' world gradient, 1/mm^2
  Real unit = 1;          // samples are stored values times this: of noise, about 1
  Real outward = -1;      // of gradients of stored values
  Real searchMm = 0;      // each way
  Real contrast = 0;      // standard deviations of the noise of |g|
  Real leastStepMm = 0;   // steps are no shorter
};

// In units of EdgeSearch, per voxel and per voxel squared.
template <class Real>
struct EdgeSample {
  glm::vec<3, Real> gradient{0};
  glm::mat<3, 3, Real> hessian{0};
  bool known = false;
};

template <class Real>
struct FoundEdge {
  bool found = false;
  Real offsetMm = 0;  // along the outward normal
  Real strength = 0;  // |g| over the standard deviation of its noise, at the hit
};

namespace edge {

constexpr double kLeastPeak = 1e-4;  // of |g|
constexpr double kStepVoxels = 0.5;
constexpr int kMostSteps = 400;     // each way: a search over hundreds of voxels takes longer steps
constexpr double kMostMoved = 0.5;  // of the smoothing's deviation: what is taken back for curvature

// |v| of any size.
template <class Real>
Real lengthOf(const glm::vec<3, Real>& v) {
  const Real largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
  return largest > 0 ? largest * glm::length(v / largest) : Real(0);
}

// The gradient at a place of the line.
template <class Real>
struct Slope {
  Real s = 0;       // mm
  Real size = 0;    // |g|, world
  Real along = 0;   // its part along the line, positive as at the hit
  Real change = 0;  // d ln|g| / ds, 1/mm
  bool known = false;
};

template <class Real, class Sample>
class Line {
 public:
  using Vec = glm::vec<3, Real>;
  using Mat = glm::mat<3, 3, Real>;
  Line(const EdgeSearch<Real>& search, const Sample& sample, const Vec& voxel)
      : search_(search),
        sample_(sample),
        origin_(voxel),
        gradientToWorld_(glm::transpose(search.voxelFromWorld)) {
    const EdgeSample<Real> at = sample(voxel);
    const Vec g = gradientToWorld_ * at.gradient;
    const Real size = lengthOf(g);
    valid_ = at.known && size > 0 && size < std::numeric_limits<Real>::infinity();
    if (!valid_) return;
    normal_ = search.outward * g / size;
    direction_ = search.voxelFromWorld * normal_;
    here_ = slopeOf(at, 0);
  }

  bool valid() const { return valid_; }
  const Slope<Real>& here() const { return here_; }
  const Vec& normal() const { return normal_; }
  const Vec& direction() const { return direction_; }
  Vec at(Real s) const { return origin_ + s * direction_; }

  Slope<Real> slope(Real s) const {
    const Vec p = at(s);
    for (int axis = 0; axis < 3; ++axis)
      if (!(p[axis] >= search_.low[axis] && p[axis] <= search_.high[axis])) return {};
    return slopeOf(sample_(p), s);
  }

  // By what smoothing has moved the edge at s against the outward normal, mm.
  Real movedInward(Real s) const {
    const EdgeSample<Real> at = sample_(this->at(s));
    const Vec g = gradientToWorld_ * at.gradient;
    const Real size = lengthOf(g);
    if (!at.known || !(size > 0)) return 0;
    const Vec u = g / size;
    const Mat shape = (search_.outward / size) * (gradientToWorld_ * at.hessian * search_.voxelFromWorld);
    const Mat across = Mat(1) - glm::outerProduct(u, u);
    const Mat bent = across * shape * across;
    Real trace = 0, variance = 0;
    for (int i = 0; i < 3; ++i) {
      trace += glm::dot(bent[i], search_.smoothing[i]);  // both are symmetric
      variance += search_.smoothing[i][i];
    }
    const Real most = Real(kMostMoved) * std::sqrt(variance / 3);
    return std::clamp(trace / 2, -most, most);
  }

 private:
  Slope<Real> slopeOf(const EdgeSample<Real>& at, Real s) const {
    if (!at.known) return {};
    const Vec g = gradientToWorld_ * at.gradient;
    const Real size = lengthOf(g);
    if (!(size > 0)) return {s, 0, 0, 0, true};
    const Vec u = g / size;
    const Vec bend = at.hessian * (search_.voxelFromWorld * u) / size;
    return {s, size, search_.outward * glm::dot(g, normal_), glm::dot(direction_, bend), true};
  }

  const EdgeSearch<Real>& search_;
  const Sample& sample_;
  Vec origin_;
  Mat gradientToWorld_;
  Vec normal_{0}, direction_{0};
  Slope<Real> here_;
  bool valid_ = false;
};

// Root of `change` between a place where |g| rises and one where it falls: regula falsi (Illinois).
template <class L, class Real>
Slope<Real> peakBetween(const L& line, Slope<Real> rising, Slope<Real> falling) {
  const Real close = (sizeof(Real) == 4 ? Real(2e-5) : Real(1e-10)) * std::abs(falling.s - rising.s);
  const Real toward = falling.s > rising.s ? Real(1) : Real(-1);
  Real weightRising = rising.change, weightFalling = falling.change;
  Slope<Real> best = rising.size > falling.size ? rising : falling;
  for (int i = 0, kept = 0; i < 40; ++i) {
    const Real part = weightRising / (weightRising - weightFalling);
    const Slope<Real> at = line.slope(rising.s + part * (falling.s - rising.s));
    if (!at.known) return best;
    const Real moved = std::abs(at.s - best.s);
    best = at;
    const Real up = toward * at.change;
    if (up == 0 || moved < close) return best;
    if (up > 0) {
      rising = at;
      weightRising = at.change;
      if (kept == 1) weightFalling /= 2;
      kept = 1;
    } else {
      falling = at;
      weightFalling = at.change;
      if (kept == -1) weightRising /= 2;
      kept = -1;
    }
  }
  return best;
}

}  // namespace edge

// Standard deviation of what noise makes of |g| where it points along `direction` (unit, world).
template <class Real>
Real gradientNoise(const EdgeSearch<Real>& search, const glm::vec<3, Real>& direction) {
  return std::sqrt(std::max(glm::dot(direction, search.noise * direction), Real(0)));
}

// sample(voxel): the field there; known only where the field is one. `voxel`: a hit.
template <class Real, class Sample>
FoundEdge<Real> findEdge(const EdgeSearch<Real>& search, const Sample& sample,
                         const glm::vec<3, Real>& voxel) {
  using edge::Slope;
  FoundEdge<Real> out;
  const edge::Line<Real, Sample> line(search, sample, voxel);
  if (!line.valid()) return out;
  const Real noise = gradientNoise(search, line.normal());
  out.strength = line.here().size / noise;
  const auto& d = line.direction();
  const Real voxelMm = 1 / std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  const Real step = std::max(
      {Real(edge::kStepVoxels) * voxelMm, search.leastStepMm, search.searchMm / Real(edge::kMostSteps)});
  const auto isEdge = [&](const Slope<Real>& peak, const Slope<Real>& from, const Slope<Real>& to) {
    return peak.size >= search.contrast * noise && peak.along > 0 &&
           std::min(from.size, to.size) <= (1 - Real(edge::kLeastPeak)) * peak.size;
  };
  Slope<Real> before[2] = {line.here(), line.here()};
  for (int i = 1; before[0].known || before[1].known; ++i) {
    Slope<Real> nearest;
    for (int side = 0; side < 2; ++side) {
      Slope<Real>& from = before[side];
      const Real toward = side == 0 ? Real(1) : Real(-1);
      if (!from.known || std::abs(from.s) >= search.searchMm) {
        from.known = false;
        continue;
      }
      const Slope<Real> to = line.slope(toward * std::min(Real(i) * step, search.searchMm));
      const bool rises = toward * from.change > 0 || (i == 1 && side == 0 && from.change == 0);
      // A step may end at the peak itself.
      const bool falls = toward * to.change < 0 || (to.change == 0 && from.change != 0);
      if (to.known && rises && falls) {
        const Slope<Real> peak = edge::peakBetween(line, from, to);
        if (isEdge(peak, from, to) && (!nearest.known || std::abs(peak.s) < std::abs(nearest.s)))
          nearest = peak;
      }
      from = to;
      if (to.along < -search.contrast * noise) from.known = false;
    }
    if (!nearest.known) continue;
    out.found = true;
    out.offsetMm = nearest.s + line.movedInward(nearest.s);
    return out;
  }
  return out;
}

}  // namespace isolux::volume
