#include "volume/labels/slice_mask.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include <glm/common.hpp>

#include "volume/labels/mask_parts.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr double kThick = 1.5;        // times the spacing in slices
constexpr double kMostRamp = 16.0;    // times the shorter spacing in slices: steps of 1/127 are few
constexpr float kGuardOfHalf = 0.4f;  // of the ramp of half a voxel
constexpr float kThinOfGuard = 0.25f;
constexpr int kTileBlocks = 64;                                   // on an axis: 16 MB a thread
constexpr float kFar = std::numeric_limits<float>::max() / 4.0f;  // mm^2

// Pixels [low, end) of a slice.
struct PixelBox {
  glm::ivec2 low{0}, end{0};
  glm::ivec2 size() const { return end - low; }
  bool contains(glm::ivec2 at) const {
    return at.x >= low.x && at.y >= low.y && at.x < end.x && at.y < end.y;
  }
};

// Values of the pixels of a rectangle.
struct Image {
  Extent2 extent;
  std::vector<float> values;

  void resize(glm::ivec2 size) {
    extent = {size};
    values.resize(extent.count());
  }
  float* row(int y) { return values.data() + extent.index(0, y); }
  const float* row(int y) const { return values.data() + extent.index(0, y); }
};

// The sides of a slice's pixels, and w near borders.
class Slice {
 public:
  // `reach`: pixels beyond the ramps that depend on them.
  Slice(glm::ivec2 size, const ThickSlices& slices, int reach)
      : extent_{size}, slices_(slices), reach_(slices.rampVoxels() + reach), inside_(extent_.count()) {}

  std::uint8_t* sides(int y) { return inside_.data() + extent_.index(0, y); }
  const std::uint8_t* sides(int y) const { return inside_.data() + extent_.index(0, y); }
  // From the sides of all pixels.
  void measure();

  // Outside of it w, and what is made of it, is 1 or -1. Empty: everywhere.
  const PixelBox& part() const { return part_; }
  const Image& ramps() const { return ramp_; }  // of part()
  // Returns whether the pixel is on that side, and no border within the ramp.
  bool isFarOn(std::uint8_t side, glm::ivec2 at) const {
    if (inside_[extent_.index(at)] != side) return false;
    return !part_.contains(at) || std::abs(ramp_.values[ramp_.extent.index(at - part_.low)]) >= 1.0f;
  }

 private:
  bool findPart();
  void measureRow(int y);
  void makeRamps();

  Extent2 extent_;
  ThickSlices slices_;
  glm::ivec2 reach_;
  std::vector<std::uint8_t> inside_;  // 1 in the set
  PixelBox part_;
  Image toSide_[2];  // squared distance along x to the nearest pixel that is outside, inside
  Image ramp_;
  std::vector<float> near_[2];
};

// The margins of one slice after the other.
class SliceMargins {
 public:
  SliceMargins(const ThickSlices& slices, double smoothing)
      : kernel_(smoothing),
        guard_(std::min(kMaskGuard, kGuardOfHalf * static_cast<float>(slices.halfMm() / slices.rampMm))) {}
  // Returns how many pixels beyond a ramp depend on it.
  int reach() const { return static_cast<int>(kernel_.radius()) + 2; }

  // The slices beside it; the slice itself where there is none.
  void compute(const Slice& slice, const Slice& before, const Slice& after);
  // Of a pixel of the slice's part.
  float margin(glm::ivec2 at) const { return margin_.values[margin_.extent.index(at - low_)]; }
  bool isThin(glm::ivec2 at) const { return thin_[margin_.extent.index(at - low_)] != 0; }

 private:
  void smooth(const Image& ramps);

  MaskWeights kernel_;
  float guard_;
  glm::ivec2 low_{0};
  Image alongX_, smoothed_, margin_;  // smoothed_: one pixel larger on each side, as alongX_ in x
  std::vector<float> line_;
  std::vector<std::uint8_t> thin_, alone_;
};

// Whether no other slice has the pixel's side there, nor nearly.
bool isAlone(const Slice& slice, const Slice& before, const Slice& after, glm::ivec2 at) {
  const std::uint8_t other = slice.sides(at.y)[at.x] != 0 ? 0 : 1;
  return before.isFarOn(other, at) && after.isFarOn(other, at);
}

// All that is nearer to a border than the ramp and the kernel reach. False: there is no border.
bool Slice::findPart() {
  const glm::ivec2 size = extent_.size;
  glm::ivec2 low = size, high(-1);
  const auto add = [&](glm::ivec2 at) {
    low = glm::min(low, at);
    high = glm::max(high, at);
  };
  for (int y = 0; y < size.y; ++y) {
    const std::uint8_t* const row = sides(y);
    const std::uint8_t* const next = y + 1 < size.y ? sides(y + 1) : row;
    for (int x = 0; x < size.x; ++x) {
      if (row[x] != next[x]) {
        add({x, y});
        add({x, y + 1});
      }
      if (x + 1 < size.x && row[x] != row[x + 1]) {
        add({x, y});
        add({x + 1, y});
      }
    }
  }
  if (high.x < 0) return false;
  part_ = {glm::max(low - reach_, 0), glm::min(high + 1 + reach_, size)};
  return true;
}

void Slice::measureRow(int y) {
  const int width = part_.size().x;
  const std::uint8_t* const own = sides(part_.low.y + y) + part_.low.x;
  const auto spacing = static_cast<float>(slices_.spacingMm.x);
  float* const to[2] = {toSide_[0].row(y), toSide_[1].row(y)};
  int since[2] = {width, width};  // pixels; as many or more: none yet
  const auto look = [&](int x, bool again) {
    for (int of = 0; of < 2; ++of) {
      since[of] = own[x] == of ? 0 : since[of] + 1;
      const float mm = spacing * static_cast<float>(since[of]);
      const float squared = since[of] >= width ? kFar : mm * mm;
      to[of][x] = again ? std::min(to[of][x], squared) : squared;
    }
  };
  for (int x = 0; x < width; ++x) look(x, false);
  since[0] = since[1] = width;
  for (int x = width - 1; x >= 0; --x) look(x, true);
}

void Slice::makeRamps() {
  const glm::ivec2 size = part_.size();
  for (Image& image : toSide_) image.resize(size);
  ramp_.resize(size);
  for (int y = 0; y < size.y; ++y) measureRow(y);
  const int reach = slices_.rampVoxels().y;
  const auto half = static_cast<float>(slices_.halfMm());
  const auto perMm = static_cast<float>(1.0 / slices_.rampMm);
  for (int y = 0; y < size.y; ++y) {
    for (int of = 0; of < 2; ++of) {
      std::vector<float>& near = near_[of];
      near.assign(static_cast<std::size_t>(size.x), kFar);
      for (int other = std::max(0, y - reach); other < std::min(size.y, y + reach + 1); ++other) {
        const auto mm = static_cast<float>(slices_.spacingMm.y * (other - y));
        const float* const row = toSide_[of].row(other);
        const float squared = mm * mm;
        for (std::size_t x = 0; x < near.size(); ++x) near[x] = std::min(near[x], row[x] + squared);
      }
    }
    const std::uint8_t* const own = sides(part_.low.y + y) + part_.low.x;
    float* const out = ramp_.row(y);
    for (int x = 0; x < size.x; ++x) {
      const auto at = static_cast<std::size_t>(x);
      const float d = std::sqrt(own[x] != 0 ? near_[0][at] : near_[1][at]) - half;
      const float w = std::min(1.0f, d * perMm);
      out[x] = own[x] != 0 ? w : -w;
    }
  }
}

void Slice::measure() {
  part_ = {};
  if (findPart()) makeRamps();
}

void SliceMargins::smooth(const Image& ramps) {
  const glm::ivec2 size = ramps.extent.size, larger = size + 2;
  const int radius = static_cast<int>(kernel_.radius());
  alongX_.resize({larger.x, size.y});
  line_.resize(static_cast<std::size_t>(larger.x + 2 * radius));
  const auto weight = [&](int k) { return static_cast<float>(kernel_.weights[static_cast<std::size_t>(k)]); };
  for (int y = 0; y < size.y; ++y) {
    const float* const row = ramps.row(y);
    for (int x = 0; x < static_cast<int>(line_.size()); ++x)
      line_[static_cast<std::size_t>(x)] = row[std::clamp(x - radius - 1, 0, size.x - 1)];
    const float* const middle = line_.data() + radius;
    float* const out = alongX_.row(y);
    for (int x = 0; x < larger.x; ++x) out[x] = weight(0) * middle[x];
    for (int k = 1; k <= radius; ++k)
      for (int x = 0; x < larger.x; ++x) out[x] += weight(k) * (middle[x - k] + middle[x + k]);
  }
  smoothed_.resize(larger);
  for (int y = 0; y < larger.y; ++y) {
    const auto rowAt = [&](int k) { return alongX_.row(std::clamp(y - 1 + k, 0, size.y - 1)); };
    float* const out = smoothed_.row(y);
    const float* const here = rowAt(0);
    for (int x = 0; x < larger.x; ++x) out[x] = weight(0) * here[x];
    for (int k = 1; k <= radius; ++k) {
      const float *const before = rowAt(-k), *const after = rowAt(k);
      for (int x = 0; x < larger.x; ++x) out[x] += weight(k) * (before[x] + after[x]);
    }
  }
}

void SliceMargins::compute(const Slice& slice, const Slice& before, const Slice& after) {
  low_ = slice.part().low;
  const glm::ivec2 size = slice.part().size();
  margin_.resize(size);
  if (margin_.extent.count() == 0) return;
  smooth(slice.ramps());
  thin_.assign(margin_.values.size(), 0);
  alone_.assign(margin_.values.size(), 0);
  const auto sharpening = static_cast<float>(kernel_.sharpening);
  const float thinBelow = kThinOfGuard * guard_;
  for (int y = 0; y < size.y; ++y) {
    const std::uint8_t* const own = slice.sides(low_.y + y) + low_.x;
    const float *const above = smoothed_.row(y) + 1, *const here = smoothed_.row(y + 1) + 1,
                       *const below = smoothed_.row(y + 2) + 1;
    float* const out = margin_.row(y);
    for (int x = 0; x < size.x; ++x) {
      const float laplacian = (here[x - 1] + here[x + 1]) + (above[x] + below[x]) - 4.0f * here[x];
      const float u = here[x] - sharpening * laplacian;
      out[x] = own[x] != 0 ? u : -u;
      const std::size_t at = margin_.extent.index(x, y);
      alone_[at] = isAlone(slice, before, after, low_ + glm::ivec2(x, y)) ? 1 : 0;
      thin_[at] = alone_[at] != 0 || out[x] < thinBelow ? 1 : 0;
    }
  }
  for (int y = 0; y < size.y; ++y)
    for (int x = 0; x < size.x; ++x) {
      bool nearThin = false, nearAlone = false;
      for (int j = std::max(0, y - 1); j < std::min(size.y, y + 2); ++j)
        for (int i = std::max(0, x - 1); i < std::min(size.x, x + 2); ++i) {
          nearThin = nearThin || thin_[margin_.extent.index(i, j)] != 0;
          nearAlone = nearAlone || alone_[margin_.extent.index(i, j)] != 0;
        }
      float& m = margin_.row(y)[x];
      if (nearThin) m = std::max(m, nearAlone ? 1.0f : std::abs(slice.ramps().row(y)[x]));
      m = std::clamp(m, guard_, 1.0f);
    }
}

}  // namespace

glm::ivec2 ThickSlices::rampVoxels() const {
  // The nearest centre on the other side is half a voxel farther than the border.
  return glm::ivec2(glm::ceil(rampMm / spacingMm + 0.5));
}

glm::ivec3 ThickSlices::voxel(glm::ivec2 at, int slice) const {
  glm::ivec3 voxel;
  voxel[across] = slice;
  voxel[within.x] = at.x;
  voxel[within.y] = at.y;
  return voxel;
}

std::optional<ThickSlices> thickSlicesOf(const GridGeometry& geometry) {
  const glm::dvec3 spacing = geometry.spacingMm();
  ThickSlices slices;
  for (int axis = 0; axis < 3; ++axis)
    if (spacing[axis] > spacing[slices.across]) slices.across = axis;
  slices.within = {slices.across == 0 ? 1 : 0, slices.across == 2 ? 1 : 2};
  slices.spacingMm = {spacing[slices.within.x], spacing[slices.within.y]};
  const double distance = spacing[slices.across];
  if (distance < kThick * std::max(slices.spacingMm.x, slices.spacingMm.y)) return std::nullopt;
  slices.rampMm = std::min(distance, 2.0 * kMostRamp * slices.halfMm());
  return slices;
}

SliceMask::SliceMask(const LabelBlocks& blocks, std::span<const int> labels, double smoothing,
                     const ThickSlices& slices)
    : blocks_(blocks), isMember_(membersOf(blocks, labels)), smoothing_(smoothing), slices_(slices) {}

glm::ivec3 SliceMask::reachBlocks() const {
  const glm::ivec2 reach = slices_.rampVoxels() + SliceMargins(slices_, smoothing_).reach();
  glm::ivec3 blocks(1);
  for (int i = 0; i < 2; ++i)
    blocks[slices_.within[i]] = (reach[i] + LabelBlocks::kSize - 1) / LabelBlocks::kSize;
  return blocks;
}

void SliceMask::run(std::vector<std::int8_t>& voxels, std::vector<std::uint16_t>& thin,
                    const std::function<bool(std::size_t)>& wanted, base::Progress& progress) const {
  const Extent3 blocks = blocks_.blocks();
  std::vector<PixelBox> parts(static_cast<std::size_t>(blocks.dims[slices_.across]),  // of blocks, in a layer
                              {glm::ivec2(std::numeric_limits<int>::max()), glm::ivec2(0)});
  for (std::size_t block = 0; block < blocks.count(); ++block) {
    if (!wanted(block)) continue;
    const glm::ivec3 at = blocks.at(block);
    PixelBox& part = parts[static_cast<std::size_t>(at[slices_.across])];
    part.low = glm::min(part.low, slices_.inSlice(at));
    part.end = glm::max(part.end, slices_.inSlice(at) + 1);
  }
  std::vector<Tile> tiles;
  for (std::size_t layer = 0; layer < parts.size(); ++layer) {
    const PixelBox& part = parts[layer];
    for (int y = part.low.y; y < part.end.y; y += kTileBlocks)
      for (int x = part.low.x; x < part.end.x; x += kTileBlocks)
        tiles.push_back(
            {static_cast<int>(layer), {x, y}, glm::min(glm::ivec2(x, y) + kTileBlocks, part.end)});
  }
  blocks_.grid().visit([&](const auto& stored) {
    using Voxel = typename std::decay_t<decltype(stored)>::value_type;
    const SetMembers<Voxel> members(blocks_, isMember_);
    parallelSteps(tiles.size(), progress, {0.0, 1.0, "smoothing labels"},
                  [&](std::size_t tile) { runTile(tiles[tile], stored, members, voxels, thin, progress); });
  });
}

template <class T>
void SliceMask::runTile(const Tile& tile, const std::vector<T>& stored, const SetMembers<T>& members,
                        std::vector<std::int8_t>& voxels, std::vector<std::uint16_t>& thin,
                        const base::Progress& progress) const {
  const Extent3 extent = blocks_.grid().extent(), blocks = blocks_.blocks();
  SliceMargins margins(slices_, smoothing_);
  const int reach = margins.reach(), edge = LabelBlocks::kSize;
  const glm::ivec2 size = slices_.inSlice(extent.dims);
  const PixelBox wanted{edge * tile.low, glm::min(edge * tile.end, size)};
  // Of whose pixels the wanted ones depend.
  const PixelBox seen{glm::max(wanted.low - slices_.rampVoxels() - reach, 0),
                      glm::min(wanted.end + slices_.rampVoxels() + reach, size)};
  const std::size_t step = extent.index(slices_.voxel({1, 0}, 0));
  std::vector<Slice> three(3, Slice(seen.size(), slices_, reach));
  const auto sliceOf = [&](int slice) -> Slice& { return three[static_cast<std::size_t>(slice) % 3]; };
  const auto measure = [&](int slice) {
    Slice& into = sliceOf(slice);
    for (int y = 0; y < seen.size().y; ++y) {
      std::size_t at = extent.index(slices_.voxel(seen.low + glm::ivec2(0, y), slice));
      std::uint8_t* const sides = into.sides(y);
      for (int x = 0; x < seen.size().x; ++x, at += step) sides[x] = members.has(stored[at]) ? 1 : 0;
    }
    into.measure();
  };
  const int first = edge * tile.layer, last = extent.dims[slices_.across] - 1;
  for (int y = tile.low.y; y < tile.end.y; ++y)
    for (int x = tile.low.x; x < tile.end.x; ++x) thin[blocks.index(slices_.voxel({x, y}, tile.layer))] = 0;
  for (int slice = std::max(first - 1, 0); slice <= first; ++slice) measure(slice);
  for (int slice = first; slice <= std::min(first + edge - 1, last); ++slice) {
    if (progress.stopRequested()) return;
    if (slice < last) measure(slice + 1);
    const Slice &own = sliceOf(slice), &before = sliceOf(std::max(slice - 1, 0)),
                &after = sliceOf(std::min(slice + 1, last));
    margins.compute(own, before, after);
    for (int y = wanted.low.y; y < wanted.end.y; ++y) {
      std::size_t at = extent.index(slices_.voxel({wanted.low.x, y}, slice));
      for (int x = wanted.low.x; x < wanted.end.x; ++x, at += step) {
        const glm::ivec2 pixel = glm::ivec2(x, y) - seen.low;
        const bool isInside = own.sides(pixel.y)[pixel.x] != 0, isNear = own.part().contains(pixel);
        const int steps = static_cast<int>(kMaskSteps * (isNear ? margins.margin(pixel) : 1.0f) + 0.5f);
        voxels[at] = static_cast<std::int8_t>(isInside ? steps : -steps);
        if (isInside && (isNear ? margins.isThin(pixel) : isAlone(own, before, after, pixel)))
          ++thin[blocks.index(slices_.voxel({x, y}, slice) / edge)];
      }
    }
  }
}

}  // namespace isolux::volume
