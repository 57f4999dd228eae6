// Verdicts on random numbers: mean and variance of a stream, its z value against a known mean, and the limit
// of a chi-squared sum.
#pragma once

#include <cmath>

namespace isolux::test {

// Running mean and variance (Welford 1962).
class Moments {
 public:
  void add(double value) {
    ++count_;
    const double apart = value - mean_;
    mean_ += apart / count_;
    squares_ += apart * (value - mean_);
  }
  double count() const { return count_; }
  double mean() const { return mean_; }
  double variance() const { return squares_ / (count_ - 1); }  // of one value
  double standardError() const { return std::sqrt(variance() / count_); }
  // How many standard errors the mean lies above what is expected; of a constant stream, 0 if it agrees up to
  // rounding, else infinite.
  double z(double expected) const {
    const double error = standardError(), apart = mean_ - expected;
    if (error > 1e-12 * std::abs(expected)) return apart / error;
    return std::abs(apart) <= 1e-6 * std::abs(expected) ? 0.0 : HUGE_VAL;
  }

 private:
  double count_ = 0, mean_ = 0, squares_ = 0;
};

// What a chi-squared sum with this many degrees of freedom exceeds with a probability of about 1e-6 (Wilson &
// Hilferty 1931).
inline double chiSquaredLimit(int degrees) {
  const double t = 2.0 / (9.0 * degrees);
  return degrees * std::pow(1.0 - t + 4.7534 * std::sqrt(t), 3);
}

}  // namespace isolux::test
