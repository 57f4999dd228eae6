// One dataset of an HDF5 file: its chunks, read from where the reader says that they lie.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "volume/read/chunks/chunked_array.h"
#include "volume/read/hdf5/hdf5_layout.h"
#include "volume/read/input/bytes.h"

namespace isolux::volume {

class Hdf5Array final : public ChunkedArray {
 public:
  // `chunks`: layout.chunkCount() of them. Throws base::Error{input}, naming a filter that is not read.
  Hdf5Array(const std::filesystem::path& file, const Hdf5Layout& layout, std::vector<Hdf5Chunk> chunks);

  const ArrayLayout& layout() const override { return layout_; }
  bool plain() const override { return format_.codecs.empty(); }
  ArrayChunk read(std::span<const std::uint64_t> index, std::span<const std::uint64_t> low,
                  std::span<const std::uint64_t> size) const override;

 private:
  ChunkFormat formatOf(std::uint64_t mask) const;

  std::vector<std::unique_ptr<Bytes>> files_;  // the file itself, then layout.files
  ArrayLayout layout_;
  ChunkFormat format_;
  std::vector<Codec> filters_;  // in the order in which they were applied
  std::vector<Hdf5Chunk> chunks_;
};

}  // namespace isolux::volume
