// Ranks that are threads of the test: the same protocol without MPI.
#pragma once

#include <algorithm>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>
#include <vector>

#include "app/cluster/ranks.h"

namespace isolux::test {

// What they share.
struct RankHub {
  explicit RankHub(int count) : size(count) {}
  int size;
  std::mutex mutex;
  std::map<int, std::deque<app::RankMessage>> inboxes;
  std::map<int, std::deque<std::vector<std::byte>>> broadcasts;
};

class ThreadRanks : public app::Ranks {
 public:
  ThreadRanks(std::shared_ptr<RankHub> hub, int rank) : hub_(std::move(hub)), rank_(rank) {}

  int rank() const override { return rank_; }
  int size() const override { return hub_->size; }
  void broadcast(std::span<std::byte> bytes, const base::Progress& progress) override {
    if (rank_ == 0) {
      const std::lock_guard lock(hub_->mutex);
      for (int rank = 1; rank < hub_->size; ++rank)
        hub_->broadcasts[rank].emplace_back(bytes.begin(), bytes.end());
      return;
    }
    for (;; std::this_thread::yield()) {
      progress.throwIfStopped();
      const std::lock_guard lock(hub_->mutex);
      auto& waiting = hub_->broadcasts[rank_];
      if (waiting.empty()) continue;
      std::copy(waiting.front().begin(), waiting.front().end(), bytes.begin());
      waiting.pop_front();
      return;
    }
  }
  void send(int to, int kind, std::string bytes) override {
    const std::lock_guard lock(hub_->mutex);
    hub_->inboxes[to].push_back({rank_, kind, std::move(bytes)});
  }
  std::optional<app::RankMessage> next() override {
    const std::lock_guard lock(hub_->mutex);
    auto& inbox = hub_->inboxes[rank_];
    if (inbox.empty()) return std::nullopt;
    app::RankMessage message = std::move(inbox.front());
    inbox.pop_front();
    return message;
  }
  bool allSent() override { return true; }
  void end() override {}

 private:
  std::shared_ptr<RankHub> hub_;
  int rank_;
};

}  // namespace isolux::test
