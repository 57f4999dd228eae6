// A volume, or several levels of one, in arrays that are kept in chunks: Zarr's and HDF5's.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "base/progress.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/read/chunks/chunked_array.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/read_options.h"
#include "volume/volume.h"

namespace isolux::volume {

// What the axes of an array are; each at most once. An axis that none of them names has one entry.
struct ArrayAxes {
  std::optional<std::size_t> x, y, z, time, channel;
};

class ArrayVolume final : public ChunkedVolume {
 public:
  // `facts` but storedType, levels' dims and chunkDims, times and channels, which come from the arrays: one
  // for each level, all of one type and with as many axes. Throws base::Error{input} for dims that no volume
  // has.
  ArrayVolume(ChunkedFacts facts, ArrayAxes axes, std::vector<std::shared_ptr<const ChunkedArray>> arrays);

  const ChunkedFacts& facts() const override { return facts_; }
  // As the facts say it, where that is known later.
  void setTitle(std::string title) { facts_.title = std::move(title); }
  void setChoices(std::vector<std::string> choices,
                  std::string warning);  // warning: empty, or of the one chosen
  VoxelType fileType() const { return arrays_.front()->layout().type; }  // of readWhole()
  VoxelType typeInFile() const { return arrays_.front()->fileType(); }

  std::size_t read(VolumePart part, std::size_t level, glm::ivec3 low, glm::ivec3 size,
                   std::span<std::byte> voxels) const override;

  // All voxels of level 0 in the file's type, chunks on all cores. `missingChunks` counts those that the file
  // does not have, and `chunks` all. Throws as read(), and Error{interrupted}.
  struct Whole {
    FileVoxels voxels;
    std::size_t chunks = 0, missingChunks = 0;
  };
  Whole readWhole(VolumePart part, base::Progress& progress) const;

 private:
  struct Box {
    glm::ivec3 low, size;
  };
  template <class To>
  std::size_t readOneChunk(VolumePart part, std::size_t level, glm::ivec3 chunk, Box wanted, Box destination,
                           To* voxels, std::size_t* missing) const;
  template <class To>
  std::size_t readBox(VolumePart part, std::size_t level, Box box, Box destination, To* voxels,
                      std::size_t* missing) const;
  glm::ivec3 chunkOf(const ArrayLayout& layout) const;

  ChunkedFacts facts_;
  ArrayAxes axes_;
  std::vector<std::shared_ptr<const ChunkedArray>> arrays_;
};

// The whole of level 0 as volume::readVolume gives it. Channels are its components. Throws base::Error
// (input, memory, usage, interrupted).
Volume wholeVolume(const ArrayVolume& volume, const ReadOptions& options, base::Progress& progress);

}  // namespace isolux::volume
