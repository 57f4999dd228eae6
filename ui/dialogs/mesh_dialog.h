// Exports the isosurface as a triangle mesh: how fine, whether closed, and how far it is. Not modal: the
// window stays usable meanwhile.
#pragma once

#include <functional>
#include <memory>

#include <QDialog>
#include <QTimer>

#include "app/mesh/mesh_job.h"
#include "ui/theme/style.h"
#include "ui/widgets/time_left.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace isolux::ui {

class MeshDialog : public QDialog {
  Q_OBJECT
 public:
  // `resolved` by scene::resolve of that volume, as it is when the dialog is opened.
  MeshDialog(std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene resolved,
             QWidget* parent = nullptr);
  ~MeshDialog() override;  // stops; the end of the work is not waited for

  // Asks for the name of the file to begin; empty: cancelled.
  using AskName = std::function<QString()>;
  void setAskName(AskName ask) { ask_ = std::move(ask); }
  void exportTo(const QString& file);  // .stl, .ply, .obj or .vtp
  bool exporting() const { return job_ && !job_->finished(); }
  QString text() const;

  QComboBox* surface;         // of the isosurfaces that are shown
  QDoubleSpinBox* tolerance;  // mm; 0: triangles are not split
  QCheckBox* closed;
  QPushButton* start;      // also stops
  QPushButton* showPlace;  // where a tolerance is missed: the farthest place
  QProgressBar* bar;

 Q_SIGNALS:
  void exported(const QString& file, const QString& more);
  void placeAsked(const glm::dvec3& worldMm);

 private:
  void startOrStop();
  void poll();
  void tell(const QString& text, Ink ink = Ink::normal);
  scene::Scene chosenScene() const;
  void showEstimate();

  std::shared_ptr<const volume::PreparedVolume> volume_;
  scene::Scene resolved_;
  std::unique_ptr<app::MeshJob> job_;
  AskName ask_;
  TimeLeft left_;
  QLabel *estimate_, *text_;
  QTimer timer_;
};

}  // namespace isolux::ui
