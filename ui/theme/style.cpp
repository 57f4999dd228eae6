#include "ui/theme/style.h"

#include <cmath>

#include <QApplication>
#include <QFont>
#include <QPainter>
#include <QPalette>
#include <QProxyStyle>
#include <QRegularExpression>
#include <QStyleFactory>
#include <QStyleOption>
#include <QWidget>

#include "ui/theme/theme.h"

namespace isolux::ui {

namespace {

Theme chosenTheme = Theme::dark;

// Fields, boxes and buttons have an edge of 3 : 1 against the panel at least; Fusion's is nearly the panel's
// colour. With the focus the edge is the accent.
class Style : public QProxyStyle {
 public:
  Style() : QProxyStyle(QStyleFactory::create("Fusion")) {}

  // Disabled entries of menus are grey, not engraved: on a light ground that reads as printed twice.
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                QStyleHintReturn* more) const override {
    return hint == SH_EtchDisabledText ? 0 : QProxyStyle::styleHint(hint, option, widget, more);
  }

  void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    // Fusion draws tool buttons by this element, too, with options of another type.
    const auto* const button = qstyleoption_cast<const QStyleOptionButton*>(option);
    const bool raised =
        element == PE_PanelButtonCommand && button && !(button->features & QStyleOptionButton::Flat);
    if (element == PE_IndicatorCheckBox || element == PE_FrameLineEdit || raised)
      drawEdge(option, painter);
    else if (element == PE_IndicatorRadioButton)
      drawEdge(option, painter, 0.5 * option->rect.height());
  }

  void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option, QPainter* painter,
                          const QWidget* widget) const override {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    const bool spinBox = control == CC_SpinBox && static_cast<const QStyleOptionSpinBox*>(option)->frame,
               comboBox = control == CC_ComboBox && static_cast<const QStyleOptionComboBox*>(option)->frame;
    if (spinBox || comboBox) drawEdge(option, painter);
    if (control == CC_Slider) {
      QStyleOption handle = *option;
      handle.rect = subControlRect(CC_Slider, option, SC_SliderHandle, widget).adjusted(1, 1, -1, -1);
      drawEdge(&handle, painter);
    }
  }

 private:
  static void drawEdge(const QStyleOption* option, QPainter* painter, double radius = 2.0) {
    const bool enabled = option->state & State_Enabled, focus = enabled && option->state & State_HasFocus;
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(focus ? colours.accent : enabled ? colours.edge : colours.disabledText, 1.0));
    painter->setBrush(Qt::NoBrush);
    painter->drawRoundedRect(QRectF(option->rect).adjusted(0.5, 0.5, -0.5, -0.5), radius, radius);
    painter->restore();
  }
};

QPalette paletteOf(const ThemeColours& c) {
  QPalette palette;
  using Role = std::pair<QPalette::ColorRole, QColor>;
  for (const auto& [role, color] : {Role{QPalette::Window, c.window},
                                    Role{QPalette::WindowText, c.text},
                                    Role{QPalette::Base, c.base},
                                    Role{QPalette::AlternateBase, c.window},
                                    Role{QPalette::Text, c.text},
                                    Role{QPalette::PlaceholderText, c.quietText},
                                    Role{QPalette::Button, c.raised},
                                    Role{QPalette::ButtonText, c.text},
                                    Role{QPalette::BrightText, c.text},
                                    Role{QPalette::ToolTipBase, c.raised},
                                    Role{QPalette::ToolTipText, c.text},
                                    Role{QPalette::Highlight, c.accent},
                                    Role{QPalette::HighlightedText, c.onAccent},
                                    Role{QPalette::Link, c.accent},
                                    Role{QPalette::LinkVisited, c.accent},
                                    Role{QPalette::Light, c.border},
                                    Role{QPalette::Midlight, c.raised},
                                    Role{QPalette::Mid, c.border},
                                    Role{QPalette::Dark, c.edge},
                                    Role{QPalette::Shadow, QColor(0x0c, 0x0e, 0x11)}})
    palette.setColor(role, color);
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    palette.setColor(QPalette::Disabled, role, c.disabledText);
  palette.setColor(QPalette::Disabled, QPalette::Base, c.window);
  palette.setColor(QPalette::Disabled, QPalette::Highlight, c.border);
  return palette;
}

// Places in it are named: @border is colours.border.
constexpr auto sheet = R"(
    QToolBar { border: 0; border-bottom: 1px solid @border; padding: 3px 6px; spacing: 2px; background: @window; }
    QToolBar::separator { background: @border; width: 1px; margin: 5px 6px; }
    QToolBar QToolButton { border: 0; border-radius: 4px; padding: 4px; min-width: 20px; }
    QToolBar QToolButton:hover { background: @raised; }
    QToolBar QToolButton:pressed, QToolBar QToolButton:checked { background: @border; }
    QMenuBar { background: @window; padding: 1px 4px; }
    QMenuBar::item { padding: 4px 9px; border-radius: 4px; background: transparent; }
    QMenuBar::item:selected { background: @raised; }
    QStatusBar { border-top: 1px solid @border; }
    QStatusBar::item { border: 0; }
    QDockWidget { font-weight: 600; }
    QDockWidget::title { background: @window; padding: 7px 10px; border-bottom: 1px solid @border; }
    QTabBar::tab { padding: 6px 5px; border: 0; border-bottom: 2px solid transparent; color: @quietText; }
    QTabBar::tab:selected { color: @text; border-bottom-color: @accent; }
    QToolTip { border: 1px solid @border; padding: 4px; background: @raised; color: @text; }
    QMainWindow::separator { background: @border; width: 1px; height: 1px; }
    QSplitter::handle { background: @border; }
    QScrollArea { border: 0; }
    QHeaderView::section { background: @window; color: @quietText; border: 0; border-bottom: 1px solid @border;
                           padding: 4px 6px; }
    QDialogButtonBox { dialogbuttonbox-buttons-have-icons: 0; }
    QDialogButtonBox QPushButton { min-width: 76px; padding: 4px 10px; }
    #loadCard { background: @window; border: 1px solid @border; border-radius: 8px; }
    #tourCard { background: @raised; border: 1px solid @accent; border-radius: 8px; }
    #tourFrame { background: transparent; border: 3px solid @accent; border-radius: 6px; }
    #messageBar { background: @noteArea; border: 0; border-left: 4px solid @accent; border-bottom: 1px solid @border; }
    #messageBar[level="error"] { background: @errorArea; border-left-color: @error; }
    #messageBar[level="warning"] { border-left-color: @warning; }
    #caveats { background: @window; color: @warning; border: 1px solid @border; border-radius: 3px; padding: 2px 7px; }
    #messageBar QTextEdit { background: transparent; }
    QWidget[ink="quiet"] { color: @quietText; }
    QWidget[ink="error"] { color: @error; }
    QWidget[ink="warning"] { color: @warning; }
    QWidget[ink="good"] { color: @good; }
  )";

// Lengths of 3 pixels and more; lines keep their width.
QString spacesScaled(const QString& text) {
  if (textScale() == 1.0) return text;
  static const QRegularExpression length("\\b([3-9]|[0-9]{2,})px");
  QString scaled;
  qsizetype from = 0;
  for (auto matches = length.globalMatch(text); matches.hasNext();) {
    const QRegularExpressionMatch match = matches.next();
    scaled += text.mid(from, match.capturedStart() - from) +
              QString::number(std::lround(textScale() * match.captured(1).toInt())) + "px";
    from = match.capturedEnd();
  }
  return scaled + text.mid(from);
}

QString sheetOf(const ThemeColours& c) {
  QString text = sheet;
  for (const auto& [name, color] :
       {std::pair{"@border", c.border}, std::pair{"@window", c.window}, std::pair{"@raised", c.raised},
        std::pair{"@quietText", c.quietText}, std::pair{"@text", c.text}, std::pair{"@accent", c.accent},
        std::pair{"@noteArea", c.noteArea}, std::pair{"@errorArea", c.errorArea},
        std::pair{"@error", c.error}, std::pair{"@warning", c.warning}, std::pair{"@good", c.good}})
    text.replace(name, color.name());
  return spacesScaled(text);
}

void applyFont() {
  QFont font = QApplication::font();
  if (font.pointSizeF() < 9.5) font.setPointSizeF(9.5);
  font.setPointSizeF(textScale() * font.pointSizeF());
  font.setHintingPreference(QFont::PreferFullHinting);
  QApplication::setFont(font);
}

}  // namespace

void applyTheme(Theme theme) {
  static const bool first = [] {
    systemIsDark();  // as long as the palette is the desktop's
    QApplication::setStyle(new Style);
    applyFont();
    return true;
  }();
  static_cast<void>(first);
  chosenTheme = theme;
  colours = coloursOf(theme);
  QApplication::setPalette(paletteOf(colours));
  qApp->setStyleSheet(sheetOf(colours));
}

Theme theme() {
  return chosenTheme;
}

void setInk(QWidget* widget, Ink ink) {
  constexpr const char* names[] = {"", "quiet", "error", "warning", "good"};
  const QString name = names[static_cast<int>(ink)];
  if (widget->property("ink").toString() == name) return;
  widget->setProperty("ink", name);
  widget->style()->unpolish(widget);
  widget->style()->polish(widget);
}

}  // namespace isolux::ui
