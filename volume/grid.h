// Provides scalar volumes: voxels in their smallest exact type, and their geometry (voxels/grid_geometry.h).
//
// Value (shown to the user, data units) = slope * stored + intercept. A Grid is immutable once shared.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "base/memory_budget.h"
#include "volume/voxels/grid_geometry.h"

namespace isolux::base {
class Progress;
}

namespace isolux::volume {

class BrickSource;  // volume/bricks/brick_source.h

// The results of a pass over the voxels, known without one (volume/large/volume_index.h): stored units.
struct VoxelFacts {
  VoxelType storedType = VoxelType::uint8;  // one of the five
  double storedMinimum = 0.0, storedMaximum = 0.0;
  std::size_t missing = 0;
  std::uint64_t hash = 0;  // as Grid::hash()
};

class Grid {
 public:
  // Counts missing voxels (NaN; ±Inf become NaN) and computes the range and the hash: one pass, on all cores.
  // Requires geometry.voxelCount() entries in `voxels`, and a finite slope that is not 0. With `progress` it
  // reports progress and throws Error{interrupted} after a stop request.
  Grid(const GridGeometry& geometry, VoxelArray voxels, double slope = 1.0, double intercept = 0.0);
  Grid(const GridGeometry& geometry, VoxelArray voxels, double slope, double intercept,
       base::Progress& progress);

  // The same with the geometry and the scale of `before`, whose voxels these are but in pieces of which
  // differs(first, end), indices of voxels, is true: only those are looked at.
  Grid(const Grid& before, VoxelArray voxels,
       const std::function<bool(std::size_t first, std::size_t end)>& differs, base::Progress& progress);

  // Makes an out-of-core grid: parts of the voxels are read from a file on demand. stored() and value() read
  // them, slowly; voxels() throws.
  Grid(const GridGeometry& geometry, const VoxelFacts& facts, double slope, double intercept,
       std::shared_ptr<BrickSource> source);

  const GridGeometry& geometry() const { return geometry_; }
  glm::ivec3 dims() const { return geometry_.dims; }
  Extent3 extent() const { return geometry_.extent(); }
  VoxelType storedType() const;
  bool isWhole() const { return !source_; }                               // its voxels are in memory
  const std::shared_ptr<BrickSource>& source() const { return source_; }  // null if isWhole()
  // Returns all voxels. Throws Error{memory} if they stay in a file: operations that need them are then
  // impossible.
  const VoxelArray& voxels() const {
    if (source_) throwNotWhole();
    return voxels_;
  }
  // Calls use(vector of the stored type) with all voxels. Throws as voxels() does.
  template <class Use>
  decltype(auto) visit(const Use& use) const {
    return std::visit(use, voxels());
  }
  VoxelArray takeVoxels() && { return std::move(voxels_); }

  double slope() const { return slope_; }
  double intercept() const { return intercept_; }
  double valueOfStored(double stored) const { return slope_ * stored + intercept_; }
  double storedOfValue(double value) const { return (value - intercept_) / slope_; }
  // Returns the stored isovalue that rays and blocks compare with: rounded to float.
  float storedIsovalue(double isovalue) const { return static_cast<float>(storedOfValue(isovalue)); }

  std::size_t index(int x, int y, int z) const { return extent().index(x, y, z); }
  std::size_t index(glm::ivec3 voxel) const { return extent().index(voxel); }
  double stored(int x, int y, int z) const;  // NaN if missing
  double stored(glm::ivec3 voxel) const { return stored(voxel.x, voxel.y, voxel.z); }
  double value(int x, int y, int z) const { return valueOfStored(stored(x, y, z)); }
  double value(glm::ivec3 voxel) const { return valueOfStored(stored(voxel)); }

  // Return the range of the values of voxels that are not missing; {0, 0} if all are missing.
  double minimum() const { return minimum_; }
  double maximum() const { return maximum_; }
  // Return the exact range in stored units. storedOfValue(minimum()) is not exact: if |slope| is small
  // against |intercept|, the value has lost the stored number.
  double storedMinimum() const { return storedMinimum_; }
  double storedMaximum() const { return storedMaximum_; }
  std::size_t missingCount() const { return missing_; }
  // Returns whether a corner of the cell is missing. Corners beyond the border repeat the border's.
  bool cellHasMissing(glm::ivec3 cell) const;
  std::size_t bytes() const;                                         // of all voxels, in memory or not
  static constexpr std::size_t kHashedBytes = std::size_t{1} << 20;  // of voxels: a block of hash()
  // Returns a 64-bit hash of dims, worldFromVoxel, slope, intercept, type and voxels. It is FNV-1a over
  // 8-byte words of the header and then of the hashes of blocks of kHashedBytes of voxels, so that cores can
  // share the work.
  std::uint64_t hash() const { return hash_; }
  // Returns the hash of a volume whose blocks have these hashes.
  static std::uint64_t hashOf(const GridGeometry& geometry, double slope, double intercept, VoxelType stored,
                              std::span<const std::uint64_t> pieces);

 private:
  // Holds what is known of kHashedBytes of voxels.
  struct Piece {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    std::size_t missing = 0;
    std::uint64_t hash = 0;
  };
  template <class T>
  static Piece scan(std::span<T> voxels);
  template <class Wanted>
  void scanPieces(base::Progress& progress, const Wanted& wanted);
  void sumUp();
  [[noreturn]] void throwNotWhole() const;
  void setRange(double storedMinimum, double storedMaximum);

  GridGeometry geometry_;
  VoxelArray voxels_;          // empty if there is a source
  std::vector<Piece> pieces_;  // likewise
  double slope_, intercept_;
  double minimum_ = 0.0, maximum_ = 0.0;
  double storedMinimum_ = 0.0, storedMaximum_ = 0.0;
  std::size_t missing_ = 0;
  std::uint64_t hash_ = 0;
  base::MemoryBudget::Held held_;  // readers reserve before they allocate
  std::shared_ptr<BrickSource> source_;
};

}  // namespace isolux::volume
