#include "app/cluster/tile_baker.h"

#include <algorithm>
#include <array>
#include <exception>
#include <utility>

#include "app/cluster/tile_bytes.h"

namespace isolux::app {

namespace {

bool isFinished(const gi::LightLattice& lattice, const gi::BlockRequest& wanted, std::uint32_t samples) {
  const auto block = lattice.at(wanted.block);
  if (!block) return false;
  const auto texels = wanted.texels & ~block->unlit;
  for (std::size_t i = 0; i < texels.size(); ++i)
    if (texels[i] && block->samples[i] < samples) return false;
  return true;
}

}  // namespace

TileBaker::TileBaker(std::shared_ptr<gi::LightBake> sky, std::shared_ptr<gi::LightBake> lamps,
                     TileRequests requests, std::uint32_t samples)
    : sky_(std::move(sky)), lamps_(std::move(lamps)), requests_(std::move(requests)), samples_(samples) {}

void TileBaker::begin(std::uint32_t tile) {
  hand_.push_back({tile, paths(tile), requestOf(tile)});
  noteHand();
  want();
}

void TileBaker::drop(std::uint32_t tile) {
  if (std::erase_if(hand_, [&](const Tile& one) { return one.number == tile; }) == 0) return;
  noteHand();
  want();
}

// The first tile before the second, that before the third, and those before the rest.
void TileBaker::want() {
  for (const bool ofSky : {true, false}) {
    const std::shared_ptr<gi::LightBake>& bake = ofSky ? sky_ : lamps_;
    if (!bake) continue;
    std::array<std::vector<gi::BlockRequest>, 4> requests;
    for (std::size_t i = 0; i < hand_.size(); ++i) {
      const TileRequest& tile = requestOf(hand_[i].number);
      const std::vector<gi::BlockRequest>& blocks = ofSky ? tile.sky : tile.lamps;
      std::vector<gi::BlockRequest>& to = requests[std::min<std::size_t>(i, requests.size() - 1)];
      to.insert(to.end(), blocks.begin(), blocks.end());
    }
    for (std::size_t w = 0; w < requests.size(); ++w)
      bake->want(static_cast<gi::Priority>(w), std::move(requests[w]));
    bake->waitFor(0, 0.0);  // it has taken them: what is not among them may be forgotten
  }
}

std::uint64_t TileBaker::paths(std::uint32_t tile) const {
  const TileRequest& request = requestOf(tile);
  return (sky_ ? pathsOf(*sky_->lattice(), request.sky) : 0) +
         (lamps_ ? pathsOf(*lamps_->lattice(), request.lamps) : 0);
}

bool TileBaker::finishes(std::vector<gi::BlockRequest>& left, const gi::LightBake* bake) const {
  if (!bake) return true;
  while (!left.empty() && isFinished(*bake->lattice(), left.back(), samples_)) left.pop_back();
  return left.empty();
}

std::vector<std::uint32_t> TileBaker::takeFinished() {
  for (const auto& bake : {sky_, lamps_})
    if (bake)
      if (const std::exception_ptr failed = bake->failure()) std::rethrow_exception(failed);
  std::vector<std::uint32_t> finished;
  std::erase_if(hand_, [&](Tile& tile) {
    const bool sky = finishes(tile.left.sky, sky_.get()), lamps = finishes(tile.left.lamps, lamps_.get());
    if (!sky || !lamps) return false;
    finished.push_back(tile.number);
    ++work_.tiles;
    work_.paths += paths(tile.number) - tile.pathsBefore;
    return true;
  });
  if (finished.empty()) return finished;
  noteHand();
  want();
  return finished;
}

void TileBaker::forget(std::uint32_t tile) {
  const TileRequest& request = requestOf(tile);
  for (const gi::BlockRequest& wanted : request.sky)
    if (sky_) sky_->lattice()->share(wanted.block, nullptr);
  for (const gi::BlockRequest& wanted : request.lamps)
    if (lamps_) lamps_->lattice()->share(wanted.block, nullptr);
}

void TileBaker::noteHand() {
  const Clock::time_point now = Clock::now();
  if (idle_) work_.idleSeconds += std::chrono::duration<double>(now - idleSince_).count();
  idle_ = hand_.empty();
  idleSince_ = now;
}

RankWork TileBaker::work() const {
  RankWork work = work_;
  const Clock::time_point now = Clock::now();
  work.seconds = std::chrono::duration<double>(now - began_).count();
  if (idle_) work.idleSeconds += std::chrono::duration<double>(now - idleSince_).count();
  for (const auto& bake : {sky_, lamps_})
    if (bake) work.rays += bake->counters().rays;
  return work;
}

}  // namespace isolux::app
