#include "volume/read/zarr/zarr_array.h"

#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/words.h"
#include "volume/read/chunks/checksums.h"
#include "volume/read/zarr/json_fields.h"
#include "volume/read/zarr/zarr_statements.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr std::uint64_t kMostChunksInShard = std::uint64_t{1} << 24;

}  // namespace

bool ZarrArray::isArray(const ZarrStore& store, const std::string& key) {
  if (const auto text = store.text(joinedKey(key, "zarr.json"))) {
    const nlohmann::json json = parseJson(*text, store.nameOf(joinedKey(key, "zarr.json")));
    return json.value("node_type", nlohmann::json()) == "array";
  }
  return store.open(joinedKey(key, ".zarray")) != nullptr;
}

ZarrArray::ZarrArray(std::shared_ptr<const ZarrStore> store, std::string key)
    : store_(std::move(store)), key_(std::move(key)) {
  const std::string v3 = joinedKey(key_, "zarr.json"), v2 = joinedKey(key_, ".zarray");
  nlohmann::json attributes = nlohmann::json::object();
  if (const auto text = store_->text(v3)) {
    const std::string file = store_->nameOf(v3);
    const nlohmann::json json = parseJson(*text, file, &warnings_);
    if (json.value("node_type", nlohmann::json()) != "array")
      throwInput(file, "node_type", "is not an array");
    metadata_ = parseZarrV3(json, file);
    if (json.contains("attributes") && json["attributes"].is_object()) attributes = json["attributes"];
  } else if (const auto old = store_->text(v2)) {
    const std::string file = store_->nameOf(v2);
    metadata_ = parseZarrV2(parseJson(*old, file, &warnings_), file);
    const std::string beside = joinedKey(key_, ".zattrs");
    if (const auto more = store_->text(beside))
      attributes = parseJson(*more, store_->nameOf(beside), &warnings_);
  } else {
    throwInput(store_->nameOf(key_), "", "is not a Zarr array: it has neither zarr.json nor .zarray");
  }
  attributes_ = std::make_shared<const nlohmann::json>(std::move(attributes));
  metadata_.format.number = withSign(attributesOf(*this), metadata_.format.number);
  layout_ = {metadata_.dims, metadata_.format.dims, metadata_.format.number.type};
  if (metadata_.shards) {
    std::uint64_t chunks = 1;
    for (std::size_t axis = 0; axis < layout_.dims.size(); ++axis) {
      chunks *= metadata_.shards->dims[axis] / layout_.chunk[axis];
      if (chunks > kMostChunksInShard)
        throwInput(store_->nameOf(v3), "chunk_shape", "a shard has more than 16777216 chunks");
    }
  }
}

std::string ZarrArray::keyOf(std::span<const std::uint64_t> index) const {
  const auto textOf = [](std::uint64_t i) { return std::to_string(i); };
  return joinedKey(key_, metadata_.keyPrefix + base::joined(index, metadata_.separator, textOf));
}

// A chunk that has no file has the fill value; but not where all is gone.
void ZarrArray::checkStillThere() const {
  const std::string key = joinedKey(key_, metadata_.version == 2 ? ".zarray" : "zarr.json");
  if (!store_->open(key)) throwInput(store_->nameOf(key), "", "is no longer there");
}

ZarrArray::ShardIndex ZarrArray::readShardIndex(const Bytes& shard) const {
  const ZarrShards& shards = *metadata_.shards;
  std::size_t count = 1;
  for (std::size_t axis = 0; axis < layout_.dims.size(); ++axis)
    count *= static_cast<std::size_t>(shards.dims[axis] / layout_.chunk[axis]);
  std::vector<std::byte> bytes(16 * count + (shards.indexSummed ? 4 : 0));
  if (bytes.size() > shard.size())
    throwInput(shard.name(), "index", "damaged: the shard is shorter than its index");
  shard.read(shards.indexAtStart ? 0 : shard.size() - bytes.size(), bytes);
  if (shards.indexSummed) {
    const auto sum = numberAt<std::uint32_t>(&bytes[16 * count], false);
    if (crc32c(std::span(bytes).first(16 * count)) != sum)
      throwInput(shard.name(), "index", "damaged: the checksum of the shard's index is wrong");
  }
  ShardIndex index(count);
  for (std::size_t i = 0; i < count; ++i)
    index[i] = {numberAt<std::uint64_t>(&bytes[16 * i], shards.indexBig),
                numberAt<std::uint64_t>(&bytes[16 * i + 8], shards.indexBig)};
  return index;
}

ZarrArray::Place ZarrArray::placeInShard(const Bytes& shard, const std::string& key,
                                         std::span<const std::uint64_t> index) const {
  std::uint64_t at = 0;
  for (std::size_t axis = 0; axis < index.size(); ++axis) {
    const std::uint64_t count = metadata_.shards->dims[axis] / layout_.chunk[axis];
    at = at * count + index[axis] % count;
  }
  const auto indexOfShard = [&] { return std::make_shared<const ShardIndex>(readShardIndex(shard)); };
  const Place place = (*indices_.get(key, indexOfShard))[static_cast<std::size_t>(at)];
  constexpr std::uint64_t none = ~std::uint64_t{0};
  if (place.offset == none && place.size == none) return place;
  if (place.offset > shard.size() || place.size > shard.size() - place.offset)
    throwInput(shard.name(), chunkPlace(index), "damaged: beyond the end of the shard");
  return place;
}

ArrayChunk ZarrArray::read(std::span<const std::uint64_t> index, std::span<const std::uint64_t> low,
                           std::span<const std::uint64_t> size) const {
  const ChunkFormat& format = metadata_.format;
  std::vector<std::uint64_t> file(index.begin(), index.end());
  if (metadata_.shards)
    for (std::size_t axis = 0; axis < file.size(); ++axis)
      file[axis] /= metadata_.shards->dims[axis] / layout_.chunk[axis];
  const std::string key = keyOf(file);
  const std::unique_ptr<Bytes> bytes = store_->open(key);
  if (!bytes) {
    checkStillThere();
    return missingChunk(format);
  }
  Place place{0, bytes->size()};
  if (metadata_.shards) {
    place = placeInShard(*bytes, key, index);
    if (place.offset == ~std::uint64_t{0} && place.size == ~std::uint64_t{0}) return missingChunk(format);
  }
  return readChunk(format, *bytes, place.offset, place.size, low, size, chunkPlace(index));
}

}  // namespace isolux::volume
