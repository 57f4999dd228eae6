// Stores baked lighting: texels in blocks that exist only where something is lit, and defines requests to a
// bake.
//
// One thread at a time writes a block, any number read. Every write has a revision, so that readers fetch
// only changed blocks. A block is immutable once written: writing exchanges it, and readers of the old one
// keep it.
//
// A texel holds the mean of its estimates so far and their number of paths (0: not baked). Contents:
//   irradiance  E, RGB or one channel, for light of unit exposure (Wyman et al. 2006 eq. 2)
//   transfer    SH coefficients of T (precomputed radiance transfer), order^2 per channel, index
//               channel * order^2 + i: E = sum T_i l_i with those of the environment (eq. 5 to 9)
// A normal is the texel's own (unit, world, outward). It is 0 if its isosurface has none or no isosurface is
// near: such texels stay unbaked. Throws std::bad_alloc, or Error{memory} if the memory budget has no room
// for a new block; the lattice is then unchanged.
#pragma once

#include <array>
#include <atomic>
#include <bitset>
#include <cstdint>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/memory_budget.h"
#include "gi/lattice/lattice_geometry.h"

namespace isolux::gi {

struct LightContent {
  enum class Kind { irradiance, transfer };
  Kind kind = Kind::irradiance;
  int channels = 3;  // 1 or 3
  int order = 0;     // of transfer
  int components() const { return kind == Kind::irradiance ? channels : channels * order * order; }
  bool operator==(const LightContent&) const = default;
};

struct LatticeBlock {
  std::array<std::uint32_t, kTexelsOfBlock> samples{};
  std::array<glm::vec3, kTexelsOfBlock> normals{};
  std::vector<glm::vec3> places;  // voxels, where texels are lit; empty unless the lattice has an isovalue
  std::bitset<kTexelsOfBlock> unlit;  // requested texels without a normal
  std::vector<float> means;           // kTexelsOfBlock x components, a texel's components adjacent
  base::MemoryBudget::Held held{};    // set by write(); lives as long as the block

  static std::size_t bytesOf(const LightContent& content, bool withPlaces = false) {
    const std::size_t ofTexel =
        static_cast<std::size_t>(content.components()) * sizeof(float) + (withPlaces ? sizeof(glm::vec3) : 0);
    return sizeof(LatticeBlock) + static_cast<std::size_t>(kTexelsOfBlock) * ofTexel;
  }
  std::size_t bytes() const {
    return sizeof(LatticeBlock) + means.capacity() * sizeof(float) + places.capacity() * sizeof(glm::vec3);
  }
};

// Requested texels of one block.
struct BlockRequest {
  std::uint32_t block = 0;
  std::bitset<kTexelsOfBlock> texels;
  bool operator==(const BlockRequest&) const = default;
};

// Priorities, in the order in which they are served.
enum class Priority { visible, nearby, band, rest };

class LightLattice {
 public:
  LightLattice(const LatticeGeometry& geometry, LightContent content, std::string key);

  const LatticeGeometry& geometry() const { return geometry_; }
  const LightContent& content() const { return content_; }
  const std::string& key() const { return key_; }  // JSON of all that its light depends on

  LatticeBlock dark() const;                                          // a block in which nothing is lit
  std::shared_ptr<const LatticeBlock> at(std::uint32_t block) const;  // null: nothing is lit there
  void write(std::uint32_t block, LatticeBlock in);                   // replaces it, with a new revision
  // Stores a block of a lattice of the same geometry and content, without a copy; null removes the block.
  // Requires that no frame reads a lattice from which blocks are removed: revisions do not show it.
  void share(std::uint32_t block, std::shared_ptr<const LatticeBlock> fresh);
  // Removes all light; revisions continue. Requires that the LightBake that fills the lattice is destroyed.
  void clear();

  // Returns the revision of the newest write or clear(). Read it before changedSince(), so that no change is
  // missed.
  std::uint64_t revision() const { return revision_.load(std::memory_order_acquire); }
  // Returns the blocks written after `revision`, in the order of their last write.
  std::vector<std::uint32_t> changedSince(std::uint64_t revision) const;
  std::uint64_t clearedAt() const;  // revision of the last clear()
  std::uint64_t bakedTexels() const;
  std::size_t bytes() const;
  // Returns the bytes still to be allocated if every texel becomes lit.
  std::size_t bytesToFill() const;
  // Throws Error{memory} if bytesToFill() does not fit into the memory budget. Reserves nothing.
  void checkThatAllFits() const;

 private:
  LatticeGeometry geometry_;
  LightContent content_;
  std::string key_;
  base::MemoryBudget::Held held_;  // for the table
  // Guards the table; blocks are shared immutable copies. No code counts, allocates or frees memory while it
  // is locked. A writer may be a thread of low priority, and the window's thread a reader.
  mutable std::mutex mutex_;
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Stored {
    std::shared_ptr<const LatticeBlock> block;
    std::uint64_t baked = 0;                     // texels of the block
    std::uint64_t revision = 0;                  // of its last write
    std::uint32_t older = kNone, newer = kNone;  // blocks, in the order of their last write
  };
  void unlink(Stored& stored);

  std::vector<Stored> blocks_;
  std::uint32_t newest_ = kNone;  // the block written last
  std::size_t filled_ = 0;        // existing blocks
  std::atomic<std::uint64_t> revision_{0};
  std::uint64_t clearedAt_ = 0;
  std::uint64_t bakedTexels_ = 0;
  std::size_t blockBytes_ = 0;
};

}  // namespace isolux::gi
