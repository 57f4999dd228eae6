#include "ui/theme/interface_scale.h"

#include <algorithm>

#include <QByteArray>
#include <QtGlobal>

namespace isolux::ui {

namespace {
double scaleOfTexts = 1.0;
}

void applyInterfaceScale(int percent) {
  constexpr auto variable = "QT_SCALE_FACTOR";
  const double scale = 0.01 * std::clamp(percent, smallestScale, largestScale);
  scaleOfTexts = std::min(1.0, scale);
  if (scale > 1.0 && !qEnvironmentVariableIsSet(variable)) qputenv(variable, QByteArray::number(scale));
}

double textScale() {
  return scaleOfTexts;
}

}  // namespace isolux::ui
