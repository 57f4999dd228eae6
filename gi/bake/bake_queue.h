// Orders the work of a bake: requested texels, block by block, by priority, round and position in the
// request.
//
// It reads from the lattice only how many samples texels have. A unit that is popped is computed elsewhere,
// written to the lattice, and then completed with give(). Not thread-safe: LightBake locks it. Throws
// std::bad_alloc.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <queue>
#include <utility>
#include <vector>

#include "gi/lattice/light_lattice.h"

namespace isolux::gi {

// Number of samples above which noise is a fine grain: no texel differs visibly from its neighbours.
constexpr std::uint32_t kSmoothSamples = 16;

// Returns the numbers of samples at which the rounds up to `samples` end: 4, 16, 64, ..., samples.
std::vector<std::uint32_t> roundsUpTo(std::uint32_t samples);

class BakeQueue {
 public:
  // Texels of a block to bring to `target` samples; those that have more are not changed.
  struct Unit {
    std::uint32_t block = 0, target = 0;
    std::bitset<kTexelsOfBlock> texels;
    std::size_t request = 0;
    std::uint64_t generation = 0;  // of the request when the unit was popped
  };
  struct Totals {
    std::uint64_t wanted = 0, done = 0, started = 0;  // texels
    std::uint64_t samplesDone = 0;                    // of requested texels, up to the number requested
    // Visible (Priority::visible); of these, with kSmoothSamples or all samples.
    std::uint64_t seen = 0, smooth = 0;
  };
  // Position up to which fulfilled() has checked; start with an empty one.
  struct Cursor {
    std::uint64_t generation = 0;
    std::size_t request = 0, index = 0;
  };

  BakeQueue(const LightLattice& lattice, std::uint32_t samples);

  void want(Priority request, std::vector<BlockRequest> blocks);
  void setSamples(std::uint32_t samples);
  std::uint32_t samples() const { return samples_; }

  std::optional<Unit> take();  // pops a unit; nullopt: nothing to do, or only in blocks being worked on
  void give(const Unit& unit);
  bool idle() const { return taken_ == 0 && totals_.done == totals_.wanted; }
  const Totals& totals() const { return totals_; }
  bool fulfilled(std::uint32_t samples, Cursor& cursor) const;

 private:
  static constexpr std::size_t kPriorities = 4;
  static constexpr std::uint32_t kNone = 0xffffffff;
  struct Item {
    std::uint32_t target = 0, index = 0;  // in the request
    // NOLINTNEXTLINE(modernize-use-nullptr): the 0 it compares with is the library's
    auto operator<=>(const Item&) const = default;
  };
  using Heap = std::priority_queue<Item, std::vector<Item>, std::greater<>>;
  struct Entry {
    std::array<std::uint32_t, kPriorities> index{kNone, kNone, kNone, kNone};  // in each request
    std::uint16_t wanted = 0, done = 0, started = 0, seen = 0, smooth = 0;
    bool taken = false;
    std::uint64_t samplesDone = 0;
  };

  std::vector<BlockRequest> cleaned(std::vector<BlockRequest> blocks);
  std::uint32_t leastSamples(const BlockRequest& wanted) const;
  std::uint32_t roundAfter(std::uint32_t samples) const;
  void fill(std::size_t request);
  void push(std::size_t request, std::uint32_t index);
  void count(std::uint32_t block);

  const LightLattice& lattice_;
  std::uint32_t samples_;
  std::vector<std::uint32_t> rounds_;
  std::array<std::vector<BlockRequest>, kPriorities> requests_;
  std::array<Heap, kPriorities> heaps_;
  std::array<std::uint64_t, kPriorities> generations_{};
  std::uint64_t generation_ = 1;      // changes with any request and with the number of samples
  std::vector<Entry> entries_;        // of blocks
  std::vector<std::uint32_t> place_;  // of blocks, for cleaned()
  // Entries postponed because their block is being worked on for another request.
  std::vector<std::pair<std::size_t, std::uint32_t>> waiting_;
  std::size_t taken_ = 0;
  Totals totals_;
};

}  // namespace isolux::gi
