// How the numbers of a chunk lie in a file: their type, byte order, order of axes and codecs. Zarr and HDF5
// say it in words of their own and mean the same.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "volume/read/chunks/chunked_array.h"
#include "volume/read/chunks/codecs.h"
#include "volume/read/input/bytes.h"

namespace isolux::volume {

// A type of numbers in a file. float16 becomes float32, and bool uint8, when a chunk is read.
struct FileNumber {
  VoxelType type = VoxelType::uint8;                              // that it becomes
  bool half = false;                                              // 2 bytes each, float16
  bool big = false;                                               // byte order; of a single byte neither
  std::size_t bytes() const { return half ? 2 : bytesOf(type); }  // in the file
};

struct ChunkFormat {
  FileNumber number;
  std::vector<std::uint64_t> dims;  // of a chunk
  std::vector<std::size_t> order;   // axes, slowest first, as the chunk's numbers follow each other
  std::vector<Codec> codecs;        // in the order in which they are undone
  std::array<std::byte, 8> fill{};  // a number of `number.type`, machine's byte order

  std::uint64_t numbers() const;                                          // of a chunk
  std::uint64_t fileBytes() const { return numbers() * number.bytes(); }  // unpacked
};

// Throws base::Error{input} where chunks are larger than 2 GiB unpacked, the most that Blosc knows, unless
// they are plain; and where dims overflow.
void checkChunkBytes(const ChunkFormat& format, const std::string& file, const std::string& place);

// The chunk that takes `stored` bytes from `offset` on: all of it if it is packed, else the box
// [low, low + size). Throws base::Error: input at `place`, memory.
ArrayChunk readChunk(const ChunkFormat& format, const Bytes& bytes, std::uint64_t offset,
                     std::uint64_t stored, std::span<const std::uint64_t> low,
                     std::span<const std::uint64_t> size, const std::string& place);

// Of a chunk without codecs, which lies at `offset`, the box [low, low + size): only its bytes are read.
ArrayChunk readPlainChunk(const ChunkFormat& format, const Bytes& bytes, std::uint64_t offset,
                          std::span<const std::uint64_t> low, std::span<const std::uint64_t> size);

// "chunk 0/1/2", for messages.
std::string chunkPlace(std::span<const std::uint64_t> index);

// A chunk that the file does not have.
ArrayChunk missingChunk(const ChunkFormat& format);

// A number of `type` in the machine's byte order; what does not fit the type is cast as C++ clamps it.
std::array<std::byte, 8> fillOf(VoxelType type, double value);

}  // namespace isolux::volume
