// Provides the luminance of linear colours (BT.709) and the sRGB transfer function. Safe from any thread;
// reports no errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace isolux::base {

// Returns the relative luminance (ITU-R BT.709) of any type with members x, y and z, in their precision.
template <class Rgb>
constexpr auto luminance(const Rgb& linear) {
  using Real = std::remove_cvref_t<decltype(linear.x)>;
  return Real(0.2126) * linear.x + Real(0.7152) * linear.y + Real(0.0722) * linear.z;
}

// Apply the sRGB transfer function (IEC 61966-2-1) and its inverse to one channel in [0, 1].
template <class Real>
Real encodeSrgb(Real linear) {
  return linear <= Real(0.0031308) ? Real(12.92) * linear
                                   : Real(1.055) * std::pow(linear, Real(1.0 / 2.4)) - Real(0.055);
}
template <class Real>
Real decodeSrgb(Real encoded) {
  return encoded <= Real(0.04045) ? encoded / Real(12.92)
                                  : std::pow((encoded + Real(0.055)) / Real(1.055), Real(2.4));
}

// Returns one channel as an 8-bit sRGB value; `linear` is clamped to [0, 1].
inline std::uint8_t screenByte(double linear) {
  return static_cast<std::uint8_t>(std::lround(255.0 * encodeSrgb(std::clamp(linear, 0.0, 1.0))));
}

}  // namespace isolux::base
