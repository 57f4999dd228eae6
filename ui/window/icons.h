// The program's icons: SVG files drawn in the palette's text colour, so that they read on light and dark.
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace isolux::ui {

// `name` without folder and ending ("open"); disabled and 2x variants included.
QIcon icon(const QString& name);
QPixmap iconPixmap(const QString& name, int size, const QColor& colour, double devicePixelRatio);
QIcon applicationIcon();

}  // namespace isolux::ui
