#include "app/runtime/thread_limit.h"

#include <algorithm>
#include <cstdlib>
#include <latch>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

#include <tbb/global_control.h>
#include <tbb/info.h>

#include "base/error.h"

namespace isolux::app {

namespace {

// oneTBB, the software driver and the light bake take one thread a core each; watchers and libraries a few.
constexpr int kUsers = 3, kFew = 6;

}  // namespace

int threadsAvailable(int wanted) {
  std::latch over(1);
  std::vector<std::jthread> threads;
  threads.reserve(static_cast<std::size_t>(std::max(wanted, 0)));
  try {
    for (int i = 0; i < wanted; ++i) threads.emplace_back([&] { over.wait(); });
  } catch (const std::system_error&) {
    // That was the last.
  }
  over.count_down();
  return static_cast<int>(threads.size());
}

bool refusesThreads(const std::exception& error) noexcept {
  return std::string_view(error.what()).starts_with("pthread_create has failed");
}

ThreadShare shareThreads() {
  const int cores = std::max(1, tbb::info::default_concurrency());
  const int given = threadsAvailable(kUsers * cores + kFew);
  if (given == kUsers * cores + kFew) return {};
  if (given == 0)  // oneTBB would end the process
    throw base::Error(base::ErrorKind::memory, "", "threads",
                      "cannot create a thread; raise the process limit (ulimit -u)");
  const int share = std::clamp((given - kFew) / kUsers, 0, cores);
  auto limit = std::make_shared<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                     static_cast<std::size_t>(std::max(share, 1)));
  ::setenv("LP_NUM_THREADS", std::to_string(share).c_str(), 1);  // of llvmpipe; 0: it works on the caller's
  return {std::move(limit), "threads: the system provides only " + std::to_string(given) +
                                " more (ulimit -u); Isolux works with " +
                                (share > 1 ? std::to_string(share) : "one")};
}

}  // namespace isolux::app
