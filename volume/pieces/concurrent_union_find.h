// Sets that several threads join at once: union-find without locks, after Jayanti & Tarjan 2016.
//
// Each element points to a smaller one of its set, or to itself. However threads meet, the end is the same:
// the root of a set is its smallest element.
#pragma once

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace isolux::volume {

class ConcurrentUnionFind {
 public:
  explicit ConcurrentUnionFind(std::size_t count) : parent_(count) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = static_cast<std::uint32_t>(i);
  }

  std::size_t count() const { return parent_.size(); }

  std::uint32_t root(std::uint32_t element) {
    for (;;) {
      const std::uint32_t parent = load(element);
      if (parent == element) return element;
      std::uint32_t expected = parent;
      const std::uint32_t grandparent = load(parent);
      if (grandparent != parent)
        std::atomic_ref(parent_[element])
            .compare_exchange_weak(expected, grandparent, std::memory_order_relaxed);
      element = grandparent;
    }
  }

  void join(std::uint32_t a, std::uint32_t b) {
    for (;;) {
      a = root(a);
      b = root(b);
      if (a == b) return;
      if (a < b) std::swap(a, b);
      std::uint32_t expected = a;
      if (std::atomic_ref(parent_[a]).compare_exchange_strong(expected, b, std::memory_order_relaxed)) return;
    }
  }

 private:
  std::uint32_t load(std::uint32_t element) {
    return std::atomic_ref(parent_[element]).load(std::memory_order_relaxed);
  }
  std::vector<std::uint32_t> parent_;
};

}  // namespace isolux::volume
