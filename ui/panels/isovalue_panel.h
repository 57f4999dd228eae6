// The isovalue's corner of the window: the histogram with its line, the exact value, the suggestion.
#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/edit.h"

class QLabel;
class QToolButton;

namespace isolux::ui {

class HistogramSlider;
class NumberSpinBox;

class IsovaluePanel : public QWidget {
  Q_OBJECT
 public:
  explicit IsovaluePanel(QWidget* parent = nullptr);

  void setVolume(VolumePointer volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  HistogramSlider* slider() const { return slider_; }
  NumberSpinBox* spinBox() const { return spinBox_; }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();
  void dragEnded();

 private:
  void send(std::optional<double> value, const char* mergeKey, bool endsAfterPause);

  scene::Scene scene_;
  VolumePointer volume_;
  HistogramSlider* slider_;
  NumberSpinBox* spinBox_;
  QToolButton *suggest_, *showAll_;
};

}  // namespace isolux::ui
