// Which rank bakes which tiles: guided chunks (a share of what is left, so that messages are few), then
// single tiles, and in the end the oldest that are not finished a second time, so that nobody waits for a
// rank that is slow or stands still. Knows nothing of light.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <set>
#include <vector>

namespace isolux::app {

class TileQueue {
 public:
  static constexpr std::size_t kMostOfChunk = 64;

  // `tiles` in the order in which they are given out, each once.
  TileQueue(std::vector<std::uint32_t> tiles, int ranks);

  // What this rank is to begin now. While any are left: at least one, at most its share, left / (2 ranks).
  // Then one that others have not finished and this rank has not had: of those that the fewest hold, the one
  // given out first. Empty: none is left for it.
  std::vector<std::uint32_t> take(int rank);
  // The rank has finished the tile. True for the first that has.
  bool finish(std::uint32_t tile, int rank);
  // Ranks that have the tile in hand.
  std::vector<int> holders(std::uint32_t tile) const;
  void drop(std::uint32_t tile, int rank);  // no longer in its hand

  std::size_t inHand(int rank) const { return hands_[static_cast<std::size_t>(rank)].size(); }
  bool anyLeft() const { return !left_.empty(); }  // that nobody was given yet
  bool finished() const { return finished_ == all_; }
  std::size_t finishedTiles() const { return finished_; }
  std::size_t tiles() const { return all_; }
  // The rank whose answer counted; none: it is not finished.
  std::optional<int> finisher(std::uint32_t tile) const;

 private:
  struct Tile {
    std::set<int> had;  // ranks that were ever given it
    int finisher = -1;
  };
  const Tile& at(std::uint32_t tile) const;
  void give(std::uint32_t tile, int rank);

  std::size_t all_, finished_ = 0;
  int ranks_;
  std::deque<std::uint32_t> left_;
  std::deque<std::uint32_t> given_;  // in the order of their first giving, finished ones dropped when seen
  std::vector<Tile> tiles_;          // by number
  std::vector<std::set<std::uint32_t>> hands_;
};

}  // namespace isolux::app
