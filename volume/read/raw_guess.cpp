#include "volume/read/raw_guess.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string_view>

namespace isolux::volume {

namespace {

using volume::Endianness;
using volume::RawDescription;
using volume::VoxelType;

struct NamedType {
  const char* word;
  VoxelType type;
};
// Longer words first: "uint16" contains "int16".
constexpr std::array<NamedType, 19> namedTypes{{{"uint8", VoxelType::uint8},
                                                {"uint16", VoxelType::uint16},
                                                {"uint32", VoxelType::uint32},
                                                {"uint64", VoxelType::uint64},
                                                {"uchar", VoxelType::uint8},
                                                {"ushort", VoxelType::uint16},
                                                {"int8", VoxelType::int8},
                                                {"int16", VoxelType::int16},
                                                {"int32", VoxelType::int32},
                                                {"int64", VoxelType::int64},
                                                {"float32", VoxelType::float32},
                                                {"float64", VoxelType::float64},
                                                {"double", VoxelType::float64},
                                                {"float", VoxelType::float32},
                                                {"short", VoxelType::int16},
                                                {"u8", VoxelType::uint8},
                                                {"u16", VoxelType::uint16},
                                                {"f32", VoxelType::float32},
                                                {"f64", VoxelType::float64}}};

// The types a file of so many bytes per voxel most often has.
constexpr std::array<VoxelType, 4> commonTypes{VoxelType::uint8, VoxelType::int16, VoxelType::uint16,
                                               VoxelType::float32};

std::optional<VoxelType> typeInName(const std::string& name) {
  for (const NamedType& entry : namedTypes) {
    if (name.find(entry.word) != std::string::npos) return entry.type;
  }
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
  for (std::size_t begin = 0; begin <= name.size();) {
    const std::size_t end = std::min(name.find_first_of("_.-", begin), name.size());
    const std::string_view word = std::string_view(name).substr(begin, end - begin);
    if (word == "be" || word == "big" || word == "msb") return true;
    begin = end + 1;
  }
  return false;
}

class Guesses {
 public:
  Guesses(std::uint64_t bytes, Endianness endianness) : bytes_(bytes), endianness_(endianness) {}

  // Adds the description when it fills the file; a header may stand before the voxels if `header` allows it.
  void add(glm::ivec3 dims, VoxelType type, std::uint64_t header) {
    RawDescription guess;
    guess.dims = dims;
    guess.type = type;
    guess.endianness = endianness_;
    const std::uint64_t needed = bytesNeeded(guess);
    if (needed > bytes_ || bytes_ - needed > header) return;
    guess.headerBytes = static_cast<std::size_t>(bytes_ - needed);
    const auto same = [&](const RawDescription& g) { return g.dims == guess.dims && g.type == guess.type; };
    if (std::none_of(list_.begin(), list_.end(), same)) list_.push_back(guess);
  }
  std::vector<RawDescription> take() { return std::move(list_); }

 private:
  std::uint64_t bytes_;
  Endianness endianness_;
  std::vector<RawDescription> list_;
};

}  // namespace

std::uint64_t bytesNeeded(const RawDescription& description) {
  const auto factor = [](int n) { return static_cast<long double>(std::max(n, 0)); };
  const long double bytes = factor(description.dims.x) * factor(description.dims.y) *
                                factor(description.dims.z) *
                                static_cast<long double>(volume::bytesOf(description.type)) +
                            static_cast<long double>(description.headerBytes);
  constexpr auto largest = std::numeric_limits<std::uint64_t>::max();
  return bytes >= static_cast<long double>(largest) ? largest : static_cast<std::uint64_t>(bytes);
}

std::vector<RawDescription> guessRaw(const std::string& fileName, std::uint64_t fileBytes) {
  std::string name = fileName;
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  Guesses guesses(fileBytes, bigEndianInName(name) ? Endianness::big : Endianness::little);
  const auto dims = dimsInName(name);
  const auto type = typeInName(name);
  constexpr std::uint64_t plausibleHeader = 4096;

  if (dims) {
    if (type) guesses.add(*dims, *type, plausibleHeader);
    for (const VoxelType common : commonTypes) guesses.add(*dims, common, plausibleHeader);
    guesses.add(*dims, VoxelType::float64, plausibleHeader);
  }
  std::vector<VoxelType> types(commonTypes.begin(), commonTypes.end());
  if (type) types.assign(1, *type);
  for (const VoxelType candidate : types) {
    const auto voxels = static_cast<double>(fileBytes) / static_cast<double>(volume::bytesOf(candidate));
    const int side = static_cast<int>(std::lround(std::cbrt(voxels)));
    if (side > 1) guesses.add(glm::ivec3(side), candidate, 0);
  }
  for (const int side : {512, 256, 128, 64}) {
    for (const VoxelType candidate : types) {
      const std::uint64_t slice =
          static_cast<std::uint64_t>(side) * static_cast<std::uint64_t>(side) * volume::bytesOf(candidate);
      const std::uint64_t slices = fileBytes / slice;
      if (slices > 1 && slices <= 4096) {
        guesses.add({side, side, static_cast<int>(slices)}, candidate, 0);
      }
    }
  }
  return guesses.take();
}

}  // namespace isolux::volume
