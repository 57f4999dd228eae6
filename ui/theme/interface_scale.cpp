#include "ui/theme/interface_scale.h"

#include <algorithm>

#include <QByteArray>
#include <QtGlobal>

namespace isolux::ui {

void applyInterfaceScale(int percent) {
  constexpr auto variable = "QT_SCALE_FACTOR";
  if (percent == 100 || qEnvironmentVariableIsSet(variable)) return;
  qputenv(variable, QByteArray::number(0.01 * std::clamp(percent, smallestScale, largestScale)));
}

}  // namespace isolux::ui
