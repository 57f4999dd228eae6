// Lets what takes long to end - threads to join, gigabytes to free - end on a thread of its own, so that
// whoever is done with it (the window's thread, or one that holds a lock) does not wait.
//
// Ask it to stop first: retire() only takes the waiting off the caller's hands. Before the process ends, what
// is still ending is waited for, but not for ever: awaitRetired(). Safe from any thread.
#pragma once

#include <functional>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace isolux::base {

// Calls `end` soon on another thread; here, if the system has no thread to give. `end` must not throw.
void endElsewhere(std::function<void()> end) noexcept;

// Destroys the value on another thread. For a shared one: gives up this reference there.
template <class Value>
void retire(Value value) noexcept {
  auto kept = std::make_shared<Value>(std::move(value));
  // Moved: a reference that stayed here could be the last one.
  endElsewhere([kept = std::move(kept)]() mutable { kept.reset(); });
}

// Waits until everything retired so far has ended; false at the timeout, when the process should leave
// without its static destructors (std::_Exit), because threads still run.
bool awaitRetired(double timeoutSeconds);

// A thread and the data that it shares with its owner. When the owner is done with them, both end elsewhere:
// ask the work to stop before. Where the system has no thread to give, the work is done by the constructor.
template <class Data>
class RetiringThread {
 public:
  // work(data) must not throw.
  template <class Work>
  RetiringThread(std::shared_ptr<Data> data, Work work) : data_(std::move(data)) {
    try {
      thread_ = std::jthread([kept = data_, work] { work(*kept); });
    } catch (const std::system_error&) {
      work(*data_);
    }
  }
  ~RetiringThread() { retire(std::pair(std::move(data_), std::move(thread_))); }
  RetiringThread(const RetiringThread&) = delete;
  RetiringThread& operator=(const RetiringThread&) = delete;

  Data* operator->() const { return data_.get(); }

 private:
  std::shared_ptr<Data> data_;
  std::jthread thread_;
};

}  // namespace isolux::base
