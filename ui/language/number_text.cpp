#include "ui/language/number_text.h"

#include <algorithm>
#include <cmath>

#include <QHash>
#include <QObject>

#include "ui/language/translated.h"

namespace isolux::ui {

QString numberText(double value, int significant) {
  if (!std::isfinite(value)) return std::isnan(value) ? QObject::tr("missing") : value > 0 ? "∞" : "−∞";
  if (value == 0.0) return "0";
  const double magnitude = std::abs(value);
  if (magnitude < 1e-4 || magnitude >= 1e9) return QString::number(value, 'g', significant);
  const int decimals = std::max(0, significant - 1 - static_cast<int>(std::floor(std::log10(magnitude))));
  QString text = QString::number(value, 'f', decimals);
  if (text.contains('.')) {
    while (text.endsWith('0')) text.chop(1);
    if (text.endsWith('.')) text.chop(1);
  }
  return text == "-0" ? "0" : text;
}

QString valueText(double value, const QString& unit, int significant) {
  const QString number = numberText(value, significant);
  return unit.isEmpty() ? number : number + ' ' + unit;
}

QString groupedText(std::uint64_t number) {
  QString text = QString::number(number);
  for (qsizetype i = text.size() - 3; i > 0; i -= 3) text.insert(i, QChar(0x202F));
  return text;
}

QString bytesText(double bytes) {
  const char* units[] = {QT_TRANSLATE_NOOP("QObject", "bytes"), "kB", "MB", "GB", "TB"};
  int unit = 0;
  while (bytes >= 1000.0 && unit < 4) {
    bytes /= 1000.0;
    ++unit;
  }
  return numberText(bytes, unit == 0 ? 6 : 3) + ' ' + (unit == 0 ? QObject::tr(units[0]) : units[unit]);
}

QString plainWordsOf(const QString& identifier) {
  // Names of people, signs, abbreviations, and identifiers whose words are not the field's term.
  static const QHash<QString, QString> special = {{"blinn_phong", "Blinn-Phong"},
                                                  {"marschner_lobb", "Marschner–Lobb"},
                                                  {"sobol_owen", "Sobol (Owen)"},
                                                  {"r11g11b10", "R11G11B10"},
                                                  {"cpu", "CPU"},
                                                  {"gpu", "GPU"},
                                                  {"fov", "Field of view"},
                                                  {"accessibility", "Crevice shading"},
                                                  {"ambient_variation", "Hemisphere lighting"},
                                                  {"inner_tint", "Back-face tint"},
                                                  {"facing_opacity", "View-dependent opacity"},
                                                  {"ghost", "Uncertainty surfaces"},
                                                  {"ghost_opacity", "Uncertainty opacity"},
                                                  {"noise_band", "Uncertainty band"},
                                                  {"letters", "Orientation labels"},
                                                  {"component", "Channel"},
                                                  {"csg", "Boolean operation"},
                                                  {"csg_path", "Second volume"},
                                                  {"csg_value", "Second isovalue"},
                                                  {"csg_weight", "Second weight"},
                                                  {"smallest", "Minimum volume"},
                                                  {"frames", "Framing"},
                                                  {"fetch", "Voxel access"},
                                                  {"rest_hits", "Hits at rest"},
                                                  {"key", "Key light only"},
                                                  {"fill", "Fill light"},
                                                  {"rim", "Rim light"},
                                                  {"three_point", "Three-point"},
                                                  {"space", "Reference frame"},
                                                  {"gi", "Global illumination"},
                                                  {"color", "Colour"},
                                                  {"map", "Colour map"},
                                                  {"ct_hu", "CT in Hounsfield units"},
                                                  {"ct", "CT in other units"},
                                                  {"mr", "MR"},
                                                  {"kappa1", "κ₁ (larger curvature)"},
                                                  {"kappa2", "κ₂ (smaller curvature)"},
                                                  {"curvature_2d", "κ₁ and κ₂"},
                                                  {"coolwarm", "Cool–warm"},
                                                  {"blue_orange", "Blue–orange"},
                                                  {"purple_green", "Purple–green"}};
  if (const auto found = special.find(identifier); found != special.end()) return *found;
  QString words = identifier;
  words.replace('_', ' ');
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

QString wordsOf(const QString& identifier) {
  return translated(texts::words, plainWordsOf(identifier).toStdString());
}

}  // namespace isolux::ui
