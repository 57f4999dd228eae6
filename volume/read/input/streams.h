// Forward streams of voxel bytes out of a file: inflated, or parsed from text.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "volume/read/input/bytes.h"
#include "volume/read/input/image_header.h"

namespace isolux::volume {

// Tells by the first bytes of a file or stream: gzip, zstd or bzip2. Zlib's streams have no mark.
bool isPacked(std::string_view head);
// Gives what deflate (zlib, gzip), zstd (a block of 128 KiB in 4 bytes) or bzip2 (one of 46 MB in 40) packs
// at the very best: no stream with this beginning can hold a larger claim.
constexpr std::uint64_t kBestDeflateRatio = 1032;
std::uint64_t bestRatio(std::string_view head);

class VoxelStream {
 public:
  virtual ~VoxelStream() = default;
  // Fills `out`, a whole number of elements, or throws Error{input} "truncated ...".
  virtual void read(std::span<std::byte> out) = 0;
  // True when data follow the part that was read. Throws Error{input} where packed ones are damaged.
  virtual bool hasMore() = 0;
  // After hasMore(): true where packed data end before their own end, so that their checksum is missing.
  virtual bool isCut() const { return false; }
};

// zlib, gzip, zstd or bzip2 (several members, too) between `offset` and offset + length.
std::unique_ptr<VoxelStream> inflateStream(const Bytes& bytes, std::uint64_t offset, std::uint64_t length);
// Numbers separated by white space or commas, as values of `type` in the machine's byte order.
std::unique_ptr<VoxelStream> textStream(const Bytes& bytes, std::uint64_t offset, VoxelType type);

// The first bytes of a file that is one zlib, gzip, zstd or bzip2 stream, at most `most`; fewer when it is
// shorter, none when broken.
std::string inflatedHead(const Bytes& bytes, std::size_t most);

}  // namespace isolux::volume
