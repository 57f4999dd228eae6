#include "volume/read/chunks/array_volume.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <type_traits>

#include "base/error.h"
#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

using base::throwInput;

namespace {

std::uint64_t along(const std::optional<std::size_t>& axis, const std::vector<std::uint64_t>& values) {
  return axis ? values[*axis] : 1;
}

// A box of numbers, three strides on each side.
template <class From, class To>
void copyBox(const From* from, std::array<std::uint64_t, 3> fromStrides, To* to,
             std::array<std::uint64_t, 3> toStrides, glm::ivec3 size) {
  const auto nx = static_cast<std::size_t>(size.x);
  for (std::uint64_t z = 0; z < static_cast<std::uint64_t>(size.z); ++z)
    for (std::uint64_t y = 0; y < static_cast<std::uint64_t>(size.y); ++y) {
      const From* const row = from + z * fromStrides[2] + y * fromStrides[1];
      To* const out = to + z * toStrides[2] + y * toStrides[1];
      if constexpr (std::is_same_v<From, To>) {
        if (fromStrides[0] == 1) {
          std::memcpy(out, row, nx * sizeof(To));
          continue;
        }
      }
      for (std::size_t x = 0; x < nx; ++x) out[x] = static_cast<To>(row[x * fromStrides[0]]);
    }
}

void checkDimsOf(const ArrayLayout& layout, const ArrayAxes& axes, const std::string& file) {
  for (const auto& axis : {axes.x, axes.y, axes.z})
    if (along(axis, layout.dims) > 65535)
      throwInput(
          file, "dims",
          "an axis has " + std::to_string(along(axis, layout.dims)) + " voxels; at most 65535 are read");
  for (const auto& axis : {axes.time, axes.channel})
    if (along(axis, layout.dims) > 1000000) throwInput(file, "dims", "time steps or channels are absurd");
}

// Each chunk costs a look into its file, some ten microseconds, however few voxels it has.
void checkChunksOf(const ChunkedLevel& level, const std::string& file) {
  constexpr std::size_t most = std::size_t{1} << 24, fewVoxels = 4096;
  const glm::dvec3 chunk(level.chunkDims);
  const glm::dvec3 chunks = glm::ceil(glm::dvec3(level.geometry.dims) / chunk);
  const double voxels = chunk.x * chunk.y * chunk.z;
  if (chunks.x * chunks.y * chunks.z > static_cast<double>(most) && voxels < static_cast<double>(fewVoxels))
    throwInput(file, "chunks",
               "has more than " + std::to_string(most) + " chunks of fewer than " +
                   std::to_string(fewVoxels) + " voxels; write it with larger ones");
}

glm::ivec3 dimsOf(const ArrayLayout& layout, const ArrayAxes& axes) {
  return {static_cast<int>(along(axes.x, layout.dims)), static_cast<int>(along(axes.y, layout.dims)),
          static_cast<int>(along(axes.z, layout.dims))};
}

}  // namespace

ArrayVolume::ArrayVolume(ChunkedFacts facts, ArrayAxes axes,
                         std::vector<std::shared_ptr<const ChunkedArray>> arrays)
    : facts_(std::move(facts)), axes_(axes), arrays_(std::move(arrays)) {
  const ArrayLayout& finest = arrays_.front()->layout();
  facts_.storedType = bytesOf(finest.type) <= 2 ? finest.type : VoxelType::float32;
  facts_.levels.resize(arrays_.size());
  for (std::size_t level = 0; level < arrays_.size(); ++level) {
    const ArrayLayout& layout = arrays_[level]->layout();
    checkDimsOf(layout, axes_, facts_.name);
    if (layout.type != finest.type || layout.dims.size() != finest.dims.size() ||
        along(axes_.time, layout.dims) != along(axes_.time, finest.dims) ||
        along(axes_.channel, layout.dims) != along(axes_.channel, finest.dims))
      throwInput(facts_.name, "level " + std::to_string(level),
                 "its type, axes, time steps or channels are not those of level 0");
    facts_.levels[level].geometry.dims = dimsOf(layout, axes_);
    facts_.levels[level].chunkDims = chunkOf(layout);
    checkChunksOf(facts_.levels[level], facts_.name);
    if (layout.keepsRows) facts_.levels[level].chunkDims = {facts_.levels[level].geometry.dims.x, 1, 1};
    facts_.levels[level].cheapParts = arrays_[level]->plain();
  }
  if (facts_.storedType != finest.type) facts_.wholeVoxelBytes = bytesOf(finest.type) + sizeof(float);
  facts_.times = static_cast<int>(along(axes_.time, finest.dims));
  facts_.channels = static_cast<int>(along(axes_.channel, finest.dims));
  if (facts_.storedType != finest.type && finest.type != VoxelType::float32)
    facts_.warnings.push_back(std::string(nameOf(finest.type)) +
                              " voxels are read as float32; values may be rounded");
}

// Plain chunks are read in parts, so how they are cut does not matter.
glm::ivec3 ArrayVolume::chunkOf(const ArrayLayout& layout) const {
  const glm::ivec3 dims = dimsOf(layout, axes_);
  const auto clipped = [&](const std::optional<std::size_t>& axis, int n) {
    return static_cast<int>(
        std::min<std::uint64_t>(along(axis, layout.chunk), static_cast<std::uint64_t>(n)));
  };
  return {clipped(axes_.x, dims.x), clipped(axes_.y, dims.y), clipped(axes_.z, dims.z)};
}

// `wanted` lies in the chunk and in `destination`, whose voxels follow each other at `voxels`.
template <class To>
std::size_t ArrayVolume::readOneChunk(VolumePart part, std::size_t level, glm::ivec3 chunk, Box wanted,
                                      Box destination, To* voxels, std::size_t* missing) const {
  const ChunkedArray& array = *arrays_[level];
  const ArrayLayout& layout = array.layout();
  const std::size_t axes = layout.dims.size();
  std::vector<std::uint64_t> index(axes), low(axes), size(axes, 1);
  const auto place = [&](const std::optional<std::size_t>& axis, int chunkIndex, int first, int count) {
    if (!axis) return;
    index[*axis] = static_cast<std::uint64_t>(chunkIndex);
    low[*axis] = static_cast<std::uint64_t>(first) - index[*axis] * layout.chunk[*axis];
    size[*axis] = static_cast<std::uint64_t>(count);
  };
  place(axes_.x, chunk.x, wanted.low.x, wanted.size.x);
  place(axes_.y, chunk.y, wanted.low.y, wanted.size.y);
  place(axes_.z, chunk.z, wanted.low.z, wanted.size.z);
  const auto placeOne = [&](const std::optional<std::size_t>& axis, int entry) {
    if (axis)
      place(axis, static_cast<int>(static_cast<std::uint64_t>(entry) / layout.chunk[*axis]), entry, 1);
  };
  placeOne(axes_.time, part.time);
  placeOne(axes_.channel, part.channel);
  const ArrayChunk read = array.read(index, low, size);
  std::uint64_t first = 0;
  for (std::size_t axis = 0; axis < axes; ++axis)
    first += (low[axis] - read.start[axis]) * read.strides[axis];
  const auto stride = [&](const std::optional<std::size_t>& axis) {
    return axis ? read.strides[*axis] : std::uint64_t{0};
  };
  const Extent3 extent{destination.size};
  const std::array<std::uint64_t, 3> toStrides = {1, extent.row(), extent.slice()};
  To* const to = voxels + extent.index(wanted.low - destination.low);
  withType(layout.type, [&](auto zero) {
    using From = decltype(zero);
    if constexpr (std::is_same_v<From, To> || std::is_same_v<To, float>)
      copyBox(reinterpret_cast<const From*>(read.bytes.data()) + first,
              {stride(axes_.x), stride(axes_.y), stride(axes_.z)}, to, toStrides, wanted.size);
  });
  if (missing != nullptr && read.missing) ++*missing;
  return read.bytesRead;
}

template <class To>
std::size_t ArrayVolume::readBox(VolumePart part, std::size_t level, Box box, Box destination, To* voxels,
                                 std::size_t* missing) const {
  const glm::ivec3 chunk = chunkOf(arrays_[level]->layout());
  const glm::ivec3 first = box.low / chunk, last = (box.low + box.size - 1) / chunk;
  std::size_t bytes = 0;
  forEachIn(first, last + 1, [&](glm::ivec3 index) {
    const glm::ivec3 low = glm::max(box.low, index * chunk);
    const glm::ivec3 high = glm::min(box.low + box.size, (index + 1) * chunk);
    bytes += readOneChunk(part, level, index, {low, high - low}, destination, voxels, missing);
  });
  return bytes;
}

void ArrayVolume::setChoices(std::vector<std::string> choices, std::string warning) {
  facts_.choices = std::move(choices);
  if (!warning.empty()) facts_.warnings.push_back(std::move(warning));
}

std::size_t ArrayVolume::read(VolumePart part, std::size_t level, glm::ivec3 low, glm::ivec3 size,
                              std::span<std::byte> voxels) const {
  const Box box{low, size};
  std::size_t bytes = 0;
  withType(facts_.storedType, [&](auto zero) {
    using To = decltype(zero);
    To* const first = reinterpret_cast<To*>(voxels.data());
    bytes = readBox(part, level, box, box, first, nullptr);
    if constexpr (std::is_same_v<To, float>)
      for (float& voxel : std::span(first, voxels.size() / sizeof(float)))
        if (!std::isfinite(voxel)) voxel = std::numeric_limits<float>::quiet_NaN();
  });
  return bytes;
}

ArrayVolume::Whole ArrayVolume::readWhole(VolumePart part, base::Progress& progress) const {
  constexpr std::size_t atOnce = std::size_t{1} << 20;  // voxels: in a few milliseconds
  const ChunkedLevel& level = facts_.levels.front();
  const glm::ivec3 dims = level.geometry.dims,
                   step = level.cheapParts ? wholeRows(dims, atOnce) : level.chunkDims;
  const Extent3 steps{(dims + step - 1) / step};
  Whole whole;
  whole.chunks = steps.count();
  std::atomic<std::size_t> missing{0};
  withType(fileType(), [&](auto zero) {
    using To = decltype(zero);
    std::vector<To> voxels;
    resizeStoppably(voxels, level.geometry.voxelCount(), progress);
    parallelSteps(whole.chunks, progress, {0.0, 1.0, "reading"}, [&](std::size_t i) {
      const glm::ivec3 low = steps.at(i) * step;
      std::size_t lacking = 0;
      readBox(part, 0, {low, glm::min(step, dims - low)}, {glm::ivec3(0), dims}, voxels.data(), &lacking);
      missing.fetch_add(lacking > 0 ? 1 : 0, std::memory_order_relaxed);
    });
    whole.voxels = std::move(voxels);
  });
  whole.missingChunks = missing.load();
  return whole;
}

}  // namespace isolux::volume
