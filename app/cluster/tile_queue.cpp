#include "app/cluster/tile_queue.h"

#include <algorithm>

namespace isolux::app {

TileQueue::TileQueue(std::vector<std::uint32_t> tiles, int ranks)
    : all_(tiles.size()), ranks_(ranks), left_(tiles.begin(), tiles.end()) {
  const auto last = std::ranges::max_element(tiles);
  tiles_.resize(last == tiles.end() ? 0 : std::size_t{*last} + 1);
  hands_.resize(static_cast<std::size_t>(ranks));
}

const TileQueue::Tile& TileQueue::at(std::uint32_t tile) const {
  return tiles_.at(tile);
}

void TileQueue::give(std::uint32_t tile, int rank) {
  tiles_[tile].had.insert(rank);
  hands_[static_cast<std::size_t>(rank)].insert(tile);
}

std::vector<std::uint32_t> TileQueue::take(int rank) {
  std::vector<std::uint32_t> chunk;
  if (!left_.empty()) {
    const std::size_t share = left_.size() / (2 * static_cast<std::size_t>(ranks_));
    const std::size_t count = std::clamp<std::size_t>(share, 1, kMostOfChunk);
    for (std::size_t i = 0; i < count; ++i) {
      chunk.push_back(left_.front());
      given_.push_back(left_.front());
      left_.pop_front();
      give(chunk.back(), rank);
    }
    return chunk;
  }
  std::erase_if(given_, [this](std::uint32_t tile) { return at(tile).finisher >= 0; });
  std::optional<std::uint32_t> best;
  for (const std::uint32_t tile : given_) {
    if (at(tile).had.contains(rank)) continue;
    if (!best || at(tile).had.size() < at(*best).had.size()) best = tile;
  }
  if (!best) return chunk;
  give(*best, rank);
  chunk.push_back(*best);
  return chunk;
}

bool TileQueue::finish(std::uint32_t tile, int rank) {
  drop(tile, rank);
  Tile& one = tiles_.at(tile);
  if (one.finisher >= 0) return false;
  one.finisher = rank;
  ++finished_;
  return true;
}

std::vector<int> TileQueue::holders(std::uint32_t tile) const {
  std::vector<int> ranks;
  for (const int rank : at(tile).had)
    if (hands_[static_cast<std::size_t>(rank)].contains(tile)) ranks.push_back(rank);
  return ranks;
}

void TileQueue::drop(std::uint32_t tile, int rank) {
  hands_[static_cast<std::size_t>(rank)].erase(tile);
}

std::optional<int> TileQueue::finisher(std::uint32_t tile) const {
  const int rank = at(tile).finisher;
  return rank < 0 ? std::nullopt : std::optional(rank);
}

}  // namespace isolux::app
