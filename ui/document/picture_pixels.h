// Pictures of Qt and of the layers below, from one to the other. Row 0 at the top.
#pragma once

#include <QImage>

#include "render/graph/frame.h"

namespace isolux::ui {

render::ColorImage colorImageOf(const QImage& image);
QImage imageOf(const render::ColorImage& image);  // a copy; opaque unless the picture is transparent

}  // namespace isolux::ui
