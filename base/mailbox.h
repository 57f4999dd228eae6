// One value on its way from one thread to another: a newer one takes the place of one that was not fetched
// yet.
//
// Nobody waits: a thread that the system has put aside in the middle of a call holds nothing that others
// need.
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

  // Returns what was not fetched, so that the caller chooses where it is freed.
  std::unique_ptr<Value> put(std::unique_ptr<Value> value) noexcept {
    return std::unique_ptr<Value>(value_.exchange(value.release(), std::memory_order_acq_rel));
  }
  std::unique_ptr<Value> take() noexcept { return put(nullptr); }  // null: nothing is there
  bool empty() const noexcept { return value_.load(std::memory_order_acquire) == nullptr; }

 private:
  std::atomic<Value*> value_{nullptr};
};

}  // namespace isolux::base
