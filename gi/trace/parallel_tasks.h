// Numbered tasks on a few threads of their own, as many as the system gives; the caller waits.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace isolux::gi {

// Calls body(task) for 0 .. count - 1 until one returns false. True when all returned true. What a body
// throws is thrown here, and ends the others after what they are at.
template <class Body>
bool runTasks(std::size_t count, int threads, const Body& body) {
  std::atomic<std::size_t> next{0};
  std::atomic<bool> going{true};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto work = [&] {
    try {
      while (going.load(std::memory_order_relaxed)) {
        const std::size_t task = next.fetch_add(1, std::memory_order_relaxed);
        if (task >= count) return;
        if (!body(task)) going = false;
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      going = false;
    }
  };
  {
    std::vector<std::jthread> others;
    try {
      for (int i = 1; i < threads && static_cast<std::size_t>(i) < count; ++i) others.emplace_back(work);
    } catch (const std::system_error&) {
      // The system gives no more: those that there are do the work.
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return going;
}

}  // namespace isolux::gi
