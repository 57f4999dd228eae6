// Works on units of a bake: calls the estimator for a few texels at a time and writes the block.
#pragma once

#include <cstdint>
#include <functional>
#include <stop_token>
#include <vector>

#include "gi/bake_queue.h"

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
  void findNormals(const BakeQueue::Unit& unit, LatticeBlock& block);
  bool bring(const BakeQueue::Unit& unit, LatticeBlock& block, const std::stop_token& stop,
             const AfterCall& leave);

  LightLattice& lattice_;
  const TexelEstimator& estimator_;
  double pathsOfCall_ = 1024.0;
  bool changed_ = false;
  std::vector<glm::ivec3> texels_;
  std::vector<glm::vec3> normals_;
  std::vector<std::size_t> indices_;  // in the block
  std::vector<float> means_;
};

}  // namespace isolux::gi
