#include "volume/bricks/damage.h"

#include <algorithm>
#include <cstring>
#include <limits>

#include <glm/common.hpp>

#include "base/error.h"
#include "volume/voxels/stored_type.h"

namespace isolux::volume {

namespace {

std::size_t voxelsOf(glm::ivec3 size) {
  return GridGeometry{.dims = size}.voxelCount();
}

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
  const glm::ivec3 at = piece.low - whole.low;
  const std::byte* source = from.data();
  for (int z = 0; z < piece.size.z; ++z)
    for (int y = 0; y < piece.size.y; ++y, source += row) {
      const std::size_t line = static_cast<std::size_t>(at.z + z) * static_cast<std::size_t>(whole.size.y) +
                               static_cast<std::size_t>(at.y + y);
      const std::size_t voxel =
          line * static_cast<std::size_t>(whole.size.x) + static_cast<std::size_t>(at.x);
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
  for (int z = first.z; z <= last.z; ++z)
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x) {
        const glm::ivec3 index(x, y, z), from = glm::max(low, index * piece);
        const Box box{from, glm::min(low + size, (index + 1) * piece) - from};
        std::vector<std::byte> read(voxelsOf(box.size) * voxelBytes);
        const std::string error = triedToRead(file, part, level, box, read, bytes);
        if (!error.empty()) {
          damaged.push_back({box.low, box.size, error});
          read = unknownVoxels(facts.storedType, voxelsOf(box.size));
        }
        copyInto(read, box, {low, size}, voxelBytes, voxels);
      }
  return bytes;
}

void noteDamage(const std::string& file, DamagedPart&& part, std::vector<DamagedPart>& damaged) {
  if (std::find(damaged.begin(), damaged.end(), part) != damaged.end()) return;
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

bool isMended(const ChunkedVolume& file, VolumePart part, const std::vector<DamagedPart>& damaged) {
  return std::any_of(damaged.begin(), damaged.end(), [&](const DamagedPart& one) {
    std::vector<std::byte> voxels(voxelsOf(one.size) * bytesOf(file.facts().storedType));
    std::size_t bytes = 0;
    return triedToRead(file, part, 0, {one.low, one.size}, voxels, bytes).empty();
  });
}

}  // namespace isolux::volume
