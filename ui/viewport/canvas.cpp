#include "ui/viewport/canvas.h"

#include <QPainter>

#include "ui/viewport/texture_canvas.h"

namespace isolux::ui {

namespace {

// Paints pictures in main memory with Qt's raster engine: where OpenGL is software, or the window system has
// none.
class PixelCanvas : public QWidget, public Canvas {
 public:
  PixelCanvas(QWidget* parent, Painted painted) : QWidget(parent), Canvas(std::move(painted)) {
    setAttribute(Qt::WA_OpaquePaintEvent);
    setAttribute(Qt::WA_TransparentForMouseEvents);
  }
  QWidget* widget() override { return this; }
  CanvasKind kind() const override { return CanvasKind::pixels; }
  QImage read(const CanvasPicture& picture) override { return picture.pixels; }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    const CanvasContent& shown = content();
    if (!shown.picture) {
      painter.fillRect(rect(), QColor::fromRgbF(canvasGround[0], canvasGround[1], canvasGround[2]));
    } else {
      const QSize pixels = (QSizeF(size()) * devicePixelRatioF()).toSize();
      painter.setRenderHint(QPainter::SmoothPixmapTransform, shown.picture.size() != pixels);
      painter.drawImage(rect(), shown.over.isNull() ? shown.picture.pixels : shown.over);
      if (shown.opacityBefore > 0.0) {
        painter.setOpacity(shown.opacityBefore);
        painter.drawImage(rect(), shown.before.pixels);
      }
    }
    painter.end();
    this->painted();
  }
};

}  // namespace

std::unique_ptr<Canvas> makeCanvas(CanvasKind kind, QWidget* parent, Canvas::Painted painted) {
  if (kind == CanvasKind::textures) return std::make_unique<TextureCanvas>(parent, std::move(painted));
  return std::make_unique<PixelCanvas>(parent, std::move(painted));
}

}  // namespace isolux::ui
