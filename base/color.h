// Linear colours (BT.709): their luminance, and how screens encode them. Any thread; no errors.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>

namespace isolux::base {

// Relative luminance (ITU-R BT.709) of anything with x, y and z, in their precision.
template <class Rgb>
constexpr auto luminance(const Rgb& linear) {
  using Real = std::remove_cvref_t<decltype(linear.x)>;
  return Real(0.2126) * linear.x + Real(0.7152) * linear.y + Real(0.0722) * linear.z;
}

// The sRGB transfer function (IEC 61966-2-1), per component in [0, 1].
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

// One component as a screen takes it; what lies outside [0, 1] is cut off.
inline std::uint8_t screenByte(double linear) {
  return static_cast<std::uint8_t>(std::lround(255.0 * encodeSrgb(std::clamp(linear, 0.0, 1.0))));
}

}  // namespace isolux::base
