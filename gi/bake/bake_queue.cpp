#include "gi/bake/bake_queue.h"

#include <algorithm>
#include <cassert>
#include <limits>

#include "gi/lattice/texel_bits.h"

namespace isolux::gi {

namespace {

constexpr std::uint32_t kLongestRound = 1024;  // so that one texel's round is a few ms

}  // namespace

std::vector<std::uint32_t> roundsUpTo(std::uint32_t samples) {
  std::vector<std::uint32_t> rounds;
  for (std::uint64_t end = 4; end < samples; end += std::min<std::uint64_t>(3 * end, kLongestRound))
    rounds.push_back(static_cast<std::uint32_t>(end));
  rounds.push_back(samples);
  return rounds;
}

BakeQueue::BakeQueue(const LightLattice& lattice, std::uint32_t samples)
    : lattice_(lattice),
      samples_(std::max(samples, 1u)),
      rounds_(roundsUpTo(samples_)),
      entries_(lattice.geometry().blockCount()),
      place_(lattice.geometry().blockCount(), kNone) {}

// Each block once, and only texels of the lattice.
std::vector<BlockRequest> BakeQueue::cleaned(std::vector<BlockRequest> blocks) {
  std::size_t kept = 0;
  for (const BlockRequest& wanted : blocks) {
    if (wanted.block >= entries_.size()) continue;
    const auto texels = wanted.texels & texelsWithin(lattice_.geometry(), wanted.block);
    if (texels.none()) continue;
    std::uint32_t& place = place_[wanted.block];
    if (place == kNone) {
      place = static_cast<std::uint32_t>(kept);
      blocks[kept++] = {wanted.block, texels};
    } else {
      blocks[place].texels |= texels;
    }
  }
  blocks.resize(kept);
  for (const BlockRequest& wanted : blocks) place_[wanted.block] = kNone;
  return blocks;
}

void BakeQueue::want(Priority request, std::vector<BlockRequest> blocks) {
  const auto w = static_cast<std::size_t>(request);
  std::vector<BlockRequest> fresh = cleaned(std::move(blocks));
  if (fresh == requests_[w]) return;
  requests_[w].swap(fresh);
  const std::vector<BlockRequest>& old = fresh;

  std::vector<std::uint32_t> changed;  // blocks whose texels are not the same as before
  changed.reserve(requests_[w].size() + old.size());
  std::vector<std::uint32_t> before(requests_[w].size());
  for (std::size_t i = 0; i < before.size(); ++i) before[i] = entries_[requests_[w][i].block].index[w];
  for (const BlockRequest& wanted : old) entries_[wanted.block].index[w] = kNone;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const BlockRequest& wanted = requests_[w][i];
    entries_[wanted.block].index[w] = static_cast<std::uint32_t>(i);
    if (before[i] == kNone || old[before[i]].texels != wanted.texels) changed.push_back(wanted.block);
  }
  for (const BlockRequest& wanted : old)
    if (entries_[wanted.block].index[w] == kNone) changed.push_back(wanted.block);
  for (const std::uint32_t block : changed) count(block);
  fill(w);
  ++generation_;
}

void BakeQueue::setSamples(std::uint32_t samples) {
  samples = std::max(samples, 1u);
  if (samples == samples_) return;
  samples_ = samples;
  rounds_ = roundsUpTo(samples);
  for (std::size_t w = 0; w < kPriorities; ++w) {
    for (const BlockRequest& wanted : requests_[w]) count(wanted.block);
    fill(w);
  }
  ++generation_;
}

// Of the wanted texels that are not known to be without a normal; the largest number if there are none.
std::uint32_t BakeQueue::leastSamples(const BlockRequest& wanted) const {
  const auto block = lattice_.at(wanted.block);
  if (!block) return 0;
  std::uint32_t least = std::numeric_limits<std::uint32_t>::max();
  forEachTexel(wanted.texels & ~block->unlit,
               [&](std::size_t i) { least = std::min(least, block->samples[i]); });
  return least;
}

std::uint32_t BakeQueue::roundAfter(std::uint32_t samples) const {
  return *std::upper_bound(rounds_.begin(), rounds_.end(), samples);
}

void BakeQueue::push(std::size_t request, std::uint32_t index) {
  const std::uint32_t least = leastSamples(requests_[request][index]);
  if (least < samples_) heaps_[request].push({roundAfter(least), index});
}

void BakeQueue::fill(std::size_t request) {
  ++generations_[request];
  std::erase_if(waiting_, [&](const auto& item) { return item.first == request; });
  heaps_[request] = {};
  for (std::uint32_t i = 0; i < requests_[request].size(); ++i) push(request, i);
}

std::optional<BakeQueue::Unit> BakeQueue::take() {
  for (std::size_t w = 0; w < kPriorities; ++w) {
    Heap& heap = heaps_[w];
    while (!heap.empty()) {
      const Item item = heap.top();
      const BlockRequest& wanted = requests_[w][item.index];
      if (entries_[wanted.block].taken) {
        waiting_.emplace_back(w, item.index);
        heap.pop();
        continue;
      }
      // The block may have come further for another request.
      const std::uint32_t least = leastSamples(wanted);
      heap.pop();
      if (least >= samples_) continue;
      const std::uint32_t target = roundAfter(least);
      if (target > item.target) {
        heap.push({target, item.index});
        continue;
      }
      entries_[wanted.block].taken = true;
      ++taken_;
      return Unit{wanted.block, target, wanted.texels, w, generations_[w]};
    }
  }
  return std::nullopt;
}

void BakeQueue::give(const Unit& unit) {
  assert(entries_[unit.block].taken && taken_ > 0);
  entries_[unit.block].taken = false;
  --taken_;
  count(unit.block);
  if (generations_[unit.request] == unit.generation)
    push(unit.request, entries_[unit.block].index[unit.request]);
  std::erase_if(waiting_, [&](const auto& item) {
    const bool freed = requests_[item.first][item.second].block == unit.block;
    if (freed) push(item.first, item.second);
    return freed;
  });
}

void BakeQueue::count(std::uint32_t block) {
  Entry& entry = entries_[block];
  const auto changeTotals = [&](const auto& change) {
    totals_.wanted = change(totals_.wanted, entry.wanted);
    totals_.done = change(totals_.done, entry.done);
    totals_.started = change(totals_.started, entry.started);
    totals_.samplesDone = change(totals_.samplesDone, entry.samplesDone);
    totals_.seen = change(totals_.seen, entry.seen);
    totals_.smooth = change(totals_.smooth, entry.smooth);
  };
  changeTotals(std::minus<std::uint64_t>());
  entry.wanted = entry.done = entry.started = entry.smooth = 0;
  entry.samplesDone = 0;

  std::bitset<kTexelsOfBlock> texels;
  for (std::size_t w = 0; w < kPriorities; ++w)
    if (entry.index[w] != kNone) texels |= requests_[w][entry.index[w]].texels;
  std::bitset<kTexelsOfBlock> seen;
  if (entry.index[0] != kNone) seen = requests_[0][entry.index[0]].texels;
  if (const auto lit = lattice_.at(block)) {
    texels &= ~lit->unlit;
    seen &= ~lit->unlit;
    const std::uint32_t enough = std::min(kSmoothSamples, samples_);
    forEachTexel(seen, [&](std::size_t i) {
      entry.smooth = static_cast<std::uint16_t>(entry.smooth + (lit->samples[i] >= enough));
    });
    forEachTexel(texels, [&](std::size_t i) {
      const std::uint32_t samples = lit->samples[i];
      entry.started = static_cast<std::uint16_t>(entry.started + (samples > 0));
      entry.done = static_cast<std::uint16_t>(entry.done + (samples >= samples_));
      entry.samplesDone += std::min(samples, samples_);
    });
  }
  entry.wanted = static_cast<std::uint16_t>(texels.count());
  entry.seen = static_cast<std::uint16_t>(seen.count());
  changeTotals(std::plus<std::uint64_t>());
}

// Texels never lose samples, so what was fulfilled stays so while the requests are the same.
bool BakeQueue::fulfilled(std::uint32_t samples, Cursor& cursor) const {
  if (cursor.generation != generation_) cursor = {generation_, 0, 0};
  samples = samples == 0 ? samples_ : std::min(samples, samples_);
  for (; cursor.request < kPriorities; ++cursor.request, cursor.index = 0)
    for (; cursor.index < requests_[cursor.request].size(); ++cursor.index)
      if (leastSamples(requests_[cursor.request][cursor.index]) < samples) return false;
  // Only then have all that were at work been counted.
  return samples < samples_ || taken_ == 0;
}

}  // namespace isolux::gi
