#include "volume/large/volume_index.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <type_traits>
#include <utility>

#include <tbb/combinable.h>

#include "base/error.h"
#include "volume/bricks/slice_reader.h"
#include "volume/parallel/parallel_steps.h"
#include "volume/statistics/typical_step.h"
#include "volume/statistics/value_bins.h"
#include "volume/voxels/stored_type.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kLeastUnitBytes = std::size_t{8} << 20;  // pieces of the hash overlap units by one

std::size_t valuesOf(VoxelType type) {
  return type == VoxelType::float32 ? 0 : std::size_t{1} << (8 * bytesOf(type));
}

template <class T>
std::size_t countIndex(T value) {
  return static_cast<std::size_t>(static_cast<int>(value) -
                                  static_cast<int>(std::numeric_limits<T>::lowest()));
}

}  // namespace

VolumeIndex::VolumeIndex(const ChunkedFacts& facts, VolumePart part)
    : facts_(facts), part_(part), isWhole_(facts.storedType != VoxelType::float32) {
  const std::size_t width = bytesOf(facts_.storedType);
  const std::size_t layerBytes = Extent3{dims()}.slice() * width * kIndexBlockCells;
  layersOfUnit_ = static_cast<int>((kLeastUnitBytes + layerBytes - 1) / layerBytes);
  pieceVoxels_ = Grid::kHashedBytes / width;
  const auto units = static_cast<std::size_t>((dims().z + slicesOfUnit() - 1) / slicesOfUnit());
  const std::size_t voxels = Extent3{dims()}.count();
  held_ = base::machineMemory().reserve(voxels / 512 * 2 * sizeof(float), "the index of the volume",
                                        "a volume of fewer voxels needs less");
  done_.resize(units, 0);
  least_.resize(units, std::numeric_limits<float>::max());
  most_.resize(units, std::numeric_limits<float>::lowest());
  missing_.resize(units, 0);
  hashes_.resize((voxels + pieceVoxels_ - 1) / pieceVoxels_, 0);
  blocks_ = std::make_shared<MinMaxBlocks>(dims(), kIndexBlockCells);
  counts_.resize(valuesOf(facts_.storedType), 0);
}

std::size_t VolumeIndex::unitsDone() const {
  return static_cast<std::size_t>(std::ranges::count(done_, std::uint8_t{1}));
}

// Of each voxel of these slices whether it could not be read; nothing: all of them could.
std::vector<std::uint8_t> VolumeIndex::unknownVoxels(int first, int slices) const {
  std::vector<std::uint8_t> unknown;
  for (const DamagedPart& part : damaged_) {
    const int from = std::max(part.low.z, first), behind = std::min(part.low.z + part.size.z, first + slices);
    if (from >= behind) continue;
    unknown.resize(Extent3{dims()}.slice() * static_cast<std::size_t>(slices), 0);
    for (int z = from; z < behind; ++z)
      for (int y = part.low.y; y < part.low.y + part.size.y; ++y) {
        const std::size_t row = Extent3{dims()}.index(part.low.x, y, z - first);
        std::fill_n(unknown.begin() + static_cast<std::ptrdiff_t>(row), part.size.x, std::uint8_t{1});
      }
  }
  return unknown;
}

// Blocks of the layers that begin in these slices may hold anything where they hold voxels that could not be
// read.
void VolumeIndex::openBlocks(int first, int slices) {
  const glm::ivec3 blocks = blocks_->dims();
  if (blocks_->count() == 0) return;
  const int firstLayer = first / kIndexBlockCells,
            behindLayer = std::min((first + slices + kIndexBlockCells - 1) / kIndexBlockCells, blocks.z);
  for (const DamagedPart& part : damaged_) {
    // Block b holds the voxels 8 b .. 8 b + 8.
    glm::ivec3 low = (part.low + kIndexBlockCells - 1) / kIndexBlockCells - 1,
               high = (part.low + part.size - 1) / kIndexBlockCells;
    low = glm::max(low, glm::ivec3(0, 0, firstLayer));
    high = glm::min(high, glm::ivec3(blocks.x, blocks.y, behindLayer) - 1);
    forEachIn(low, high + 1, [&](glm::ivec3 block) {
      blocks_->set(blocks_->index(block), kUnknownMinimum, kUnknownMaximum);
    });
  }
}

template <class T>
void VolumeIndex::scanUnit(SliceReader& reader, std::size_t unit, base::Progress& progress) {
  const std::size_t slice = Extent3{dims()}.slice();
  const int first = static_cast<int>(unit) * slicesOfUnit();
  const int own = std::min(slicesOfUnit(), dims().z - first);
  // The blocks end with the first slice of the next unit, and the last piece of the hash beyond the unit's
  // end.
  const std::size_t begin = static_cast<std::size_t>(first) * slice,
                    end = begin + static_cast<std::size_t>(own) * slice;
  const std::size_t firstPiece = (begin + pieceVoxels_ - 1) / pieceVoxels_,
                    behindPiece = (end + pieceVoxels_ - 1) / pieceVoxels_;
  const std::size_t lastVoxel = std::max(end, behindPiece * pieceVoxels_);
  const int behind =
      std::min(dims().z, std::max(first + own + 1, static_cast<int>((lastVoxel + slice - 1) / slice)));
  const std::span<const T> slab = reader.slices<T>(first, behind, progress);

  parallelSteps(behindPiece - std::min(firstPiece, behindPiece), progress, {}, [&](std::size_t i) {
    const std::size_t from = (firstPiece + i) * pieceVoxels_ - begin;
    const std::size_t length = std::min(pieceVoxels_, slab.size() - from);
    hashes_[firstPiece + i] = base::Hasher().addWords(slab.data() + from, length * sizeof(T));
  });

  struct Found {
    T least = std::numeric_limits<T>::max(), most = std::numeric_limits<T>::lowest();
    std::uint64_t missing = 0;
    std::vector<std::uint64_t> counts;
  };
  tbb::combinable<Found> partial(
      [this] { return Found{.counts = std::vector<std::uint64_t>(counts_.size())}; });
  const std::vector<std::uint8_t> unknown = unknownVoxels(first, own);
  parallelPieces(end - begin, std::size_t{1} << 18, progress, {}, [&](std::size_t from, std::size_t to) {
    Found& found = partial.local();
    for (std::size_t i = from; i != to; ++i) {
      if (!unknown.empty() && unknown[i] != 0) continue;
      const T v = slab[i];
      if constexpr (std::is_floating_point_v<T>) {
        if (std::isnan(v)) {
          ++found.missing;
          continue;
        }
      } else {
        ++found.counts[countIndex(v)];
      }
      found.least = v < found.least ? v : found.least;
      found.most = v > found.most ? v : found.most;
    }
  });
  const std::size_t blockSlices =
      static_cast<std::size_t>(std::min(own + 1, dims().z - first));  // without what is hashed only
  blocks_->setLayers(first / kIndexBlockCells, slab.first(blockSlices * slice), dims(), progress);
  openBlocks(first, own);
  // From here on nothing throws: a unit counts once.
  partial.combine_each([&](const Found& found) {
    missing_[unit] += found.missing;
    if (found.least <= found.most) {
      least_[unit] = std::min(least_[unit], static_cast<float>(found.least));
      most_[unit] = std::max(most_[unit], static_cast<float>(found.most));
    }
    for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += found.counts[i];
  });
  done_[unit] = 1;
}

void VolumeIndex::scan(const ChunkedVolume& file, IndexPart part, base::Progress& progress,
                       const std::function<void()>& keep) {
  const auto i = static_cast<std::size_t>(part.i), n = static_cast<std::size_t>(part.n);
  const std::size_t from = units() * (i - 1) / n, to = units() * i / n;
  const int ofPiece = static_cast<int>(pieceVoxels_ / Extent3{dims()}.slice());
  SliceReader reader(file, part_, slicesOfUnit() + ofPiece + 2,
                     [this](DamagedPart&& part) { recordDamage(facts_.name, std::move(part), damaged_); });
  for (std::size_t unit = from; unit < to; ++unit) {
    progress.throwIfStopped();
    progress.report(static_cast<double>(unit - from) / static_cast<double>(to - from), "indexing");
    if (done_[unit]) continue;
    const std::uint64_t before = reader.bytesRead();
    withStoredType(facts_.storedType, [&](auto zero) { scanUnit<decltype(zero)>(reader, unit, progress); });
    bytesRead_ += reader.bytesRead() - before;
    keep();
  }
}

void VolumeIndex::join(const VolumeIndex& other) {
  // Counts are of all units together: of those that both have done they cannot be told apart.
  for (std::size_t unit = 0; unit < units(); ++unit)
    if (done_[unit] && other.done_[unit]) return;
  const std::size_t slice = Extent3{dims()}.slice();
  for (std::size_t unit = 0; unit < units(); ++unit) {
    if (!other.done_[unit]) continue;
    done_[unit] = 1;
    least_[unit] = other.least_[unit];
    most_[unit] = other.most_[unit];
    missing_[unit] = other.missing_[unit];
    const std::size_t begin = unit * static_cast<std::size_t>(slicesOfUnit()) * slice;
    const std::size_t end = begin + static_cast<std::size_t>(slicesOfUnit()) * slice;
    for (std::size_t piece = (begin + pieceVoxels_ - 1) / pieceVoxels_;
         piece < std::min(hashes_.size(), (end + pieceVoxels_ - 1) / pieceVoxels_); ++piece)
      hashes_[piece] = other.hashes_[piece];
    const std::size_t layer = Extent3{blocks_->dims()}.slice();
    const auto layers = static_cast<std::size_t>(layersOfUnit_);
    for (std::size_t block = unit * layers * layer;
         block < std::min(blocks_->count(), (unit + 1) * layers * layer); ++block)
      blocks_->set(block, other.blocks_->minimum(block), other.blocks_->maximum(block));
  }
  for (std::size_t i = 0; i < counts_.size(); ++i) counts_[i] += other.counts_[i];
  for (DamagedPart part : other.damaged_) recordDamage(facts_.name, std::move(part), damaged_);
}

double VolumeIndex::stepOf(const ChunkedVolume& file, double slope, double intercept,
                           base::Progress& progress) {
  // A row is asked for with those behind and above it, which mostly lie in the same chunks.
  struct Rows {
    int y = 0, z = 0;
    glm::ivec2 size{0};
    std::vector<double> values;
  } rows;
  const ChunkedLevel& level = facts_.levels.front();
  const int width = level.cheapParts ? dims().x : std::clamp(level.chunkDims.x, 1, dims().x);
  const auto read = [&]<class T>(T, int y, int z) {
    rows = {y, z, {std::min(2, dims().y - y), std::min(2, dims().z - z)}, {}};
    rows.values.resize(Extent2{rows.size}.count() * Extent3{dims()}.row());
    std::atomic<std::uint64_t> bytes{0};
    parallelSteps(static_cast<std::size_t>((dims().x + width - 1) / width), progress, {}, [&](std::size_t i) {
      const int x = static_cast<int>(i) * width;
      const glm::ivec3 box(std::min(width, dims().x - x), rows.size);
      std::vector<T> stored(Extent3{box}.count());
      std::vector<DamagedPart> damaged;
      bytes += readAround(file, part_, 0, {x, y, z}, box, std::as_writable_bytes(std::span(stored)), damaged);
      const auto length = static_cast<std::size_t>(box.x);
      for (std::size_t row = 0; row < stored.size() / length; ++row)
        for (std::size_t at = 0; at < length; ++at)
          rows.values[row * static_cast<std::size_t>(dims().x) + static_cast<std::size_t>(x) + at] =
              damaged.empty() ? slope * static_cast<double>(stored[row * length + at]) + intercept
                              : std::numeric_limits<double>::quiet_NaN();
    });
    bytesRead_ += bytes;
  };
  const auto rowOf = [&](int y, int z) {
    const auto isThere = [&] {
      return y >= rows.y && y < rows.y + rows.size.x && z >= rows.z && z < rows.z + rows.size.y;
    };
    if (!isThere()) withStoredType(facts_.storedType, [&](auto zero) { read(zero, y, z); });
    const auto length = static_cast<std::size_t>(dims().x);
    const std::size_t row = Extent2{rows.size}.index(y - rows.y, z - rows.z);
    return std::span<const double>(rows.values).subspan(row * length, length);
  };
  return volume::typicalStep(dims(), rowOf, progress);
}

void VolumeIndex::finish(const ChunkedVolume& file, base::Progress& progress) {
  if (isFinished_) return;
  bool isAny = false;
  for (std::size_t unit = 0; unit < units(); ++unit) isAny = isAny || least_[unit] <= most_[unit];
  if (!isAny && !damaged_.empty())
    base::throwInput(facts_.name, "", "nothing of it can be read: " + damaged_[0].error);
  typicalStep_ = typicalStoredStep_ = stepOf(file, facts_.slope, facts_.intercept, progress);
  if (facts_.slope != 1.0 || facts_.intercept != 0.0) typicalStoredStep_ = stepOf(file, 1.0, 0.0, progress);
  if (!isWhole_) countFloats(file, progress);
  isFinished_ = true;
}

void VolumeIndex::countFloats(const ChunkedVolume& file, base::Progress& progress) {
  const VoxelFacts found = voxelFacts(1.0, 0.0);
  const bool any = found.missing < Extent3{dims()}.count();
  const HistogramBinning bins = HistogramBinning::of(VoxelType::float32, any ? found.storedMinimum : 0.0,
                                                     any ? found.storedMaximum : 0.0, kHistogramBins);
  std::vector<std::uint64_t> sum(bins.count, 0);
  const int step = slicesOfUnit();
  SliceReader reader(file, part_, step, [](DamagedPart&&) {});  // scan() has noted it
  for (int z = 0; z < dims().z; z += step) {
    progress.throwIfStopped();
    progress.report(static_cast<double>(z) / dims().z, "counting values");
    const std::span<const float> slab = reader.slices<float>(z, std::min(z + step, dims().z), progress);
    const std::vector<std::uint64_t> counts = countVoxels(slab, bins, progress);
    std::ranges::transform(counts, sum, sum.begin(), std::plus<>());
  }
  bytesRead_ += reader.bytesRead();
  counts_ = std::move(sum);
}

VoxelFacts VolumeIndex::voxelFacts(double slope, double intercept) const {
  VoxelFacts found{.storedType = facts_.storedType};
  Bounds<double> range;
  for (std::size_t unit = 0; unit < units(); ++unit) {
    found.missing += missing_[unit];
    if (least_[unit] <= most_[unit])
      range.add({static_cast<double>(least_[unit]), static_cast<double>(most_[unit])});
  }
  if (range.low <= range.high) {
    found.storedMinimum = range.low;
    found.storedMaximum = range.high;
  }
  found.hash = Grid::hashOf(facts_.levels.front().geometry, slope, intercept, facts_.storedType, hashes_);
  // What is unknown is hashed as zeros, which a volume may have.
  if (!damaged_.empty()) {
    base::Hasher hash;
    hash.addWords(&found.hash, sizeof found.hash);
    for (const DamagedPart& part : damaged_) {
      hash.addWords(&part.low, sizeof part.low);
      hash.addWords(&part.size, sizeof part.size);
    }
    found.hash = hash;
  }
  return found;
}

Histogram VolumeIndex::histogram(const Grid& grid) const {
  const HistogramBinning bins =
      HistogramBinning::of(facts_.storedType, grid.storedMinimum(), grid.storedMaximum(), kHistogramBins);
  if (!isWhole_) return histogramOf(bins, counts_, grid);
  std::vector<std::uint64_t> counts(bins.count, 0);
  const bool isSigned = facts_.storedType == VoxelType::int8 || facts_.storedType == VoxelType::int16;
  const int lowest = isSigned ? -static_cast<int>(counts_.size() / 2) : 0;
  for (std::size_t i = 0; i < counts_.size(); ++i)
    if (counts_[i] > 0)
      counts[std::min(bins.binOf(lowest + static_cast<int>(i)), bins.count - 1)] += counts_[i];
  return histogramOf(bins, std::move(counts), grid);
}

}  // namespace isolux::volume
