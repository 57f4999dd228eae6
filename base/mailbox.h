// Passes one value from one thread to another; a newer value replaces one that was not fetched yet.
//
// All operations are lock-free: a thread that is preempted in the middle of a call blocks no other thread.
#pragma once

#include <atomic>
#include <memory>

namespace isolux::base {

template <class Value>
class Mailbox {
 public:
  Mailbox() = default;
  ~Mailbox() { take(); }
  Mailbox(const Mailbox&) = delete;
  Mailbox& operator=(const Mailbox&) = delete;

  // Stores `value` and returns the one that it replaces, so that the caller chooses where that is freed.
  std::unique_ptr<Value> put(std::unique_ptr<Value> value) noexcept {
    return std::unique_ptr<Value>(value_.exchange(value.release(), std::memory_order_acq_rel));
  }
  std::unique_ptr<Value> take() noexcept { return put(nullptr); }  // returns null if empty
  bool empty() const noexcept { return value_.load(std::memory_order_acquire) == nullptr; }

 private:
  std::atomic<Value*> value_{nullptr};
};

}  // namespace isolux::base
