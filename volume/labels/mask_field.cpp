#include "volume/labels/mask_field.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <functional>
#include <iterator>
#include <numeric>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

#include <glm/common.hpp>

#include "volume/labels/mask_parts.h"
#include "volume/labels/slice_mask.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr int kEdge = LabelBlocks::kSize;

// ---- Which voxels are in the set ----

// A bit for each voxel of a block: bit x of byte 8 z + y. Beyond the volume the border's is repeated.
using BlockBits = std::array<std::uint8_t, kEdge * kEdge>;

// The set, block by block.
class SetBlocks {
 public:
  SetBlocks(const LabelBlocks& blocks, const std::vector<bool>& isMember, base::Progress& progress);

  enum State : std::int32_t { outside = -1, inside = -2 };  // of all voxels of a block; else index of bits
  Extent3 blocks() const { return extent_; }
  std::int32_t state(glm::ivec3 block) const { return states_[extent_.index(block)]; }
  // Returns the bits of the row of 8 voxels in `block` that has these coordinates in it.
  unsigned row(std::size_t block, std::size_t y, std::size_t z) const {
    const std::int32_t state = states_[block];
    if (state < 0) return state == inside ? 0xff : 0;
    return bits_[static_cast<std::size_t>(state)][kEdge * z + y];
  }

 private:
  template <class T>
  void fill(BlockBits& bits, const std::vector<T>& voxels, const Extent3& extent, glm::ivec3 block,
            const SetMembers<T>& members) const;

  Extent3 extent_;
  std::vector<std::int32_t> states_;
  std::vector<BlockBits> bits_;  // of the blocks that are neither
  base::MemoryBudget::Held held_;
};

SetBlocks::SetBlocks(const LabelBlocks& blocks, const std::vector<bool>& isMember, base::Progress& progress)
    : extent_(blocks.blocks()), states_(extent_.count(), outside) {
  std::vector<std::size_t> mixed;
  for (std::size_t block = 0; block < states_.size(); ++block) {
    bool any = false, all = true;
    for (const std::uint16_t index : blocks.of(block)) {
      const bool member = index != LabelBlocks::kMissing && isMember[index];
      any = any || member;
      all = all && member;
    }
    if (any && !all) {
      states_[block] = static_cast<std::int32_t>(mixed.size());
      mixed.push_back(block);
    } else if (any) {
      states_[block] = inside;
    }
  }
  held_ = base::machineMemory().reserve(mixed.size() * sizeof(BlockBits), "the borders of labels",
                                        "a volume with fewer voxels needs less");
  bits_.resize(mixed.size());
  blocks.grid().visit([&](const auto& voxels) {
    using Voxel = typename std::decay_t<decltype(voxels)>::value_type;
    const SetMembers<Voxel> members(blocks, isMember);
    constexpr std::size_t together = 256;
    parallelPieces(mixed.size(), together, progress, {0.0, 0.2, "smoothing labels"},
                   [&](std::size_t first, std::size_t end) {
                     for (std::size_t i = first; i < end; ++i)
                       fill(bits_[i], voxels, blocks.grid().extent(), extent_.at(mixed[i]), members);
                   });
  });
}

template <class T>
void SetBlocks::fill(BlockBits& bits, const std::vector<T>& voxels, const Extent3& extent, glm::ivec3 block,
                     const SetMembers<T>& members) const {
  const glm::ivec3 low = kEdge * block, last = extent.dims - 1;
  for (int z = 0; z < kEdge; ++z)
    for (int y = 0; y < kEdge; ++y) {
      const T* const row =
          voxels.data() + extent.index(0, std::min(low.y + y, last.y), std::min(low.z + z, last.z));
      unsigned byte = 0;
      for (int x = 0; x < kEdge; ++x) {
        byte |= static_cast<unsigned>(members.has(row[std::min(low.x + x, last.x)])) << x;
      }
      bits[static_cast<std::size_t>(kEdge * z + y)] = static_cast<std::uint8_t>(byte);
    }
}

// ---- A block and what lies around it ----

// The bits of 24 x 24 x 24 voxels: bit i of row (y, z) is the voxel i - 8 along x from the block's first.
class Surroundings {
 public:
  static constexpr int kWidth = 3 * kEdge;

  // Fills the rows up to `reach` voxels around the block. `dims`: of the volume.
  Surroundings(const SetBlocks& set, glm::ivec3 dims, glm::ivec3 block, int reach);

  std::uint32_t row(int y, int z) const { return rows_[static_cast<std::size_t>(kWidth * z + y)]; }
  // Whether all voxels up to `reach` from the block are on one side.
  bool isPure() const { return all_ || !any_; }

 private:
  std::array<std::uint32_t, kWidth * kWidth> rows_;
  bool any_ = false, all_ = true;
};

Surroundings::Surroundings(const SetBlocks& set, glm::ivec3 dims, glm::ivec3 block, int reach) {
  const Extent3 blocks = set.blocks();
  const int first = kEdge - reach, end = 2 * kEdge + reach;
  const std::uint32_t mask = ((1u << (end - first)) - 1) << first;
  for (int z = first; z < end; ++z)
    for (int y = first; y < end; ++y) {
      const int voxelY = std::clamp(kEdge * (block.y - 1) + y, 0, dims.y - 1),
                voxelZ = std::clamp(kEdge * (block.z - 1) + z, 0, dims.z - 1);
      const std::size_t at = blocks.index(block.x, voxelY / kEdge, voxelZ / kEdge);
      const auto rowOf = [&](std::size_t of) {
        return set.row(of, static_cast<std::size_t>(voxelY % kEdge),
                       static_cast<std::size_t>(voxelZ % kEdge));
      };
      const unsigned here = rowOf(at);
      const unsigned before = block.x > 0 ? rowOf(at - 1) : (here & 1) != 0 ? 0xffu : 0u;
      const unsigned after = block.x + 1 < blocks.dims.x ? rowOf(at + 1) : (here & 0x80) != 0 ? 0xffu : 0u;
      const std::uint32_t row = before | here << kEdge | after << (2 * kEdge);
      rows_[static_cast<std::size_t>(kWidth * z + y)] = row;
      any_ = any_ || (row & mask) != 0;
      all_ = all_ && (row & mask) == mask;
    }
}

// ---- Smoothing ----

// The kernel along one axis, and its sums over rows of bits.
class MaskKernel {
 public:
  static constexpr int kMostRadius = 6;

  explicit MaskKernel(double smoothing) {
    const MaskWeights kernel(smoothing);
    radius_ = static_cast<int>(kernel.radius());
    assert(radius_ <= kMostRadius);
    std::ranges::transform(kernel.weights, weights_.begin(), [](double w) { return static_cast<float>(w); });
    sharpening_ = static_cast<float>(kernel.sharpening);
    sums_.resize(std::size_t{1} << (2 * radius_ + 1));
    for (std::size_t bits = 0; bits < sums_.size(); ++bits) {
      double of = 0.0;
      for (int i = 0; i <= 2 * radius_; ++i)
        if ((bits >> i & 1) != 0) of += kernel.weights[static_cast<std::size_t>(std::abs(i - radius_))];
      sums_[bits] = static_cast<float>(of);
    }
  }

  int radius() const { return radius_; }
  float weight(int distance) const { return weights_[static_cast<std::size_t>(distance)]; }
  float sharpening() const { return sharpening_; }  // factor of the Laplacian
  // Returns the smoothed value at the middle of 2 radius() + 1 bits.
  float sum(std::uint32_t bits) const { return sums_[bits & (sums_.size() - 1)]; }

 private:
  int radius_ = 0;
  float sharpening_ = 0.0f;
  std::array<float, kMostRadius + 1> weights_{};
  std::vector<float> sums_;
};

// The margins m of a block's voxels, and of those around it which voxels are thin.
class BlockMargins {
 public:
  explicit BlockMargins(const MaskKernel& kernel) : kernel_(kernel) {}

  // `low`: the block's first voxel.
  void compute(const Surroundings& around, glm::ivec3 low, glm::ivec3 dims);

  // Of voxel (x, y, z) of the block.
  float margin(int x, int y, int z) const { return margins_[at(x + 2, y + 2, z + 2)]; }
  // Bit x: of the row's voxels which are thin; and which are or have a neighbour that is.
  unsigned thin(int y, int z) const { return thin_[y + 1][z + 1] >> 1 & 0xff; }
  unsigned nearThin(int y, int z) const {
    unsigned any = 0;
    for (int j = y; j < y + 3; ++j)
      for (int k = z; k < z + 3; ++k) any |= thin_[j][k];
    return (any | any >> 1 | any >> 2) & 0xff;
  }

 private:
  static constexpr int kSmoothed = kEdge + 4;  // voxels -2 to 9 of the block: of g
  static constexpr int kWide = kSmoothed + 2 * MaskKernel::kMostRadius;
  static constexpr std::size_t at(int x, int y, int z) {
    return static_cast<std::size_t>((z * kSmoothed + y) * kSmoothed + x);
  }
  // out = the kernel's sum of the values `step` apart, of 12 values.
  void addUp(const float* in, std::size_t step, float* out) const {
    static_assert(kSmoothed % 4 == 0);
    for (int x = 0; x < kSmoothed; x += 4) {  // sums of four stay in registers
      float sum[4];
      for (int i = 0; i < 4; ++i) sum[i] = kernel_.weight(0) * in[x + i];
      for (int k = 1; k <= kernel_.radius(); ++k) {
        const float weight = kernel_.weight(k);
        const float* const before = in + x - static_cast<std::size_t>(k) * step;
        const float* const after = in + x + static_cast<std::size_t>(k) * step;
        for (int i = 0; i < 4; ++i) sum[i] += weight * (before[i] + after[i]);
      }
      std::ranges::copy(sum, out + x);
    }
  }
  void smooth(const Surroundings& around);
  void addMargins(const Surroundings& around, int y, int z);

  const MaskKernel& kernel_;
  std::array<float, kSmoothed * kWide * kWide> alongX_{};
  std::array<float, kSmoothed * kSmoothed * kWide> alongXY_{};
  std::array<float, kSmoothed * kSmoothed * kSmoothed> smoothed_{}, margins_{};
  unsigned thin_[kEdge + 2][kEdge + 2] = {};  // bit 0: the voxel before the block
};

void BlockMargins::smooth(const Surroundings& around) {
  const int radius = kernel_.radius(), wide = kSmoothed + 2 * radius, first = kEdge - 2 - radius;
  constexpr std::size_t row = kSmoothed;
  const auto slice = row * static_cast<std::size_t>(wide);
  for (int z = 0; z < wide; ++z)
    for (int y = 0; y < wide; ++y) {
      const std::uint32_t bits = around.row(first + y, first + z) >> first;
      float* const out =
          alongX_.data() + static_cast<std::size_t>(z) * slice + static_cast<std::size_t>(y) * row;
      const std::uint32_t window = (1u << wide) - 1, within = bits & window;
      if (within == 0 || within == window)
        std::fill_n(out, kSmoothed, kernel_.sum(within));
      else
        for (int x = 0; x < kSmoothed; ++x) out[x] = kernel_.sum(bits >> x);
    }
  for (int z = 0; z < wide; ++z)
    for (int y = 0; y < kSmoothed; ++y)
      addUp(alongX_.data() + static_cast<std::size_t>(z) * slice + static_cast<std::size_t>(y + radius) * row,
            row, alongXY_.data() + at(0, y, z));
  for (int z = 0; z < kSmoothed; ++z)
    for (int y = 0; y < kSmoothed; ++y)
      addUp(alongXY_.data() + at(0, y, z + radius), row * row, smoothed_.data() + at(0, y, z));
}

void BlockMargins::addMargins(const Surroundings& around, int y, int z) {
  constexpr std::size_t row = kSmoothed, slice = row * row;
  const float sharpening = kernel_.sharpening();
  const float* const g = smoothed_.data() + at(0, y, z);
  float* const out = margins_.data() + at(0, y, z);
  const std::uint32_t bits = around.row(kEdge - 2 + y, kEdge - 2 + z) >> (kEdge - 2);
  unsigned thin = 0;
  for (std::size_t x = 1; x + 1 < row; ++x) {
    const float sum =
        (g[x - 1] + g[x + 1]) + (*(g + x - row) + g[x + row]) + (*(g + x - slice) + g[x + slice]);
    const float u = 2.0f * (g[x] - sharpening * (sum - 6.0f * g[x])) - 1.0f;
    out[x] = (bits >> x & 1) != 0 ? u : -u;
    thin |= static_cast<unsigned>(out[x] < kThinBelow) << (x - 1);
  }
  thin_[y - 1][z - 1] = thin;
}

void BlockMargins::compute(const Surroundings& around, glm::ivec3 low, glm::ivec3 dims) {
  smooth(around);
  unsigned inVolume = 0;  // what lies beyond the border is no voxel
  for (int x = -1; x <= kEdge; ++x)
    if (low.x + x >= 0 && low.x + x < dims.x) inVolume |= 1u << (x + 1);
  for (int z = -1; z <= kEdge; ++z)
    for (int y = -1; y <= kEdge; ++y) {
      addMargins(around, y + 2, z + 2);
      const bool in = low.y + y >= 0 && low.y + y < dims.y && low.z + z >= 0 && low.z + z < dims.z;
      thin_[y + 1][z + 1] &= in ? inVolume : 0;
    }
}

// ---- The field ----

using WantedBlocks = std::function<bool(std::size_t)>;

class MaskMaker {
 public:
  MaskMaker(const LabelBlocks& blocks, std::span<const int> labels, double smoothing,
            base::Progress& progress)
      : dims_(blocks.grid().dims()),
        smoothing_(smoothing),
        set_(blocks, membersOf(blocks, labels), progress),
        kernel_(smoothing) {
    assert(smoothing >= 0.0 && smoothing <= kMostSmoothing);
  }

  // Computes the blocks that `wanted` names.
  void run(std::vector<std::int8_t>& voxels, std::vector<std::uint16_t>& thin, const WantedBlocks& wanted,
           base::Progress& progress) const {
    const Extent3 extent = set_.blocks();
    parallelSteps(extent.rows(), progress, {0.2, 1.0, "smoothing labels"}, [&](std::size_t row) {
      BlockMargins margins(kernel_);
      for (glm::ivec3 block = extent.firstOfRow(row); block.x < extent.dims.x; ++block.x)
        if (const std::size_t index = extent.index(block); wanted(index))
          thin[index] = compute(block, margins, voxels);
    });
  }

 private:
  int reach() const { return smoothing_ > 0.0 ? kernel_.radius() + 2 : 0; }
  bool isFarFromBorders(glm::ivec3 block) const;
  std::uint16_t compute(glm::ivec3 block, BlockMargins& margins, std::vector<std::int8_t>& voxels) const;

  glm::ivec3 dims_;
  double smoothing_;
  SetBlocks set_;
  MaskKernel kernel_;
};

bool MaskMaker::isFarFromBorders(glm::ivec3 block) const {
  const std::int32_t state = set_.state(block);
  if (state >= 0) return false;
  const glm::ivec3 low = glm::max(block - 1, 0), end = glm::min(block + 2, set_.blocks().dims);
  bool same = true;
  forEachIn(low, end, [&](glm::ivec3 beside) { same = same && set_.state(beside) == state; });
  return same;
}

// Returns the number of thin voxels in the set.
std::uint16_t MaskMaker::compute(glm::ivec3 block, BlockMargins& margins,
                                 std::vector<std::int8_t>& voxels) const {
  const glm::ivec3 low = kEdge * block, size = glm::min(dims_ - low, kEdge);
  const Extent3 extent{dims_};
  const auto rowOf = [&](int y, int z) { return voxels.data() + extent.index(low + glm::ivec3(0, y, z)); };
  const auto fill = [&](bool inside) {
    for (int z = 0; z < size.z; ++z)
      for (int y = 0; y < size.y; ++y)
        std::fill_n(rowOf(y, z), size.x, static_cast<std::int8_t>(inside ? 127 : -127));
    return std::uint16_t{0};
  };
  if (isFarFromBorders(block)) return fill(set_.state(block) == SetBlocks::inside);
  const Surroundings around(set_, dims_, block, reach());
  if (around.isPure()) return fill(around.row(kEdge, kEdge) >> kEdge & 1);

  if (smoothing_ > 0.0) margins.compute(around, low, dims_);
  int thin = 0;
  for (int z = 0; z < size.z; ++z)
    for (int y = 0; y < size.y; ++y) {
      const std::uint32_t inside = around.row(kEdge + y, kEdge + z) >> kEdge;
      const unsigned whole = smoothing_ > 0.0 ? margins.nearThin(y, z) : 0xffu;
      std::int8_t* const row = rowOf(y, z);
      for (int x = 0; x < size.x; ++x) {
        const float m = (whole >> x & 1) != 0 ? 1.0f : std::clamp(margins.margin(x, y, z), kMaskGuard, 1.0f);
        const int steps = static_cast<int>(kMaskSteps * m + 0.5f);
        row[x] = static_cast<std::int8_t>((inside >> x & 1) != 0 ? steps : -steps);
      }
      if (smoothing_ > 0.0) thin += std::popcount(margins.thin(y, z) & inside & 0xffu);
    }
  return static_cast<std::uint16_t>(thin);
}

std::optional<ThickSlices> slicesOf(const LabelBlocks& blocks, double smoothing) {
  return smoothing > 0.0 ? thickSlicesOf(blocks.grid().geometry()) : std::nullopt;
}

// Computes the blocks that `wanted` names, at least.
void fillMask(const LabelBlocks& blocks, const MaskField& mask, std::vector<std::int8_t>& voxels,
              std::vector<std::uint16_t>& thin, const WantedBlocks& wanted, base::Progress& progress) {
  if (const auto slices = slicesOf(blocks, mask.smoothing))
    SliceMask(blocks, mask.labels, mask.smoothing, *slices).run(voxels, thin, wanted, progress);
  else
    MaskMaker(blocks, mask.labels, mask.smoothing, progress).run(voxels, thin, wanted, progress);
}

// Returns how many blocks beyond one with a changed voxel change, on each axis.
glm::ivec3 reachOf(const LabelBlocks& blocks, const MaskField& mask) {
  const auto slices = slicesOf(blocks, mask.smoothing);
  return slices ? SliceMask(blocks, mask.labels, mask.smoothing, *slices).reachBlocks() : glm::ivec3(1);
}

std::vector<int> ascending(std::span<const int> labels) {
  std::vector<int> sorted(labels.begin(), labels.end());
  std::sort(sorted.begin(), sorted.end());
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

base::MemoryBudget::Held reserveMask(const LabelBlocks& blocks) {
  return base::machineMemory().reserve(blocks.grid().geometry().voxelCount(), "the field of the labels",
                                       "a volume with fewer voxels needs less");
}

std::shared_ptr<const Grid> maskGrid(const LabelBlocks& blocks, std::vector<std::int8_t> voxels,
                                     base::Progress& progress) {
  return std::make_shared<const Grid>(blocks.grid().geometry(), std::move(voxels),
                                      1.0 / static_cast<double>(kMaskSteps), 0.0, progress);
}

}  // namespace

std::size_t MaskField::thinVoxels() const {
  return std::accumulate(thin.begin(), thin.end(), std::size_t{0});
}

MaskField makeMask(const LabelBlocks& blocks, std::span<const int> labels, double smoothing,
                   base::Progress& progress) {
  base::MemoryBudget::Held held = reserveMask(blocks);
  MaskField mask{
      nullptr, ascending(labels), smoothing, std::vector<std::uint16_t>(blocks.blocks().count()), {}};
  std::vector<std::int8_t> voxels;
  resizeStoppably(voxels, blocks.grid().geometry().voxelCount(), progress);
  fillMask(
      blocks, mask, voxels, mask.thin, [](std::size_t) { return true; }, progress);
  held.release();  // the grid counts it from here on
  mask.grid = maskGrid(blocks, std::move(voxels), progress);
  return mask;
}

MaskField changedMask(const MaskField& mask, const LabelBlocks& blocks, std::span<const int> labels,
                      base::Progress& progress) {
  base::MemoryBudget::Held held = reserveMask(blocks);
  MaskField changed{nullptr, ascending(labels), mask.smoothing, mask.thin, {}};
  std::vector<int> others;  // in one set only
  std::ranges::set_symmetric_difference(mask.labels, changed.labels, std::back_inserter(others));
  const std::vector<bool> isOther = membersOf(blocks, others);
  const Extent3 extent = blocks.blocks();
  const glm::ivec3 reach = reachOf(blocks, changed);
  std::vector<std::uint8_t>& near = changed.changed;  // blocks with such voxels, or within reach of one
  near.resize(extent.count());
  for (std::size_t block = 0; block < near.size(); ++block) {
    const auto has = [&](std::uint16_t index) { return index != LabelBlocks::kMissing && isOther[index]; };
    if (!std::ranges::any_of(blocks.of(block), has)) continue;
    const glm::ivec3 at = extent.at(block);
    forEachIn(glm::max(at - reach, 0), glm::min(at + reach + 1, extent.dims),
              [&](glm::ivec3 beside) { near[extent.index(beside)] = 1; });
  }
  std::vector<std::int8_t> voxels = std::get<std::vector<std::int8_t>>(mask.grid->voxels());
  fillMask(
      blocks, changed, voxels, changed.thin, [&](std::size_t block) { return near[block] != 0; }, progress);
  held.release();
  std::vector<bool> layers(static_cast<std::size_t>(extent.dims.z));  // of blocks, with changed ones
  for (std::size_t block = 0; block < near.size(); ++block)
    if (near[block] != 0) layers[block / extent.slice()] = true;
  const std::size_t layer = blocks.grid().extent().slice() * kEdge;  // voxels
  const auto differs = [&](std::size_t first, std::size_t end) {
    for (std::size_t i = first / layer; i <= (end - 1) / layer; ++i)
      if (layers[i]) return true;
    return false;
  };
  changed.grid = std::make_shared<const Grid>(*mask.grid, std::move(voxels), differs, progress);
  return changed;
}

}  // namespace isolux::volume
