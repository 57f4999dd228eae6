// The isovalue's corner of the window: the histogram with its lines, the exact value, the suggestion; where
// there are several isosurfaces, their list.
#pragma once

#include <QWidget>

#include "ui/document/document.h"
#include "ui/document/edit.h"

class QBoxLayout;
class QLabel;
class QScrollArea;
class QToolButton;

namespace isolux::ui {

class HistogramSlider;
class NumberSpinBox;
class SurfaceList;

class IsovaluePanel : public QWidget {
  Q_OBJECT
 public:
  explicit IsovaluePanel(QWidget* parent = nullptr);

  void setVolume(VolumePointer volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  QToolButton* addButton() const { return add_; }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();
  void dragEnded();

 private:
  void send(std::optional<double> value, const char* mergeKey, bool endsAfterPause);
  void moveSurface(int number, double value, bool endsAfterPause);
  void addSurface(std::optional<double> value);
  void showSurfaces(const scene::Scene& resolved);
  void arrange(bool several);

  scene::Scene scene_;
  VolumePointer volume_;
  HistogramSlider* slider_;
  NumberSpinBox* spinBox_;
  SurfaceList* surfaces_;
  QScrollArea* scroll_;  // of the list
  QLabel* title_;
  QToolButton *add_, *suggest_, *showAll_;
  QBoxLayout* buttons_;
};

}  // namespace isolux::ui
