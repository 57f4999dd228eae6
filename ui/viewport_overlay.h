// What stands over the picture: anatomical letters, orientation cube, scale bar, or why there is no picture.
// Painted by the raster engine, so that letters and lines are crisp at any device pixel ratio.
#pragma once

#include <QWidget>

#include "scene/camera.h"

namespace isolux::ui {

class ViewportOverlay : public QWidget {
  Q_OBJECT
 public:
  explicit ViewportOverlay(QWidget* parent);

  void setCamera(const scene::Camera& camera, bool visible);
  void setProblem(const QString& text);  // empty: none

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paintLetters(QPainter& painter) const;
  void paintCube(QPainter& painter) const;
  void paintScale(QPainter& painter) const;
  void paintProblem(QPainter& painter) const;

  scene::Camera camera_;
  scene::CameraFrame frame_{};
  bool visible_ = false;
  QString problem_;
};

}  // namespace isolux::ui
