#include "tests/support/sampled_hit.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "volume/field/reconstruct.h"

namespace isolux::volume {

namespace {

struct Sample {
  double t = 0.0, f = 0.0;  // f: minus the isovalue; NaN where voxels are missing
  bool inside() const { return f >= 0.0; }
};

class Sampler {
 public:
  Sampler(const Grid& grid, double isovalue, const Ray& ray) : grid_(grid), isovalue_(isovalue), ray_(ray) {}

  Sample at(double t) const { return {t, sampleTrilinear(grid_, position(t)).value - isovalue_}; }

  // Whether no cell between two samples has a missing corner: a crossing is only known where the field is.
  bool whole(double from, double to) const {
    if (grid_.missingCount() == 0) return true;
    Ray segment = ray_;
    segment.tMinimum = from;
    segment.tMaximum = to;
    CellWalk walk(grid_.dims(), segment);
    for (bool more = walk.inside(); more; more = walk.next())
      if (std::isnan(sampleTrilinear(grid_, glm::dvec3(walk.cell()) + 0.5).value)) return false;
    return true;
  }

  // Eq. (1), `steps` times on the half of the bracket in which the side changes.
  RayHit refined(Sample low, Sample high, int steps) const {
    const bool entering = high.inside();
    Sample best = std::abs(low.f) < std::abs(high.f) ? low : high;
    for (int i = 0; i < steps; ++i) {
      best = at(std::clamp(low.t + (high.t - low.t) * low.f / (low.f - high.f), low.t, high.t));
      (best.inside() == entering ? high : low) = best;
    }
    RayHit hit;
    hit.t = best.t;
    hit.voxel = position(best.t);
    hit.valueError = std::abs(best.f);
    hit.entering = entering;
    return hit;
  }

 private:
  glm::dvec3 position(double t) const {
    return glm::clamp(ray_.origin + t * ray_.direction, glm::dvec3(0.0), glm::dvec3(grid_.dims() - 1));
  }
  const Grid& grid_;
  double isovalue_;
  Ray ray_;
};

}  // namespace

std::optional<RayHit> firstHitSampled(const Grid& grid, const MinMaxBlocks& blocks, double isovalue,
                                      const Ray& ray, const SampledOptions& options) {
  assert(options.rate > 0.0 && options.nearFactor >= 1.0);
  if (blocks.count() == 0 || std::isnan(isovalue) || !ray.valid()) return std::nullopt;
  CellWalk walk(grid.dims(), ray);
  if (!walk.inside()) return std::nullopt;

  const Sampler sampler(grid, isovalue, ray);
  const double step = 1.0 / (options.rate * glm::length(ray.direction));
  const auto stored = grid.storedIsovalue(isovalue);
  double t = walk.tBegin();
  std::optional<Sample> before;
  for (bool more = true; more;) {
    const glm::ivec3 block = walk.cell() / blocks.blockCells(), low = block * blocks.blockCells();
    const bool active = blocks.active(blocks.index(block), stored);
    more = walk.leave(low, glm::min(low + blocks.blockCells(), grid.dims() - 1));
    const double tLeave = more ? walk.tBegin() : walk.tEnd();
    if (!active) t = std::max(t, tLeave);
    while (active && t <= tLeave) {
      const Sample sample = sampler.at(t);
      if (std::isnan(sample.f)) {
        before.reset();
      } else {
        if (before && before->inside() != sample.inside() && sampler.whole(before->t, sample.t))
          return sampler.refined(*before, sample, options.refinements);
        before = sample;
      }
      const bool atEnd = t >= walk.tEnd();
      const double next = t + (std::abs(sample.f) < options.nearThreshold ? step / options.nearFactor : step);
      if (atEnd || !(next > t)) return std::nullopt;
      t = more ? next : std::min(next, walk.tEnd());
    }
  }
  return std::nullopt;
}

}  // namespace isolux::volume
