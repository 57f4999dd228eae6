// Destroys objects in the background if their destruction takes long (threads to join, gigabytes to free).
//
// The caller, such as the window's thread or one that holds a lock, does not wait. Request the object to stop
// first: destroyInBackground() only moves the waiting to another thread. Before the process ends,
// awaitDestroyed() waits for pending destructions, up to a timeout. Safe from any thread.
#pragma once

#include <functional>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace isolux::base {

// Calls `end` soon on another thread, or in this call if the system cannot create a thread. Requires that
// `end` does not throw.
void runInBackground(std::function<void()> end) noexcept;

// Destroys the value on another thread. For a shared pointer, releases this reference there.
template <class Value>
void destroyInBackground(Value value) noexcept {
  auto kept = std::make_shared<Value>(std::move(value));
  // Moved: a copy that stayed here could be the last reference.
  runInBackground([kept = std::move(kept)]() mutable { kept.reset(); });
}

// Waits until everything retired so far is destroyed. Returns false at the timeout [s]: threads still run,
// and the process should exit without static destructors (std::_Exit).
bool awaitDestroyed(double timeoutSeconds);

// A thread and the data that it shares with its owner. Its destructor destroys both in the background;
// request the work to stop before. If the system cannot create a thread, the constructor does the work.
template <class Data>
class BackgroundThread {
 public:
  // Runs work(data) on the thread. Requires that it does not throw.
  template <class Work>
  BackgroundThread(std::shared_ptr<Data> data, Work work) : data_(std::move(data)) {
    try {
      thread_ = std::jthread([kept = data_, work] { work(*kept); });
    } catch (const std::system_error&) {
      work(*data_);
    }
  }
  ~BackgroundThread() { destroyInBackground(std::pair(std::move(data_), std::move(thread_))); }
  BackgroundThread(const BackgroundThread&) = delete;
  BackgroundThread& operator=(const BackgroundThread&) = delete;

  Data* operator->() const { return data_.get(); }

 private:
  std::shared_ptr<Data> data_;
  std::jthread thread_;
};

}  // namespace isolux::base
