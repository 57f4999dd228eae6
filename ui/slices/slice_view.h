// One slice of the volume: shows it with the crosshair, and turns the mouse into edits.
//
// Left click or drag moves slice.position, the wheel by a voxel across the slice; right drag changes
// slice.width (to the sides) and slice.level (up and down), a right click offers windows and one more
// isosurface of the value there; Ctrl+wheel zooms about the pointer, a double click shows the whole again.
//
// Pictures are drawn by a thread (app/jobs/slice_job.h): of changes while one is drawn only the newest is
// drawn next, and until it is there the last one stays.
#pragma once

#include <memory>
#include <optional>

#include <QImage>
#include <QPointF>
#include <QTimer>
#include <QWidget>

class QMenu;

#include "app/jobs/slice_job.h"
#include "scene/scene.h"
#include "ui/document/document.h"
#include "ui/document/edit.h"
#include "volume/statistics/grey_window.h"

namespace isolux::ui {

class SliceView : public QWidget {
  Q_OBJECT
 public:
  explicit SliceView(volume::SliceDirection direction, QWidget* parent = nullptr);
  ~SliceView() override;

  void setVolume(const VolumePointer& volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);

  volume::SliceDirection direction() const { return direction_; }
  // In pixels of the screen, as it is drawn now or will be next; none without a volume.
  std::optional<volume::SlicePlane> plane() const;
  glm::dvec3 position() const;  // where the slices meet, world mm
  QPointF placeOf(glm::dvec3 world) const;
  const QImage& shown() const { return image_; }  // without the crosshair
  bool complete() const { return drawn_ && order() == *drawn_; }

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void gestureEnded();
  void failed(const QString& message);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;

 private:
  enum class Drag { none, position, window };
  volume::SliceFrame frame() const;
  std::optional<app::SliceOrder> order() const;
  glm::dvec3 worldAt(QPointF place) const;
  void orderNew();
  void paintCrosshair(QPainter& painter) const;
  void poll();
  void moveTo(QPointF place);
  void dragWindow(QPointF step);
  void zoom(QPointF place, double factor);
  void offerSurface(QMenu* menu, QPointF place);
  void offerWindows(QPointF at, QPoint place);
  void sendWindow(double level, double width, const char* mergeKey);
  volume::GreyWindow window() const;

  const volume::SliceDirection direction_;
  VolumePointer volume_;
  scene::Scene scene_, resolved_;
  double zoom_ = 1.0;
  glm::dvec3 middle_{0.0};  // of what is shown, mm, where zoomed
  std::unique_ptr<app::SliceJob> job_;
  std::optional<app::SliceOrder> drawn_;
  QImage image_;
  QTimer timer_;
  Drag drag_ = Drag::none;
  bool moved_ = false;
  QPointF last_;
  double steps_ = 0.0;  // of the wheel, not yet taken
};

}  // namespace isolux::ui
