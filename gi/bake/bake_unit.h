// Works on units of a bake: calls the estimator for a few texels at a time and writes the block.
//
// A call takes a few milliseconds whatever a path costs: a round of a single texel whose paths are long is
// cut into several calls, and what they have summed is kept while the thread heeds other wishes in between.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "gi/bake/bake_queue.h"
#include "gi/bake/texel_estimator.h"

namespace isolux::gi {

// One for each thread: learns how many paths take a few milliseconds.
class UnitRunner {
 public:
  UnitRunner(LightLattice& lattice, const TexelEstimator& estimator)
      : lattice_(lattice), estimator_(estimator) {}

  // Told after each call of the estimator what it did; true: go no further.
  using AfterCall = std::function<bool(std::uint64_t rays, std::uint64_t paths)>;

  // Brings the unit's texels to its target, or part of them when told to leave; what was done is in the
  // lattice, also when the estimator throws (which is passed on).
  void run(const BakeQueue::Unit& unit, const std::stop_token& stop, const AfterCall& leave);

 private:
  void findPoints(const BakeQueue::Unit& unit, LatticeBlock& block);
  bool bring(const BakeQueue::Unit& unit, LatticeBlock& block, const std::stop_token& stop,
             const AfterCall& leave);
  void choose(const BakeQueue::Unit& unit, const LatticeBlock& block, std::uint32_t first);
  bool addPaths(std::uint32_t count, const std::stop_token& stop, const AfterCall& leave, bool& left);
  void store(LatticeBlock& block, std::uint32_t target);

  // Texels of a block on their way from `first` samples to `first + count`, all with the same number so far.
  struct Round {
    std::uint32_t block = 0, first = 0, count = 0, done = 0;  // count 0: none is under way
    std::vector<std::size_t> indices;                         // in the block
    std::vector<glm::ivec3> texels;
    std::vector<TexelPoint> points;
    std::vector<double> sums;  // texels x components
  };

  LightLattice& lattice_;
  const TexelEstimator& estimator_;
  double pathsOfCall_ = 1024.0;
  bool changed_ = false;
  Round round_;
  std::vector<std::size_t> indices_;  // of findPoints()
  std::vector<glm::ivec3> texels_;
  std::vector<TexelPoint> points_;
};

}  // namespace isolux::gi
