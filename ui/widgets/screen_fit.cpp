#include "ui/widgets/screen_fit.h"

#include <algorithm>

namespace isolux::ui {

QRect fittedOnScreens(const QRect& window, const QList<QRect>& screens) {
  if (screens.isEmpty()) return window;
  const auto shared = [&](const QRect& screen) {
    const QRect common = screen.intersected(window);
    return static_cast<qint64>(common.width()) * common.height();
  };
  const QRect& screen = *std::max_element(
      screens.begin(), screens.end(), [&](const QRect& a, const QRect& b) { return shared(a) < shared(b); });
  QRect fitted(window.topLeft(), window.size().boundedTo(screen.size()));
  fitted.moveLeft(std::clamp(fitted.left(), screen.left(), screen.left() + screen.width() - fitted.width()));
  fitted.moveTop(std::clamp(fitted.top(), screen.top(), screen.top() + screen.height() - fitted.height()));
  return fitted;
}

}  // namespace isolux::ui
