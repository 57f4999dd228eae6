#include "app/cluster/cluster_master.h"

#include <algorithm>
#include <thread>
#include <utility>

#include <nlohmann/json.hpp>

#include "app/version.h"
#include "base/clock.h"
#include "base/error.h"
#include "base/number_text.h"
#include "gi/arithmetic.h"
#include "volume/read/process/wire.h"

namespace isolux::app {

void Pause::after(bool happened) {
  constexpr int least = 100, most = 4000;
  microseconds_ = happened ? 0 : std::clamp(2 * microseconds_, least, most);
  if (microseconds_ > 0) std::this_thread::sleep_for(std::chrono::microseconds(microseconds_));
}

ClusterMaster::ClusterMaster(Ranks& ranks, ClusterLight& light, ClusterHello own, gi::StoredLight finished,
                             Options options)
    : ranks_(ranks),
      light_(light),
      finished_(std::move(finished)),
      options_(options),
      queue_(light.requests().tiles(), ranks.size()),
      peers_(static_cast<std::size_t>(ranks.size())) {
  peers_[0].hello = std::move(own);
  peers_[0].ready = peers_[0].left = true;
}

std::string ClusterMaster::nameOf(int rank) const {
  const std::string& host = peers_[static_cast<std::size_t>(rank)].hello.host;
  const std::string number = "rank " + std::to_string(rank);
  return host.empty() ? number : number + " on " + host;
}

bool ClusterMaster::step() {
  bool happened = false;
  while (const auto message = ranks_.next()) {
    hear(*message);
    happened = true;
  }
  for (const std::uint32_t tile : light_.baker().takeFinished()) {
    finishOwn(tile);
    happened = true;
  }
  return handOut() || happened;
}

void ClusterMaster::hear(const RankMessage& message) {
  RankReport& peer = peers_.at(static_cast<std::size_t>(message.from));
  switch (static_cast<ClusterMessage>(message.kind)) {
    case ClusterMessage::here:
      peer.hello.host = message.bytes;
      return;
    case ClusterMessage::hello:
      return welcome(message.from, messageFrom<ClusterHello>(message.bytes));
    case ClusterMessage::light:
      return takeLight(message.from, messageFrom<TileMessage>(message.bytes));
    case ClusterMessage::bye:
      peer.work = messageFrom<RankWork>(message.bytes);
      peer.left = true;
      return;
    case ClusterMessage::failed: {
      const base::Error error = errorFrom(message.bytes);
      peer.left = true;
      throw base::Error(error.kind(), nameOf(message.from), "", error.what());
    }
    default:
      volume::throwBadAnswer("a message of an unknown kind");
  }
}

// Whatever makes other light is refused before any of it is taken.
void ClusterMaster::welcome(int rank, const ClusterHello& hello) {
  RankReport& peer = peers_[static_cast<std::size_t>(rank)];
  const ClusterHello& own = peers_[0].hello;
  peer.hello = hello;
  const auto refuse = [&](const std::string& reason) { base::throwInput(nameOf(rank), "", reason); };
  if (hello.version != own.version)
    refuse("is Isolux " + hello.version + ", and " + nameOf(0) + " is " + own.version);
  if (hello.volumeHash != own.volumeHash)
    refuse("has another volume than " + nameOf(0) + " (" + base::hexText(hello.volumeHash) + ", not " +
           base::hexText(own.volumeHash) + "); --send-volume sends it from there");
  for (const auto& [theirs, ours] :
       {std::pair(&hello.skyKey, &own.skyKey), std::pair(&hello.lampsKey, &own.lampsKey)})
    if (*theirs != *ours)
      refuse("computes other light than " + nameOf(0) + ": " + gi::keyDifference(*theirs, *ours));
  if (hello.arithmetic != own.arithmetic && !options_.mixArithmetic)
    refuse("computes by \"" + hello.arithmetic + "\", and " + nameOf(0) + " by \"" + own.arithmetic +
           "\": the last bits of the light differ; use --arithmetic no-fma on all ranks, or "
           "--mix-arithmetic, which the file records");
  peer.ready = true;
}

void ClusterMaster::takeLight(int rank, const TileMessage& tile) {
  peers_[static_cast<std::size_t>(rank)].work = tile.work;
  if (tile.tile >= light_.requests().of.size() || light_.requests().of[tile.tile].empty())
    volume::throwBadAnswer("light of an unknown tile");
  if (queue_.finisher(tile.tile)) {
    queue_.drop(tile.tile, rank);
    return compare(rank, tile);
  }
  takeTile(tile, light_.requests().of[tile.tile], finished_);
  queue_.finish(tile.tile, rank);
  dropElsewhere(tile.tile);
}

void ClusterMaster::compare(int rank, const TileMessage& tile) const {
  const int first = *queue_.finisher(tile.tile);
  const auto arithmeticOf = [&](int of) { return peers_[static_cast<std::size_t>(of)].hello.arithmetic; };
  if (arithmeticOf(first) != arithmeticOf(rank)) return;  // last bits may differ, as the user knows
  const TileMessage before = tileMessage(tile.tile, light_.requests().of[tile.tile], finished_);
  if (before.sky == tile.sky && before.lamps == tile.lamps) return;
  base::throwInput(nameOf(rank), "",
                   "has baked tile " + std::to_string(tile.tile) + " to other light than " + nameOf(first) +
                       ": one of these machines computes wrongly");
}

void ClusterMaster::finishOwn(std::uint32_t tile) {
  const TileRequest& request = light_.requests().of[tile];
  if (queue_.finisher(tile)) {
    queue_.drop(tile, 0);
    compare(0, tileMessage(tile, request, light_.working()));
  } else {
    shareTile(request, light_.working(), finished_);
    queue_.finish(tile, 0);
    dropElsewhere(tile);
  }
  light_.baker().forget(tile);
}

void ClusterMaster::dropElsewhere(std::uint32_t tile) {
  for (const int holder : queue_.holders(tile)) {
    queue_.drop(tile, holder);
    if (holder == 0) {
      light_.baker().drop(tile);
      continue;
    }
    TileMessage message;
    message.tile = tile;
    ranks_.send(holder, static_cast<int>(ClusterMessage::drop), bytesOf(message));
  }
}

// Two tiles in hand keep a rank at work while messages travel; a tile that others have, too, is for ranks
// that have nothing.
bool ClusterMaster::handOut() {
  const bool all = std::ranges::all_of(peers_, [](const RankReport& peer) { return peer.ready; });
  if (!all && base::secondsSince(began_) < options_.readySeconds) return false;
  bool given = false;
  if (!firstTileAt_) firstTileAt_ = std::chrono::steady_clock::now();
  for (int rank = 0; rank < ranks_.size(); ++rank) {
    if (!peers_[static_cast<std::size_t>(rank)].ready) continue;
    while (queue_.inHand(rank) < (queue_.anyLeft() ? 2u : 1u)) {
      const std::vector<std::uint32_t> chunk = queue_.take(rank);
      for (const std::uint32_t tile : chunk) give(rank, tile);
      if (chunk.empty()) break;
      given = true;
    }
  }
  return given;
}

void ClusterMaster::give(int rank, std::uint32_t tile) {
  const TileRequest& request = light_.requests().of[tile];
  if (rank == 0) {
    shareTile(request, finished_, light_.working());
    light_.baker().begin(tile);
    return;
  }
  ranks_.send(rank, static_cast<int>(ClusterMessage::work), bytesOf(tileMessage(tile, request, finished_)));
}

double ClusterMaster::seconds() const {
  return firstTileAt_ ? base::secondsSince(*firstTileAt_) : 0.0;
}

double ClusterMaster::fraction() const {
  return queue_.tiles() == 0
             ? 1.0
             : static_cast<double>(queue_.finishedTiles()) / static_cast<double>(queue_.tiles());
}

nlohmann::ordered_json ranksJson(const std::vector<RankReport>& ranks) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const RankReport& rank : ranks)
    list.push_back({{"host", rank.hello.host},
                    {"threads", rank.hello.threads},
                    {"tiles", rank.work.tiles},
                    {"paths", rank.work.paths},
                    {"rays", rank.work.rays},
                    {"seconds", rank.work.seconds},
                    {"idle_share", rank.work.seconds > 0.0 ? rank.work.idleSeconds / rank.work.seconds : 0.0},
                    {"target", rank.hello.target},
                    {"arithmetic", rank.hello.arithmetic},
                    {"answers", rank.left}});
  return list;
}

bool farewellTo(Ranks& ranks, std::vector<RankReport>& peers, double seconds) {
  for (int rank = 1; rank < ranks.size(); ++rank)
    ranks.send(rank, static_cast<int>(ClusterMessage::stop), {});
  const auto begin = std::chrono::steady_clock::now();
  const auto allLeft = [&] {
    return std::ranges::all_of(peers, [](const RankReport& peer) { return peer.left; });
  };
  Pause pause;
  while (!allLeft() && base::secondsSince(begin) < seconds) {
    const auto message = ranks.next();
    if (message) {
      RankReport& peer = peers.at(static_cast<std::size_t>(message->from));
      const auto kind = static_cast<ClusterMessage>(message->kind);
      if (kind == ClusterMessage::bye) peer.work = messageFrom<RankWork>(message->bytes);
      if (kind == ClusterMessage::bye || kind == ClusterMessage::failed) peer.left = true;
    }
    pause.after(message.has_value());
  }
  return allLeft();
}

std::vector<RankReport> ClusterMaster::reports() const {
  std::vector<RankReport> reports = peers_;
  reports[0].work = light_.baker().work();
  return reports;
}

std::string ClusterMaster::arithmetic() const {
  std::string all = peers_[0].hello.arithmetic;
  for (const RankReport& peer : peers_)
    if (peer.ready) all = gi::joinedArithmetic(all, peer.hello.arithmetic);
  return all;
}

}  // namespace isolux::app
