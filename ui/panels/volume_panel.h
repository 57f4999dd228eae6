// What is known about the volume on screen, and the choices its file offers: series, component, time step.
#pragma once

#include <QScrollArea>

#include "ui/document/document.h"
#include "ui/document/edit.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QSpinBox;

namespace isolux::ui {

class SourcePanel;
class WrappedText;

class InfoPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit InfoPanel(QWidget* parent = nullptr);

  void setVolume(VolumePointer volume);
  void setScene(const scene::Scene& scene);
  void setFirstPicture(double seconds);  // since the bytes were read
  QComboBox* seriesChoice() const { return series_; }
  QComboBox* componentChoice() const { return component_; }
  QSpinBox* timeStepChoice() const { return timeStep_; }
  SourcePanel* sourcePanel() const { return source_; }
  QString warnings() const;

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void failed(const QString& message);

 private:
  WrappedText* addRow(const QString& name);
  void showFacts();
  void showChoices();

  scene::Scene scene_;
  VolumePointer volume_;
  QFormLayout *facts_, *choices_;
  WrappedText *name_, *format_, *dims_, *type_, *spacing_, *extent_, *axes_, *range_, *missing_, *memory_;
  WrappedText *time_, *warnings_;
  QLabel* warningTitle_;
  QWidget* choiceBox_;
  QComboBox *series_, *component_;
  QSpinBox* timeStep_;
  SourcePanel* source_;
};

}  // namespace isolux::ui
