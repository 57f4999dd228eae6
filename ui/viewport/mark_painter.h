// Paints marks over the picture: dots, lines (dashed where they leave the surface, faint behind it), labels.
#pragma once

#include <vector>

#include <QColor>
#include <QRectF>

#include "app/interaction/mark_view.h"

class QPainter;

namespace isolux::ui {

// `size`: of the picture, in the painter's pixels. Returns where the labels stand, in the order of the marks;
// empty: its mark is not to be seen. Labels keep off the dots of all marks, off one another and off what is
// `taken` as long as there is room.
std::vector<QRectF> paintMarks(QPainter& painter, const std::vector<app::MarkShape>& marks,
                               const scene::CameraFrame& frame, QSizeF size, std::vector<QRectF> taken = {});

}  // namespace isolux::ui
