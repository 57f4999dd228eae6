#include "ui/widgets/picture_dot.h"

#include <QPainter>

#include "ui/language/number_text.h"
#include "ui/theme/style.h"
#include "ui/widgets/time_left.h"

namespace isolux::ui {

namespace {
constexpr int dotSide = 9, dotMargin = 10;  // pixels
}

PictureDot::PictureDot(QWidget* parent) : QWidget(parent) {
  setObjectName("pictureDot");
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Preferred);
  tell();
}

QSize PictureDot::sizeHint() const {
  return {dotSide + 2 * dotMargin, dotSide + 4};
}

void PictureDot::setDrawn(double milliseconds, bool complete) {
  milliseconds_ = milliseconds;
  final_ = complete;
  tell();
}

void PictureDot::setDrawing(bool draws) {
  if (draws == draws_) return;
  draws_ = draws;
  tell();
}

void PictureDot::setLight(const QString& unfinished, bool works) {
  if (unfinished == light_ && works == lightWorks_) return;
  light_ = unfinished;
  lightWorks_ = works;
  tell();
}

void PictureDot::tell() {
  QStringList lines;
  if (!light_.isEmpty()) lines += light_;
  if (milliseconds_ < 0.0) {
    lines += tr("No image yet");
  } else if (isFinal()) {
    lines += light_.isEmpty() ? tr("The image is final") : tr("The image is final except for its light");
  } else {
    lines += tr("A finer image is being rendered");
  }
  setAccessibleName(lines.join(". "));
  if (milliseconds_ >= 0.0) lines += tr("Last render time: %1").arg(durationText(1e-3 * milliseconds_));
  setToolTip(lines.join('\n'));
  update();
}

void PictureDot::paintEvent(QPaintEvent*) {
  if (milliseconds_ < 0.0) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor colour = isFinal() ? colours.quietText : colours.warning;
  painter.setPen(QPen(colour, 1.5));
  painter.setBrush(isFinal() ? QBrush(colour) : Qt::NoBrush);
  painter.drawEllipse(QRectF(0.5 * (width() - dotSide), 0.5 * (height() - dotSide), dotSide, dotSide));
}

}  // namespace isolux::ui
