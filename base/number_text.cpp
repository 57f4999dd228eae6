#include "base/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace isolux::base {

namespace {

constexpr int kExactDigits = 17;  // of any double

template <class... Format>
std::string written(Format... format) {
  std::array<char, 64> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), format...).ptr};
}

bool readsBackAs(double value, const std::string& text) {
  double read = 0.0;
  const auto result = std::from_chars(text.data(), text.data() + text.size(), read);
  return result.ec == std::errc() && read == value;
}

}  // namespace

std::string shortText(double value, int significant) {
  std::string text = written(value, std::chars_format::general, std::min(significant, kExactDigits));
  // 100 of two digits is no "1e+02".
  constexpr double plain = 1e6;
  double rounded = 0.0;
  std::from_chars(text.data(), text.data() + text.size(), rounded);
  const bool large = text.find("e+") != std::string::npos && std::abs(rounded) < plain;
  return large ? written(rounded, std::chars_format::fixed, 0) : text;
}

std::string shortestText(double value) {
  return written(value);
}

std::string exactText(double value) {
  const std::string brief = shortText(value);
  return readsBackAs(value, brief) ? brief : shortText(value, kExactDigits);
}

std::string hexText(std::uint64_t value) {
  const std::string digits = written(value, 16);
  return std::string(16 - digits.size(), '0') + digits;
}

}  // namespace isolux::base
