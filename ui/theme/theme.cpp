#include "ui/theme/theme.h"

#include <algorithm>

#include <QByteArray>
#include <QGuiApplication>
#include <QPalette>
#include <QStyleHints>

#include <glm/vec3.hpp>

#include "base/color.h"

namespace isolux::ui {

namespace {

double scaleOfTexts = 1.0;

const ThemeColours darkColours{.window{0x24, 0x28, 0x2e},
                               .base{0x1a, 0x1d, 0x22},
                               .raised{0x2f, 0x34, 0x3c},
                               .border{0x3d, 0x44, 0x4e},
                               .edge{0x8a, 0x94, 0xa1},
                               .text{0xe3, 0xe7, 0xec},
                               .quietText{0xa9, 0xb2, 0xbd},
                               .disabledText{0x6b, 0x74, 0x80},
                               .accent{0x4c, 0x9b, 0xd6},
                               .onAccent{0x10, 0x14, 0x18},
                               .isovalue{0xf2, 0xb1, 0x34},
                               .onIsovalue{0x22, 0x1a, 0x08},
                               .error{0xee, 0x7b, 0x72},
                               .warning{0xe8, 0xb2, 0x4a},
                               .good{0x7f, 0xc8, 0x8a},
                               .errorArea{0x3a, 0x28, 0x29},
                               .noteArea{0x26, 0x32, 0x3d},
                               .plotInside{0x8f, 0xb4, 0xd4},
                               .plotOutside{0x4d, 0x5d, 0x6e},
                               .plotInk{0xf4, 0xf6, 0xf8}};

const ThemeColours lightColours{.window{0xf2, 0xf4, 0xf6},
                                .base{0xff, 0xff, 0xff},
                                .raised{0xe4, 0xe8, 0xec},
                                .border{0xc6, 0xcc, 0xd3},
                                .edge{0x74, 0x7d, 0x88},
                                .text{0x1a, 0x1e, 0x24},
                                .quietText{0x50, 0x5a, 0x66},
                                .disabledText{0x93, 0x9b, 0xa5},
                                .accent{0x17, 0x68, 0xad},
                                .onAccent{0xff, 0xff, 0xff},
                                .isovalue{0xc4, 0x74, 0x00},
                                .onIsovalue{0x14, 0x0e, 0x02},
                                .error{0xb0, 0x26, 0x1e},
                                .warning{0x85, 0x55, 0x00},
                                .good{0x1b, 0x6b, 0x2c},
                                .errorArea{0xfd, 0xe7, 0xe5},
                                .noteArea{0xe2, 0xee, 0xf8},
                                .plotInside{0x4d, 0x80, 0xad},
                                .plotOutside{0xb3, 0xbf, 0xca},
                                .plotInk{0x2b, 0x33, 0x3d}};

double relativeLuminance(const QColor& color) {
  return base::luminance(glm::dvec3(base::decodeSrgb(double(color.redF())),
                                    base::decodeSrgb(double(color.greenF())),
                                    base::decodeSrgb(double(color.blueF()))));
}

}  // namespace

bool systemIsDark() {
#if QT_VERSION >= QT_VERSION_CHECK(6, 5, 0)
  return QGuiApplication::styleHints()->colorScheme() != Qt::ColorScheme::Light;
#else
  // The desktop's palette, before the window has one of its own.
  static const bool dark = [] {
    const QPalette palette = QGuiApplication::palette();
    return palette.color(QPalette::Window).lightness() < palette.color(QPalette::WindowText).lightness();
  }();
  return dark;
#endif
}

const ThemeColours& coloursOf(Theme theme) {
  if (theme == Theme::system) return systemIsDark() ? darkColours : lightColours;
  return theme == Theme::light ? lightColours : darkColours;
}

double contrast(const QColor& a, const QColor& b) {
  const double p = relativeLuminance(a), q = relativeLuminance(b);
  return (std::max(p, q) + 0.05) / (std::min(p, q) + 0.05);
}

void applyInterfaceScale(int percent) {
  constexpr auto variable = "QT_SCALE_FACTOR";
  const double scale = 0.01 * std::clamp(percent, smallestScale, largestScale);
  scaleOfTexts = std::min(1.0, scale);
  if (scale > 1.0 && !qEnvironmentVariableIsSet(variable)) qputenv(variable, QByteArray::number(scale));
}

double textScale() {
  return scaleOfTexts;
}

}  // namespace isolux::ui
