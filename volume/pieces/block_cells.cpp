#include "volume/pieces/block_cells.h"

namespace isolux::volume {

BlockCells::Slice BlockCells::slice(int z) const {
  Slice slice;
  std::uint64_t any = 0, all = ~std::uint64_t{0};
  for (int corner = 0; corner < 8; ++corner) {
    std::uint64_t bits = 0;
    for (int y = 0; y < count_.y; ++y) {
      const unsigned row =
          rows_[static_cast<std::size_t>((z + (corner >> 2)) * kCorners + y + (corner >> 1 & 1))];
      bits |= std::uint64_t{row >> (corner & 1) & 255u} << (8 * y);
    }
    slice.corners[static_cast<std::size_t>(corner)] = bits;
    any |= bits;
    all &= bits;
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
