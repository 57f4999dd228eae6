// One slice of the volume: shows it with the lines of the other slices, and turns mouse and keys into edits.
//
// Left click or drag moves slice.position, the wheel by a voxel across the slice; right drag changes
// slice.width (to the sides) and slice.level (up and down), a right click opens a menu; Ctrl+wheel zooms
// about the pointer, middle or Shift+left drag pans, a double click shows the whole again. With the focus:
// arrows move the position by a voxel, with Shift they pan; page keys step across, + and - zoom.
//
// It shows the plane that its user has chosen (app/slices/slice_choice.h): across an axis, oblique, or one of
// the cuts; one that shows a cut moves it by the wheel.
//
// Pictures are drawn by a thread (app/tasks/slice_task.h): of changes while one is drawn only the newest is
// drawn next, and until it is there the last one stays. During a gesture, where full pictures take long,
// drafts are drawn.
#pragma once

#include <optional>

#include <QColor>
#include <QImage>
#include <QPointF>
#include <QWidget>

#include "app/slices/slice_choice.h"
#include "app/tasks/slice_task.h"
#include "scene/scene.h"
#include "ui/document/background_task.h"
#include "ui/document/document.h"
#include "ui/document/edit.h"
#include "volume/statistics/grey_window.h"

class QMenu;

namespace isolux::ui {

struct PlaneOfView {
  app::ChosenPlane plane;
  QColor color;
};

class SliceView : public QWidget {
  Q_OBJECT
 public:
  // Shows this direction until another plane is chosen; color: of its plane in the other views.
  SliceView(volume::SliceDirection direction, QColor color, QWidget* parent = nullptr);
  void setVolume(const VolumePointer& volume);
  void setScene(const scene::Scene& scene, const scene::Scene& resolved);
  void setInteracting(bool interacting);            // a gesture is on its way, here or elsewhere
  void setOthers(std::vector<PlaneOfView> others);  // whose lines are drawn

  void choose(const app::SliceChoice& choice);
  // A cut that the scene has no more is the direction again.
  app::SliceChoice choice() const;
  volume::SliceDirection direction() const { return direction_; }
  std::optional<PlaneOfView> planeOfView() const;  // none without a volume

  // In pixels of the screen, as it is drawn now or will be next; none without a volume.
  std::optional<volume::SlicePlane> plane() const;
  glm::dvec3 position() const;  // where the slices meet, world mm
  QPointF placeOf(glm::dvec3 world) const;
  const QImage& shown() const { return image_; }  // without the crosshair
  bool complete() const { return drawn_ && order() == *drawn_; }

  const VolumePointer& volume() const { return volume_; }
  const scene::Scene& scene() const { return scene_; }
  void showWhole();

 Q_SIGNALS:
  void edited(const isolux::ui::Edit& edit);
  void gestureBegan();
  void gestureEnded();
  void chosen();  // another plane
  void failed(const QString& message);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent*) override { orderNew(); }
  void showEvent(QShowEvent*) override { orderNew(); }
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  enum class Drag { none, position, window, pan };
  std::optional<app::ChosenPlane> chosenPlane() const;
  std::optional<app::SliceOrder> order() const;
  int coarseness() const;
  glm::dvec3 worldAt(QPointF place) const;
  void orderNew();
  void showAnew();
  void nameIt();
  void take(app::SliceTask& task);
  void moveTo(glm::dvec3 world, bool endsAfterPause);
  void step(double voxels);
  void dragWindow(QPointF step);
  void zoom(QPointF place, double factor);
  void pan(QPointF step);
  bool takeKey(QKeyEvent* event);
  void openMenu(QPointF place);

  const volume::SliceDirection direction_;
  const QColor color_;
  app::SliceChoice choice_;
  std::vector<PlaneOfView> others_;
  VolumePointer volume_;
  scene::Scene scene_, resolved_;
  double zoom_ = 1.0;
  std::optional<glm::dvec3> middle_;  // of what is shown, mm; none: the volume's
  BackgroundTask<app::DrawnSlice> task_;
  app::SliceOrder ordered_;  // of the task
  std::optional<app::SliceOrder> drawn_;
  double fullMilliseconds_ = 0.0;  // what the last full picture took
  QImage image_;
  bool interacting_ = false;
  Drag drag_ = Drag::none;
  bool moved_ = false;
  QPointF last_;
  double steps_ = 0.0;  // of the wheel, not yet taken
};

// Each entry of the menu is one step of undo, or chooses the view's plane, which is none. The view has a
// volume. Windows for tissues are there where values are in HU, the convention where anatomy is stated.
// `worldMm`: the point of the slice that the menu is asked for.
QMenu* makeSliceMenu(SliceView& view, glm::dvec3 worldMm);

}  // namespace isolux::ui
