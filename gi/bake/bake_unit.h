// Computes units of a bake: calls the estimator for a few texels at a time and writes the block.
//
// A call takes a few milliseconds, whatever a path costs. A round of a single texel with long paths is split
// into several calls. Between them, the thread stores the partial sums and serves other requests.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "gi/bake/bake_queue.h"
#include "gi/bake/texel_estimator.h"

namespace isolux::gi {

// Runs units on one thread. Adapts the number of paths per call so that a call takes a few milliseconds.
class UnitRunner {
 public:
  UnitRunner(LightLattice& lattice, const TexelEstimator& estimator)
      : lattice_(lattice), estimator_(estimator) {}

  // Called after each call of the estimator with its rays and paths; returns true to leave the unit.
  using AfterCall = std::function<bool(std::uint64_t rays, std::uint64_t paths)>;

  // Refines the unit's texels to its target, or fewer of them if `leave` returns true. The lattice contains
  // the samples computed so far, also if the estimator throws; the exception is passed on.
  void run(const BakeQueue::Unit& unit, const std::stop_token& stop, const AfterCall& leave);

 private:
  void findPoints(const BakeQueue::Unit& unit, LatticeBlock& block);
  bool bring(const BakeQueue::Unit& unit, LatticeBlock& block, const std::stop_token& stop,
             const AfterCall& leave);
  void choose(const BakeQueue::Unit& unit, const LatticeBlock& block, std::uint32_t first);
  bool addPaths(std::uint32_t count, const std::stop_token& stop, const AfterCall& leave, bool& left);
  void store(LatticeBlock& block, std::uint32_t target);

  // Texels of a block being refined from `first` to `first + count` samples; all have the same number so far.
  struct Round {
    std::uint32_t block = 0, first = 0, count = 0, done = 0;  // count 0: no round is in progress
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
