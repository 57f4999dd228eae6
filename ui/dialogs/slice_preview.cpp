#include "ui/dialogs/slice_preview.h"

#include <algorithm>

#include <QPainter>

#include "ui/theme/style.h"

namespace isolux::ui {

SlicePreview::SlicePreview(QWidget* parent) : QWidget(parent) {
  setMinimumSize(260, 260);
}

void SlicePreview::showSlice(const QImage& image, double aspect, const QString& text) {
  image_ = image;
  aspect_ = std::clamp(aspect, 0.02, 50.0);
  text_ = text;
  update();
}

void SlicePreview::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.fillRect(rect(), Qt::black);
  if (image_.isNull()) {
    painter.setPen(colours.quietText);
    painter.drawText(rect().adjusted(16, 16, -16, -16), Qt::AlignCenter | Qt::TextWordWrap, text_);
  } else {
    QSizeF size(width(), width() / aspect_);
    if (size.height() > height()) size = {height() * aspect_, static_cast<double>(height())};
    QRectF target(QPointF(), size);
    target.moveCenter(QRectF(rect()).center());
    const bool enlarged = size.width() > image_.width();  // enlarged voxels stay voxels
    painter.setRenderHint(QPainter::SmoothPixmapTransform, !enlarged);
    painter.drawImage(target, image_);
  }
  painter.setPen(colours.border);
  painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

}  // namespace isolux::ui
