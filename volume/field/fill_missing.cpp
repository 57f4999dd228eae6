#include "volume/field/fill_missing.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <cstdint>

#include <glm/common.hpp>

#include "volume/parallel/parallel_steps.h"
#include "volume/voxels/extent.h"

namespace isolux::volume {

namespace {

using Ring = std::vector<std::size_t>;  // indices of voxels

constexpr std::size_t kPiece = std::size_t{1} << 14;  // voxels of a ring at a time
constexpr std::uint32_t kTakenBits = 0x7fc00001u;     // a NaN: missing, and in a ring already

class Gaps {
 public:
  Gaps(std::vector<float>& values, glm::ivec3 dims, base::Progress& progress)
      : values_(values), dims_(dims), progress_(progress) {}

  // The missing voxels beside known ones, all marked as taken.
  Ring firstRing(base::ProgressRange share) {
    const std::size_t rows = Extent3{dims_}.rows();
    std::vector<Ring> found((rows + kRows - 1) / kRows);
    parallelPieces(rows, kRows, progress_, share, [&](std::size_t begin, std::size_t end) {
      std::vector<std::uint8_t> known(static_cast<std::size_t>(dims_.x) + 2);
      for (std::size_t row = begin; row < end; ++row) findBesideKnown(row, known, found[begin / kRows]);
    });
    Ring ring = joined(found);
    forEach(ring.size(), [&](std::size_t i) { values_[ring[i]] = std::bit_cast<float>(kTakenBits); });
    return ring;
  }

  void fill(const Ring& ring) {
    std::vector<float> means(ring.size());
    forEach(ring.size(), [&](std::size_t i) { means[i] = meanAround(ring[i]); });
    forEach(ring.size(), [&](std::size_t i) { values_[ring[i]] = means[i]; });
  }

  // The missing neighbours of a filled ring, each once; now taken.
  Ring nextRing(const Ring& ring) {
    std::vector<Ring> found((ring.size() + kPiece - 1) / kPiece);
    forEach(ring.size(), [&](std::size_t i) {
      forNeighbours(ring[i], [&](std::size_t voxel) {
        if (take(voxel)) found[i / kPiece].push_back(voxel);
      });
    });
    return joined(found);
  }

  void clearRest(base::ProgressRange share) {
    parallelPieces(values_.size(), std::size_t{1} << 18, progress_, share,
                   [&](std::size_t begin, std::size_t end) {
                     for (std::size_t i = begin; i < end; ++i)
                       if (std::isnan(values_[i])) values_[i] = 0.0f;
                   });
  }

 private:
  static constexpr std::size_t kRows = 64;

  const float* row(int y, int z) const { return values_.data() + Extent3{dims_}.index(0, y, z); }

  // `known` is scratch: whether any of the nine rows around has a value at x, at x + 1.
  void findBesideKnown(std::size_t index, std::vector<std::uint8_t>& known, Ring& ring) const {
    const glm::ivec3 first = Extent3{dims_}.firstOfRow(index);
    const int y = first.y, z = first.z;
    const float* const own = row(y, z);
    const auto width = static_cast<std::size_t>(dims_.x);
    if (std::none_of(own, own + width, [](float v) { return std::isnan(v); })) return;
    std::fill(known.begin(), known.end(), std::uint8_t{0});
    for (int k = std::max(z - 1, 0); k <= std::min(z + 1, dims_.z - 1); ++k)
      for (int j = std::max(y - 1, 0); j <= std::min(y + 1, dims_.y - 1); ++j) {
        const float* const other = row(j, k);
        for (std::size_t x = 0; x < width; ++x) known[x + 1] |= other[x] == other[x] ? 1 : 0;
      }
    for (std::size_t x = 0; x < width; ++x)
      if (std::isnan(own[x]) && (known[x] | known[x + 1] | known[x + 2]))
        ring.push_back(static_cast<std::size_t>(own - values_.data()) + x);
  }

  // Calls visit(index) for the voxel and its neighbours, x fastest.
  template <class Visit>
  void forNeighbours(std::size_t voxel, const Visit& visit) const {
    const Extent3 extent{dims_};
    const glm::ivec3 at = extent.at(voxel);
    forEachIn(glm::max(at - 1, 0), glm::min(at + 2, dims_),
              [&](glm::ivec3 neighbour) { visit(extent.index(neighbour)); });
  }

  float meanAround(std::size_t voxel) const {
    double sum = 0.0;
    int count = 0;
    forNeighbours(voxel, [&](std::size_t i) {
      if (!std::isnan(values_[i])) sum += static_cast<double>(values_[i]), ++count;
    });
    return static_cast<float>(sum / count);
  }

  // Marks a missing voxel; true for the first thread that does.
  bool take(std::size_t voxel) {
    const std::atomic_ref<float> value(values_[voxel]);
    if (!std::isnan(value.load(std::memory_order_relaxed))) return false;
    const float before = value.exchange(std::bit_cast<float>(kTakenBits), std::memory_order_relaxed);
    return std::bit_cast<std::uint32_t>(before) != kTakenBits;
  }

  Ring joined(const std::vector<Ring>& parts) const {
    Ring all;
    std::size_t size = 0;
    for (const Ring& part : parts) size += part.size();
    all.reserve(size);
    for (const Ring& part : parts) {
      progress_.throwIfStopped();
      all.insert(all.end(), part.begin(), part.end());
    }
    return all;
  }

  template <class Visit>
  void forEach(std::size_t count, const Visit& visit) {
    parallelPieces(count, kPiece, progress_, {}, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) visit(i);
    });
  }

  std::vector<float>& values_;
  glm::ivec3 dims_;
  base::Progress& progress_;
};

}  // namespace

void fillMissing(std::vector<float>& values, glm::ivec3 dims, base::Progress& progress,
                 base::ProgressRange share) {
  const auto at = [&](double part) { return share.from + (share.to - share.from) * part; };
  Gaps gaps(values, dims, progress);
  Ring ring = gaps.firstRing({at(0.0), at(0.4), share.stage});
  for (int i = 1; !ring.empty(); ++i) {
    gaps.fill(ring);
    if (i == kFilledRings) break;
    if (share.stage) progress.report(at(0.4 + 0.4 * i / kFilledRings), share.stage);
    ring = gaps.nextRing(ring);
  }
  gaps.clearRest({at(0.8), at(1.0), share.stage});
}

}  // namespace isolux::volume
