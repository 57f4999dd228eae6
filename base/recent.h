// Caches the results of recent requests and evicts entries when memory runs out.
#pragma once

#include <algorithm>
#include <cstddef>
#include <mutex>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.h"

namespace isolux::base {

// Returns make(). If that throws Error{memory}, calls forget() and tries again. forget() evicts one entry and
// returns whether there was one. Throws the error if nothing is left to evict.
template <class Make, class Forget>
auto madeWithRoom(const Make& make, const Forget& forget) {
  for (;;) try {
      return make();
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::memory || !forget()) throw;
    }
}

// Keeps the `most` entries that were requested last. All members are safe from any thread and never wait for
// the computation of another thread, which may be stopped.
template <class Key, class Value>
class Recent {
 public:
  explicit Recent(std::size_t most = 1) : most_(most) {}

  // Keeps at least so many from now on.
  void keepAtLeast(std::size_t most) {
    const std::lock_guard lock(mutex_);
    most_ = std::max(most_, most);
  }

  // Returns nullopt if the entry is not kept.
  std::optional<Value> find(const Key& key) {
    const std::lock_guard lock(mutex_);
    return found(key);
  }

  // Returns the entry; computes it as make() if it is not kept. Evicts before it computes, so that never more
  // than `most` take memory, and again while make() throws Error{memory}. If two threads compute the same
  // entry at the same time, both return the first result.
  template <class Make>
  Value get(const Key& key, const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      if (std::optional<Value> kept = found(key)) return std::move(*kept);
      leaveRoom();
    }
    Value made = madeWithRoom(make, [this] { return forgetOldest(); });
    const std::lock_guard lock(mutex_);
    if (std::optional<Value> kept = found(key)) return std::move(*kept);
    leaveRoom();
    entries_.emplace_back(key, made);
    return made;
  }

  // Returns false if no entry is kept.
  bool forgetOldest() {
    const std::lock_guard lock(mutex_);
    if (entries_.empty()) return false;
    entries_.erase(entries_.begin());
    return true;
  }

  bool empty() const {
    const std::lock_guard lock(mutex_);
    return entries_.empty();
  }

 private:
  using Entry = std::pair<Key, Value>;

  std::optional<Value> found(const Key& key) {
    const auto at = std::ranges::find(entries_, key, &Entry::first);
    if (at == entries_.end()) return std::nullopt;
    std::rotate(at, at + 1, entries_.end());
    return entries_.back().second;
  }
  void leaveRoom() {
    if (entries_.size() >= most_) entries_.erase(entries_.begin());
  }

  std::size_t most_;
  mutable std::mutex mutex_;    // held for moments
  std::vector<Entry> entries_;  // the one requested last is last
};

// Keeps one value that is computed at the first request: find({}), get({}, make).
template <class Value>
using Once = Recent<std::monostate, Value>;

}  // namespace isolux::base
