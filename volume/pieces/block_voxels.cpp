#include "volume/pieces/block_voxels.h"

#include <utility>

namespace isolux::volume {

namespace {

constexpr std::size_t kRows = 64;

// Runs of set bits of the 64 rows along x, at most four in each, joined where runs of neighbouring rows
// touch.
class VoxelRuns {
 public:
  explicit VoxelRuns(const VoxelBits& bits) : bits_(bits) {
    std::size_t runs = 0;
    for (std::size_t row = 0; row < kRows; ++row) {
      first_[row] = static_cast<std::uint8_t>(runs);
      runs += static_cast<std::size_t>(std::popcount(starts(rowBits(row))));
    }
    count_ = runs;
    for (std::size_t run = 0; run < runs; ++run) parent_[run] = static_cast<std::uint8_t>(run);
    components_ = static_cast<int>(runs);
    for (std::size_t row = 0; row < kRows; ++row) {
      if (row % 8 > 0) joinRows(row, row - 1);
      if (row >= 8) joinRows(row, row - 8);
    }
  }

  int components() const { return components_; }

  void label(VoxelLabels& labels) {
    std::uint8_t next = 0;
    std::array<std::uint8_t, 256> number;
    for (std::size_t run = 0; run < count_; ++run) {
      const std::size_t smallest = root(run);
      number[run] = smallest == run ? next++ : number[smallest];
    }
    for (std::size_t row = 0; row < kRows; ++row) {
      const unsigned bits = rowBits(row);
      std::size_t run = first_[row];
      for (std::size_t x = 0; x < 8; ++x) {
        if ((bits >> x & 1u) == 0) continue;
        labels[8 * row + x] = number[run];
        if ((bits >> x & 2u) == 0) ++run;
      }
    }
  }

 private:
  static unsigned starts(unsigned bits) { return bits & ~(bits << 1); }
  unsigned rowBits(std::size_t row) const {
    return static_cast<unsigned>(bits_[row / 8] >> (8 * (row % 8))) & 255u;
  }
  // The run of a row that holds the bit at x.
  std::size_t runAt(std::size_t row, int x) const {
    const unsigned upTo = (2u << x) - 1;
    return first_[row] + static_cast<std::size_t>(std::popcount(starts(rowBits(row)) & upTo)) - 1;
  }
  std::size_t root(std::size_t run) {
    while (parent_[run] != run) {
      parent_[run] = parent_[parent_[run]];
      run = parent_[run];
    }
    return run;
  }
  void joinRows(std::size_t row, std::size_t other) {
    for (unsigned touching = starts(rowBits(row) & rowBits(other)); touching != 0; touching &= touching - 1) {
      const int x = std::countr_zero(touching);
      std::size_t a = root(runAt(row, x)), b = root(runAt(other, x));
      if (a == b) continue;
      if (a < b) std::swap(a, b);
      parent_[a] = static_cast<std::uint8_t>(b);
      --components_;
    }
  }

  const VoxelBits& bits_;
  std::array<std::uint8_t, kRows> first_;  // run of each row
  std::array<std::uint8_t, 256> parent_;
  std::size_t count_ = 0;
  int components_ = 0;
};

// Whether all set bits hang together: a flood from the first one, along x, y and z in turn.
bool connected(const VoxelBits& bits) {
  constexpr std::uint64_t notFirstX = 0xfefefefefefefefeu, notLastX = 0x7f7f7f7f7f7f7f7fu;
  std::size_t first = 0;
  while (first < 8 && bits[first] == 0) ++first;
  if (first == 8) return false;
  VoxelBits reached{};
  reached[first] = bits[first] & (~bits[first] + 1);
  const auto grow = [&](std::size_t z) {  // whether anything is new
    std::uint64_t now = reached[z];
    if (z > 0) now |= reached[z - 1];
    if (z < 7) now |= reached[z + 1];
    now &= bits[z];
    for (std::uint64_t before = ~now; before != now;) {
      before = now;
      now = (now | (now << 1 & notFirstX) | (now >> 1 & notLastX)) & bits[z];
      now = (now | now << 8 | now >> 8) & bits[z];
    }
    const bool more = now != reached[z];
    reached[z] = now;
    return more;
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t z = 0; z < 8; ++z) more |= grow(z);
    for (std::size_t z = 8; z-- > 0;) more |= grow(z);
  }
  return reached == bits;
}

}  // namespace

int labelVoxels(const VoxelBits& bits, VoxelLabels& labels) {
  if (connected(bits)) return 1;
  VoxelRuns runs(bits);
  if (runs.components() > 1) runs.label(labels);
  return runs.components();
}

}  // namespace isolux::volume
