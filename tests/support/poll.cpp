#include "tests/support/poll.h"

#include <chrono>
#include <thread>

namespace isolux::test {

bool pollUntil(const std::function<bool()>& condition, double timeoutSeconds) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeoutSeconds);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace isolux::test
