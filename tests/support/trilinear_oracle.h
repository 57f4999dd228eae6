// An independent search for the first crossing of the trilinear isosurface, in extended precision, and the
// comparison of hits with it.
//
// Shares no arithmetic with what it judges, and must not: no blocks, no Bernstein form, no state from cell to
// cell but the side: the planes the ray crosses are merged in order, each segment finds its cell from its
// middle, and the cubic in it is that through four samples, in the power basis, cut at its extrema.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "volume/grid.h"
#include "volume/hit/cell_walk.h"
#include "volume/hit/exact_hit.h"

namespace isolux::test {

class TrilinearOracle {
 public:
  explicit TrilinearOracle(const volume::Grid& grid);
  // Of values by a formula: of a volume that is too large for memory.
  using Value = std::function<double(glm::ivec3 voxel)>;
  TrilinearOracle(glm::ivec3 dims, Value value);

  const volume::Grid& grid() const { return *grid_; }  // of the first constructor
  std::optional<double> firstHit(double isovalue, const volume::Ray& ray) const;

 private:
  using Real = long double;
  std::optional<Real> searchCell(Real isovalue, const volume::Ray& ray, Real t0, Real t1, int& side) const;

  double cornerOf(glm::ivec3 voxel) const;

  const volume::Grid* grid_ = nullptr;
  glm::ivec3 dims_;
  std::vector<float> stored_;  // holds every stored type exactly
  Value value_;                // or this
};

// How hits compare with the oracle's. Distances along the ray in voxels.
struct HitTally {
  long rays = 0, hits = 0;
  long misses = 0;      // the oracle has an earlier crossing
  long inventions = 0;  // a hit where the oracle has no crossing
  long borderline = 0;  // touches within rounding: the answer changes with the last digits of the isovalue
  double worstVoxels = 0.0;  // of the hits that agree

  void add(const HitTally& other);
};
void compareHit(const TrilinearOracle& oracle, double isovalue, const volume::Ray& ray,
                const std::optional<volume::RayHit>& found, HitTally& tally);

}  // namespace isolux::test
