#include "ui/viewport/canvas.h"

#include "ui/viewport/pixel_canvas.h"
#include "ui/viewport/texture_canvas.h"

namespace isolux::ui {

std::unique_ptr<Canvas> makeCanvas(CanvasKind kind, QWidget* parent, Canvas::Painted painted) {
  if (kind == CanvasKind::textures) return std::make_unique<TextureCanvas>(parent, std::move(painted));
  return std::make_unique<PixelCanvas>(parent, std::move(painted));
}

}  // namespace isolux::ui
