// What lies over a slice: the lines in which the planes of the other views cross it, and points of marks.
#pragma once

#include <vector>

#include <QColor>
#include <QSizeF>

#include "app/slices/slice_choice.h"
#include "scene/scene.h"

class QPainter;

namespace isolux::ui {

struct PlaneOfView {
  app::ChosenPlane plane;
  QColor color;
};

// `picture`: in pixels of the screen, of which the painter's unit has `ratio`. Lines are open about the
// crosshair, and end at `border` from the sides, where letters stand.
void paintPlanes(QPainter& painter, const volume::SlicePlane& picture, const std::vector<PlaneOfView>& planes,
                 glm::dvec3 crosshairMm, QSizeF border, double ratio);
// Points no farther from the plane than `reachMm`; pins with their names.
void paintPoints(QPainter& painter, const volume::SlicePlane& picture, const std::vector<scene::Mark>& marks,
                 double reachMm, double ratio);
// In the colour that the view's plane has elsewhere, at its top.
void paintStripe(QPainter& painter, int width, const QColor& color);

}  // namespace isolux::ui
