#include "render/legend/legend.h"

#include <algorithm>
#include <cmath>

#include "base/decimal_text.h"
#include "base/number_text.h"
#include "base/numbers.h"

namespace isolux::render {

namespace {

std::string powerOfTen(int exponent) {
  static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string text = exponent < 0 ? "10⁻" : "10";
  for (const char digit : std::to_string(std::abs(exponent))) text += digits[digit - '0'];
  return text;
}

}  // namespace

std::vector<double> tickValues(double low, double high, int count) {
  if (low > high) std::swap(low, high);
  const double step0 = (high - low) / count;
  // Too narrow for its own magnitude: no two ticks would differ in float's digits.
  if (!(step0 > 1e-7 * std::max(std::fabs(low), std::fabs(high)))) return {0.5 * (low + high)};
  const double step = base::niceAbove(step0);
  std::vector<double> values;
  constexpr double slack = 1e-6;  // a tick at the very end stays in spite of rounding
  for (double i = std::ceil(low / step - slack); i <= high / step + slack; i += 1.0)
    values.push_back(i == 0.0 ? 0.0 : i * step);  // no negative zero
  // One number is no scale. From a count of 5 on, the step is at most half the range, so that two fit.
  return values.size() < 2 ? tickValues(low, high, 2 * count) : values;
}

std::vector<double> logarithmicTicks(double low, double high) {
  constexpr double slack = 1e-9, longRange = 150.0, endsApart = 0.12;
  std::vector<double> values;
  const auto last = static_cast<int>(std::floor(std::log10(high) + slack));
  for (int power = static_cast<int>(std::floor(std::log10(low) + slack)); power <= last; ++power)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double value = digit * std::pow(10.0, power);
      if (digit > 1.0 && high / low > longRange) continue;
      if (value >= low * (1.0 - slack) && value <= high * (1.0 + slack)) values.push_back(value);
    }
  // Its ends, where none of these is near.
  const double apart = std::pow(high / low, endsApart);
  std::vector<double> all;
  all.reserve(values.size() + 2);
  if (values.empty() || values.front() > low * apart) all.push_back(low);
  for (const double value : values) all.push_back(value);
  if (all.back() * apart < high) all.push_back(high);
  return all;
}

bool areShownAsPowers(const std::vector<double>& ticks) {
  constexpr double smallest = 0.00099, largest = 99999.0;
  return !ticks.empty() && (ticks.front() < smallest || ticks.back() > largest);
}

std::string logarithmicTickText(double value, bool asPower) {
  if (!asPower) return base::shortText(value, 3);
  const auto power = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  const std::string digit = base::shortText(value / std::pow(10.0, power), 2);
  return (digit == "1" ? "" : digit + "·") + powerOfTen(power);
}

TickFormat tickFormat(const std::vector<double>& ticks) {
  constexpr double smallest = 1e-3, largest = 1e5;
  double most = 0.0;
  for (const double tick : ticks) most = std::max(most, std::fabs(tick));
  TickFormat format;
  if (most > 0.0 && (most < smallest * 9.99 || most >= largest))
    format.exponent = static_cast<int>(std::floor(std::log10(most) + 1e-9));
  const double scale = std::pow(10.0, format.exponent);
  double step = most / scale;
  for (std::size_t i = 1; i < ticks.size(); ++i) step = std::min(step, (ticks[i] - ticks[i - 1]) / scale);
  const int precise = ticks.size() < 2 ? 2 : 0;  // a lone tick is no round number
  format.decimals =
      step > 0.0 ? std::clamp(precise - static_cast<int>(std::floor(std::log10(step) + 1e-9)), 0, 9) : 0;
  return format;
}

std::string tickText(double value, const TickFormat& format) {
  return (value < 0.0 ? "\u2212" : "") +
         base::fixedText(std::fabs(value) / std::pow(10.0, format.exponent), format.decimals);
}

std::string axisTitle(const std::string& quantity, const std::string& unit, int exponent) {
  const std::string factor = exponent != 0 ? powerOfTen(exponent) : "";
  if (unit.empty() && factor.empty()) return quantity;
  return quantity + " (" + factor + (unit.empty() || factor.empty() ? "" : " ") + unit + ")";
}

}  // namespace isolux::render
