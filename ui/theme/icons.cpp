#include "ui/theme/icons.h"

#include <algorithm>
#include <utility>

#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPixmapCache>
#include <QSvgRenderer>

#include "ui/theme/style.h"

// The resources lie in a static library: the linker keeps them only when they are asked for by name.
static void initialiseIcons() {
  Q_INIT_RESOURCE(icons);
}

namespace isolux::ui {

namespace {

class ThemedIcon : public QIconEngine {
 public:
  explicit ThemedIcon(QString name) : name_(std::move(name)) {}

  QIconEngine* clone() const override { return new ThemedIcon(name_); }
  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const int side = std::min(rect.width(), rect.height());
    QRect square(0, 0, side, side);
    square.moveCenter(rect.center());
    painter->drawPixmap(square, drawn(side, mode, painter->device()->devicePixelRatioF()));
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    return scaledPixmap(size, mode, state, 1.0);
  }
  QPixmap scaledPixmap(const QSize& size, QIcon::Mode mode, QIcon::State, qreal scale) override {
    // From Qt 6.8 on `size` is in points, before in pixels.
    const double ratio = QT_VERSION < QT_VERSION_CHECK(6, 8, 0) ? 1.0 : scale;
    QPixmap pixmap = drawn(std::min(size.width(), size.height()), mode, ratio);
    pixmap.setDevicePixelRatio(scale);
    return pixmap;
  }

 private:
  QPixmap drawn(int side, QIcon::Mode mode, double ratio) const {
    const QColor& colour = mode == QIcon::Disabled ? colours.disabledText : colours.text;
    const QString key = QString("isolux %1 %2 %3 %4").arg(name_, colour.name()).arg(side).arg(ratio);
    QPixmap pixmap;
    if (!QPixmapCache::find(key, &pixmap)) {
      pixmap = iconPixmap(name_, side, colour, ratio);
      QPixmapCache::insert(key, pixmap);
    }
    return pixmap;
  }

  const QString name_;
};

}  // namespace

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
  return QIcon(new ThemedIcon(name));
}

QIcon applicationIcon() {
  QIcon result;
  for (const int size : {32, 64, 128, 256}) result.addPixmap(iconPixmap("isolux", size, Qt::white, 1.0));
  return result;
}

}  // namespace isolux::ui
