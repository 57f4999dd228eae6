#include "ui/window/icons.h"

#include <QApplication>
#include <QFile>
#include <QPainter>
#include <QPalette>
#include <QSvgRenderer>

// The resources lie in a static library: the linker keeps them only when they are asked for by name.
static void initialiseIcons() {
  Q_INIT_RESOURCE(icons);
}

namespace isolux::ui {

QPixmap iconPixmap(const QString& name, int size, const QColor& colour, double devicePixelRatio) {
  initialiseIcons();
  QFile file(":/icons/" + name + ".svg");
  QByteArray svg = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
  svg.replace("currentColor", colour.name().toUtf8());
  QPixmap pixmap(QSize(size, size) * devicePixelRatio);
  pixmap.setDevicePixelRatio(devicePixelRatio);
  pixmap.fill(Qt::transparent);
  QSvgRenderer renderer(svg);
  QPainter painter(&pixmap);
  painter.setOpacity(colour.alphaF());
  renderer.render(&painter, QRectF(0, 0, size, size));
  return pixmap;
}

QIcon icon(const QString& name) {
  const QPalette palette = QApplication::palette();
  QIcon result;
  for (const double ratio : {1.0, 2.0}) {
    result.addPixmap(iconPixmap(name, 24, palette.color(QPalette::ButtonText), ratio));
    result.addPixmap(iconPixmap(name, 24, palette.color(QPalette::Disabled, QPalette::ButtonText), ratio),
                     QIcon::Disabled);
  }
  return result;
}

QIcon applicationIcon() {
  QIcon result;
  for (const int size : {32, 64, 128, 256}) result.addPixmap(iconPixmap("isolux", size, Qt::white, 1.0));
  return result;
}

}  // namespace isolux::ui
