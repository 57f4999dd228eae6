#include "volume/read/hdf5/hdf5_array.h"

#include <algorithm>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "base/memory_budget.h"
#include "volume/read/process/wire.h"

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
    case 307:
      return {CodecKind::bzip2, 1};
    case 32000:
      return {CodecKind::lzf, 1};
    case 32001:
      return {CodecKind::blosc, 1};
    case 32004:
      return {CodecKind::lz4Blocks, 1};
    case 32015:
      return {CodecKind::zstd, 1};
    default:
      break;
  }
  // The library itself has the first three, so that h5repack undoes them; the others are plug-ins.
  static constexpr std::pair<std::uint32_t, const char*> known[] = {
      {4, "szip"}, {5, "nbit"}, {6, "scaleoffset"}, {32008, "bitshuffle"}, {32013, "zfp"}, {32026, "blosc2"}};
  std::string name = "number " + std::to_string(filter.id);
  for (const auto& [id, text] : known)
    if (id == filter.id) name = text;
  throwInput(
      file, dataset,
      "its chunks are packed by the filter " + name + ", which is not read; " +
          (filter.id < 7 ? "h5repack -f GZIP=1 FILE NEW changes it"
                         : "copy it with h5py after \"import hdf5plugin\", with compression=\"gzip\""));
}

}  // namespace

Hdf5Array::Hdf5Array(const std::filesystem::path& file, const Hdf5Layout& layout,
                     std::vector<Hdf5Chunk> chunks)
    : layout_{layout.dims, layout.chunk, layout.number.type}, chunks_(std::move(chunks)) {
  files_.push_back(std::make_unique<FileBytes>(file));
  for (const std::string& other : layout.files) files_.push_back(openBeside(file)(other));
  format_.number = layout.number;
  format_.dims = layout.chunk;
  format_.order.resize(layout.chunk.size());
  std::iota(format_.order.begin(), format_.order.end(), std::size_t{0});
  format_.fill = layout.fill;
  for (const Hdf5Filter& filter : layout.filters)
    filters_.push_back(codecOfFilter(filter, layout.number, file.string(), layout.dataset));
  format_.codecs.assign(filters_.rbegin(), filters_.rend());
  checkChunkBytes(format_, file.string(), layout.dataset);
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
  if (chunk.file >= files_.size()) throwBadAnswer("a chunk is in no file");
  const Bytes& bytes = *files_[static_cast<std::size_t>(chunk.file)];
  if (chunk.address > bytes.size() || chunk.size > bytes.size() - chunk.address)
    throwInput(bytes.name(), place, "truncated: beyond the end of the file");
  const ChunkFormat format = chunk.mask == 0 ? format_ : formatOf(chunk.mask);
  const std::uint64_t wanted = format.fileBytes();
  if (format.codecs.empty() ? chunk.size != wanted
                            : chunk.size > longestPacked(static_cast<std::size_t>(wanted)))
    throwInput(bytes.name(), place,
               "damaged: it has " + std::to_string(chunk.size) + " bytes, its voxels take " +
                   std::to_string(wanted));
  if (format.codecs.empty()) return readPlainChunk(format, bytes, chunk.address, low, size);
  const auto held = base::machineMemory().reserve(static_cast<std::size_t>(chunk.size + 2 * wanted),
                                                  "a chunk of " + bytes.name(), "");
  std::vector<std::byte> packed(static_cast<std::size_t>(chunk.size));
  bytes.read(chunk.address, packed);
  return unpackChunk(format, packed, bytes.name(), place);
}

}  // namespace isolux::volume
