// Provides the smallest interval, or box, that holds what was added to it.
#pragma once

#include <limits>

#include <glm/common.hpp>

namespace isolux::volume {

// T: a floating-point number, or a vector of them. NaN changes nothing; low > high: nothing was added.
template <class T>
struct Bounds {
  T low = T(std::numeric_limits<float>::infinity()), high = -low;

  void add(const T& value) {
    low = glm::min(low, value);
    high = glm::max(high, value);
  }
  void add(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  T size() const { return high - low; }
};

}  // namespace isolux::volume
