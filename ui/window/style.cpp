#include "ui/window/style.h"

#include <QApplication>
#include <QFont>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QStyleFactory>
#include <QStyleOption>

namespace isolux::ui {

namespace {

// Boxes to check have an edge of 3 : 1 against the panel at least, checked or not; Fusion's is nearly the
// panel's colour.
class Style : public QProxyStyle {
 public:
  Style() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    if (element != PE_IndicatorCheckBox) return;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(option->state & State_Enabled ? colours::checkEdge : colours::disabledText);
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5), 2.0, 2.0);
    painter->restore();
  }
};

}  // namespace

void applyStyle() {
  using namespace colours;
  QApplication::setStyle(new Style);

  QPalette palette;
  palette.setColor(QPalette::Window, window);
  palette.setColor(QPalette::WindowText, text);
  palette.setColor(QPalette::Base, base);
  palette.setColor(QPalette::AlternateBase, window);
  palette.setColor(QPalette::Text, text);
  palette.setColor(QPalette::PlaceholderText, disabledText);
  palette.setColor(QPalette::Button, raised);
  palette.setColor(QPalette::ButtonText, text);
  palette.setColor(QPalette::BrightText, Qt::white);
  palette.setColor(QPalette::ToolTipBase, raised);
  palette.setColor(QPalette::ToolTipText, text);
  palette.setColor(QPalette::Highlight, accent);
  palette.setColor(QPalette::HighlightedText, QColor(0x10, 0x14, 0x18));
  palette.setColor(QPalette::Link, accent);
  palette.setColor(QPalette::Light, border);
  palette.setColor(QPalette::Midlight, raised);
  palette.setColor(QPalette::Mid, border);
  palette.setColor(QPalette::Dark, base);
  palette.setColor(QPalette::Shadow, QColor(0x0c, 0x0e, 0x11));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
    palette.setColor(QPalette::Disabled, role, disabledText);
  }
  palette.setColor(QPalette::Disabled, QPalette::Base, window);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, border);
  QApplication::setPalette(palette);

  QFont font = QApplication::font();
  if (font.pointSizeF() < 9.5) font.setPointSizeF(9.5);
  font.setHintingPreference(QFont::PreferFullHinting);
  QApplication::setFont(font);

  qApp->setStyleSheet(
      QString(R"(
    QToolBar { border: 0; border-bottom: 1px solid %1; padding: 3px 6px; spacing: 2px; background: %2; }
    QToolBar::separator { background: %1; width: 1px; margin: 5px 6px; }
    QToolBar QToolButton { border: 0; border-radius: 4px; padding: 4px; min-width: 20px; }
    QToolBar QToolButton:hover { background: %3; }
    QToolBar QToolButton:pressed, QToolBar QToolButton:checked { background: %1; }
    QMenuBar { background: %2; padding: 1px 4px; }
    QMenuBar::item { padding: 4px 9px; border-radius: 4px; background: transparent; }
    QMenuBar::item:selected { background: %3; }
    QStatusBar { border-top: 1px solid %1; }
    QStatusBar::item { border: 0; }
    QDockWidget { font-weight: 600; }
    QDockWidget::title { background: %2; padding: 7px 10px; border-bottom: 1px solid %1; }
    QTabBar::tab { padding: 6px 7px; border: 0; border-bottom: 2px solid transparent; color: %4; }
    QTabBar::tab:selected { color: %5; border-bottom-color: %6; }
    QToolTip { border: 1px solid %1; padding: 4px; background: %3; color: %5; }
    QMainWindow::separator { background: %1; width: 1px; height: 1px; }
    QSplitter::handle { background: %1; }
    QScrollArea { border: 0; }
    QHeaderView::section { background: %2; color: %4; border: 0; border-bottom: 1px solid %1; padding: 4px 6px; }
    QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
    QDialogButtonBox QPushButton { min-width: 76px; padding: 4px 10px; }
  )")
          .arg(border.name(), window.name(), raised.name(), quietText.name(), text.name(), accent.name()));
}

}  // namespace isolux::ui
