#include "base/destroy_in_background.h"

#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <system_error>
#include <thread>

namespace isolux::base {

namespace {

struct Ending {
  std::mutex mutex;
  std::condition_variable changed;
  int count = 0;  // of ends that are under way
};

constexpr double kSecondsAtExit = 2.0;

// Never destroyed: threads may end after the program's statics are gone. exit() gives them some time before
// that.
Ending& ending() {
  static Ending* const all = [] {
    std::atexit([] { awaitDestroyed(kSecondsAtExit); });
    return new Ending;
  }();
  return *all;
}

void ended() {
  // Told with the lock held: a waiter may end the process as soon as it is open.
  const std::lock_guard lock(ending().mutex);
  --ending().count;
  ending().changed.notify_all();
}

}  // namespace

void runInBackground(std::function<void()> end) noexcept {
  {
    const std::lock_guard lock(ending().mutex);
    ++ending().count;
  }
  const auto shared = std::make_shared<std::function<void()>>(std::move(end));
  const auto run = [shared] {
    (*shared)();
    *shared = nullptr;  // what it holds goes before it counts as ended
    ended();
  };
  try {
    std::thread(run).detach();
  } catch (const std::system_error&) {
    run();
  }
}

bool awaitDestroyed(double timeoutSeconds) {
  std::unique_lock lock(ending().mutex);
  return ending().changed.wait_for(lock, std::chrono::duration<double>(timeoutSeconds),
                                   [] { return ending().count == 0; });
}

}  // namespace isolux::base
