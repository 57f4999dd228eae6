#pragma once

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/grid.h"
#include "volume/voxels/stored_type.h"

namespace isolux::test {

// A grid as a file in chunks of this size; can be made to wait and to fail, in whole or in part.
class GridAsFile final : public volume::ChunkedVolume {
 public:
  GridAsFile(volume::Grid grid, glm::ivec3 chunkDims) : grid_(std::move(grid)) {
    facts_.name = "grid";
    facts_.storedType = grid_.storedType();
    facts_.levels = {{grid_.geometry(), chunkDims}};
  }
  const volume::ChunkedFacts& facts() const override { return facts_; }
  std::size_t read(volume::VolumePart, std::size_t, glm::ivec3 low, glm::ivec3 size,
                   std::span<std::byte> voxels) const override {
    ++reads;
    voxelsRead += static_cast<std::uint64_t>(size.x) * static_cast<std::uint64_t>(size.y) *
                  static_cast<std::uint64_t>(size.z);
    for (int axis = 0; axis < 3; ++axis)
      if (low[axis] % facts_.levels[0].chunkDims[axis] != 0) ++readsWithin;
    {
      std::unique_lock lock(mutex);
      opened.wait(lock, [&] { return isOpen; });
    }
    if (fails) base::throwInput("grid", "chunk", "is damaged");
    if (breaks) throw std::runtime_error("of a codec");
    for (const glm::ivec3& one : damaged) {
      const glm::ivec3 first = one * facts_.levels[0].chunkDims, behind = first + facts_.levels[0].chunkDims;
      if (glm::all(glm::lessThan(low, behind)) && glm::all(glm::lessThan(first, low + size)))
        base::throwInput("grid", "chunk " + std::to_string(one.x), "is cut off");
    }
    volume::withStoredType(grid_.storedType(), [&](auto zero) {
      auto* out = reinterpret_cast<decltype(zero)*>(voxels.data());
      for (int z = low.z; z < low.z + size.z; ++z)
        for (int y = low.y; y < low.y + size.y; ++y)
          for (int x = low.x; x < low.x + size.x; ++x)
            *out++ = static_cast<decltype(zero)>(grid_.stored(x, y, z));
    });
    return voxels.size();
  }
  void open() {
    const std::lock_guard lock(mutex);
    isOpen = true;
    opened.notify_all();
  }
  const volume::Grid& grid() const { return grid_; }

  mutable std::atomic<int> reads{0}, readsWithin{0};  // readsWithin: that begin within a chunk
  mutable std::atomic<std::uint64_t> voxelsRead{0};
  std::atomic<bool> fails{false}, breaks{false};  // with an Error, with another exception
  std::vector<glm::ivec3> damaged{};              // chunks that cannot be read
  mutable std::mutex mutex;
  mutable std::condition_variable opened;
  bool isOpen = true;

 private:
  volume::Grid grid_;
  volume::ChunkedFacts facts_;
};

}  // namespace isolux::test
