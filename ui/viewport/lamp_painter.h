// Draws the handles of lamps over the picture.
#pragma once

#include <optional>
#include <vector>

#include "app/interaction/lamp_handles.h"

class QPainter;

namespace isolux::ui {

void paintLamps(QPainter& painter, const std::vector<app::LampHandle>& handles,
                const std::optional<app::LampGrip>& grip);  // grip: under the pointer, or being dragged

}  // namespace isolux::ui
