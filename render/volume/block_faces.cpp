#include "render/volume/block_faces.h"

#include <algorithm>
#include <limits>

namespace isolux::render {

namespace {

constexpr std::uint32_t kNoPlace = std::numeric_limits<std::uint32_t>::max();

PackedFace packed(std::size_t block, int axis, bool high) {
  return static_cast<PackedFace>(6 * block + static_cast<std::size_t>(2 * axis + (high ? 1 : 0)));
}

}  // namespace

std::vector<PackedFace> boundaryFaces(const std::vector<std::uint8_t>& active, glm::ivec3 dims) {
  std::vector<PackedFace> faces;
  const std::ptrdiff_t strides[3] = {1, dims.x, static_cast<std::ptrdiff_t>(dims.x) * dims.y};
  std::size_t i = 0;
  for (int z = 0; z < dims.z; ++z)
    for (int y = 0; y < dims.y; ++y)
      for (int x = 0; x < dims.x; ++x, ++i) {
        if (!active[i]) continue;
        const glm::ivec3 block(x, y, z);
        for (int axis = 0; axis < 3; ++axis) {
          const auto neighbour = [&](std::ptrdiff_t step) {
            return active[static_cast<std::size_t>(static_cast<std::ptrdiff_t>(i) + step)] != 0;
          };
          if (block[axis] == 0 || !neighbour(-strides[axis])) faces.push_back(packed(i, axis, false));
          if (block[axis] == dims[axis] - 1 || !neighbour(strides[axis]))
            faces.push_back(packed(i, axis, true));
        }
      }
  return faces;
}

BlockFaceSet::BlockFaceSet(glm::ivec3 blockDims)
    : dims_(blockDims),
      places_(6 * static_cast<std::size_t>(blockDims.x) * static_cast<std::size_t>(blockDims.y) *
                  static_cast<std::size_t>(blockDims.z),
              kNoPlace) {}

void BlockFaceSet::update(const std::vector<std::uint8_t>& active, std::span<const std::uint32_t> changed) {
  // A changed block costs about 130 times what a block costs in a scan of all (isolux_bench isovalue).
  if (changed.size() > active.size() / 128) {
    rebuild(active);
    return;
  }
  for (const std::uint32_t block : changed) updateBlock(active, block);
}

void BlockFaceSet::rebuild(const std::vector<std::uint8_t>& active) {
  for (const PackedFace face : faces_) places_[face] = kNoPlace;
  faces_ = boundaryFaces(active, dims_);
  for (std::size_t place = 0; place < faces_.size(); ++place)
    places_[faces_[place]] = static_cast<std::uint32_t>(place);
  dirtyPages_.assign((faces_.size() + kPageFaces - 1) / kPageFaces, 1);
}

// The faces between a block and its neighbours, on both their sides.
void BlockFaceSet::updateBlock(const std::vector<std::uint8_t>& active, std::uint32_t block) {
  const auto width = static_cast<std::uint32_t>(dims_.x), height = static_cast<std::uint32_t>(dims_.y);
  const std::uint32_t strides[3] = {1, width, width * height};
  const glm::ivec3 at(block % width, block / width % height, block / (width * height));
  const bool here = active[block] != 0;
  for (int axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      bool there = false;
      if (at[axis] != (high ? dims_[axis] - 1 : 0)) {
        const std::uint32_t neighbour = high ? block + strides[axis] : block - strides[axis];
        there = active[neighbour] != 0;
        setFace(packed(neighbour, axis, !high), there && !here);
      }
      setFace(packed(block, axis, high), here && !there);
    }
}

void BlockFaceSet::setFace(PackedFace face, bool wanted) {
  std::uint32_t& place = places_[face];
  if (wanted == (place != kNoPlace)) return;
  if (wanted) {
    place = static_cast<std::uint32_t>(faces_.size());
    faces_.push_back(0);
    write(place, face);
    return;
  }
  // The last face takes the place of the one that goes.
  const PackedFace last = faces_.back();
  faces_.pop_back();
  if (place < faces_.size()) {
    places_[last] = place;
    write(place, last);
  }
  place = kNoPlace;
}

void BlockFaceSet::write(std::size_t place, PackedFace face) {
  faces_[place] = face;
  const std::size_t page = place / kPageFaces;
  if (page >= dirtyPages_.size()) dirtyPages_.resize(page + 1, 0);
  dirtyPages_[page] = 1;
}

std::vector<BlockFaceSet::Range> BlockFaceSet::takeDirty() {
  std::vector<Range> ranges;
  for (std::size_t page = 0; page < dirtyPages_.size(); ++page) {
    const std::size_t first = page * kPageFaces;
    if (!dirtyPages_[page] || first >= faces_.size()) continue;
    const std::size_t end = std::min(first + kPageFaces, faces_.size());
    if (!ranges.empty() && ranges.back().first + ranges.back().count == first)
      ranges.back().count = end - ranges.back().first;
    else
      ranges.push_back({first, end - first});
  }
  std::fill(dirtyPages_.begin(), dirtyPages_.end(), std::uint8_t{0});
  return ranges;
}

}  // namespace isolux::render
