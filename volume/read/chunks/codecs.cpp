#include "volume/read/chunks/codecs.h"

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <string>

#include <blosc.h>
#include <bzlib.h>
#include <lz4.h>
#include <zlib.h>
#include <zstd.h>

#include "base/error.h"
#include "volume/read/chunks/checksums.h"
#include "volume/read/input/bytes.h"

namespace isolux::volume {

namespace {

using PackedBytes = std::span<const std::byte>;
using Unpacked = std::vector<std::byte>;

[[noreturn]] void damaged(CodecKind kind, const std::string& reason) {
  base::throwInput("", "", std::string(nameOf(kind)) + " data are damaged: " + reason);
}

[[noreturn]] void tooLong(CodecKind kind, std::size_t atMost) {
  damaged(kind, "they unpack to more than the " + std::to_string(atMost) + " bytes of a chunk");
}

std::uint32_t number32(PackedBytes bytes, std::size_t at, bool big = false) {
  return numberAt<std::uint32_t>(&bytes[at], big);
}

// inflateEnd() on every way out.
class InflateState {
 public:
  InflateState() {
    constexpr int zlibOrGzip = 32 + MAX_WBITS;
    if (::inflateInit2(&stream, zlibOrGzip) != Z_OK) throw std::bad_alloc();
  }
  ~InflateState() { ::inflateEnd(&stream); }
  InflateState(const InflateState&) = delete;
  InflateState& operator=(const InflateState&) = delete;
  z_stream stream{};
};

// `in` and `out` are below 4 GiB: chunks and what they are packed to are.
Unpacked inflated(PackedBytes packed, std::size_t atMost) {
  Unpacked out(atMost + 1);  // one more tells that there is more
  InflateState state;
  z_stream& z = state.stream;
  z.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(packed.data()));  // zlib's older signature
  z.avail_in = static_cast<uInt>(packed.size());
  z.next_out = reinterpret_cast<Bytef*>(out.data());
  z.avail_out = static_cast<uInt>(out.size());
  for (;;) {
    const int result = ::inflate(&z, Z_FINISH);
    if (z.avail_out == 0) tooLong(CodecKind::deflate, atMost);
    if (result == Z_STREAM_END) {
      const bool anotherMember = z.avail_in >= 2 && z.next_in[0] == 0x1f && z.next_in[1] == 0x8b;
      if (!anotherMember) break;
      ::inflateReset(&z);
      continue;
    }
    if (result == Z_BUF_ERROR) damaged(CodecKind::deflate, "they are cut off");
    damaged(CodecKind::deflate, z.msg != nullptr ? z.msg : "no such stream");
  }
  out.resize(out.size() - z.avail_out);
  return out;
}

Unpacked unzstd(PackedBytes packed, std::size_t atMost) {
  Unpacked out(atMost);
  const std::size_t size = ::ZSTD_decompress(out.data(), out.size(), packed.data(), packed.size());
  if (::ZSTD_isError(size) != 0) damaged(CodecKind::zstd, ::ZSTD_getErrorName(size));
  out.resize(size);
  return out;
}

// `out` is below 4 GiB.
Unpacked unbzip2(PackedBytes packed, std::size_t atMost) {
  Unpacked out(atMost + 1);  // one more tells that there is more
  auto size = static_cast<unsigned>(out.size());
  char* const in = const_cast<char*>(reinterpret_cast<const char*>(packed.data()));  // its older signature
  const int result = ::BZ2_bzBuffToBuffDecompress(reinterpret_cast<char*>(out.data()), &size, in,
                                                  static_cast<unsigned>(packed.size()), 0, 0);
  if (result == BZ_OUTBUFF_FULL || (result == BZ_OK && size > atMost)) tooLong(CodecKind::bzip2, atMost);
  if (result == BZ_UNEXPECTED_EOF) damaged(CodecKind::bzip2, "they are cut off");
  if (result != BZ_OK)
    damaged(CodecKind::bzip2, result == BZ_DATA_ERROR_MAGIC ? "no such stream" : "a block's sum is wrong");
  out.resize(size);
  return out;
}

void decodeLz4Block(PackedBytes packed, std::span<std::byte> out, CodecKind kind) {
  const int made =
      ::LZ4_decompress_safe(reinterpret_cast<const char*>(packed.data()), reinterpret_cast<char*>(out.data()),
                            static_cast<int>(packed.size()), static_cast<int>(out.size()));
  if (made < 0 || static_cast<std::size_t>(made) != out.size())
    damaged(kind, "a block does not unpack to its length");
}

Unpacked unlz4(PackedBytes packed, std::size_t atMost) {
  if (packed.size() < 4) damaged(CodecKind::lz4, "they are cut off");
  const std::size_t size = number32(packed, 0);
  if (size > atMost) tooLong(CodecKind::lz4, atMost);
  Unpacked out(size);
  decodeLz4Block(packed.subspan(4), out, CodecKind::lz4);
  return out;
}

// https://github.com/nemequ/liblzf (lzf_d.c): runs of literals, and copies of what is already unpacked.
Unpacked unlzf(PackedBytes packed, std::size_t atMost) {
  constexpr CodecKind kind = CodecKind::lzf;
  Unpacked out;
  std::size_t at = 0;
  const auto next = [&] {
    if (at == packed.size()) damaged(kind, "they are cut off");
    return static_cast<std::size_t>(packed[at++]);
  };
  while (at < packed.size()) {
    const std::size_t control = next();
    if (control < 32) {
      if (control + 1 > packed.size() - at) damaged(kind, "they are cut off");
      out.insert(out.end(), packed.begin() + static_cast<std::ptrdiff_t>(at),
                 packed.begin() + static_cast<std::ptrdiff_t>(at + control + 1));
      at += control + 1;
    } else {
      const std::size_t length = (control >> 5 < 7 ? control >> 5 : 7 + next()) + 2;
      const std::size_t back = ((control & 31u) << 8 | next()) + 1;
      if (back > out.size()) damaged(kind, "they refer to bytes before the first");
      for (std::size_t i = 0; i < length; ++i) out.push_back(out[out.size() - back]);
    }
    if (out.size() > atMost) tooLong(kind, atMost);
  }
  return out;
}

Unpacked unlz4Blocks(PackedBytes packed, std::size_t atMost) {
  constexpr CodecKind kind = CodecKind::lz4Blocks;
  if (packed.size() < 12) damaged(kind, "they are cut off");
  const std::uint64_t size = numberAt<std::uint64_t>(packed.data(), true),
                      blockBytes = number32(packed, 8, true);
  if (size > atMost) tooLong(kind, atMost);
  if (blockBytes == 0) damaged(kind, "blocks have no length");
  Unpacked out(static_cast<std::size_t>(size));
  std::span<std::byte> rest(out);
  for (std::size_t at = 12; !rest.empty();) {
    if (packed.size() - at < 4) damaged(kind, "they are cut off");
    const std::size_t length = number32(packed, at, true);
    at += 4;
    if (length > packed.size() - at) damaged(kind, "they are cut off");
    const auto block = rest.first(static_cast<std::size_t>(std::min<std::uint64_t>(blockBytes, rest.size())));
    if (length == block.size())  // did not get shorter: as it is
      std::memcpy(block.data(), packed.data() + at, length);
    else
      decodeLz4Block(packed.subspan(at, length), block, kind);
    at += length;
    rest = rest.subspan(block.size());
  }
  return out;
}

Unpacked unblosc(PackedBytes packed, std::size_t atMost) {
  std::size_t size = 0;
  if (::blosc_cbuffer_validate(packed.data(), packed.size(), &size) != 0)
    damaged(CodecKind::blosc, "they are cut off, or no Blosc 1 frame");
  if (size > atMost) tooLong(CodecKind::blosc, atMost);
  Unpacked out(size);
  if (size == 0) return out;
  const int made = ::blosc_decompress_ctx(packed.data(), out.data(), out.size(), 1);
  if (made < 0 || static_cast<std::size_t>(made) != size) {
    const char* const library = ::blosc_cbuffer_complib(packed.data());
    damaged(CodecKind::blosc, std::string("its codec (") + (library != nullptr ? library : "unknown") +
                                  ") gave up, or is not in the library");
  }
  return out;
}

Unpacked unshuffled(PackedBytes packed, std::size_t elementBytes) {
  const std::size_t count = packed.size() / elementBytes;
  Unpacked out(packed.size());
  for (std::size_t byte = 0; byte < elementBytes; ++byte)
    for (std::size_t i = 0; i < count; ++i) out[i * elementBytes + byte] = packed[byte * count + i];
  std::copy(packed.begin() + static_cast<std::ptrdiff_t>(count * elementBytes), packed.end(),
            out.begin() + static_cast<std::ptrdiff_t>(count * elementBytes));
  return out;
}

// Without the sum behind it.
PackedBytes summed(CodecKind kind, PackedBytes bytes) {
  if (bytes.size() < 4) damaged(kind, "they are cut off");
  return bytes.first(bytes.size() - 4);
}

Unpacked checkedCrc(PackedBytes packed, std::size_t) {
  const PackedBytes bytes = summed(CodecKind::crc32c, packed);
  if (crc32c(bytes) != number32(packed, bytes.size())) damaged(CodecKind::crc32c, "the checksum is wrong");
  return {bytes.begin(), bytes.end()};
}

Unpacked checkedFletcher(PackedBytes packed, std::size_t) {
  const PackedBytes bytes = summed(CodecKind::fletcher32, packed);
  const std::uint32_t sum = fletcher32(bytes), stored = number32(packed, bytes.size());
  // HDF5 up to 1.6.2 wrote the bytes of each half the other way round on little-endian machines.
  const std::uint32_t reversed = (sum & 0x00ff00ffu) << 8 | (sum & 0xff00ff00u) >> 8;
  if (stored != sum && stored != reversed) damaged(CodecKind::fletcher32, "the checksum is wrong");
  return {bytes.begin(), bytes.end()};
}

struct KnownCodec {
  std::string_view name;
  Unpacked (*unpack)(PackedBytes packed, std::size_t sizeOrMost);  // the size is that of a shuffled number
};

constexpr KnownCodec kCodecs[] = {  // of the kinds
    {"deflate", inflated},  {"zstd", unzstd},
    {"bzip2", unbzip2},     {"lz4", unlz4},
    {"lz4", unlz4Blocks},   {"lzf", unlzf},
    {"blosc", unblosc},     {"shuffle", unshuffled},
    {"crc32c", checkedCrc}, {"fletcher32", checkedFletcher}};

}  // namespace

std::string_view nameOf(CodecKind kind) {
  return kCodecs[static_cast<int>(kind)].name;
}

std::vector<std::byte> unpacked(const Codec& codec, std::span<const std::byte> packed, std::size_t atMost) {
  const std::size_t sizeOrMost = codec.kind == CodecKind::shuffle ? codec.elementBytes : atMost;
  return kCodecs[static_cast<int>(codec.kind)].unpack(packed, sizeOrMost);
}

std::size_t longestPacked(std::size_t bytes) {
  return bytes + bytes / 4 + 65536;
}

}  // namespace isolux::volume
