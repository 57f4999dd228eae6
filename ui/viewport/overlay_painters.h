// Paint the handles, the marks, and where the slices lie, over the picture.
#pragma once

#include <optional>
#include <vector>

#include <QColor>
#include <QLineF>
#include <QRectF>

#include "app/cuts/cut_handles.h"
#include "app/view_math/lamp_handles.h"
#include "app/view_math/mark_view.h"

class QPainter;

namespace isolux::ui {

// `grip`: under the pointer, or being dragged.
void paintLamps(QPainter& painter, const std::vector<app::LampHandle>& handles,
                const std::optional<app::LampGrip>& grip);
// Planes and the box that cut: light lines on a dark rim, so that they are seen on any picture.
void paintCuts(QPainter& painter, const std::vector<app::CutShape>& shapes,
               const std::optional<app::CutGrip>& grip);

// Dots, lines (dashed where they leave the surface, faint behind it) and labels. `size`: of the picture, in
// the painter's pixels. Returns where the labels stand, in the order of the marks; empty: its mark is not to
// be seen. Labels keep off the dots of all marks, off one another and off what is `taken` as long as there is
// room.
std::vector<QRectF> paintMarks(QPainter& painter, const std::vector<app::MarkShape>& marks,
                               const scene::CameraFrame& frame, QSizeF size, std::vector<QRectF> taken = {});

// Where the slices lie: the outlines of their planes and the crosshair.
struct SliceOutline {
  std::vector<glm::dvec3> corners;  // in order, world mm
  QColor color;
};
struct SlicesInPicture {
  std::vector<SliceOutline> outlines;  // none: nothing is painted
  glm::dvec3 crosshairMm{0.0};
};

// Edges of the outlines in a picture of this size, in pixels. What lies behind the eye is left out.
std::vector<QLineF> sliceLines(const SlicesInPicture& slices, const scene::CameraFrame& frame, QSizeF size);

// `size`: of the picture, in the painter's pixels. What lies behind the eye is left out.
void paintSlices(QPainter& painter, const SlicesInPicture& slices, const scene::CameraFrame& frame,
                 QSizeF size);

}  // namespace isolux::ui
