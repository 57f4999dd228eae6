// How far the light is: what is stored, per cent, rate, time left, with pause and stop. Lives in the status
// bar and is not there when no light is stored.
#pragma once

#include <QLabel>
#include <QWidget>

#include "app/light/light_controller.h"
#include "ui/widgets/time_left.h"

class QProgressBar;
class QToolButton;

namespace isolux::ui {

class LightStatus : public QWidget {
  Q_OBJECT
 public:
  explicit LightStatus(QWidget* parent = nullptr);

  void setState(const app::LightState& state, bool cancelled);
  QString text() const { return label_->text(); }
  QToolButton* pauseButton() const { return pause_; }  // also goes on
  QToolButton* stopButton() const { return stop_; }

 Q_SIGNALS:
  void paused();
  void goOn();
  void cancelled();

 private:
  QLabel* label_;
  QProgressBar* bar_;
  QToolButton *pause_, *stop_;
  bool halted_ = false;  // the first button goes on
};

// "light 9 % complete" while light is on its way or stopped on it; "" when a picture shows all of it, or has
// none.
QString unfinishedLightText(const app::LightState& state, bool cancelled);

// "Light is being computed: 57 %, 18 s left", or paused, or stopped; "" when none is on its way.
QString unfinishedLightSentence(const app::LightState& state, bool cancelled);

// "1.2 million rays/s": as people read it.
QString rateText(double raysPerSecond);

}  // namespace isolux::ui
