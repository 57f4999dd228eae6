// Words of study.md that its tables share.
#pragma once

#include <string>

#include "app/study/study.h"

namespace isolux::app {

// "0.0123"; "–" for what is not finite.
std::string tableNumber(double value, int digits = 3);
// The value, marked where it is the default.
std::string markedValue(const StudySetting& setting);

}  // namespace isolux::app
