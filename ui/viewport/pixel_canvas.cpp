#include "ui/viewport/pixel_canvas.h"

#include <QPainter>

namespace isolux::ui {

PixelCanvas::PixelCanvas(QWidget* parent, Painted painted) : QWidget(parent), Canvas(std::move(painted)) {
  setAttribute(Qt::WA_OpaquePaintEvent);
  setAttribute(Qt::WA_TransparentForMouseEvents);
}

void PixelCanvas::paintEvent(QPaintEvent*) {
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

}  // namespace isolux::ui
