#include "volume/read/chunks/chunk_format.h"

#include <bit>
#include <cmath>
#include <cstring>
#include <limits>

#include <glm/gtc/packing.hpp>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/words.h"
#include "volume/read/input/convert.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr std::uint64_t kLargestPackedChunk = std::uint64_t{1} << 31;

std::vector<std::byte> floatsOfHalves(std::span<const std::byte> halves) {
  std::vector<std::byte> floats(2 * halves.size());
  for (std::size_t i = 0; i < halves.size() / 2; ++i) {
    std::uint16_t half = 0;
    std::memcpy(&half, halves.data() + 2 * i, 2);
    const float wide = glm::unpackHalf1x16(half);
    std::memcpy(floats.data() + 4 * i, &wide, 4);
  }
  return floats;
}

// Numbers of the file, in their order there, in the machine's.
std::vector<std::byte> machineNumbers(const FileNumber& number, std::vector<std::byte> bytes) {
  if (number.big != (std::endian::native == std::endian::big) && number.bytes() > 1)
    swapBytes(bytes, number.bytes());
  return number.half ? floatsOfHalves(bytes) : std::move(bytes);
}

std::vector<std::uint64_t> stridesOf(const ChunkFormat& format, std::span<const std::uint64_t> dims) {
  std::vector<std::uint64_t> strides(dims.size());
  std::uint64_t stride = 1;
  for (auto axis = format.order.rbegin(); axis != format.order.rend(); ++axis) {
    strides[*axis] = stride;
    stride *= dims[*axis];
  }
  return strides;
}

// The whole chunk.
ArrayChunk unpackChunk(const ChunkFormat& format, std::span<const std::byte> packed, const std::string& file,
                       const std::string& place) {
  const auto wanted = static_cast<std::size_t>(format.fileBytes());
  try {
    ArrayChunk chunk;
    chunk.bytesRead = packed.size();
    for (std::size_t i = 0; i < format.codecs.size(); ++i) {
      const bool last = i + 1 == format.codecs.size();
      chunk.bytes = unpacked(format.codecs[i], i == 0 ? packed : std::span<const std::byte>(chunk.bytes),
                             last ? wanted : longestPacked(wanted));
    }
    if (format.codecs.empty()) chunk.bytes.assign(packed.begin(), packed.end());
    if (chunk.bytes.size() != wanted)
      throwInput("", "",
                 "damaged: " + std::to_string(chunk.bytes.size()) + " bytes instead of the " +
                     std::to_string(wanted) + " of a chunk");
    chunk.bytes = machineNumbers(format.number, std::move(chunk.bytes));
    chunk.start.assign(format.dims.size(), 0);
    chunk.strides = stridesOf(format, format.dims);
    return chunk;
  } catch (const base::Error& error) {
    throw base::Error(error.kind(), file, place, error.reason());
  }
}

}  // namespace

std::uint64_t ChunkFormat::numbers() const {
  std::uint64_t product = 1;
  for (const std::uint64_t n : dims) product *= n;
  return product;
}

void checkChunkBytes(const ChunkFormat& format, const std::string& file, const std::string& place) {
  std::uint64_t bytes = sizeof(double);  // the widest that numbers become
  for (const std::uint64_t n : format.dims)
    if (n == 0 || __builtin_mul_overflow(bytes, n, &bytes) || bytes > std::uint64_t{1} << 62)
      throwInput(file, place, "the size of a chunk is absurd");
  if (!format.codecs.empty() && format.fileBytes() > kLargestPackedChunk)
    throwInput(file, place,
               "packed chunks have " + std::to_string(format.fileBytes()) + " bytes; at most 2 GiB are read");
}

ArrayChunk readPlainChunk(const ChunkFormat& format, const Bytes& bytes, std::uint64_t offset,
                          std::span<const std::uint64_t> low, std::span<const std::uint64_t> size) {
  const std::vector<std::uint64_t> fileStrides = stridesOf(format, format.dims);
  // Axes, the fastest first, that are needed whole follow each other in the file: one run.
  const std::size_t width = format.number.bytes();
  std::uint64_t run = 1, total = 1;
  std::size_t runAxes = 0;
  for (auto axis = format.order.rbegin(); axis != format.order.rend(); ++axis) {
    run *= size[*axis];
    ++runAxes;
    if (size[*axis] != format.dims[*axis]) break;
  }
  for (const std::uint64_t n : size) total *= n;
  const std::span slow = std::span(format.order).first(format.order.size() - runAxes);
  std::vector<std::byte> out(static_cast<std::size_t>(total) * width);
  std::vector<std::uint64_t> at(low.begin(), low.end());
  for (std::uint64_t done = 0; done < total; done += run) {
    std::uint64_t place = 0;
    for (std::size_t axis = 0; axis < at.size(); ++axis) place += at[axis] * fileStrides[axis];
    bytes.read(offset + place * width, std::span(out).subspan(static_cast<std::size_t>(done) * width,
                                                              static_cast<std::size_t>(run) * width));
    for (std::size_t i = slow.size(); i-- > 0;) {
      const std::size_t axis = slow[i];
      if (++at[axis] < low[axis] + size[axis]) break;
      at[axis] = low[axis];
    }
  }
  ArrayChunk chunk;
  chunk.bytesRead = out.size();
  chunk.bytes = machineNumbers(format.number, std::move(out));
  chunk.start.assign(low.begin(), low.end());
  chunk.strides = stridesOf(format, size);
  return chunk;
}

ArrayChunk readChunk(const ChunkFormat& format, const Bytes& bytes, std::uint64_t offset,
                     std::uint64_t stored, std::span<const std::uint64_t> low,
                     std::span<const std::uint64_t> size, const std::string& place) {
  const std::uint64_t wanted = format.fileBytes();
  const bool isPlain = format.codecs.empty();
  if (isPlain ? stored != wanted : stored > longestPacked(static_cast<std::size_t>(wanted)))
    throwInput(
        bytes.name(), place,
        "damaged: it has " + std::to_string(stored) + " bytes, its voxels take " + std::to_string(wanted));
  if (isPlain) return readPlainChunk(format, bytes, offset, low, size);
  const auto held = base::machineMemory().reserve(static_cast<std::size_t>(stored + 2 * wanted),
                                                  "a chunk of " + bytes.name(), "");
  std::vector<std::byte> packed(static_cast<std::size_t>(stored));
  bytes.read(offset, packed);
  return unpackChunk(format, packed, bytes.name(), place);
}

std::string chunkPlace(std::span<const std::uint64_t> index) {
  return "chunk " + base::joined(index, "/", [](std::uint64_t i) { return std::to_string(i); });
}

ArrayChunk missingChunk(const ChunkFormat& format) {
  ArrayChunk chunk;
  chunk.bytes.assign(format.fill.begin(),
                     format.fill.begin() + static_cast<std::ptrdiff_t>(bytesOf(format.number.type)));
  chunk.start.assign(format.dims.size(), 0);
  chunk.strides.assign(format.dims.size(), 0);
  chunk.missing = true;
  return chunk;
}

std::array<std::byte, 8> fillOf(VoxelType type, double value) {
  std::array<std::byte, 8> fill{};
  withType(type, [&](auto zero) {
    using T = decltype(zero);
    T number{};
    if constexpr (std::is_floating_point_v<T>) {
      number = static_cast<T>(value);
    } else if (!std::isnan(value)) {
      constexpr double low = static_cast<double>(std::numeric_limits<T>::lowest());
      constexpr double high = static_cast<double>(std::numeric_limits<T>::max());
      number = value <= low    ? std::numeric_limits<T>::lowest()
               : value >= high ? std::numeric_limits<T>::max()
                               : static_cast<T>(value);
    }
    std::memcpy(fill.data(), &number, sizeof(T));
  });
  return fill;
}

}  // namespace isolux::volume
