// One Zarr array: its metadata, and its chunks out of their files.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "base/recent.h"
#include "volume/read/chunks/chunked_array.h"
#include "volume/read/zarr/zarr_metadata.h"
#include "volume/read/zarr/zarr_store.h"

namespace isolux::volume {

class ZarrArray final : public ChunkedArray {
 public:
  // The array in the folder `key` of the store. Throws base::Error{input}.
  ZarrArray(std::shared_ptr<const ZarrStore> store, std::string key);

  const ArrayLayout& layout() const override { return layout_; }
  bool plain() const override { return metadata_.format.codecs.empty(); }
  ArrayChunk read(std::span<const std::uint64_t> index, std::span<const std::uint64_t> low,
                  std::span<const std::uint64_t> size) const override;

  const ZarrMetadata& metadata() const { return metadata_; }
  const nlohmann::json& attributes() const { return *attributes_; }
  const std::vector<std::string>& warnings() const { return warnings_; }  // of the metadata

  // True where the folder `key` holds an array's metadata. Throws base::Error{input} where these are no JSON.
  static bool isArray(const ZarrStore& store, const std::string& key);

 private:
  struct Place {
    std::uint64_t offset = 0, size = 0;  // bytes; all bits of both: no such chunk
  };
  using ShardIndex = std::vector<Place>;

  std::string keyOf(std::span<const std::uint64_t> index) const;
  void checkStillThere() const;
  Place placeInShard(const Bytes& shard, const std::string& key, std::span<const std::uint64_t> index) const;
  ShardIndex readShardIndex(const Bytes& shard) const;

  std::shared_ptr<const ZarrStore> store_;
  std::string key_;
  ZarrMetadata metadata_;
  std::shared_ptr<const nlohmann::json> attributes_;
  std::vector<std::string> warnings_;
  ArrayLayout layout_;

  mutable base::Recent<std::string, std::shared_ptr<const ShardIndex>> indices_{64};  // of shards
};

}  // namespace isolux::volume
