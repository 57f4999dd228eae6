// What the metadata of a Zarr array say, checked: `.zarray` of version 2, `zarr.json` of version 3.
//
// Zarr v2 specification; Zarr v3 core 1.0 with the codecs bytes, transpose, gzip, blosc, zstd, crc32c and
// sharding_indexed, and zlib, lz4 and shuffle as numcodecs names them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "volume/read/chunks/chunk_format.h"

namespace isolux::volume {

// Chunks that lie together in one file, with a table of where each is.
struct ZarrShards {
  std::vector<std::uint64_t> dims;  // of a shard, multiples of the chunk's
  bool indexAtStart = false, indexBig = false, indexSummed = false;
};

struct ZarrMetadata {
  int version = 2;
  std::vector<std::uint64_t> dims;
  ChunkFormat format;               // with shards: of a chunk in them
  std::optional<double> fillValue;  // of format.fill; none where the file has none
  std::optional<ZarrShards> shards;
  std::string keyPrefix, separator;         // of a chunk's file: prefix, then its place ("0.1.2")
  std::vector<std::string> dimensionNames;  // empty, or of each axis; "" where it has none
};

// Both throw base::Error{input} naming file and field.
ZarrMetadata parseZarrV2(const nlohmann::json& json, const std::string& file);
ZarrMetadata parseZarrV3(const nlohmann::json& json, const std::string& file);

}  // namespace isolux::volume
