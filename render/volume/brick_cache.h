// Manages which bricks of a volume are resident, and in which slot of the cache; evicts the least recently
// used. No GL.
//
// Brick b contains the voxels that lookups around cells 32 b .. 32 b + 31 need, 32 b - apron .. 32 b + 32 +
// apron on each axis; bricks.glsl reads them. Time is counted in rounds: one pass of rays over the image.
// Hadwiger et al. 2005 sec. 3.4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <list>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::render {

inline constexpr int brickCells = 32;  // per axis; bricks.glsl has the same numbers
// Voxels that a lookup reads before its cell and behind it.
inline constexpr int cubicApron = 1, quinticApron = 2;
constexpr int brickTexels(int apron) {
  return brickCells + 1 + 2 * apron;
}

// One bit for each block of 8^3 cells of a brick: x + 4 y + 16 z.
using BlockBits = std::uint64_t;
constexpr BlockBits blockBit(glm::ivec3 blockOfBrick) {
  return BlockBits{1} << (blockOfBrick.x + 4 * blockOfBrick.y + 16 * blockOfBrick.z);
}

// Returns the bricks of a volume per axis; at least one.
glm::ivec3 brickDims(glm::ivec3 voxels);

class BrickCache {
 public:
  using Brick = std::uint32_t;  // index in the volume, x fastest
  using Slot = std::uint32_t;
  using Round = std::uint64_t;

  BrickCache(std::size_t bricks, std::size_t slots);

  Round beginRound() { return ++round_; }
  Round round() const { return round_; }

  std::optional<Slot> slotOf(Brick brick) const;
  // Marks a resident brick as needed by rays of this round.
  void use(Brick brick);

  // Returns the round that last used the brick that the next place() would evict; 0 while a slot is free.
  Round oldest() const;
  // Returns whether place() would find a slot.
  bool hasPlace(Round kept) const { return oldest() < kept || resident_ < slots(); }
  struct Placement {
    Slot slot;
    std::optional<Brick> evicted;
  };
  // Makes a brick resident, as if used in this round. Requires that it is not resident. Returns nullopt if
  // all slots were used since `kept`.
  std::optional<Placement> place(Brick brick, Round kept);

  std::size_t slots() const { return entries_.size(); }
  std::size_t resident() const { return resident_; }

 private:
  struct Entry {
    std::optional<Brick> brick;
    Round used = 0;
    std::list<Slot>::iterator place;
  };
  static constexpr Slot kNowhere = ~Slot{0};
  void touch(Slot slot);

  Round round_ = 0;
  std::vector<Slot> slots_;     // of each brick
  std::vector<Entry> entries_;  // of each slot
  std::list<Slot> recent_;      // slots, the most recently used first
  std::size_t resident_ = 0;
};

}  // namespace isolux::render
