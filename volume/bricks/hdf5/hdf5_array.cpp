#include "volume/bricks/hdf5/hdf5_array.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/memory_budget.h"

namespace isolux::volume {

using base::throwInput;

namespace {

// The HDF Group's list of registered filters.
Codec codecOfFilter(const Hdf5Filter& filter, const FileNumber& number, const std::string& file,
                    const std::string& dataset) {
  switch (filter.id) {
    case 1:
      return {CodecKind::deflate, 1};
    case 2: {
      const std::size_t bytes = filter.values.empty() ? number.bytes() : filter.values.front();
      if (bytes < 1 || bytes > 256) throwInput(file, dataset, "the filter shuffle has no size of elements");
      return {CodecKind::shuffle, bytes};
    }
    case 3:
      return {CodecKind::fletcher32, 1};
    case 32001:
      return {CodecKind::blosc, 1};
    case 32004:
      return {CodecKind::lz4Blocks, 1};
    case 32015:
      return {CodecKind::zstd, 1};
    default:
      break;
  }
  static constexpr std::pair<std::uint32_t, const char*> known[] = {
      {4, "szip"},    {5, "nbit"},           {6, "scaleoffset"}, {307, "bzip2"},
      {32000, "lzf"}, {32008, "bitshuffle"}, {32013, "zfp"},     {32026, "blosc2"}};
  std::string name = "number " + std::to_string(filter.id);
  for (const auto& [id, text] : known)
    if (id == filter.id) name = text;
  throwInput(
      file, dataset,
      "its chunks are packed by the filter " + name +
          ", which is not read; deflate, shuffle, fletcher32, blosc, lz4 and zstd are: h5repack changes it");
}

}  // namespace

Hdf5Array::Hdf5Array(const std::filesystem::path& file, const Hdf5Layout& layout,
                     std::vector<Hdf5Chunk> chunks)
    : bytes_(file), layout_{layout.dims, layout.chunk, layout.number.type}, chunks_(std::move(chunks)) {
  format_.number = layout.number;
  format_.dims = layout.chunk;
  format_.order.resize(layout.chunk.size());
  std::iota(format_.order.begin(), format_.order.end(), std::size_t{0});
  format_.fill = layout.fill;
  for (const Hdf5Filter& filter : layout.filters)
    filters_.push_back(codecOfFilter(filter, layout.number, bytes_.name(), layout.dataset));
  format_.codecs.assign(filters_.rbegin(), filters_.rend());
  checkChunkBytes(format_, bytes_.name(), layout.dataset);
}

ChunkFormat Hdf5Array::formatOf(std::uint64_t mask) const {
  ChunkFormat format = format_;
  format.codecs.clear();
  for (std::size_t i = filters_.size(); i-- > 0;)
    if ((mask >> i & 1u) == 0) format.codecs.push_back(filters_[i]);
  return format;
}

ArrayChunk Hdf5Array::read(std::span<const std::uint64_t> index, std::span<const std::uint64_t> low,
                           std::span<const std::uint64_t> size) const {
  std::uint64_t at = 0;
  std::string place = "chunk ";
  for (std::size_t axis = 0; axis < index.size(); ++axis) {
    at = at * ((layout_.dims[axis] - 1) / layout_.chunk[axis] + 1) + index[axis];
    place += (axis > 0 ? "/" : "") + std::to_string(index[axis]);
  }
  const Hdf5Chunk& chunk = chunks_[static_cast<std::size_t>(at)];
  if (chunk.size == 0) return missingChunk(format_);
  if (chunk.address > bytes_.size() || chunk.size > bytes_.size() - chunk.address)
    throwInput(bytes_.name(), place, "truncated: it lies behind the end of the file");
  const ChunkFormat format = chunk.mask == 0 ? format_ : formatOf(chunk.mask);
  const std::uint64_t wanted = format.fileBytes();
  if (format.codecs.empty() ? chunk.size != wanted
                            : chunk.size > longestPacked(static_cast<std::size_t>(wanted)))
    throwInput(bytes_.name(), place,
               "damaged: it has " + std::to_string(chunk.size) + " bytes, its voxels take " +
                   std::to_string(wanted));
  if (format.codecs.empty()) return readPlainChunk(format, bytes_, chunk.address, low, size);
  const auto held = base::machineMemory().reserve(static_cast<std::size_t>(chunk.size + 2 * wanted),
                                                  "a chunk of " + bytes_.name(), "");
  std::vector<std::byte> packed(static_cast<std::size_t>(chunk.size));
  bytes_.read(chunk.address, packed);
  return unpackChunk(format, packed, bytes_.name(), place);
}

}  // namespace isolux::volume
