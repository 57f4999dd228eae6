#include "volume/read/plain/raw.h"

#include <optional>

#include "base/error.h"
#include "base/number_text.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

namespace {

constexpr const char* usage = "WxHxD TYPE [little|big] [spacing sx,sy,sz] [header BYTES]";

[[noreturn]] void badWord(std::string_view word, const std::string& reason) {
  base::throwUsage("", "raw description, " + inQuotes(word), reason + "; expected: " + usage);
}

std::optional<VoxelType> rawTypeNamed(std::string_view name) {
  static constexpr TypeName aliases[] = {{"char", VoxelType::int8},     {"uchar", VoxelType::uint8},
                                         {"short", VoxelType::int16},   {"ushort", VoxelType::uint16},
                                         {"int", VoxelType::int32},     {"uint", VoxelType::uint32},
                                         {"float", VoxelType::float32}, {"double", VoxelType::float64}};
  for (int type = 0; type <= static_cast<int>(VoxelType::float64); ++type)
    if (sameIgnoringCase(name, nameOf(static_cast<VoxelType>(type)))) return static_cast<VoxelType>(type);
  return typeNamed(aliases, name);
}

glm::ivec3 dimsOf(std::string_view word) {
  const std::string lower = lowered(word);  // "256X256X128" is fine
  const auto parts = splitAt(lower, "x");
  if (parts.size() != 3) badWord(word, "three sizes are needed");
  glm::ivec3 dims;
  for (int axis = 0; axis < 3; ++axis) {
    const auto n = integerOf(parts[static_cast<std::size_t>(axis)]);
    if (!n || *n < 1 || *n > 65535) badWord(word, "each size must be a whole number from 1 to 65535");
    dims[axis] = static_cast<int>(*n);
  }
  return dims;
}

glm::dvec3 spacingOf(std::string_view word) {
  const auto parts = splitAt(word, ",");
  if (parts.size() != 3) badWord(word, "three spacings are needed");
  glm::dvec3 spacing;
  for (int axis = 0; axis < 3; ++axis) {
    const auto value = realOf(parts[static_cast<std::size_t>(axis)]);
    if (!value || !(*value >= 1e-9) || !(*value <= 1e9))
      badWord(word, "each spacing must be from 1e-9 to 1e9 mm");
    spacing[axis] = *value;
  }
  return spacing;
}

}  // namespace

RawDescription parseRawDescription(const std::string& text) {
  const auto words = wordsOf(text);
  if (words.empty()) badWord(text, "it is empty");
  RawDescription description;
  description.dims = dimsOf(words[0]);
  if (words.size() < 2) badWord(text, "the type is missing");
  const auto type = rawTypeNamed(words[1]);
  if (!type) badWord(words[1], "is not a voxel type (int8 ... uint64, float32, float64)");
  description.type = *type;
  bool hasOrder = false, hasSpacing = false, hasHeader = false;
  const auto once = [](bool& seen, std::string_view word) {
    if (seen) badWord(word, "is given twice");
    seen = true;
  };
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::string_view word = words[i];
    const bool hasValue = i + 1 < words.size();
    if (word == "little" || word == "big") {
      once(hasOrder, word);
      description.endianness = word == "big" ? Endianness::big : Endianness::little;
    } else if (word == "spacing") {
      once(hasSpacing, word);
      if (!hasValue) badWord(word, "needs three numbers");
      description.spacingMm = spacingOf(words[++i]);
    } else if (word == "header") {
      once(hasHeader, word);
      const auto bytes = hasValue ? integerOf(words[i + 1]) : std::nullopt;
      if (!bytes || *bytes < 0) badWord(hasValue ? words[i + 1] : word, "the header needs a number of bytes");
      description.headerBytes = static_cast<std::size_t>(*bytes);
      ++i;
    } else {
      badWord(word, "is not known");
    }
  }
  return description;
}

std::string toText(const RawDescription& description) {
  using base::exactText;
  const auto& d = description;
  std::string text = std::to_string(d.dims.x) + "x" + std::to_string(d.dims.y) + "x" +
                     std::to_string(d.dims.z) + " " + std::string(nameOf(d.type)) +
                     (d.endianness == Endianness::big ? " big" : " little");
  if (d.spacingMm != glm::dvec3(1.0))
    text += " spacing " + exactText(d.spacingMm.x) + "," + exactText(d.spacingMm.y) + "," +
            exactText(d.spacingMm.z);
  if (d.headerBytes > 0) text += " header " + std::to_string(d.headerBytes);
  return text;
}

ImageHeader headerOfRaw(const RawDescription& description, const std::string& file) {
  ImageHeader header;
  header.format = "raw";
  header.type = description.type;
  header.dims = {description.dims.x, description.dims.y, description.dims.z};
  checkDims(header, file, "raw description");
  header.worldFromVoxel =
      checkedGeometry(glm::dmat3(1.0), description.spacingMm, glm::dvec3(0.0), file, header.warnings);
  header.payload.offset = description.headerBytes;
  header.payload.endianness = description.endianness;
  return header;
}

}  // namespace isolux::volume
