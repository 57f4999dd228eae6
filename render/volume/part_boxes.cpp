#include "render/volume/part_boxes.h"

#include <glm/common.hpp>

#include "render/volume/brick_cache.h"
#include "volume/bricks/brick_source.h"
#include "volume/voxels/stored_type.h"

namespace isolux::render {

namespace {

constexpr int kBlocksPerBrick = brickCells / volume::BoxBounds::kBlockCells;

// Of a block in its brick.
std::size_t ownIndex(glm::ivec3 block) {
  return static_cast<std::size_t>((block.z * kBlocksPerBrick + block.y) * kBlocksPerBrick + block.x);
}

}  // namespace

PartBoxes::PartBoxes(std::shared_ptr<const volume::Grid> grid) : grid_(std::move(grid)) {}

void PartBoxes::moved(glm::ivec3 brick, bool isResident, BlockBits lost) {
  if (!isResident) {
    boxes_.erase(brick);
    return;
  }
  const glm::ivec3 size(brickCells + 1);
  std::vector<volume::DamagedPart> unknown;  // of lost blocks
  const volume::VoxelArray voxels =
      volume::withStoredType(grid_->storedType(), [&](auto zero) -> volume::VoxelArray {
        std::vector<decltype(zero)> part(static_cast<std::size_t>(size.x * size.y * size.z));
        grid_->source()->copyBox(0, brick * brickCells, size, std::as_writable_bytes(std::span(part)),
                                 &unknown);
        return part;
      });
  base::Progress unwatched;
  boxes_.insert_or_assign(brick, Known{volume::BoxBounds::ofPart(voxels, size, *grid_, unwatched), lost});
}

PartBoxes::Blocks PartBoxes::masks(glm::ivec3 brick, std::span<const float> storedIsovalues,
                                   const volume::ActiveBlocks& active) const {
  const auto boxes = boxes_.find(brick);
  if (boxes == boxes_.end()) return {};
  const glm::ivec3 dims = active.blocks().dims(), low = brick * kBlocksPerBrick,
                   size = glm::clamp(dims - low, glm::ivec3(0), glm::ivec3(kBlocksPerBrick));
  std::vector<std::uint8_t> flags(ownIndex(glm::ivec3(kBlocksPerBrick - 1)) + 1, 0);
  const auto forEach = [size](auto&& f) {
    for (glm::ivec3 at(0); at.z < size.z; ++at.z)
      for (at.y = 0; at.y < size.y; ++at.y)
        for (at.x = 0; at.x < size.x; ++at.x) f(at);
  };
  forEach([&](glm::ivec3 at) { flags[ownIndex(at)] = active.flags()[active.blocks().index(low + at)]; });
  std::vector<std::uint64_t> masks;
  boxes->second.boxes.masks(storedIsovalues, flags, masks);
  Blocks found{low, size, {}};
  forEach([&](glm::ivec3 at) {
    const std::size_t own = ownIndex(at);
    const bool isLost = (boxes->second.lost & blockBit(at)) != 0;
    found.masks.push_back(isLost && flags[own] != 0 ? ~std::uint64_t{0} : masks[own]);
  });
  return found;
}

std::vector<glm::ivec3> PartBoxes::resident() const {
  std::vector<glm::ivec3> bricks;
  for (const auto& [brick, boxes] : boxes_) bricks.push_back(brick);
  return bricks;
}

}  // namespace isolux::render
