// Exports the isosurface as a triangle mesh: how fine, whether closed, and how far it is. Not modal: the
// window stays usable meanwhile. Without the dialog the export stops; its end is not waited for.
#pragma once

#include <functional>
#include <memory>

#include <QDialog>
#include <QLabel>

#include "app/mesh/mesh_export.h"
#include "ui/document/background_task.h"
#include "ui/theme/style.h"
#include "ui/widgets/time_left.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QProgressBar;
class QPushButton;

namespace isolux::ui {

class MeshDialog : public QDialog {
  Q_OBJECT
 public:
  // `resolved` by scene::resolve of that volume, as it is when the dialog is opened.
  MeshDialog(std::shared_ptr<const volume::PreparedVolume> volume, scene::Scene resolved,
             QWidget* parent = nullptr);

  // Asks for the name of the file to begin; empty: cancelled.
  using AskName = std::function<QString()>;
  void setAskName(AskName ask) { ask_ = std::move(ask); }
  void exportTo(const QString& file);  // .stl, .ply, .obj or .vtp
  bool exporting() const { return bool(task_); }
  QString text() const { return text_->text(); }

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
  void showProgress(const QString& name);
  void take(const QString& file, base::Task<volume::SurfaceMesh>& task);
  void tell(const QString& text, Ink ink = Ink::normal);
  scene::Scene chosenScene() const;
  void showEstimate();

  std::shared_ptr<const volume::PreparedVolume> volume_;
  scene::Scene resolved_;
  BackgroundTask<volume::SurfaceMesh> task_;
  glm::dvec3 farthest_{0.0};  // of the last export
  AskName ask_;
  TimeLeft left_;
  QLabel *estimate_, *text_;
};

}  // namespace isolux::ui
