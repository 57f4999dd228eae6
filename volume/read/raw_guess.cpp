#include "volume/read/raw_guess.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>

#include "volume/read/input/image_header.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace {

// Longer words first: "uint16" contains "int16".
constexpr TypeName namedTypes[] = {
    {"uint8", VoxelType::uint8},    {"uint16", VoxelType::uint16},   {"uint32", VoxelType::uint32},
    {"uint64", VoxelType::uint64},  {"uchar", VoxelType::uint8},     {"ushort", VoxelType::uint16},
    {"int8", VoxelType::int8},      {"int16", VoxelType::int16},     {"int32", VoxelType::int32},
    {"int64", VoxelType::int64},    {"float32", VoxelType::float32}, {"float64", VoxelType::float64},
    {"double", VoxelType::float64}, {"float", VoxelType::float32},   {"short", VoxelType::int16},
    {"u8", VoxelType::uint8},       {"u16", VoxelType::uint16},      {"f32", VoxelType::float32},
    {"f64", VoxelType::float64}};

// The types a file of so many bytes per voxel most often has.
constexpr std::array<VoxelType, 4> commonTypes{VoxelType::uint8, VoxelType::int16, VoxelType::uint16,
                                               VoxelType::float32};

std::optional<VoxelType> typeInName(const std::string& name) {
  for (const TypeName& entry : namedTypes)
    if (name.find(entry.name) != std::string::npos) return entry.type;
  return std::nullopt;
}

std::optional<glm::ivec3> dimsInName(const std::string& name) {
  for (const char* at = name.c_str(); *at != '\0'; ++at) {
    std::array<char, 6> x{}, y{}, z{};
    if (std::sscanf(at, "%5[0-9]%*1[x_-]%5[0-9]%*1[x_-]%5[0-9]", x.data(), y.data(), z.data()) != 3) continue;
    const glm::ivec3 dims{std::atoi(x.data()), std::atoi(y.data()), std::atoi(z.data())};
    if (dims.x < 1 || dims.y < 1 || dims.z < 1) return std::nullopt;
    return dims;
  }
  return std::nullopt;
}

// "be" and the like as a word of the name.
bool bigEndianInName(const std::string& name) {
  const auto words = splitAt(name, "_.-");
  return std::ranges::any_of(
      words, [](std::string_view word) { return word == "be" || word == "big" || word == "msb"; });
}

}  // namespace

std::uint64_t bytesNeeded(const RawDescription& description) {
  const auto factor = [](int n) { return static_cast<long double>(std::max(n, 0)); };
  const long double bytes = factor(description.dims.x) * factor(description.dims.y) *
                                factor(description.dims.z) *
                                static_cast<long double>(bytesOf(description.type)) +
                            static_cast<long double>(description.headerBytes);
  constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
  return bytes >= static_cast<long double>(largest) ? largest : static_cast<std::uint64_t>(bytes);
}

std::vector<RawDescription> guessRaw(const std::string& fileName, std::uint64_t fileBytes) {
  const std::string name = lowered(fileName);
  const Endianness endianness = bigEndianInName(name) ? Endianness::big : Endianness::little;
  std::vector<RawDescription> guesses;
  // Adds the description when it fills the file; a header may stand before the voxels if `header` allows it.
  const auto add = [&](glm::ivec3 dims, VoxelType type, std::uint64_t header) {
    RawDescription guess{.dims = dims, .type = type, .endianness = endianness};
    const std::uint64_t needed = bytesNeeded(guess);
    if (needed > fileBytes || fileBytes - needed > header) return;
    guess.headerBytes = static_cast<std::size_t>(fileBytes - needed);
    const auto same = [&](const RawDescription& g) { return g.dims == guess.dims && g.type == guess.type; };
    if (std::ranges::none_of(guesses, same)) guesses.push_back(guess);
  };
  const auto dims = dimsInName(name);
  const auto type = typeInName(name);
  constexpr std::uint64_t plausibleHeader = 4096;

  if (dims) {
    if (type) add(*dims, *type, plausibleHeader);
    for (const VoxelType common : commonTypes) add(*dims, common, plausibleHeader);
    add(*dims, VoxelType::float64, plausibleHeader);
  }
  std::vector<VoxelType> types(commonTypes.begin(), commonTypes.end());
  if (type) types.assign(1, *type);
  for (const VoxelType candidate : types) {
    const auto voxels = static_cast<double>(fileBytes) / static_cast<double>(bytesOf(candidate));
    const int side = static_cast<int>(std::lround(std::cbrt(voxels)));
    if (side > 1) add(glm::ivec3(side), candidate, 0);
  }
  for (const int side : {512, 256, 128, 64})
    for (const VoxelType candidate : types) {
      const std::uint64_t slices = fileBytes / (static_cast<std::uint64_t>(side * side) * bytesOf(candidate));
      if (slices > 1 && slices <= 4096) add({side, side, static_cast<int>(slices)}, candidate, 0);
    }
  return guesses;
}

}  // namespace isolux::volume
