// `zarr.json` of an array: https://zarr-specs.readthedocs.io/en/latest/v3/core/index.html
#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string_view>
#include <utility>

#include <nlohmann/json.hpp>

#include "volume/read/input/text.h"
#include "volume/read/zarr/json_fields.h"
#include "volume/read/zarr/zarr_metadata.h"

namespace isolux::volume {

namespace {

FileNumber numberOfV3(const JsonField& field) {
  static constexpr std::pair<std::string_view, FileNumber> types[] = {
      {"bool", {VoxelType::uint8}},      {"int8", {VoxelType::int8}},
      {"uint8", {VoxelType::uint8}},     {"int16", {VoxelType::int16}},
      {"uint16", {VoxelType::uint16}},   {"int32", {VoxelType::int32}},
      {"uint32", {VoxelType::uint32}},   {"int64", {VoxelType::int64}},
      {"uint64", {VoxelType::uint64}},   {"float16", {VoxelType::float32, true}},
      {"float32", {VoxelType::float32}}, {"float64", {VoxelType::float64}}};
  const std::string name = field.value().is_object() ? field.at("name").text() : field.text();
  for (const auto& [known, number] : types)
    if (name == known) return number;
  field.refuse("the type " + inQuotes(name) + " is not read");
}

// An extension point: {"name": ..., "configuration": {...}}, or the name alone.
struct Extension {
  std::string name;
  JsonField field, configuration;
};

Extension extensionOf(const JsonField& field) {
  static const nlohmann::json nothing = nlohmann::json::object();
  const JsonField none(nothing, field.file(), field.place() + ".configuration");
  if (field.value().is_string()) return {field.text(), field, none};
  const std::string name = field.at("name").text();
  return {name, field, field.has("configuration") ? field.at("configuration") : none};
}

// "0x7fc00000": the bits of a number.
std::array<std::byte, 8> fillOfBits(const JsonField& field, const FileNumber& number,
                                    std::string_view digits) {
  std::array<std::byte, 8> fill{};
  const std::size_t width = bytesOf(number.type);
  if (number.half || digits.size() != 2 * width) field.refuse("is not a number of the array's type");
  std::uint64_t bits = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), bits, 16);
  if (error != std::errc() || end != digits.data() + digits.size()) field.refuse("is not a number");
  for (std::size_t i = 0; i < width; ++i) fill[i] = static_cast<std::byte>(bits >> (8 * i) & 0xffu);
  if constexpr (std::endian::native == std::endian::big)
    std::reverse(fill.begin(), fill.begin() + static_cast<std::ptrdiff_t>(width));
  return fill;
}

std::array<std::byte, 8> fillOfV3(const JsonField& field, const FileNumber& number) {
  if (field.value().is_string())
    if (const std::string text = field.text(); text.starts_with("0x"))
      return fillOfBits(field, number, std::string_view(text).substr(2));
  return fillOf(number.type, field.number());
}

// "big" or "little" of the codec bytes.
bool bigEndianOf(const Extension& bytes) {
  const std::string endian = bytes.configuration.text("endian", "little");
  if (endian != "little" && endian != "big") bytes.configuration.at("endian").refuse("must be little or big");
  return endian == "big";
}

// Axes of what lies in the file, slowest first: order[i] of the array is its i-th.
void transpose(const Extension& codec, std::vector<std::size_t>& order) {
  const std::vector<double> wanted = codec.configuration.at("order").numbers(order.size());
  std::vector<std::size_t> turned;
  for (const double axis : wanted) {
    const bool known = axis >= 0.0 && axis < static_cast<double>(order.size()) && axis == std::floor(axis);
    if (!known) codec.configuration.at("order").refuse("is not an order of the axes");
    turned.push_back(order[static_cast<std::size_t>(axis)]);
  }
  for (const std::size_t axis : order)
    if (std::ranges::count(turned, axis) != 1)
      codec.configuration.at("order").refuse("is not an order of the axes");
  order = std::move(turned);
}

Codec packedCodecOf(const Extension& codec) {
  std::string_view name = codec.name;
  if (name.starts_with("numcodecs.")) name.remove_prefix(10);
  if (name == "gzip" || name == "zlib") return {CodecKind::deflate, 1};
  if (name == "zstd") return {CodecKind::zstd, 1};
  if (name == "bz2") return {CodecKind::bzip2, 1};
  if (name == "lz4") return {CodecKind::lz4, 1};
  if (name == "blosc") return {CodecKind::blosc, 1};
  if (name == "crc32c") return {CodecKind::crc32c, 1};
  if (name == "shuffle") {
    const double size =
        codec.configuration.has("elementsize") ? codec.configuration.at("elementsize").number() : 4.0;
    if (!(size >= 1.0 && size <= 256.0)) codec.configuration.refuse("elementsize must be 1 to 256 bytes");
    return {CodecKind::shuffle, static_cast<std::size_t>(size)};
  }
  codec.field.refuse("the codec " + inQuotes(codec.name) +
                     " is not read; bytes, transpose, gzip, zlib, zstd, bz2, lz4, blosc, shuffle, crc32c and "
                     "sharding_indexed are");
}

void readIndexCodecs(const JsonField& field, ZarrShards& shards) {
  const std::vector<JsonField> entries = field.entries();
  if (entries.empty() || extensionOf(entries[0]).name != "bytes" || entries.size() > 2)
    field.refuse("must be bytes, and crc32c if need be");
  shards.indexBig = bigEndianOf(extensionOf(entries[0]));
  if (entries.size() == 2) {
    if (extensionOf(entries[1]).name != "crc32c") field.refuse("must be bytes, and crc32c if need be");
    shards.indexSummed = true;
  }
}

void readCodecs(const JsonField& field, ZarrMetadata& metadata);

void readSharding(const Extension& codec, ZarrMetadata& metadata) {
  ChunkFormat& format = metadata.format;
  if (metadata.shards) codec.field.refuse("shards in shards are not read");
  ZarrShards shards;
  shards.dims = format.dims;
  const JsonField inner = codec.configuration.at("chunk_shape");
  format.dims = inner.counts();
  if (format.dims.size() != shards.dims.size()) inner.refuse("has not as many axes as shape");
  for (std::size_t axis = 0; axis < shards.dims.size(); ++axis)
    if (shards.dims[axis] % format.dims[axis] != 0) inner.refuse("does not divide the shard");
  const std::string location = codec.configuration.text("index_location", "end");
  if (location != "start" && location != "end")
    codec.configuration.at("index_location").refuse("must be start or end");
  shards.indexAtStart = location == "start";
  readIndexCodecs(codec.configuration.at("index_codecs"), shards);
  metadata.shards = std::move(shards);
  readCodecs(codec.configuration.at("codecs"), metadata);
}

// In the order in which a chunk is packed: some transpose, then bytes, then what packs bytes; or shards
// alone.
void readCodecs(const JsonField& field, ZarrMetadata& metadata) {
  ChunkFormat& format = metadata.format;
  const std::vector<JsonField> entries = field.entries();
  if (entries.size() > 16) field.refuse("has more than 16 codecs");
  bool asBytes = false;
  for (const JsonField& entry : entries) {
    const Extension codec = extensionOf(entry);
    if (codec.name == "sharding_indexed") {
      if (entries.size() != 1) field.refuse("sharding_indexed is read only as the one codec of an array");
      return readSharding(codec, metadata);
    }
    if (codec.name == "transpose" || codec.name == "bytes") {
      if (asBytes) entry.refuse("the codec " + codec.name + " follows bytes");
      if (codec.name == "transpose") {
        transpose(codec, format.order);
        continue;
      }
      format.number.big = bigEndianOf(codec);
      asBytes = true;
    } else {
      format.codecs.push_back(packedCodecOf(codec));
      if (!asBytes) entry.refuse("the codec bytes is missing before it");
    }
  }
  if (!asBytes) field.refuse("the codec bytes is missing");
  std::ranges::reverse(format.codecs);
}

void readKeys(const JsonField& root, ZarrMetadata& metadata) {
  const Extension encoding = extensionOf(root.at("chunk_key_encoding"));
  const bool asV2 = encoding.name == "v2";
  if (!asV2 && encoding.name != "default") encoding.field.refuse("the names of chunks are not known");
  metadata.separator = encoding.configuration.text("separator", asV2 ? "." : "/");
  if (metadata.separator != "." && metadata.separator != "/")
    encoding.configuration.at("separator").refuse("must be \".\" or \"/\"");
  metadata.keyPrefix = asV2 ? "" : "c" + metadata.separator;
}

// What is not known may be passed by only where it says so itself.
void checkKnown(const JsonField& root) {
  static constexpr std::string_view known[] = {
      "zarr_format",         "node_type",  "shape",  "data_type",  "chunk_grid",
      "chunk_key_encoding",  "fill_value", "codecs", "attributes", "dimension_names",
      "storage_transformers"};
  for (const auto& [key, value] : root.value().items()) {
    if (std::find(std::begin(known), std::end(known), key) != std::end(known) || value.is_null()) continue;
    if (value.is_object() && value.contains("must_understand") && value["must_understand"] == false) continue;
    root.refuse("the field " + inQuotes(key) + " is unknown and may not be ignored");
  }
  if (root.has("storage_transformers") && !root.at("storage_transformers").entries().empty())
    root.at("storage_transformers").refuse("none is known");
}

}  // namespace

ZarrMetadata parseZarrV3(const nlohmann::json& json, const std::string& file) {
  const JsonField root(json, file, "");
  if (const JsonField format = root.at("zarr_format"); format.value() != 3) format.refuse("is not 3");
  checkKnown(root);
  ZarrMetadata metadata;
  metadata.version = 3;
  metadata.dims = root.at("shape").counts();
  ChunkFormat& format = metadata.format;
  const Extension grid = extensionOf(root.at("chunk_grid"));
  if (grid.name != "regular") grid.field.refuse("only regular chunks are read");
  const JsonField shape = grid.configuration.at("chunk_shape");
  format.dims = shape.counts();
  if (format.dims.size() != metadata.dims.size()) shape.refuse("has not as many axes as shape");
  checkChunkBytes(ChunkFormat{format.number, format.dims, {}, {}, {}}, file, shape.place());
  format.number = numberOfV3(root.at("data_type"));
  format.order.resize(format.dims.size());
  std::iota(format.order.begin(), format.order.end(), std::size_t{0});
  format.fill = fillOfV3(root.at("fill_value"), format.number);
  readKeys(root, metadata);
  readCodecs(root.at("codecs"), metadata);
  if (root.has("dimension_names"))
    for (const JsonField& name : root.at("dimension_names").entries())
      metadata.dimensionNames.push_back(name.value().is_null() ? "" : name.text());
  if (!metadata.dimensionNames.empty() && metadata.dimensionNames.size() != metadata.dims.size())
    root.at("dimension_names").refuse("has not as many names as shape has axes");
  checkChunkBytes(format, file, "chunk_shape");
  return metadata;
}

}  // namespace isolux::volume
