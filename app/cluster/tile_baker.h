// Bakes tiles on this rank: in the order in which they are begun, several at a time where the first leaves
// threads without work.
#pragma once

#include <chrono>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "app/cluster/tile_requests.h"
#include "gi/bake/light_bake.h"

namespace isolux::app {

// What a rank has done so far.
struct RankWork {
  std::uint64_t tiles = 0, paths = 0, rays = 0;
  double seconds = 0.0, idleSeconds = 0.0;  // since the baker began; of them with nothing in hand
};

class TileBaker {
 public:
  // Bakes that nobody else asks for anything; either may be null. A tile is finished when each texel that is
  // wanted has `samples`, or has no normal.
  TileBaker(std::shared_ptr<gi::LightBake> sky, std::shared_ptr<gi::LightBake> lamps, TileRequests requests,
            std::uint32_t samples);

  // What the lattices hold of the tile is gone on from.
  void begin(std::uint32_t tile);
  void drop(std::uint32_t tile);  // it is not wanted any more, if it is in hand
  // Tiles that have become finished; they are in the lattices. Throws what ended a bake.
  std::vector<std::uint32_t> takeFinished();
  // Takes a finished or dropped tile out of the lattices.
  void forget(std::uint32_t tile);

  const TileRequest& requestOf(std::uint32_t tile) const { return requests_.of.at(tile); }
  std::size_t inHand() const { return hand_.size(); }
  RankWork work() const;

 private:
  using Clock = std::chrono::steady_clock;
  struct Tile {
    std::uint32_t number = 0;
    std::uint64_t pathsBefore = 0;
    TileRequest left;  // blocks that are not finished
  };
  void want();
  std::uint64_t paths(std::uint32_t tile) const;
  bool finishes(std::vector<gi::BlockRequest>& left, const gi::LightBake* bake) const;
  void noteHand();

  std::shared_ptr<gi::LightBake> sky_, lamps_;
  TileRequests requests_;
  std::uint32_t samples_;
  std::deque<Tile> hand_;
  RankWork work_;
  Clock::time_point began_ = Clock::now(), idleSince_ = began_;
  bool idle_ = true;
};

}  // namespace isolux::app
