// An array of numbers that a file keeps in chunks of one shape.
//
// Axes are numbered as the file lists them, 1 to 8 of them. Any number of threads may read at a time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "volume/grid.h"

namespace isolux::volume {

inline constexpr std::size_t kMostArrayAxes = 8;

struct ArrayLayout {
  std::vector<std::uint64_t> dims, chunk;  // of each axis, at least 1; the last chunk may reach over the end
  VoxelType type = VoxelType::uint8;       // of the numbers that read() gives
  bool keepsRows = false;                  // in its one chunk, any of which are read alone
};

// Of one chunk what was asked for, or more.
struct ArrayChunk {
  std::vector<std::byte> bytes;        // numbers in the machine's byte order
  std::vector<std::uint64_t> start;    // place in the chunk, by axis, of the first of them
  std::vector<std::uint64_t> strides;  // by axis, in numbers; all 0: one number stands for all
  std::size_t bytesRead = 0;           // from the file
  bool missing = false;                // the file has no such chunk: the fill value
};

class ChunkedArray {
 public:
  virtual ~ChunkedArray() = default;

  virtual const ArrayLayout& layout() const = 0;
  // Of the numbers in the file, where read() turns them into others.
  virtual VoxelType fileType() const { return layout().type; }
  // True where a part of a chunk costs no more than that part: chunks are neither packed nor summed.
  virtual bool plain() const = 0;
  // The chunk `index` (by axis); of it the box [low, low + size) is needed, which lies in chunk and array.
  // Throws base::Error{input} naming file and chunk, {memory}.
  virtual ArrayChunk read(std::span<const std::uint64_t> index, std::span<const std::uint64_t> low,
                          std::span<const std::uint64_t> size) const = 0;
};

}  // namespace isolux::volume
