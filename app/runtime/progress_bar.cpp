#include "app/runtime/progress_bar.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <stop_token>
#include <string_view>
#include <system_error>

#include <unistd.h>

#include "base/clock.h"

namespace isolux::app {

namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds silence{400}, period{100};

std::string timeText(double seconds) {
  const auto whole = static_cast<long>(std::ceil(seconds));
  if (whole < 60) return std::to_string(whole) + " s left";
  if (whole < 3600) return std::to_string(whole / 60) + " min " + std::to_string(whole % 60) + " s left";
  return std::to_string(whole / 3600) + " h " + std::to_string(whole % 3600 / 60) + " min left";
}

void drawBar(const base::Progress& progress, const std::stop_token& stop) {
  const Clock::time_point begin = Clock::now();
  std::mutex mutex;
  std::condition_variable_any wake;
  std::unique_lock lock(mutex);
  const auto endsWithin = [&](std::chrono::milliseconds time) {
    return wake.wait_for(lock, stop, time, [&] { return stop.stop_requested(); });
  };
  if (endsWithin(silence)) return;
  do {
    const double elapsed = base::secondsSince(begin);
    const std::string line = progressLine(progress.fraction(), progress.stage(), elapsed);
    std::fprintf(stderr, "\r%s\x1b[K", line.c_str());
    std::fflush(stderr);
  } while (!endsWithin(period));
  std::fputs("\r\x1b[K", stderr);
  std::fflush(stderr);
}

}  // namespace

std::string progressLine(double fraction, const char* stage, double elapsed, int width) {
  const double done = std::isfinite(fraction) ? std::clamp(fraction, 0.0, 1.0) : 0.0;
  const auto filled = static_cast<std::size_t>(done * width);
  std::string percent = std::to_string(static_cast<int>(done * 100.0));
  percent.insert(0, 3 - std::min<std::size_t>(percent.size(), 3), ' ');
  std::string line = "[" + std::string(filled, '#') +
                     std::string(static_cast<std::size_t>(width) - filled, ' ') + "] " + percent + " %";
  if (stage && *stage) line += std::string("  ") + stage;
  if (done > 0.02 && done < 1.0) line += "  " + timeText(elapsed * (1.0 - done) / done);
  return line;
}

ProgressBar::ProgressBar(const base::Progress& progress) {
  const char* const terminal = std::getenv("TERM");
  const bool isDumb = terminal && std::string_view(terminal) == "dumb";  // it cannot clear a line
  if (isDumb || !::isatty(STDERR_FILENO)) return;
  try {
    thread_ = std::jthread([&progress](const std::stop_token& stop) { drawBar(progress, stop); });
  } catch (const std::system_error&) {
    // The system gives no more threads: the work goes on without a bar.
  }
}

}  // namespace isolux::app
