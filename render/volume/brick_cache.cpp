#include "render/volume/brick_cache.h"

#include <cassert>

#include <glm/common.hpp>

namespace isolux::render {

glm::ivec3 brickDims(glm::ivec3 voxels) {
  return glm::max((voxels - 1 + brickCells - 1) / brickCells, glm::ivec3(1));
}

BrickCache::BrickCache(std::size_t bricks, std::size_t slots) : slots_(bricks, kNowhere), entries_(slots) {
  assert(slots > 0);
  for (std::size_t i = 0; i < slots; ++i)
    entries_[i].place = recent_.insert(recent_.end(), static_cast<Slot>(i));
}

std::optional<BrickCache::Slot> BrickCache::slotOf(Brick brick) const {
  const Slot slot = slots_[brick];
  return slot == kNowhere ? std::nullopt : std::optional(slot);
}

void BrickCache::touch(Slot slot) {
  entries_[slot].used = round_;
  recent_.splice(recent_.begin(), recent_, entries_[slot].place);
}

void BrickCache::use(Brick brick) {
  assert(slots_[brick] != kNowhere);
  touch(slots_[brick]);
}

BrickCache::Round BrickCache::oldest() const {
  return entries_[recent_.back()].used;
}

std::optional<BrickCache::Placement> BrickCache::place(Brick brick, Round kept) {
  assert(slots_[brick] == kNowhere);
  const Slot slot = recent_.back();
  Entry& entry = entries_[slot];
  if (entry.brick && entry.used >= kept) return std::nullopt;
  const Placement placement{slot, entry.brick};
  if (entry.brick)
    slots_[*entry.brick] = kNowhere;
  else
    ++resident_;
  entry.brick = brick;
  slots_[brick] = slot;
  touch(slot);
  return placement;
}

}  // namespace isolux::render
