// Where the slices lie in the picture: the outlines of their planes and the crosshair.
#pragma once

#include <vector>

#include <QColor>
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

// `size`: of the picture, in the painter's pixels. What lies behind the eye is left out.
void paintSlices(QPainter& painter, const SlicesInPicture& slices, const scene::CameraFrame& frame,
                 QSizeF size);

}  // namespace isolux::ui
