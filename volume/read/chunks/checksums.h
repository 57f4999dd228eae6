// Sums that chunks carry to tell damage.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace isolux::volume {

// CRC-32C (Castagnoli; RFC 3720, appendix B.4).
std::uint32_t crc32c(std::span<const std::byte> bytes);

// Fletcher's sum as HDF5's filter 3 makes it: over big-endian words of 16 bits, an odd byte as the high half
// of the last.
std::uint32_t fletcher32(std::span<const std::byte> bytes);

}  // namespace isolux::volume
