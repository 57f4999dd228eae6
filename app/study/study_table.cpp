#include "app/study/study_table.h"

#include <cmath>

#include "base/number_text.h"

namespace isolux::app {

std::string tableNumber(double value, int digits) {
  if (!std::isfinite(value)) return "–";
  return base::shortText(value, digits);
}

std::string markedValue(const StudySetting& setting) {
  return setting.isDefault ? "**" + setting.value + "** (default)" : setting.value;
}

}  // namespace isolux::app
