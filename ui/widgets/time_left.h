// How long work that has begun will take, from how far it is: "12 s left".
#pragma once

#include <QElapsedTimer>
#include <QString>

namespace isolux::ui {

// "45 s", "12 min", "1.5 h".
QString durationText(double seconds);

class TimeLeft {
 public:
  void begin();
  // `fraction` in [0, 1]; one that falls begins anew. Empty while it cannot be told.
  QString text(double fraction);

 private:
  QElapsedTimer since_;
  double first_ = 0.0, last_ = 0.0;
};

}  // namespace isolux::ui
