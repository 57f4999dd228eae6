// What a pass over all voxels of a chunked volume finds: all that drawing needs beside the voxels that rays
// come to. Equal to what is made of the same volume in memory.
//
// Made a unit after the other (some layers of blocks, a few MiB), in any order and by anybody: units of
// several files join. Kept in a file beside the volume: docs/explanation/large-volumes.md. What of the file
// cannot be read is listed; blocks that hold any of it may hold any values, so that no ray passes them
// unseen.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "base/hash.h"
#include "base/memory_budget.h"
#include "base/progress.h"
#include "volume/bricks/chunked_volume.h"
#include "volume/bricks/damage.h"
#include "volume/skip/min_max_blocks.h"
#include "volume/statistics/histogram.h"

namespace isolux::volume {

class SliceReader;

inline constexpr int kIndexBlockCells = 8;

// Part i of n, from 1: i <= n.
struct IndexPart {
  int i = 1, n = 1;
};

// Bounds of a block that holds a voxel that could not be read: it may be anything.
inline constexpr float kUnknownMinimum = std::numeric_limits<float>::lowest(),
                       kUnknownMaximum = std::numeric_limits<float>::max();

class VolumeIndex {
 public:
  // Of level 0; nothing is known yet. Throws Error{memory}.
  VolumeIndex(const ChunkedFacts& facts, VolumePart part);

  const ChunkedFacts& facts() const { return facts_; }
  VolumePart part() const { return part_; }
  glm::ivec3 dims() const { return facts_.levels.front().geometry.dims; }

  std::size_t units() const { return done_.size(); }
  std::size_t unitsDone() const;
  bool isComplete() const { return unitsDone() == units() && isFinished_; }

  // Reads the units of the part that are not done. Between units keep() is called, which may save what there
  // is. Memory: a unit and a layer of chunks (volume/bricks/slice_reader.h). Throws Error: input (too much of
  // it cannot be read), memory, interrupted.
  void scan(const ChunkedVolume& file, IndexPart part, base::Progress& progress,
            const std::function<void()>& keep);
  // Takes what `other`, of the same volume, has done and this has not.
  void join(const VolumeIndex& other);
  // After all units: what neighbours differ by, and what needs the range of values first, another pass over
  // float32 volumes. Throws as scan(), also where nothing could be read.
  void finish(const ChunkedVolume& file, base::Progress& progress);

  // Of a complete one.
  VoxelFacts voxelFacts(double slope, double intercept) const;
  std::shared_ptr<const MinMaxBlocks> blocks() const { return blocks_; }
  Histogram histogram(const Grid& grid) const;
  // volume/statistics/typical_step.h, of values with the facts' slope and intercept, or of stored numbers.
  double typicalStep(bool scaled) const { return scaled ? typicalStep_ : typicalStoredStep_; }
  const std::vector<DamagedPart>& damaged() const { return damaged_; }  // their voxels count nowhere
  std::uint64_t bytesRead() const { return bytesRead_; }                // by scan() and finish() of this one

  // As bytes of the file, and back: false, and nothing changed, where they are not of this volume.
  void write(const std::function<void(const void*, std::size_t)>& put) const;
  // `sum` goes on over what write() has put, piece by piece as it did.
  bool read(std::span<const std::byte> bytes, base::Hasher& sum);
  std::size_t mostBytes() const;  // that write() puts

 private:
  static constexpr int kHistogramBins = 512;  // as prepareVolume() makes them

  template <class T>
  void scanUnit(SliceReader& reader, std::size_t unit, base::Progress& progress);
  std::vector<std::uint8_t> unknownVoxels(int first, int slices) const;
  void openBlocks(int first, int slices);
  void countFloats(const ChunkedVolume& file, base::Progress& progress);
  double stepOf(const ChunkedVolume& file, double slope, double intercept, base::Progress& progress);
  int slicesOfUnit() const { return layersOfUnit_ * kIndexBlockCells; }
  template <class Io>
  bool transfer(Io& io);
  template <class Io>
  bool transferDamaged(Io& io);

  ChunkedFacts facts_;
  VolumePart part_;
  bool isWhole_;  // voxels are whole numbers
  int layersOfUnit_ = 1;
  std::size_t pieceVoxels_;             // hashed together
  std::vector<std::uint8_t> done_;      // of each unit
  std::vector<float> least_, most_;     // of each unit; least > most: nothing but missing voxels
  std::vector<std::uint64_t> missing_;  // of each unit
  std::vector<std::uint64_t> hashes_;   // of each piece
  std::shared_ptr<MinMaxBlocks> blocks_;
  // Whole numbers: how often each value of the type occurs, from its least on, in the units that are done.
  // float32: of the histogram's bins, once isFinished_.
  std::vector<std::uint64_t> counts_;
  std::vector<DamagedPart> damaged_;
  double typicalStep_ = 0.0, typicalStoredStep_ = 0.0;
  bool isFinished_ = false;
  std::uint64_t bytesRead_ = 0;
  base::MemoryBudget::Held held_;
};

}  // namespace isolux::volume
