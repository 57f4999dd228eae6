#include "app/study/study_table.h"

#include <array>
#include <cmath>
#include <cstdio>

namespace isolux::app {

std::string tableNumber(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

std::string markedValue(const StudySetting& setting) {
  return setting.isDefault ? "**" + setting.value + "** (default)" : setting.value;
}

}  // namespace isolux::app
