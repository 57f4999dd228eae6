// What is known about the volume on screen, and the choices its file offers: series, component, time step.
#pragma once

#include "ui/panels/panel.h"
#include "ui/widgets/number_spin_box.h"
#include "ui/widgets/wrapped_text.h"

class QComboBox;
class QFormLayout;
class QLabel;
class QSlider;
class QToolButton;

namespace isolux::ui {

class SourcePanel;

class VolumePanel : public Panel {
  Q_OBJECT
 public:
  explicit VolumePanel(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume) override;
  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  void setFirstPicture(double seconds) override;
  QComboBox* kindChoice() const { return kind_; }
  QComboBox* componentChoice() const { return component_; }
  NumberSpinBox* timeStepChoice() const { return timeStep_; }
  IntegerSpinBox* levelChoice() const { return level_; }
  QSlider* timeSlider() const { return timeSlider_; }
  QToolButton* playButton() const { return play_; }
  NumberSpinBox* speedChoice() const { return speed_; }
  double speed() const { return speed_->value(); }  // of playing, time steps per second
  void setPlaying(bool playing);
  QString warnings() const { return warnings_->text(); }

 Q_SIGNALS:
  void playClicked();
  void speedChanged(double stepsPerSecond);

 private:
  struct Fact {
    QString text, tip = {};  // without a text it is not shown
  };
  void addRow(const QString& name);
  std::vector<Fact> facts() const;  // in the order of values_
  void showFacts();
  void showChoices();

  scene::Scene scene_;
  VolumePointer volume_;
  QFormLayout *facts_, *choices_;
  std::vector<WrappedText*> values_;  // of facts_
  std::optional<double> firstPictureSeconds_;
  WrappedText* warnings_;
  QLabel* warningTitle_;
  QWidget* choiceBox_;
  QComboBox *kind_, *series_, *component_;
  QToolButton* play_;
  NumberSpinBox *timeStep_, *speed_;
  IntegerSpinBox* level_;
  QSlider* timeSlider_;  // the same, where it is let go
  QWidget* timeRow_;
  SourcePanel* source_;
};

}  // namespace isolux::ui
