// Windows that were placed on screens that may be others by now.
#pragma once

#include <QList>
#include <QRect>

namespace isolux::ui {

// The rectangle moved and made smaller until it lies on the screen that it shares most with; on the first
// where it lies on none. `screens`: what each has room for; none: it stays. One that fits stays as it is.
QRect fittedOnScreens(const QRect& window, const QList<QRect>& screens);

}  // namespace isolux::ui
