// Rank 0's side of a bake over ranks: hands out tiles, takes their light, and bakes some itself.
#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "app/cluster/cluster_light.h"
#include "app/cluster/ranks.h"
#include "app/cluster/tile_queue.h"

namespace isolux::app {

struct RankReport {
  ClusterHello hello;
  RankWork work;
  bool ready = false;  // it has said hello
  bool left = false;   // it has said goodbye, or is rank 0
};

// A list for --stats: host, threads, tiles, paths, rays, seconds, idle share, instructions.
nlohmann::ordered_json ranksJson(const std::vector<RankReport>& ranks);

// Tells all to stop, and waits for their goodbyes; false where some do not answer within `seconds`.
bool farewellTo(Ranks& ranks, std::vector<RankReport>& peers, double seconds);

class ClusterMaster {
 public:
  struct Options {
    bool mixArithmetic = false;
    double readySeconds = 30.0;  // then those that are ready begin without the others
  };
  // `finished` holds what there is of the light, and takes what is baked. All must stay.
  ClusterMaster(Ranks& ranks, ClusterLight& light, ClusterHello own, gi::StoredLight finished,
                Options options);

  // Hears what has come and hands out what it can; true if anything has happened. Throws base::Error naming
  // the host: that of a rank that has ended, {input} of another volume, light, program or arithmetic, or of a
  // tile that two ranks have baked to different light.
  bool step();
  double seconds() const;  // since the first tile was handed out
  bool isFinished() const { return queue_.finished(); }
  double fraction() const;

  bool farewell(double seconds) { return farewellTo(ranks_, peers_, seconds); }
  std::vector<RankReport> reports() const;
  std::string nameOf(int rank) const;  // "rank 2 on HOST"
  // That of all ranks that have lit anything.
  std::string arithmetic() const;

 private:
  void hear(const RankMessage& message);
  void welcome(int rank, const ClusterHello& hello);
  void takeLight(int rank, const TileMessage& tile);
  void compare(int rank, const TileMessage& tile) const;
  void finishOwn(std::uint32_t tile);
  void dropElsewhere(std::uint32_t tile);
  bool handOut();
  void give(int rank, std::uint32_t tile);

  Ranks& ranks_;
  ClusterLight& light_;
  gi::StoredLight finished_;
  Options options_;
  TileQueue queue_;
  std::vector<RankReport> peers_;
  std::chrono::steady_clock::time_point began_ = std::chrono::steady_clock::now();
  std::optional<std::chrono::steady_clock::time_point> firstTileAt_;
};

// Sleeps a little, longer the longer nothing has happened (up to 4 ms).
class Pause {
 public:
  void after(bool happened);

 private:
  int microseconds_ = 0;
};

}  // namespace isolux::app
