// PLY: text or binary in either byte order. Of the element "vertex" x, y, z; of "face" the list of corners.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "base/error.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/text.h"
#include "volume/read/mesh/mesh_formats.h"

namespace isolux::volume {

using base::throwInput;

namespace {

enum class PlyEncoding { text, little, big };

struct Property {
  std::string name;
  VoxelType type = VoxelType::float32;
  std::optional<VoxelType> countType;  // of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<Element> elements;
  std::size_t end = 0;  // the byte after it
};

std::optional<VoxelType> plyType(std::string_view name) {
  struct Name {
    std::string_view old, sized;
    VoxelType type;
  };
  static constexpr Name names[] = {
      {"char", "int8", VoxelType::int8},        {"uchar", "uint8", VoxelType::uint8},
      {"short", "int16", VoxelType::int16},     {"ushort", "uint16", VoxelType::uint16},
      {"int", "int32", VoxelType::int32},       {"uint", "uint32", VoxelType::uint32},
      {"float", "float32", VoxelType::float32}, {"double", "float64", VoxelType::float64}};
  for (const Name& n : names)
    if (name == n.old || name == n.sized) return n.type;
  return std::nullopt;
}

PlyEncoding encodingNamed(std::string_view word, const std::string& file, int line) {
  if (word == "ascii") return PlyEncoding::text;
  if (word == "binary_little_endian") return PlyEncoding::little;
  if (word == "binary_big_endian") return PlyEncoding::big;
  throwInput(file, linePlace(line), "the format " + inQuotes(word) + " is not known");
}

// "property TYPE NAME" or "property list TYPE TYPE NAME", behind the first word.
Property propertyOf(std::string_view rest, const std::string& file, int line) {
  const auto type = [&](std::string_view word) {
    const auto found = plyType(word);
    if (!found) throwInput(file, linePlace(line), "the type " + inQuotes(word) + " is not known");
    return *found;
  };
  Property property;
  std::string_view word = nextWord(rest);
  if (word == "list") {
    property.countType = type(nextWord(rest));
    if (*property.countType >= VoxelType::float32)
      throwInput(file, linePlace(line), "the length of a list is not a whole number");
    word = nextWord(rest);
  }
  property.type = type(word);
  property.name = nextWord(rest);
  return property;
}

PlyHeader parseHeader(std::string_view data, const std::string& file) {
  PlyHeader header;
  Lines lines(data);
  lines.next();  // "ply"
  bool hasFormat = false;
  while (auto line = lines.next()) {
    const std::string_view word = nextWord(*line);
    if (word == "format") {
      header.encoding = encodingNamed(nextWord(*line), file, lines.number());
      hasFormat = true;
    } else if (word == "element") {
      Element element;
      element.name = nextWord(*line);
      const auto count = integerOf(nextWord(*line));
      if (!count || *count < 0) throwInput(file, linePlace(lines.number()), "the element has no count");
      element.count = static_cast<std::uint64_t>(*count);
      header.elements.push_back(std::move(element));
    } else if (word == "property") {
      if (header.elements.empty())
        throwInput(file, linePlace(lines.number()), "a property before the first element");
      header.elements.back().properties.push_back(propertyOf(*line, file, lines.number()));
    } else if (word == "end_header") {
      if (!hasFormat) throwInput(file, "format", "is missing");
      header.end = lines.offset();
      return header;
    } else if (!word.empty() && word != "comment" && word != "obj_info") {
      throwInput(file, linePlace(lines.number()), inQuotes(word) + " does not belong in a PLY header");
    }
  }
  throwInput(file, "end_header", "truncated: is missing");
}

// The values behind the header, one after the other.
class PlyValues {
 public:
  PlyValues(std::string_view data, PlyEncoding encoding, const std::string& file,
            const base::Progress& progress)
      : data_(data), encoding_(encoding), file_(file), progress_(progress) {}

  double next(VoxelType type) {
    if (++passed_ % 65536 == 0) progress_.throwIfStopped();
    return encoding_ == PlyEncoding::text ? nextText() : nextBinary(type);
  }
  // A claim of `count` values more must fit what is left of the file.
  void expect(std::uint64_t count, VoxelType type) const {
    const std::uint64_t least = encoding_ == PlyEncoding::text ? 1 : bytesOf(type);
    if (count > (data_.size() + 1) / least) truncated();
  }

 private:
  [[noreturn]] void truncated() const {
    throwInput(file_, "", "truncated: the file ends before all announced elements");
  }
  double nextText() {
    const std::string_view word = nextWord(data_);
    if (word.empty()) truncated();
    const auto number = realOf(word);
    if (!number) throwInput(file_, "", inQuotes(word) + " is not a number");
    return *number;
  }
  double nextBinary(VoxelType type) {
    const std::size_t size = volume::bytesOf(type);
    if (data_.size() < size) truncated();
    const char* const raw = data_.data();
    data_.remove_prefix(size);
    return withType(type, [&]<class T>(T) {
      return static_cast<double>(numberAt<T>(raw, encoding_ == PlyEncoding::big));
    });
  }

  std::string_view data_;
  PlyEncoding encoding_;
  const std::string& file_;
  const base::Progress& progress_;
  std::uint64_t passed_ = 0;
};

// One row of an element: its scalars, and its list of corners.
class Rows {
 public:
  Rows(const Element& element, PlyValues& values, const std::string& file)
      : element_(element), values_(values), file_(file), scalars_(element.properties.size()) {}

  void read(const std::string& place) {
    corners_.clear();
    for (std::size_t i = 0; i < element_.properties.size(); ++i) {
      const Property& property = element_.properties[i];
      if (!property.countType) {
        scalars_[i] = values_.next(property.type);
        continue;
      }
      const double length = values_.next(*property.countType);
      if (!(length >= 0.0) || length != std::floor(length) || length > 1e9)
        throwInput(file_, place, "the length of a list is not a whole number");
      const auto count = static_cast<std::uint64_t>(length);
      values_.expect(count, property.type);
      const bool isFace = property.name == "vertex_indices" || property.name == "vertex_index";
      for (std::uint64_t k = 0; k < count; ++k) {
        const double value = values_.next(property.type);
        if (isFace) corners_.push_back(std::abs(value) < 9e15 ? static_cast<std::int64_t>(value) : -1);
      }
    }
  }
  double scalar(std::size_t property) const { return scalars_[property]; }
  const std::vector<std::int64_t>& corners() const { return corners_; }

 private:
  const Element& element_;
  PlyValues& values_;
  const std::string& file_;
  std::vector<double> scalars_;
  std::vector<std::int64_t> corners_;
};

std::array<std::size_t, 3> coordinatesOf(const Element& vertex, const std::string& file) {
  std::array<std::size_t, 3> indices{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const std::string name(1, "xyz"[axis]);
    const auto found = std::ranges::find_if(
        vertex.properties, [&](const Property& p) { return p.name == name && !p.countType; });
    if (found == vertex.properties.end()) throwInput(file, "element vertex", "has no property " + name);
    indices[axis] = static_cast<std::size_t>(found - vertex.properties.begin());
  }
  return indices;
}

}  // namespace

bool looksLikePly(const std::string& head) {
  return head.starts_with("ply\n") || head.starts_with("ply\r");
}

TriangleMesh readPlyMesh(const Bytes& bytes, const base::Progress& progress) {
  const std::string data = wholeText(bytes, progress);
  const std::string& file = bytes.name();
  if (!looksLikePly(data)) throwInput(file, "line 1", "is not \"ply\"");
  const PlyHeader header = parseHeader(data, file);
  PlyValues values(std::string_view(data).substr(header.end), header.encoding, file, progress);
  TriangleMesh mesh;
  for (const Element& element : header.elements) {
    if (element.properties.empty()) continue;
    const Property& first = element.properties.front();
    values.expect(element.count, first.countType.value_or(first.type));
    const bool isVertex = element.name == "vertex", isFace = element.name == "face";
    const auto xyz = isVertex ? coordinatesOf(element, file) : std::array<std::size_t, 3>{};
    Rows row(element, values, file);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      const std::string place = element.name + " " + std::to_string(i);
      row.read(place);
      if (isVertex) addPoint(mesh, {row.scalar(xyz[0]), row.scalar(xyz[1]), row.scalar(xyz[2])}, file, place);
      if (isFace) addPolygon(mesh, row.corners(), file, place);
    }
  }
  return mesh;
}

}  // namespace isolux::volume
