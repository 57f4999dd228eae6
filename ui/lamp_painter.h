// Draws the handles of lamps over the picture.
#pragma once

#include <optional>
#include <vector>

#include "ui/lamp_handles.h"

class QPainter;

namespace isolux::ui {

void paintLamps(QPainter& painter, const std::vector<LampHandle>& handles,
                const std::optional<LampGrip>& grip);  // grip: under the pointer, or being dragged

}  // namespace isolux::ui
