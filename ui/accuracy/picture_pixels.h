// Pictures of the window and of app/, pixel by pixel.
#pragma once

#include <QImage>

#include "render/graph/frame.h"

namespace isolux::ui {

render::ColorImage colorImageOf(const QImage& image);
QImage imageOf(const render::ColorImage& image);  // opaque

}  // namespace isolux::ui
