// Slices of level 0 of a chunked volume, one after the other, for a pass over all voxels.
//
// What is read ends where chunks end and stays until it is behind, so that a pass unpacks each chunk once,
// however thin the parts are that it asks for; on all cores. Where a layer of chunks is too large for the
// memory that is left, a part of it at a time: its chunks are then unpacked once for each part. What cannot
// be read is passed over, and told.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/bricks/damage.h"

namespace isolux::volume {

class SliceReader {
 public:
  // Told, one at a time, of what cannot be read: 0 (NaN) in slices().
  using Damaged = std::function<void(DamagedPart&&)>;
  // most: slices that are asked for at a time. The file must outlive it. Throws Error{memory}.
  SliceReader(const ChunkedVolume& file, VolumePart part, int most, Damaged damaged);

  // The slices first .. behind - 1 as stored, until the next call. `first` never falls. Throws Error: memory,
  // interrupted.
  template <class T>
  std::span<const T> slices(int first, int behind, base::Progress& progress) {
    const std::span<const std::byte> bytes = bytesOfSlices(first, behind, progress);
    return {reinterpret_cast<const T*>(bytes.data()), bytes.size() / sizeof(T)};
  }
  std::uint64_t bytesRead() const { return bytesRead_; }  // from the file

 private:
  std::span<const std::byte> bytesOfSlices(int first, int behind, base::Progress& progress);
  void read(int from, int behind, std::byte* to, base::Progress& progress);

  const ChunkedVolume& file_;
  VolumePart part_;
  Damaged damaged_;
  glm::ivec3 dims_, chunk_;  // chunk_: of which whole ones are read
  std::size_t voxelBytes_, sliceBytes_;
  int step_;                       // what is read ends at multiples of it
  std::vector<std::byte> voxels_;  // of the slices first_ .. behind_ - 1
  int first_ = 0, behind_ = 0;
  std::uint64_t bytesRead_ = 0;
  base::MemoryBudget::Held held_;
};

}  // namespace isolux::volume
