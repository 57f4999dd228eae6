#include "ui/widgets/time_left.h"

#include <algorithm>
#include <cmath>

#include <QObject>

#include "ui/language/number_text.h"

namespace isolux::ui {

QString durationText(double seconds) {
  if (!(seconds >= 0.0)) return {};
  if (seconds < 10.0) return numberText(std::max(seconds, 0.1), seconds < 1.0 ? 1 : 2) + " s";
  if (seconds < 100.0) return QString("%1 s").arg(std::lround(seconds));
  if (seconds < 6000.0) return QString("%1 min").arg(std::lround(seconds / 60.0));
  return QString("%1 h").arg(numberText(seconds / 3600.0, 2));
}

void TimeLeft::begin() {
  since_.start();
  first_ = last_ = 0.0;
}

QString TimeLeft::text(double fraction) {
  if (!since_.isValid() || fraction < last_) {
    begin();
    first_ = fraction;
  }
  last_ = fraction;
  constexpr double soonest = 0.8, least = 0.03;  // seconds, and part of the work: before, it would be a guess
  const double seconds = 1e-3 * static_cast<double>(since_.elapsed()), done = fraction - first_;
  if (seconds < soonest || done < least || fraction >= 1.0) return {};
  return QObject::tr("%1 left").arg(durationText(std::max(1.0, seconds * (1.0 - fraction) / done)));
}

}  // namespace isolux::ui
