// What accuracy costs: error against time for each quality setting that acts in the scene, of the volume and
// view on show.
//
// Measured on a background thread while the panel is seen and the window draws nothing; dropped and begun
// anew when the view or the scene changes. With the panel closed nothing of it runs.
#pragma once

#include <map>
#include <memory>
#include <string>

#include <QTimer>

#include "app/jobs/study_job.h"
#include "ui/panels/panel.h"

class QComboBox;
class QLabel;

namespace isolux::ui {

class AccuracyChart;

class AccuracyPanel : public Panel {
  Q_OBJECT
 public:
  explicit AccuracyPanel(QWidget* parent = nullptr);

  void setVolume(const VolumePointer& volume) override;
  void setScene(const scene::Scene& scene, const scene::Scene& resolved) override;
  void setDrawing(bool draws);  // the window's own picture comes first

  QComboBox* knobBox() const { return knobs_; }
  const AccuracyChart& chart() const { return *chart_; }
  QString state() const;
  bool complete() const;  // every knob that acts is measured, of the present scene
  bool working() const { return job_ != nullptr; }
  int jobsBegun() const { return jobsBegun_; }

 protected:
  void paintEvent(QPaintEvent* event) override;
  void hideEvent(QHideEvent* event) override;

 private:
  struct Measured {
    app::KnobStudy study;
    scene::Scene of;  // what it was measured of, without what knobs turn
  };
  bool isSeen() const;
  void listKnobs();
  std::vector<app::Knob> missing() const;
  void measureSoon();
  void measure();
  void drop();
  void poll();
  void showKnob();
  void showState();
  void choose(const QString& value);
  const app::Knob* knob() const;  // the one in the box; null: none acts

  VolumePointer volume_;
  scene::Scene scene_, subject_;  // subject_: the scene without what knobs turn
  std::vector<app::Knob> acting_;
  std::map<std::string, Measured> measured_;  // by the knob's name
  std::unique_ptr<app::StudyJob> job_;
  QString trouble_;
  bool drawing_ = false;
  int jobsBegun_ = 0;
  QTimer restTimer_, pollTimer_;

  QComboBox* knobs_;
  AccuracyChart* chart_;
  QLabel *state_, *meaning_, *key_;
};

}  // namespace isolux::ui
