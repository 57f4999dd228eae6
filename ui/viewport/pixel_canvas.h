// Paints pictures in main memory with Qt's raster engine: where OpenGL is software, or the window system has
// none.
#pragma once

#include "ui/viewport/canvas.h"

namespace isolux::ui {

class PixelCanvas : public QWidget, public Canvas {
  Q_OBJECT
 public:
  PixelCanvas(QWidget* parent, Painted painted);
  QWidget* widget() override { return this; }
  CanvasKind kind() const override { return CanvasKind::pixels; }
  QImage read(const CanvasPicture& picture) override { return picture.pixels; }

 protected:
  void paintEvent(QPaintEvent* event) override;
};

}  // namespace isolux::ui
