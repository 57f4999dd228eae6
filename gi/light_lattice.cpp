#include "gi/light_lattice.h"

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

LightLattice::LightLattice(LatticeGeometry geometry, LightContent content, std::string key)
    : geometry_(geometry),
      content_(content),
      key_(std::move(key)),
      held_(scene::machineMemory().reserve(geometry.blockCount() * kTableEntry, "the table of stored light",
                                           remedyFor(content))),
      blocks_(geometry.blockCount()),
      revisions_(geometry.blockCount(), 0) {}

std::shared_ptr<const LatticeBlock> LightLattice::at(std::uint32_t block) const {
  assert(block < blocks_.size());
  const std::lock_guard lock(mutex_);
  return blocks_[block];
}

bool LightLattice::has(std::uint32_t block) const {
  return at(block) != nullptr;
}

bool LightLattice::read(std::uint32_t block, LatticeBlock& out) const {
  const std::shared_ptr<const LatticeBlock> in = at(block);
  if (in) out = *in;
  return in != nullptr;
}

void LightLattice::write(std::uint32_t block, LatticeBlock in) {
  assert(block < blocks_.size());
  assert(in.means.size() ==
         static_cast<std::size_t>(kTexelsOfBlock) * static_cast<std::size_t>(content_.components()));
  if (in.held.bytes() == 0)
    in.held = scene::machineMemory().reserve(in.bytes(), "more stored light", remedyFor(content_));
  const std::uint64_t baked = bakedOf(in);
  auto fresh = std::make_shared<const LatticeBlock>(std::move(in));
  const std::lock_guard lock(mutex_);
  const std::uint64_t revision = revision_.load(std::memory_order_relaxed) + 1;
  written_.emplace_hint(written_.end(), revision, block);  // the last that can throw
  if (blocks_[block]) {
    written_.erase(revisions_[block]);
    bakedTexels_ -= bakedOf(*blocks_[block]);
    blockBytes_ -= blocks_[block]->bytes();
  }
  bakedTexels_ += baked;
  blockBytes_ += fresh->bytes();
  revisions_[block] = revision;
  blocks_[block].swap(fresh);
  revision_.store(revision, std::memory_order_release);
}

void LightLattice::clear() {
  std::vector<std::shared_ptr<const LatticeBlock>> none(blocks_.size());
  const std::lock_guard lock(mutex_);
  blocks_.swap(none);
  written_.clear();
  std::fill(revisions_.begin(), revisions_.end(), 0);
  bakedTexels_ = 0;
  blockBytes_ = 0;
  clearedAt_ = revision_.load(std::memory_order_relaxed) + 1;
  revision_.store(clearedAt_, std::memory_order_release);
}

std::vector<std::uint32_t> LightLattice::changedSince(std::uint64_t revision) const {
  const std::lock_guard lock(mutex_);
  std::vector<std::uint32_t> changed;
  for (auto entry = written_.upper_bound(revision); entry != written_.end(); ++entry)
    changed.push_back(entry->second);
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
  return (blocks_.size() - written_.size()) * LatticeBlock::bytesOf(content_);
}

void LightLattice::checkThatAllFits() const {
  const glm::ivec3 dims = geometry_.dims;
  std::string what = "light at all " + std::to_string(dims.x) + " x " + std::to_string(dims.y) + " x " +
                     std::to_string(dims.z) + " texels (";
  if (content_.kind == LightContent::Kind::transfer)
    what += "transfer of order " + std::to_string(content_.order) + ", ";
  what += std::to_string(content_.channels) + (content_.channels == 1 ? " channel)" : " channels)");
  scene::machineMemory().check(bytesToFill(), what, remedyFor(content_));
}

std::size_t LightLattice::bytes() const {
  const std::lock_guard lock(mutex_);
  return sizeof(*this) + blockBytes_ + blocks_.capacity() * sizeof(blocks_[0]) +
         revisions_.capacity() * sizeof(revisions_[0]) + written_.size() * 48;
}

}  // namespace isolux::gi
