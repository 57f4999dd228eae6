// Where the slices lie in the picture: the outlines of their planes and the crosshair.
#pragma once

#include <vector>

#include <QColor>
#include <QLineF>
#include <QSizeF>

#include <glm/vec3.hpp>

#include "scene/camera.h"

class QPainter;

namespace isolux::ui {

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
