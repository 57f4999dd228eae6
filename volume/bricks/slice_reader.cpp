#include "volume/bricks/slice_reader.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <mutex>
#include <utility>

#include <glm/common.hpp>

#include "volume/parallel/parallel_steps.h"

namespace isolux::volume {

namespace {

constexpr std::size_t kMostBytes = std::size_t{1} << 30;  // of what is read at a time
constexpr std::size_t kRowsBytes = std::size_t{4} << 20;  // of a step where any rows are cheap

}  // namespace

SliceReader::SliceReader(const ChunkedVolume& file, VolumePart part, int most, Damaged damaged)
    : file_(file),
      part_(part),
      damaged_(std::move(damaged)),
      dims_(file.facts().levels.front().geometry.dims),
      voxelBytes_(bytesOf(file.facts().storedType)),
      sliceBytes_(static_cast<std::size_t>(dims_.x) * static_cast<std::size_t>(dims_.y) * voxelBytes_) {
  const ChunkedLevel& level = file.facts().levels.front();
  if (level.cheapParts) {
    const std::size_t slices = std::max<std::size_t>(kRowsBytes / sliceBytes_, 1);
    chunk_ = {dims_.x, dims_.y, static_cast<int>(std::min(slices, static_cast<std::size_t>(dims_.z)))};
    step_ = 1;
  } else {
    chunk_ = glm::clamp(level.chunkDims, glm::ivec3(1), dims_);
    const std::size_t bytes = std::clamp<std::size_t>(base::machineMemory().left() / 4, 1, kMostBytes);
    const auto parts = (static_cast<std::size_t>(chunk_.z) * sliceBytes_ + bytes - 1) / bytes;
    step_ = std::max(1, static_cast<int>((static_cast<std::size_t>(chunk_.z) + parts - 1) / parts));
  }
  const int kept = std::min(most + step_, dims_.z);
  held_ =
      base::machineMemory().reserve(static_cast<std::size_t>(kept) * sliceBytes_, "slices of the volume", "");
}

std::span<const std::byte> SliceReader::bytesOfSlices(int first, int behind, base::Progress& progress) {
  if (behind > behind_) {
    // Ends where a part of a layer of chunks does.
    const int inLayer = behind % chunk_.z, layer = behind - inLayer;
    const int end =
        step_ == 1 || inLayer == 0
            ? behind
            : std::min({layer + (inLayer + step_ - 1) / step_ * step_, layer + chunk_.z, dims_.z});
    const int from = std::max(first, behind_), kept = std::max(behind_ - first, 0);
    const auto bytes = [this](int slices) { return static_cast<std::size_t>(slices) * sliceBytes_; };
    if (kept > 0 && first > first_)
      std::memmove(voxels_.data(), voxels_.data() + bytes(first - first_), bytes(kept));
    voxels_.resize(bytes(end - first));
    first_ = first;
    behind_ = first + kept;  // until the rest is there
    read(from, end, voxels_.data() + bytes(kept), progress);
    behind_ = end;
  }
  return std::span<const std::byte>(voxels_).subspan(static_cast<std::size_t>(first - first_) * sliceBytes_,
                                                     static_cast<std::size_t>(behind - first) * sliceBytes_);
}

void SliceReader::read(int from, int behind, std::byte* to, base::Progress& progress) {
  const bool rows =
      step_ == 1 && chunk_.x == dims_.x && chunk_.y == dims_.y;  // what is read lies in a row in memory
  const int depth = rows ? chunk_.z : behind - from;
  const glm::ivec3 size(chunk_.x, chunk_.y, depth), whole(dims_.x, dims_.y, behind - from);
  const glm::ivec3 boxes = (whole + size - 1) / size;
  const auto nx = static_cast<std::size_t>(boxes.x), ny = static_cast<std::size_t>(boxes.y);
  std::atomic<std::uint64_t> read{0};
  std::mutex mutex;  // of damaged_
  const auto readBox = [&](glm::ivec3 low, glm::ivec3 size, std::span<std::byte> voxels) {
    std::vector<DamagedPart> damaged;
    read += readAround(file_, part_, 0, low, size, voxels, damaged);
    const std::lock_guard lock(mutex);
    for (DamagedPart& one : damaged) damaged_(std::move(one));
  };
  parallelSteps(nx * ny * static_cast<std::size_t>(boxes.z), progress, {}, [&](std::size_t i) {
    const glm::ivec3 low = size * glm::ivec3(static_cast<int>(i % nx), static_cast<int>(i / nx % ny),
                                             static_cast<int>(i / nx / ny));
    const glm::ivec3 box = glm::min(size, whole - low), at = low + glm::ivec3(0, 0, from);
    const std::size_t row = static_cast<std::size_t>(box.x) * voxelBytes_,
                      bytes = row * static_cast<std::size_t>(box.y) * static_cast<std::size_t>(box.z);
    std::byte* const slices = to + static_cast<std::size_t>(low.z) * sliceBytes_;
    if (box.x == dims_.x && (box.y == dims_.y || box.z == 1)) {
      readBox(at, box, {slices + static_cast<std::size_t>(low.y) * row, bytes});
      return;
    }
    std::vector<std::byte> voxels(bytes);
    readBox(at, box, voxels);
    const std::byte* source = voxels.data();
    const std::size_t wholeRow = static_cast<std::size_t>(dims_.x) * voxelBytes_;
    for (int z = 0; z < box.z; ++z)
      for (int y = 0; y < box.y; ++y, source += row)
        std::memcpy(slices + static_cast<std::size_t>(z) * sliceBytes_ +
                        static_cast<std::size_t>(low.y + y) * wholeRow +
                        static_cast<std::size_t>(low.x) * voxelBytes_,
                    source, row);
  });
  bytesRead_ += read;
}

}  // namespace isolux::volume
