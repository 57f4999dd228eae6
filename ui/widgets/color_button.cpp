#include "ui/widgets/color_button.h"

#include <algorithm>

#include <QColorDialog>
#include <QPainter>

#include "base/color.h"
#include "ui/theme/style.h"

namespace isolux::ui {

QColor screenColour(glm::dvec3 linear) {
  const auto encoded = [](double c) { return static_cast<float>(base::encodeSrgb(std::clamp(c, 0.0, 1.0))); };
  return QColor::fromRgbF(encoded(linear.x), encoded(linear.y), encoded(linear.z));
}

glm::dvec3 linearColour(const QColor& screen) {
  const auto decoded = [](double c) { return base::decodeSrgb(c); };
  return {decoded(screen.redF()), decoded(screen.greenF()), decoded(screen.blueF())};
}

ColorButton::ColorButton(QWidget* parent) : QToolButton(parent) {
  setIconSize({58, 16});
  setFocusPolicy(Qt::StrongFocus);
  connect(this, &QToolButton::clicked, this, &ColorButton::choose);
}

void ColorButton::showColour(glm::dvec3 linear) {
  colour_ = linear;
  const double ratio = devicePixelRatioF();
  QPixmap swatch(iconSize() * ratio);
  swatch.setDevicePixelRatio(ratio);
  swatch.fill(Qt::transparent);
  QPainter painter(&swatch);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(colours.border, 1.0));
  painter.setBrush(screenColour(linear));
  painter.drawRoundedRect(QRectF(QPointF(0.5, 0.5), QSizeF(iconSize()) - QSizeF(1, 1)), 3, 3);
  setIcon(QIcon(swatch));
}

void ColorButton::choose() {
  const glm::dvec3 before = colour_;
  QColorDialog dialog(screenColour(before), this);
  dialog.setOption(QColorDialog::DontUseNativeDialog);
  dialog.setWindowTitle(tr("Colour"));
  connect(&dialog, &QColorDialog::currentColorChanged, this,
          [this](const QColor& colour) { Q_EMIT chosen(linearColour(colour)); });
  if (dialog.exec() != QDialog::Accepted) Q_EMIT chosen(before);
}

}  // namespace isolux::ui
