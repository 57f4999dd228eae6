#include "volume/read/zarr/zarr_statements.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/read/input/bytes.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/text.h"
#include "volume/read/zarr/json_fields.h"

namespace isolux::volume {

namespace {

std::optional<AttributeValue> valueOf(const nlohmann::json& json) {
  AttributeValue value;
  value.whole = json.is_number_integer();
  if (json.is_string()) {
    value.text = json.get<std::string>();
  } else if (json.is_number()) {
    value.numbers = {json.get<double>()};
  } else if (json.is_array()) {
    value.whole = true;
    for (const auto& entry : json) {
      if (!entry.is_number()) return std::nullopt;
      value.numbers.push_back(entry.get<double>());
      value.whole = value.whole && entry.is_number_integer();
    }
  } else {
    return std::nullopt;
  }
  return value;
}

// xarray writes fill values of floats into Zarr 3 as their bytes, little endian, in base64.
std::optional<double> numberInBase64(std::string_view text, VoxelType type) {
  const std::string bytes = decodedBase64(text);
  if (!text.empty() && text.front() != '=') return std::nullopt;
  return withType(type, [&]<class T>(T) -> std::optional<double> {
    if (bytes.size() != sizeof(T)) return std::nullopt;
    return static_cast<double>(numberAt<T>(bytes.data(), false));
  });
}

std::vector<std::string> axisNamesOf(const ZarrArray& array) {
  std::vector<std::string> names = array.metadata().dimensionNames;
  const auto& attributes = array.attributes();
  if (names.empty() && attributes.contains("_ARRAY_DIMENSIONS"))  // xarray's
    for (const auto& axis : JsonField(attributes["_ARRAY_DIMENSIONS"], "", "_ARRAY_DIMENSIONS").entries())
      names.push_back(axis.text());
  if (names.size() != array.metadata().dims.size()) names.clear();
  return names;
}

// All numbers of an array of one axis.
std::vector<double> lineOf(const ZarrArray& array) {
  const ArrayLayout& layout = array.layout();
  std::vector<double> line;
  while (line.size() < layout.dims[0]) {
    const std::uint64_t index[] = {line.size() / layout.chunk[0]}, low[] = {0},
                        size[] = {std::min<std::uint64_t>(layout.chunk[0], layout.dims[0] - line.size())};
    const ArrayChunk chunk = array.read(index, low, size);
    withType(layout.type, [&]<class T>(T) {
      const auto* const numbers = reinterpret_cast<const T*>(chunk.bytes.data());
      for (std::uint64_t i = 0; i < size[0]; ++i)
        line.push_back(static_cast<double>(numbers[i * chunk.strides[0]]));
    });
  }
  return line;
}

AxisStatement axisOf(const std::shared_ptr<const ZarrStore>& store, const std::string& key,
                     const std::string& name, std::uint64_t entries) {
  AxisStatement axis;
  axis.name = name;
  constexpr std::uint64_t longest = 65535;
  if (name.empty() || name.find('/') != std::string::npos || entries > longest ||
      !ZarrArray::isArray(*store, key))
    return axis;
  const ZarrArray positions(store, key);
  if (positions.layout().dims != std::vector<std::uint64_t>{entries}) return axis;
  const Attributes attributes = attributesOf(positions);
  axis = cfAxis(attributes, name);
  ArrayStatements packing;
  readCfValues(attributes, positions.metadata().format.number, packing);
  std::vector<double> line = lineOf(positions);
  for (double& position : line) position = packing.slope * position + packing.intercept;
  setPositions(axis, line);
  return axis;
}

}  // namespace

Attributes attributesOf(const ZarrArray& array) {
  Attributes attributes;
  for (const auto& [name, json] : array.attributes().items())
    if (auto value = valueOf(json)) attributes[name] = std::move(*value);
  return attributes;
}

ArrayStatements statementsOf(const std::shared_ptr<const ZarrStore>& store, const std::string& key,
                             const ZarrArray& array) {
  ArrayStatements statements;
  statements.warnings = array.warnings();
  const ZarrMetadata& metadata = array.metadata();
  Attributes attributes = attributesOf(array);
  const auto fill = attributes.find("_FillValue");
  if (fill != attributes.end() && !fill->second.text.empty()) {
    if (const auto number = numberInBase64(fill->second.text, metadata.format.number.type))
      fill->second = {"", {*number}, false};
  } else if (fill == attributes.end() && metadata.fillValue &&
             array.attributes().contains("_ARRAY_DIMENSIONS")) {
    attributes["_FillValue"] = {"", {*metadata.fillValue}, false};  // where xarray keeps it in Zarr 2
  }
  readCfValues(attributes, metadata.format.number, statements);
  const std::string folder = key.substr(0, key.rfind('/') == std::string::npos ? 0 : key.rfind('/'));
  const std::vector<std::string> names = axisNamesOf(array);
  for (std::size_t i = 0; i < names.size(); ++i) {
    try {
      statements.axes.push_back(axisOf(store, joinedKey(folder, names[i]), names[i], metadata.dims[i]));
    } catch (const base::Error& error) {  // such as dates, whose types are not read
      statements.axes.push_back({names[i], "", std::nullopt});
      if (!sameIgnoringCase(names[i], "time"))
        statements.warnings.push_back("positions of the axis " + inQuotes(names[i]) +
                                      " cannot be read: " + error.reason());
    }
  }
  return statements;
}

}  // namespace isolux::volume
