#include "ui/panels/panel.h"

#include <QEvent>

namespace isolux::ui {

void Panel::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) themeChanged();
}

}  // namespace isolux::ui
