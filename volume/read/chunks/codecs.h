// What chunks are packed with, undone: each by the library that knows it.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace isolux::volume {

enum class CodecKind {
  deflate,     // zlib or gzip, told apart by content; several gzip members, too
  zstd,        // frames
  bzip2,       // one stream
  lz4,         // numcodecs: length (4 bytes, little endian), one block
  lz4Blocks,   // HDF5's filter 32004: lengths (big endian), blocks
  lzf,         // HDF5's filter 32000, h5py's: LibLZF's format without a length
  blosc,       // a frame of Blosc 1
  shuffle,     // first bytes of all numbers, then second bytes, ...
  crc32c,      // the sum behind the bytes, little endian
  fletcher32,  // HDF5's filter 3: the sum behind the bytes
};

struct Codec {
  CodecKind kind = CodecKind::deflate;
  std::size_t elementBytes = 1;  // of shuffle
};
std::string_view nameOf(CodecKind kind);

// The bytes that were packed. Never makes more than `atMost`. Throws base::Error{input} with a reason but
// neither file nor place: damaged, cut, longer than that.
std::vector<std::byte> unpacked(const Codec& codec, std::span<const std::byte> packed, std::size_t atMost);

// How long bytes may be that a codec or a chain of them makes of so many: all that is believed of packed
// data.
std::size_t longestPacked(std::size_t bytes);

}  // namespace isolux::volume
