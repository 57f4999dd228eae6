// What stands over the picture: letters of the axes, orientation cube, scale bar, or why there is no picture.
// Painted by the raster engine, so that letters and lines are crisp at any device pixel ratio.
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include <QRectF>
#include <QWidget>

#include "app/cuts/cut_handles.h"
#include "app/view_math/lamp_handles.h"
#include "app/view_math/mark_view.h"
#include "app/view_math/orientation_cube.h"
#include "scene/camera.h"
#include "ui/viewport/overlay_painters.h"

namespace isolux::ui {

class ViewportOverlay : public QWidget {
  Q_OBJECT
 public:
  explicit ViewportOverlay(QWidget* parent);

  // Letters and lines are light on a dark background and dark on a light one.
  void setScene(const scene::Scene& resolved, bool visible, scene::WorldAxes axes);
  // Why there is no picture, and what can be done; empty: there is one. Both are the widget's accessible
  // description.
  void setProblem(const QString& reason, const QString& advice = {});
  void setTopInset(int pixels) { set(topInset_, pixels); }  // letters, cube and note stand below
  // Keeps the overlay clear of what stands in the picture already (legends, buttons).
  void setTaken(std::vector<QRectF> boxes) { set(taken_, std::move(boxes)); }
  void setNote(const QString& text);  // over a picture that is not all there; empty: none
  // Lamps that can be dragged, and which of them the pointer holds or is over.
  void setLamps(std::vector<app::LampHandle> lamps, const std::optional<app::LampGrip>& grip) {
    set(lamps_, std::move(lamps));
    set(grip_, grip);
  }
  void setCuts(std::vector<app::CutShape> cuts,
               const std::optional<app::CutGrip>& grip) {  // the same of cuts
    set(cuts_, std::move(cuts));
    set(cutGrip_, grip);
  }
  // Marks, and what clicks would do; empty: they set none.
  void setMarks(std::vector<app::MarkShape> marks, const QString& toolHint);
  void setSlices(SlicesInPicture slices);
  // From which side the cube's face there shows; none: no face.
  std::optional<scene::StandardView> cubeViewAt(QPointF position) const;
  void pointAtCube(std::optional<QPointF> position);       // lights the face up
  void setHint(const QString& text) { set(hint_, text); }  // in place of a picture: what to do first
  // Says where things stand: clear of one another, of what is taken, and, the letters, of outlines of slices.
  // Empty boxes: not there, or no room.
  struct Arrangement {
    QRectF cube, scale, note, toolHint, left, right, top, bottom;
    double scaleMm = 0.0;  // length of the bar, and in pixels
    double scalePixels = 0.0;
    std::vector<QRectF> boxes() const;  // those that are there
  };
  Arrangement arrangement() const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  template <class T>
  void set(T& member, T value) {
    if (std::exchange(member, std::move(value)) != member) update();
  }
  QFont letterFont() const;
  QFont scaleFont() const;
  QString scaleText(double mm) const;
  QStringList lines(const QString& text) const;  // as wide as the picture allows
  void paintLetters(QPainter& painter, const Arrangement& places) const;
  std::vector<app::CubeFace> cube() const;
  void paintCube(QPainter& painter, QPointF centre) const;
  void paintScale(QPainter& painter, const Arrangement& places) const;
  void paintProblem(QPainter& painter) const;
  void paintLines(QPainter& painter, const QStringList& lines, double top) const;

  struct Inks {
    QColor ink, rim;
  };
  Inks inksAt(double heightFraction) const;  // 0 is the top of the picture
  void drawText(QPainter& painter, const QFont& font, QPointF baseline, const QString& text) const;

  scene::Camera camera_;
  glm::dvec3 backgroundTop_{0.0}, backgroundBottom_{0.0};
  scene::CameraFrame frame_{};
  bool visible_ = false;
  scene::WorldAxes axes_ = scene::WorldAxes::zUp;
  QString problem_, advice_, note_, hint_, toolHint_;
  int topInset_ = 0;
  std::vector<QRectF> taken_;
  std::vector<app::LampHandle> lamps_;
  std::vector<app::MarkShape> marks_;
  std::optional<app::LampGrip> grip_;
  std::vector<app::CutShape> cuts_;
  std::optional<app::CutGrip> cutGrip_;
  SlicesInPicture slices_;
  std::optional<scene::StandardView> pointedFace_;
};

}  // namespace isolux::ui
