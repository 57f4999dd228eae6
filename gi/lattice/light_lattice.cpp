#include "gi/lattice/light_lattice.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace isolux::gi {

namespace {

std::uint64_t bakedOf(const LatticeBlock& block) {
  return static_cast<std::uint64_t>(
      std::count_if(block.samples.begin(), block.samples.end(), [](std::uint32_t n) { return n > 0; }));
}

// What the user can do about light that does not fit.
std::string_view remedyFor(const LightContent& content) {
  return content.kind == LightContent::Kind::transfer
             ? "gi.extent=view, or a lower gi.lattice_scale or gi.sh_order, needs less"
             : "gi.extent=view, or a lower gi.lattice_scale, needs less";
}

constexpr std::size_t kTableEntry =
    sizeof(std::shared_ptr<const LatticeBlock>) + sizeof(std::uint64_t) + 48;  // a node of the map

}  // namespace

LightLattice::LightLattice(const LatticeGeometry& geometry, LightContent content, std::string key)
    : geometry_(geometry),
      content_(content),
      key_(std::move(key)),
      held_(base::machineMemory().reserve(geometry.blockCount() * kTableEntry, "the table of baked light",
                                          remedyFor(content))),
      blocks_(geometry.blockCount()) {}

LatticeBlock LightLattice::dark() const {
  LatticeBlock block;
  block.means.assign(
      static_cast<std::size_t>(kTexelsOfBlock) * static_cast<std::size_t>(content_.components()), 0.0f);
  if (geometry_.isovalue) block.places.assign(kTexelsOfBlock, glm::vec3(0.0f));
  return block;
}

std::shared_ptr<const LatticeBlock> LightLattice::at(std::uint32_t block) const {
  assert(block < blocks_.size());
  const std::lock_guard lock(mutex_);
  return blocks_[block].block;
}

void LightLattice::write(std::uint32_t block, LatticeBlock in) {
  assert(block < blocks_.size());
  assert(in.means.size() ==
         static_cast<std::size_t>(kTexelsOfBlock) * static_cast<std::size_t>(content_.components()));
  assert(in.places.size() == (geometry_.isovalue ? kTexelsOfBlock : 0));
  if (in.held.bytes() == 0)
    in.held = base::machineMemory().reserve(in.bytes(), "more baked light", remedyFor(content_));
  share(block, std::make_shared<const LatticeBlock>(std::move(in)));  // the last that can throw
}

void LightLattice::share(std::uint32_t block, std::shared_ptr<const LatticeBlock> fresh) {
  assert(block < blocks_.size());
  const std::uint64_t baked = fresh ? bakedOf(*fresh) : 0;
  const std::size_t bytes = fresh ? fresh->bytes() : 0;
  const bool there = fresh != nullptr;
  const std::lock_guard lock(mutex_);
  Stored& stored = blocks_[block];
  if (stored.block) {
    unlink(stored);
    --filled_;
    bakedTexels_ -= stored.baked;
    blockBytes_ -= stored.block->bytes();
  }
  stored.block.swap(fresh);  // what was there is freed with the lock open
  stored.baked = baked;
  if (!there) return;
  stored.revision = revision_.load(std::memory_order_relaxed) + 1;
  stored.older = newest_;
  stored.newer = kNone;
  if (newest_ != kNone) blocks_[newest_].newer = block;
  newest_ = block;
  ++filled_;
  bakedTexels_ += baked;
  blockBytes_ += bytes;
  revision_.store(stored.revision, std::memory_order_release);
}

void LightLattice::unlink(Stored& stored) {
  if (stored.older != kNone) blocks_[stored.older].newer = stored.newer;
  if (stored.newer != kNone)
    blocks_[stored.newer].older = stored.older;
  else
    newest_ = stored.older;
}

void LightLattice::clear() {
  std::vector<Stored> none(blocks_.size());
  const std::lock_guard lock(mutex_);
  blocks_.swap(none);
  newest_ = kNone;
  filled_ = 0;
  bakedTexels_ = 0;
  blockBytes_ = 0;
  clearedAt_ = revision_.load(std::memory_order_relaxed) + 1;
  revision_.store(clearedAt_, std::memory_order_release);
}

std::vector<std::uint32_t> LightLattice::changedSince(std::uint64_t revision) const {
  std::vector<std::uint32_t> changed;
  const std::lock_guard lock(mutex_);
  for (std::uint32_t b = newest_; b != kNone && blocks_[b].revision > revision; b = blocks_[b].older)
    changed.push_back(b);
  std::reverse(changed.begin(), changed.end());
  return changed;
}

std::uint64_t LightLattice::clearedAt() const {
  const std::lock_guard lock(mutex_);
  return clearedAt_;
}

std::uint64_t LightLattice::bakedTexels() const {
  const std::lock_guard lock(mutex_);
  return bakedTexels_;
}

std::size_t LightLattice::bytesToFill() const {
  const std::lock_guard lock(mutex_);
  return (blocks_.size() - filled_) * LatticeBlock::bytesOf(content_, geometry_.isovalue.has_value());
}

void LightLattice::checkThatAllFits() const {
  const glm::ivec3 dims = geometry_.dims;
  std::string what = "light at all " + std::to_string(dims.x) + " x " + std::to_string(dims.y) + " x " +
                     std::to_string(dims.z) + " texels (";
  if (content_.kind == LightContent::Kind::transfer)
    what += "transfer of order " + std::to_string(content_.order) + ", ";
  what += std::to_string(content_.channels) + (content_.channels == 1 ? " channel)" : " channels)");
  base::machineMemory().check(bytesToFill(), what, remedyFor(content_));
}

std::size_t LightLattice::bytes() const {
  const std::lock_guard lock(mutex_);
  return sizeof(*this) + blockBytes_ + blocks_.capacity() * sizeof(blocks_[0]);
}

}  // namespace isolux::gi
