#include "volume/read/chunks/checksums.h"

#include <algorithm>
#include <array>

namespace isolux::volume {

namespace {

// Of each byte with k zero bytes behind it, so that eight bytes are looked up at once.
using CrcTables = std::array<std::array<std::uint32_t, 256>, 8>;

constexpr CrcTables crcTables() {
  constexpr std::uint32_t polynomial = 0x82f63b78u;  // reflected
  CrcTables tables{};
  for (std::uint32_t byte = 0; byte < 256; ++byte) {
    std::uint32_t crc = byte;
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ ((crc & 1u) != 0 ? polynomial : 0u);
    tables[0][byte] = crc;
  }
  for (std::size_t k = 1; k < 8; ++k)
    for (std::size_t byte = 0; byte < 256; ++byte)
      tables[k][byte] = (tables[k - 1][byte] >> 8) ^ tables[0][tables[k - 1][byte] & 0xffu];
  return tables;
}

constexpr CrcTables kCrcTables = crcTables();

}  // namespace

std::uint32_t crc32c(std::span<const std::byte> bytes) {
  const auto at = [&](std::size_t i) { return static_cast<std::uint32_t>(bytes[i]); };
  std::uint32_t crc = ~0u;
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    crc ^= at(i) | at(i + 1) << 8 | at(i + 2) << 16 | at(i + 3) << 24;
    crc = kCrcTables[7][crc & 0xffu] ^ kCrcTables[6][crc >> 8 & 0xffu] ^ kCrcTables[5][crc >> 16 & 0xffu] ^
          kCrcTables[4][crc >> 24] ^ kCrcTables[3][at(i + 4)] ^ kCrcTables[2][at(i + 5)] ^
          kCrcTables[1][at(i + 6)] ^ kCrcTables[0][at(i + 7)];
  }
  for (; i < bytes.size(); ++i) crc = (crc >> 8) ^ kCrcTables[0][(crc ^ at(i)) & 0xffu];
  return ~crc;
}

std::uint32_t fletcher32(std::span<const std::byte> bytes) {
  const auto folded = [](std::uint32_t sum) { return (sum & 0xffffu) + (sum >> 16); };
  constexpr std::size_t longest = 360;  // words until the second sum could overflow
  std::uint32_t first = 0, second = 0;
  std::size_t i = 0;
  while (i + 2 <= bytes.size()) {
    const std::size_t end = i + 2 * std::min(longest, (bytes.size() - i) / 2);
    for (; i < end; i += 2) {
      first += static_cast<std::uint32_t>(bytes[i]) << 8 | static_cast<std::uint32_t>(bytes[i + 1]);
      second += first;
    }
    first = folded(first);
    second = folded(second);
  }
  if (i < bytes.size()) {
    first += static_cast<std::uint32_t>(bytes[i]) << 8;
    second += first;
    first = folded(first);
    second = folded(second);
  }
  return folded(second) << 16 | folded(first);
}

}  // namespace isolux::volume
