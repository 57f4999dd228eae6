#include "volume/pieces/block_cells.h"

namespace isolux::volume {

std::array<std::uint64_t, 4> BlockCells::Layer::shifted() const {
  constexpr std::uint64_t allButLast = 0x7f7f7f7f7f7f7f7fu;
  const std::uint64_t nextY = bits >> 8 | std::uint64_t{lastY & 255u} << 56;
  const std::uint64_t lastXNextY = lastX >> 8 | std::uint64_t{lastY >> 8} << 56;
  return {bits, (bits >> 1 & allButLast) | lastX << 7, nextY, (nextY >> 1 & allButLast) | lastXNextY << 7};
}

BlockCells::Slice BlockCells::slice(int z) const {
  Slice slice;
  const auto low = layers_[static_cast<std::size_t>(z)].shifted(),
             high = layers_[static_cast<std::size_t>(z) + 1].shifted();
  std::uint64_t any = 0, all = ~std::uint64_t{0};
  for (std::size_t i = 0; i < 4; ++i) {
    slice.corners[i] = low[i];
    slice.corners[i + 4] = high[i];
    any |= low[i] | high[i];
    all &= low[i] & high[i];
  }
  for (int y = 0; y < count_.y; ++y) slice.cells |= std::uint64_t{(1u << count_.x) - 1u} << (8 * y);
  slice.whole = all & slice.cells;
  slice.crossed = any & ~all & slice.cells;
  return slice;
}

// From the first inside corner of each cell along edges to inside corners, until nothing comes.
std::uint64_t BlockCells::Slice::ambiguous() const {
  if (crossed == 0) return 0;
  std::array<std::uint64_t, 8> reached;
  std::uint64_t before = 0;
  for (std::size_t i = 0; i < 8; ++i) {
    reached[i] = corners[i] & ~before;
    before |= corners[i];
  }
  for (std::uint64_t changed = 1; changed != 0;) {
    changed = 0;
    for (std::size_t i = 0; i < 8; ++i) {
      const std::uint64_t now = corners[i] & (reached[i] | reached[i ^ 1] | reached[i ^ 2] | reached[i ^ 4]);
      changed |= now & ~reached[i];
      reached[i] = now;
    }
  }
  std::uint64_t apart = 0;
  for (std::size_t i = 0; i < 8; ++i) apart |= corners[i] & ~reached[i];
  return apart & crossed;
}

}  // namespace isolux::volume
