// Measures the speed of a bake over its last two seconds of work.
#pragma once

#include <cstdint>
#include <deque>

namespace isolux::gi {

class BakeRate {
 public:
  // Records the totals at `seconds` of work (without pauses). Cheap: most calls only compare the time.
  void note(double seconds, std::uint64_t rays, std::uint64_t paths);
  double raysPerSecond() const { return per(last_.rays - first().rays); }
  double pathsPerSecond() const { return per(last_.paths - first().paths); }

 private:
  static constexpr double kWindow = 2.0, kStep = 0.1;  // seconds
  struct Mark {
    double seconds = 0.0;
    std::uint64_t rays = 0, paths = 0;
  };
  Mark first() const { return marks_.empty() ? Mark{} : marks_.front(); }
  double per(std::uint64_t count) const {
    const double seconds = last_.seconds - first().seconds;
    return seconds > 0.0 ? static_cast<double>(count) / seconds : 0.0;
  }
  std::deque<Mark> marks_{{}};  // the first is the last one older than the window
  Mark last_;
};

}  // namespace isolux::gi
