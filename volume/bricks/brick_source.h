// The voxels of a chunked volume, brick by brick: those that were needed last stay in memory, under a budget.
//
// A brick of a level holds what its file gives without waste: a chunk, where chunks are boxes; else, of files
// that keep rows, 32 voxels per axis with those around them that lookups at its cells read (kApron in front,
// kApron + 1 behind), so that a brick on the GPU (render/volume/brick_cache.h) is one brick here. Voxels are
// stored numbers, x fastest. Least recently used bricks make room; what somebody holds stays until he lets
// go.
//
// Any thread may ask; a brick that several ask for is read once. Threads of its own, started by the first
// request(), read ahead. Errors of the file are base::Error{input} of whoever waits for the brick; it is read
// again when it is asked for again.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "base/page_allocator.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/bricks/damage.h"

namespace isolux::volume {

class BrickSource {
 public:
  static constexpr int kRowBrick = 32, kApron = 1;

  // budgetBytes: of bricks that are kept; one stays, whatever it says. Throws Error{memory} where the
  // machine's budget has less left.
  BrickSource(std::shared_ptr<const ChunkedVolume> file, VolumePart part, std::size_t budgetBytes);
  ~BrickSource();
  BrickSource(const BrickSource&) = delete;
  BrickSource& operator=(const BrickSource&) = delete;

  const ChunkedVolume& file() const;
  const ChunkedFacts& facts() const;
  VolumePart part() const;

  struct Brick {
    glm::ivec3 low, size;  // voxels of the level
    std::vector<std::byte, base::PageAllocator<std::byte>> voxels;
  };
  glm::ivec3 brickOf(std::size_t level, glm::ivec3 voxel) const;
  // Waits until it is there. `index` in bricks.
  std::shared_ptr<const Brick> brick(std::size_t level, glm::ivec3 index);
  // Whether it is in memory now.
  bool has(std::size_t level, glm::ivec3 index) const;

  // A brick that somebody will want: read by a thread of the source, unless all who asked have let go before
  // it began. Of those that wait, higher priorities first. Errors are left for brick().
  using Request = std::shared_ptr<void>;
  [[nodiscard]] Request request(std::size_t level, glm::ivec3 index, int priority);

  // The voxels first .. first + size - 1 of a level; beyond the border the border voxel repeats. unknown:
  // what cannot be read is 0, and listed there instead of thrown; boxes may reach beyond the border, too.
  void copyBox(std::size_t level, glm::ivec3 first, glm::ivec3 size, std::span<std::byte> voxels,
               std::vector<DamagedPart>* unknown = nullptr);
  // The bricks that copyBox() of it needs, as request().
  [[nodiscard]] std::vector<Request> requestBox(std::size_t level, glm::ivec3 first, glm::ivec3 size,
                                                int priority);
  double stored(glm::ivec3 voxel);  // of level 0; NaN where missing

  struct Reads {
    std::uint64_t fileBytes = 0;   // read from the file, as it reports them
    std::uint64_t bricks = 0;      // those that were read again count again
    std::uint64_t brickBytes = 0;  // of the voxels of those
    std::size_t keptBytes = 0;     // in memory now
  };
  Reads reads() const;
  std::size_t budgetBytes() const;

 private:
  struct State;
  std::shared_ptr<State> state_;  // shared with its threads
};

}  // namespace isolux::volume
