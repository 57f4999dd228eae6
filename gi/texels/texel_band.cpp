#include "gi/texels/texel_band.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <type_traits>
#include <utility>
#include <vector>

#include "gi/lattice/texel_bits.h"
#include "volume/parallel/parallel_loops.h"

namespace isolux::gi {

namespace {

using Range = volume::Bounds<float>;
bool meets(const Range& range, double from, double to) {
  return range.low <= to && range.high >= from;
}

struct Span {
  int first = 0, last = -1;
};

// Voxels of the cells from which lookups read a texel: points within `reach` texels of it.
class Footprints {
 public:
  Footprints(const LatticeGeometry& lattice, int reach, int margin)
      : lattice_(lattice), reach_(reach), margin_(margin) {}

  Span voxels(int axis, int texel) const {
    const std::int64_t n = lattice_.volumeDims[axis] - 1, d = lattice_.dims[axis] - 1;
    if (d < 1) return {0, static_cast<int>(n)};
    const std::int64_t low = std::max<std::int64_t>(texel - reach_, 0) * n / d - margin_;
    const std::int64_t high = ((texel + reach_) * n + d - 1) / d + margin_;
    return {static_cast<int>(std::max<std::int64_t>(low, 0)), static_cast<int>(std::min(high, n))};
  }

 private:
  const LatticeGeometry& lattice_;
  int reach_, margin_;
};

// In arrays of kBlockTexels^2 numbers a slice, kBlockTexels a row.
std::size_t place(int z, int y, int x) {
  const int index = (z * kBlockTexels + y) * kBlockTexels + x;
  return static_cast<std::size_t>(index);
}

// Which texels of a block have values within [low, high] (stored units) in their footprints. One for each
// thread: the tables are kept.
template <class T>
class BlockScan {
 public:
  BlockScan(const LatticeGeometry& lattice, const volume::Grid& grid, const std::vector<T>& voxels)
      : lattice_(lattice), grid_(grid), voxels_(voxels) {}

  std::bitset<kTexelsOfBlock> run(std::uint32_t block, const Footprints& footprints, double low,
                                  double high) {
    const glm::ivec3 first = lattice_.firstTexelOf(block);
    const glm::ivec3 count = glm::min(lattice_.dims - first, glm::ivec3(kBlockTexels));
    std::array<std::array<Span, kBlockTexels>, 3> spans;
    std::array<Span, 3> whole;
    for (int a = 0; a < 3; ++a) {
      const auto axis = static_cast<std::size_t>(a);
      for (int t = 0; t < count[a]; ++t)
        spans[axis][static_cast<std::size_t>(t)] = footprints.voxels(a, first[a] + t);
      whole[axis] = {spans[axis][0].first, spans[axis][static_cast<std::size_t>(count[a] - 1)].last};
    }

    // Along x, then y, then z: ranges of rows, of sheets, of boxes.
    const int rows = whole[1].last - whole[1].first + 1, sheets = whole[2].last - whole[2].first + 1;
    rows_.resize(static_cast<std::size_t>(rows) * kBlockTexels);
    sheets_.resize(static_cast<std::size_t>(sheets) * kBlockTexels * kBlockTexels);
    Range all;
    for (int z = 0; z < sheets; ++z) {
      for (int y = 0; y < rows; ++y) {
        const T* const line = voxels_.data() + grid_.index(0, whole[1].first + y, whole[2].first + z);
        for (int tx = 0; tx < count.x; ++tx) {
          Range range;
          const Span span = spans[0][static_cast<std::size_t>(tx)];
          for (int x = span.first; x <= span.last; ++x) range.add(static_cast<float>(line[x]));
          rows_[place(0, y, tx)] = range;
          all.add(range);
        }
      }
      for (int ty = 0; ty < count.y; ++ty)
        for (int tx = 0; tx < count.x; ++tx) {
          Range range;
          const Span span = spans[1][static_cast<std::size_t>(ty)];
          for (int y = span.first - whole[1].first; y <= span.last - whole[1].first; ++y)
            range.add(rows_[place(0, y, tx)]);
          sheets_[place(z, ty, tx)] = range;
        }
    }
    std::bitset<kTexelsOfBlock> texels;
    if (!meets(all, low, high)) return texels;
    for (int tz = 0; tz < count.z; ++tz)
      for (int i = 0; i < kBlockTexels * kBlockTexels; ++i) {
        if (i % kBlockTexels >= count.x || i / kBlockTexels >= count.y) continue;
        Range range;
        const Span span = spans[2][static_cast<std::size_t>(tz)];
        for (int z = span.first - whole[2].first; z <= span.last - whole[2].first; ++z)
          range.add(sheets_[place(z, 0, i)]);
        texels[place(tz, 0, i)] = meets(range, low, high);
      }
    return texels;
  }

 private:
  const LatticeGeometry& lattice_;
  const volume::Grid& grid_;
  const std::vector<T>& voxels_;
  std::vector<Range> rows_, sheets_;
};

}  // namespace

std::vector<BlockRequest> texelsOfBand(const LatticeGeometry& lattice, const volume::Grid& grid, double low,
                                       double high, int reach, base::Progress& progress, scene::Field field) {
  double from = grid.storedOfValue(low), to = grid.storedOfValue(high);
  if (from > to) std::swap(from, to);
  // A cubic field lies within the values of one voxel more on every side.
  const Footprints footprints(lattice, reach, field == scene::Field::trilinear ? 0 : 1);
  std::vector<BlockRequest> wanted(lattice.blockCount());
  std::atomic<std::size_t> done{0};
  grid.visit([&](const auto& voxels) {
    using T = typename std::decay_t<decltype(voxels)>::value_type;
    volume::parallelRanges(lattice.blockCount(), 16, [&](const volume::Indices<std::uint32_t>& range) {
      BlockScan<T> scan(lattice, grid, voxels);
      for (std::uint32_t block = range.begin(); block != range.end(); ++block) {
        if (progress.stopRequested()) return;
        wanted[block] = {block, scan.run(block, footprints, from, to)};
      }
      const std::size_t now = done += range.size();
      progress.report(static_cast<double>(now) / lattice.blockCount(), "finding the band's texels");
    });
  });
  progress.throwIfStopped();
  std::erase_if(wanted, [](const BlockRequest& block) { return block.texels.none(); });
  return wanted;
}

}  // namespace isolux::gi
