// `.zarray`: https://zarr-specs.readthedocs.io/en/latest/v2/v2.0.html
#include <algorithm>
#include <numeric>

#include <nlohmann/json.hpp>

#include "volume/read/input/text.h"
#include "volume/read/zarr/json_fields.h"
#include "volume/read/zarr/zarr_metadata.h"

namespace isolux::volume {

namespace {

struct V2Type {
  char kind;
  char width;
  VoxelType type;
  bool half = false;
};

constexpr V2Type kV2Types[] = {
    {'b', '1', VoxelType::uint8},   {'i', '1', VoxelType::int8},    {'u', '1', VoxelType::uint8},
    {'i', '2', VoxelType::int16},   {'u', '2', VoxelType::uint16},  {'i', '4', VoxelType::int32},
    {'u', '4', VoxelType::uint32},  {'i', '8', VoxelType::int64},   {'u', '8', VoxelType::uint64},
    {'f', '4', VoxelType::float32}, {'f', '8', VoxelType::float64}, {'f', '2', VoxelType::float32, true}};

// NumPy's "<u2": byte order, kind, bytes.
FileNumber numberOfV2(const JsonField& field) {
  if (field.value().is_array()) field.refuse("structured types are not read");
  const std::string text = field.text();
  const bool ordered = text.size() == 3 && (text[0] == '<' || text[0] == '>');
  if (text.size() == 3 && (ordered || text[0] == '|'))
    for (const V2Type& row : kV2Types)
      if (row.kind == text[1] && row.width == text[2] && (ordered || text[2] == '1'))
        return {row.type, row.half, text[0] == '>'};
  field.refuse("the type " + inQuotes(text) + " is not read");
}

Codec codecOfV2(const JsonField& field) {
  const std::string id = field.at("id").text();
  if (id == "zlib" || id == "gzip") return {CodecKind::deflate, 1};
  if (id == "zstd") return {CodecKind::zstd, 1};
  if (id == "bz2") return {CodecKind::bzip2, 1};
  if (id == "lz4") return {CodecKind::lz4, 1};
  if (id == "blosc") return {CodecKind::blosc, 1};
  if (id == "shuffle") {
    if (!field.has("elementsize")) return {CodecKind::shuffle, 4};  // numcodecs
    const JsonField size = field.at("elementsize");
    const auto& value = size.value();
    if (!value.is_number_unsigned() || value.get<std::uint64_t>() < 1 || value.get<std::uint64_t>() > 256)
      size.refuse("must be a number of bytes from 1 to 256");
    return {CodecKind::shuffle, value.get<std::size_t>()};
  }
  field.refuse("the codec " + inQuotes(id) +
               " is not read; zlib, gzip, zstd, bz2, lz4, blosc and shuffle are");
}

}  // namespace

ZarrMetadata parseZarrV2(const nlohmann::json& json, const std::string& file) {
  const JsonField root(json, file, "");
  if (const JsonField format = root.at("zarr_format"); format.value() != 2) format.refuse("is not 2");
  ZarrMetadata metadata;
  metadata.version = 2;
  metadata.dims = root.at("shape").counts();
  ChunkFormat& format = metadata.format;
  format.dims = root.at("chunks").counts();
  if (format.dims.size() != metadata.dims.size()) root.at("chunks").refuse("has not as many axes as shape");
  format.number = numberOfV2(root.at("dtype"));
  format.order.resize(format.dims.size());
  std::iota(format.order.begin(), format.order.end(), std::size_t{0});
  const JsonField order = root.at("order");
  if (order.text() == "F")
    std::ranges::reverse(format.order);
  else if (order.text() != "C")
    order.refuse("must be C or F");
  if (root.has("compressor")) format.codecs.push_back(codecOfV2(root.at("compressor")));
  if (root.has("filters")) {
    std::vector<JsonField> filters = root.at("filters").entries();
    if (filters.size() > 8) root.at("filters").refuse("has more than 8 filters");
    for (auto filter = filters.rbegin(); filter != filters.rend(); ++filter)
      format.codecs.push_back(codecOfV2(*filter));
  }
  if (root.has("fill_value")) {
    metadata.fillValue = root.at("fill_value").number();
    format.fill = fillOf(format.number.type, *metadata.fillValue);
  }
  metadata.separator = root.text("dimension_separator", ".");
  if (metadata.separator != "." && metadata.separator != "/")
    root.at("dimension_separator").refuse("must be \".\" or \"/\"");
  checkChunkBytes(format, file, "chunks");
  return metadata;
}

}  // namespace isolux::volume
