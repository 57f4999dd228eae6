// The program's icons: SVG files drawn in the text colour of the theme that is on, as large as they are
// shown.
#pragma once

#include <QColor>
#include <QIcon>
#include <QString>

namespace isolux::ui {

// `name` without folder and ending ("open"). Drawn when it is shown: follows the theme and any scale.
QIcon icon(const QString& name);
QPixmap iconPixmap(const QString& name, int size, const QColor& colour, double devicePixelRatio);
QIcon applicationIcon();

}  // namespace isolux::ui
