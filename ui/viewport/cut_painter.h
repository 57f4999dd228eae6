// Draws the handles of planes and of the box that cut, over the picture: light lines on a dark rim, so that
// they are seen on any picture.
#pragma once

#include <optional>
#include <vector>

#include "app/cuts/cut_handles.h"

class QPainter;

namespace isolux::ui {

void paintCuts(QPainter& painter, const std::vector<app::CutShape>& shapes,
               const std::optional<app::CutGrip>& grip);  // grip: under the pointer, or being dragged

}  // namespace isolux::ui
