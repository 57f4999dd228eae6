// Adds to sums that several threads share.
#pragma once

#include <atomic>
#include <cstdint>
#include <vector>

namespace isolux::volume {

// For one thread, whose successive amounts mostly belong to the same sum: they are added together when
// another one follows, or at the end.
class RunningSums {
 public:
  explicit RunningSums(std::vector<std::uint64_t>& sums) : sums_(sums) {}
  ~RunningSums() { flush(); }
  RunningSums(const RunningSums&) = delete;
  RunningSums& operator=(const RunningSums&) = delete;

  void add(std::uint32_t index, std::uint64_t amount) {
    if (index != index_) flush();
    index_ = index;
    sum_ += amount;
  }

 private:
  void flush() {
    if (sum_ != 0) std::atomic_ref(sums_[index_]).fetch_add(sum_, std::memory_order_relaxed);
    sum_ = 0;
  }

  std::vector<std::uint64_t>& sums_;
  std::uint32_t index_ = 0;
  std::uint64_t sum_ = 0;
};

}  // namespace isolux::volume
