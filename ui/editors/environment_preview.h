// The light probe or built-in light as it stands around the volume now: an equirectangular picture in the
// world's axes, turned by dragging.
//
// The middle is posterior (+Y), its right side the patient's left (+X), the top superior (+Z). The cross is
// where the viewer looks. Loads it beside the window's thread.
#pragma once

#include <QImage>
#include <QWidget>

#include "app/tasks/probe_task.h"
#include "scene/world_axes.h"
#include "ui/document/background_task.h"
#include "ui/document/edit.h"

namespace isolux::ui {

class EnvironmentPreview : public QWidget {
  Q_OBJECT
 public:
  explicit EnvironmentPreview(QWidget* parent = nullptr);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  void setAxes(scene::WorldAxes axes);              // of the marks along the bottom
  bool hasProbe() const { return !name_.empty(); }  // there is something to show
  bool loaded() const { return !thumbnail_.pixels.empty(); }
  QSize sizeHint() const override { return {300, 150}; }
  bool hasHeightForWidth() const override { return true; }
  int heightForWidth(int width) const override { return width / 2; }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void dragStarted();
  void dragEnded();
  void failed(const QString& message);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent*) override { image_ = {}; }
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void load();
  void take(app::ProbeTask& task);
  void draw();
  QPointF placeOf(glm::dvec3 worldDirection) const;
  void paintMarks(QPainter& painter) const;
  void endDrag();

  scene::Scene scene_, resolved_;
  scene::WorldAxes axes_ = scene::WorldAxes::anatomical;
  std::string name_;  // of what is shown, or on its way; empty: nothing
  app::ProbeThumbnail thumbnail_;
  QString problem_;
  QImage image_;  // null: to be drawn
  BackgroundTask<app::ProbeThumbnail> task_;
  bool dragging_ = false;
  QPointF last_;
};

}  // namespace isolux::ui
