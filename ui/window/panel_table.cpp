#include "ui/window/panel_table.h"

#include <QEvent>

namespace isolux::ui {

void Panel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) themeChanged();
}

}  // namespace isolux::ui
