// Runs numbered tasks on a few threads of their own, as many as the system creates; the caller waits.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace isolux::gi {

// Calls body(task) for 0 .. count - 1 until one returns false. Returns true if all returned true. An
// exception of a body ends the other threads after their current task and is rethrown here.
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
      // If the system creates no more threads, the existing ones do the work.
    }
    work();
  }
  if (failure) std::rethrow_exception(failure);
  return going;
}

}  // namespace isolux::gi
