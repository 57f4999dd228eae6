#include "tests/support/ui/watchdog.h"

#include <algorithm>

namespace isolux::test {

namespace {

double processorMilliseconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

}  // namespace

Watchdog::Watchdog() {
  const QAbstractEventDispatcher* const dispatcher = QAbstractEventDispatcher::instance();
  connect(dispatcher, &QAbstractEventDispatcher::awake, this, &Watchdog::wake);
  connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, &Watchdog::sleep);
}

// Nested loops wake within a turn: it goes on.
void Watchdog::wake() {
  if (awake_) sleep();
  awake_ = true;
  woke_ = std::chrono::steady_clock::now();
  processorBefore_ = processorMilliseconds();
}

void Watchdog::sleep() {
  if (!awake_) return;
  awake_ = false;
  const double wall =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - woke_).count();
  turns_.push_back({wall, processorMilliseconds() - processorBefore_});
}

double Watchdog::longestProcessor() const {
  double longest = 0.0;
  for (const Turn& turn : turns_) longest = std::max(longest, turn.processor);
  return longest;
}

double Watchdog::longestWall() const {
  return wallQuantile(1.0);
}

double Watchdog::wallQuantile(double part) const {
  if (turns_.empty()) return 0.0;
  std::vector<double> walls;
  walls.reserve(turns_.size());
  for (const Turn& turn : turns_) walls.push_back(turn.wall);
  std::sort(walls.begin(), walls.end());
  return walls[static_cast<std::size_t>(part * static_cast<double>(walls.size() - 1))];
}

}  // namespace isolux::test
