// Plausible descriptions of a headerless file, from its name and its size.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "volume/read/input/read_options.h"

namespace isolux::volume {

// Bytes that the description needs, header included; the largest value when that does not fit 64 bits.
std::uint64_t bytesNeeded(const RawDescription& description);

// Best first; each fits the size exactly. From the name: "skull_256x256x128_uint8.raw", "..._int16_be...".
// From the size: cubes, then stacks of 512, 256, 128 and 64 squared slices. Empty when nothing fits.
std::vector<RawDescription> guessRaw(const std::string& fileName, std::uint64_t fileBytes);

}  // namespace isolux::volume
