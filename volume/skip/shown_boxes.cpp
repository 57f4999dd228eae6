#include "volume/skip/shown_boxes.h"

#include <array>
#include <bit>

#include <glm/common.hpp>

#include "volume/parallel/parallel_loops.h"
#include "volume/skip/cell_bits.h"

namespace isolux::volume {

namespace {

constexpr int kCellsOfBlock = 8;                // of a block, along an axis
constexpr int kMostVoxels = kCellsOfBlock + 3;  // with an apron

// The voxels that a block's cells look up, row by row: a bit for each along x that is inside and shown.
class ShownRows {
 public:
  ShownRows(const Grid& grid, const VoxelMask& hidden, InsideLevel level, int apron, glm::ivec3 block);

  bool anyHidden() const { return anyHidden_; }
  // Whether one is, of those that a box of `size`^3 cells at `cell` of the block looks up.
  bool any(glm::ivec3 cell, int size) const {
    const int voxels = size + 1 + 2 * apron_;
    const unsigned window = (1u << voxels) - 1;
    unsigned found = 0;
    for (int z = 0; z < voxels; ++z)
      for (int y = 0; y < voxels; ++y)
        found |= rows_[static_cast<std::size_t>((cell.z + z) * kMostVoxels + cell.y + y)] >> cell.x & window;
    return found != 0;
  }

 private:
  int apron_;
  bool anyHidden_ = false;
  std::array<std::uint16_t, std::size_t{kMostVoxels} * kMostVoxels> rows_{};  // beyond the border none
};

ShownRows::ShownRows(const Grid& grid, const VoxelMask& hidden, InsideLevel level, int apron,
                     glm::ivec3 block)
    : apron_(apron) {
  const glm::ivec3 first = block * kCellsOfBlock - apron;
  const glm::ivec3 low = glm::max(first, glm::ivec3(0)),
                   high = glm::min(first + kCellsOfBlock + 2 * apron, grid.dims() - 1);
  const auto fill = [&](const auto& voxels) {
    for (int z = low.z; z <= high.z; ++z)
      for (int y = low.y; y <= high.y; ++y) {
        const auto* const row = voxels.data() + grid.index(0, y, z);
        unsigned bits = 0;
        for (int x = low.x; x <= high.x; ++x) {
          const bool isHidden = hidden.at({x, y, z});
          anyHidden_ |= isHidden;
          bits |= static_cast<unsigned>(!isHidden && level.holds(static_cast<float>(row[x])))
                  << (x - first.x);
        }
        rows_[static_cast<std::size_t>((z - first.z) * kMostVoxels + y - first.y)] =
            static_cast<std::uint16_t>(bits);
      }
  };
  grid.visit(fill);
}

// The bits x + 4 y + 16 z of `mask` that stay: boxes of `size`^3 cells from `first` on.
std::uint64_t shownOf(std::uint64_t mask, const ShownRows& rows, glm::ivec3 first, int size) {
  std::uint64_t kept = 0;
  for (std::uint64_t bits = mask; bits != 0; bits &= bits - 1) {
    const int bit = std::countr_zero(bits);
    if (rows.any(first + size * glm::ivec3(bit & 3, bit >> 2 & 3, bit >> 4), size)) kept |= bits & -bits;
  }
  return kept;
}

// Calls masksOf(block, use) for each block, which calls use(first cell in the block, mask) for its masks: of
// boxes of `size`^3 cells, of which only what is shown stays.
template <class MasksOf>
void keepShown(const Grid& grid, const PartlyShown& surface, int apron, int size, glm::ivec3 blocks,
               const MasksOf& masksOf) {
  parallelEach(Extent3{blocks}.rows(), [&](std::size_t row) {
    for (glm::ivec3 block = Extent3{blocks}.firstOfRow(row); block.x < blocks.x; ++block.x) {
      std::uint64_t any = 0;
      masksOf(block, [&](glm::ivec3, std::uint64_t mask) { any |= mask; });
      if (any == 0) continue;
      const ShownRows rows(grid, *surface.hidden, surface.level, apron, block);
      if (!rows.anyHidden()) continue;
      masksOf(block, [&](glm::ivec3 first, std::uint64_t& mask) { mask = shownOf(mask, rows, first, size); });
    }
  });
}

// What each surface alone makes of it, together. make(surface, masks).
template <class Make>
void unite(std::span<const PartlyShown> surfaces, std::vector<std::uint64_t>& result, const Make& make) {
  std::vector<std::uint64_t> own;
  for (std::size_t k = 0; k < surfaces.size(); ++k) {
    make(surfaces[k], k == 0 ? result : own);
    for (std::size_t i = 0; k > 0 && i < own.size(); ++i) result[i] |= own[i];
  }
}

}  // namespace

void shownBoxes(const Grid& grid, const BoxBounds& boxes, std::span<const PartlyShown> surfaces, bool cubic,
                const std::vector<std::uint8_t>& flags, std::vector<std::uint64_t>& masks) {
  unite(surfaces, masks, [&](const PartlyShown& surface, std::vector<std::uint64_t>& own) {
    boxes.masks({&surface.isovalue, 1}, flags, own);
    if (!surface.hidden) return;
    const Extent3 blocks{boxes.blockDims()};
    keepShown(grid, surface, cubic ? 1 : 0, 2, blocks.dims,
              [&](glm::ivec3 block, const auto& use) { use(glm::ivec3(0), own[blocks.index(block)]); });
  });
}

void shownCellBits(const Grid& grid, glm::ivec3 blocks, std::span<const std::uint64_t> boxMasks,
                   std::span<const PartlyShown> surfaces, std::vector<std::uint64_t>& bits) {
  unite(surfaces, bits, [&](const PartlyShown& surface, std::vector<std::uint64_t>& own) {
    cellBits(grid, blocks, boxMasks, {&surface.isovalue, 1}, own);
    if (!surface.hidden) return;
    keepShown(grid, surface, 0, 1, blocks, [&](glm::ivec3 block, const auto& use) {
      for (int i = 0; i < 8; ++i)  // groups of 4^3 cells
        use(4 * cornerStep(i), own[Extent3{2 * blocks}.index(2 * block + cornerStep(i))]);
    });
  });
}

}  // namespace isolux::volume
