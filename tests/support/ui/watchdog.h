// How long the window's thread was busy at a time: what tests of a window that never waits read.
#pragma once

#include <chrono>
#include <ctime>
#include <vector>

#include <QAbstractEventDispatcher>
#include <QObject>

namespace isolux::test {

// Measures each turn of this thread's event loop, from waking to going to sleep, while it lives.
class Watchdog : public QObject {
 public:
  Watchdog();

  struct Turn {
    double wall = 0.0;       // milliseconds, of which other programs may have had some
    double processor = 0.0;  // of this thread
  };
  const std::vector<Turn>& turns() const { return turns_; }
  double longestProcessor() const;
  double longestWall() const;
  double wallQuantile(double part) const;

 private:
  void wake();
  void sleep();

  std::chrono::steady_clock::time_point woke_{};
  double processorBefore_ = 0.0;
  bool awake_ = false;
  std::vector<Turn> turns_;
};

}  // namespace isolux::test
