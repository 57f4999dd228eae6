#include "volume/bricks/damage.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include <glm/common.hpp>

#include "base/error.h"

namespace isolux::volume {

namespace {

// In what a box is read again.
glm::ivec3 pieceOf(const ChunkedLevel& level) {
  const glm::ivec3 dims = level.geometry.dims;
  return level.keepsBoxes() ? glm::min(level.chunkDims, dims) : glm::ivec3(dims.x, dims.y, 1);
}

std::vector<std::byte> unknownVoxels(VoxelType type, std::size_t count) {
  std::vector<std::byte> bytes(count * bytesOf(type));
  if (type == VoxelType::float32) {
    const std::vector<float> missing(count, std::numeric_limits<float>::quiet_NaN());
    std::memcpy(bytes.data(), missing.data(), bytes.size());
  }
  return bytes;
}

struct Box {
  glm::ivec3 low, size;
};

void copyInto(const std::vector<std::byte>& from, Box piece, Box whole, std::size_t voxelBytes,
              std::span<std::byte> to) {
  const std::size_t row = static_cast<std::size_t>(piece.size.x) * voxelBytes;
  const std::byte* source = from.data();
  for (int z = 0; z < piece.size.z; ++z)
    for (int y = 0; y < piece.size.y; ++y, source += row) {
      const std::size_t voxel = Extent3{whole.size}.index(piece.low - whole.low + glm::ivec3(0, y, z));
      std::memcpy(to.data() + voxel * voxelBytes, source, row);
    }
}

// Why not; empty: it can be read.
std::string triedToRead(const ChunkedVolume& file, VolumePart part, std::size_t level, Box box,
                        std::vector<std::byte>& voxels, std::size_t& bytes) {
  try {
    bytes += file.read(part, level, box.low, box.size, voxels);
    return {};
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) throw;
    return error.what();
  }
}

}  // namespace

std::size_t readAround(const ChunkedVolume& file, VolumePart part, std::size_t level, glm::ivec3 low,
                       glm::ivec3 size, std::span<std::byte> voxels, std::vector<DamagedPart>& damaged) {
  try {
    return file.read(part, level, low, size, voxels);
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) throw;
  }
  const ChunkedFacts& facts = file.facts();
  const std::size_t voxelBytes = bytesOf(facts.storedType);
  const glm::ivec3 piece = pieceOf(facts.levels[level]), first = low / piece, last = (low + size - 1) / piece;
  std::size_t bytes = 0;
  forEachIn(first, last + 1, [&](glm::ivec3 index) {
    const glm::ivec3 from = glm::max(low, index * piece);
    const Box box{from, glm::min(low + size, (index + 1) * piece) - from};
    const std::size_t count = Extent3{box.size}.count();
    std::vector<std::byte> read(count * voxelBytes);
    const std::string error = triedToRead(file, part, level, box, read, bytes);
    if (!error.empty()) {
      damaged.push_back({box.low, box.size, error});
      read = unknownVoxels(facts.storedType, count);
    }
    copyInto(read, box, {low, size}, voxelBytes, voxels);
  });
  return bytes;
}

void recordDamage(const std::string& file, DamagedPart&& part, std::vector<DamagedPart>& damaged) {
  if (std::ranges::find(damaged, part) != damaged.end()) return;
  if (damaged.size() == kMostDamagedParts)
    base::throwInput(file, "",
                     "more than " + std::to_string(kMostDamagedParts) +
                         " of its parts cannot be read; the first: " + damaged.front().error);
  damaged.push_back(std::move(part));
}

std::string damageText(const std::vector<DamagedPart>& damaged) {
  const std::string error = damaged.front().error;
  if (damaged.size() == 1) return "a part of it cannot be read: " + error;
  return std::to_string(damaged.size()) + " parts of it cannot be read, the first: " + error;
}

bool isRepaired(const ChunkedVolume& file, VolumePart part, const std::vector<DamagedPart>& damaged) {
  return std::ranges::any_of(damaged, [&](const DamagedPart& one) {
    std::vector<std::byte> voxels(Extent3{one.size}.count() * bytesOf(file.facts().storedType));
    std::size_t bytes = 0;
    return triedToRead(file, part, 0, {one.low, one.size}, voxels, bytes).empty();
  });
}

}  // namespace isolux::volume
