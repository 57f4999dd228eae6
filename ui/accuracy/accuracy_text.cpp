#include "ui/accuracy/accuracy_text.h"

#include <algorithm>
#include <cmath>

#include <QObject>
#include <QStringList>

#include "app/study/quality_settings.h"
#include "scene/settings/settings.h"
#include "ui/language/number_text.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"

namespace isolux::ui {

namespace {

constexpr double micrometresBelow = 1e-3;  // mm
constexpr double millimetresToMicrometres = 1e3;

struct QuantityWords {
  const char* unit;
  const char* kept;  // %1: its bound
  double scale;      // of a number in this unit
};
// In the order of app::Quantity.
constexpr QuantityWords kQuantityWords[app::kQuantities] = {
    {QT_TRANSLATE_NOOP("QObject", "mm (depth)"), QT_TRANSLATE_NOOP("QObject", "depth error ≤ %1 mm"), 1.0},
    {QT_TRANSLATE_NOOP("QObject", "voxels (depth)"), QT_TRANSLATE_NOOP("QObject", "depth error ≤ %1 voxels"),
     1.0},
    {QT_TRANSLATE_NOOP("QObject", "% (missed pixels)"), QT_TRANSLATE_NOOP("QObject", "missed pixels ≤ %1 %"),
     0.01},
    {QT_TRANSLATE_NOOP("QObject", "degrees (normals)"), QT_TRANSLATE_NOOP("QObject", "normal error ≤ %1°"),
     1.0},
    {QT_TRANSLATE_NOOP("QObject", "% (curvature)"), QT_TRANSLATE_NOOP("QObject", "curvature error ≤ %1 %"),
     0.01},
    {QT_TRANSLATE_NOOP("QObject", "% (light)"), QT_TRANSLATE_NOOP("QObject", "light error ≤ %1 %"), 0.01}};

const QuantityWords& quantityWords(app::Quantity quantity) {
  return kQuantityWords[app::indexOf(quantity)];
}

QString roundedText(double value) {
  return numberText(value, 2);
}

QString lengthText(double mm) {
  return mm < micrometresBelow ? QObject::tr("%1 µm").arg(roundedText(mm * millimetresToMicrometres))
                               : QObject::tr("%1 mm").arg(roundedText(mm));
}

QString boundText(const QString& pattern, double bound, const QString& text) {
  if (std::isnan(bound)) return {};
  return std::isinf(bound) ? pattern.arg(QObject::tr("unbounded")) : pattern.arg(text);
}

QString settingText(const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  const std::string path = assignment.substr(0, equals);
  const auto value = QString::fromStdString(assignment.substr(equals + 1));
  const std::vector<app::QualitySetting>& list = app::qualitySettings();
  const auto quality = std::find_if(list.begin(), list.end(),
                                    [&](const app::QualitySetting& each) { return path == each.setting; });
  QString name = quality != list.end() ? wordsOf(QString(quality->label)) : nameOf(scene::setting(path));
  name[0] = name[0].toUpper();
  bool isNumber = false;
  value.toDouble(&isNumber);
  return QObject::tr("%1: %2").arg(name, isNumber ? value : wordsOf(value));
}

QString keptText(const app::Limit& limit, double bound) {
  if (limit.quantity == app::Quantity::missed && bound == 0.0) return QObject::tr("no missed pixels");
  return QObject::tr(quantityWords(limit.quantity).kept).arg(numberText(bound / unitOf(limit.quantity), 2));
}

}  // namespace

QString accuracyText(const app::Accuracy& accuracy, bool curvature) {
  const QString share =
      QObject::tr("%1 % of pixels uncertain").arg(roundedText(100.0 * accuracy.uncertainShare()));
  if (accuracy.seen == 0) return QObject::tr("Nothing visible · %1").arg(share);
  if (accuracy.seen == accuracy.uncertain) return QObject::tr("No certain pixels · %1").arg(share);
  const double data = accuracy.depthNoiseMm.most99, depth = accuracy.depthMm.most99,
               normal = accuracy.normalDegrees.most99, relative = accuracy.relativeCurvature.most99;
  QStringList parts{
      boundText(QObject::tr("Depth ± %1 (noise, discretisation)"), data, lengthText(data)),
      boundText(std::isnan(data) ? QObject::tr("Depth ± %1") : QObject::tr("rounding ± %1"), depth,
                lengthText(depth)),
      boundText(QObject::tr("normal ± %1"), normal, QObject::tr("%1°").arg(roundedText(normal)))};
  if (curvature)
    parts += boundText(QObject::tr("curvature ± %1"), relative,
                       QObject::tr("%1 %").arg(roundedText(100.0 * relative)));
  const double light = accuracy.relativeLightWithin;
  parts += boundText(QObject::tr("light ± %1"), light, QObject::tr("%1 %").arg(roundedText(100.0 * light)));
  parts += share;
  parts.removeAll(QString());
  return parts.join(" · ");
}

QString accuracyMeaning(const app::Accuracy& accuracy) {
  QString text =
      QObject::tr(
          "Error bounds of the visible surface. Noise and discretisation: against the object itself. "
          "Rounding: against the same view in double precision.\nThese bounds hold for 99 % of visible "
          "pixels (light: %2 %).\nA pixel is uncertain if rounding may change the surface that it shows, for "
          "example along edges.\nComputed with one ray through the centre of each pixel, %1 pixels.")
          .arg(accuracy.pixels)
          .arg(roundedText(100.0 * app::kLightLevel));
  const double noise = accuracy.normalNoiseDegrees.median;
  if (std::isfinite(noise) && noise > 0.0)
    text += '\n' + QObject::tr("Noise turns a typical normal by up to %1°.").arg(roundedText(noise));
  return text;
}

QString unitTextOf(app::Quantity quantity) {
  return QObject::tr(quantityWords(quantity).unit);
}

double unitOf(app::Quantity quantity) {
  return quantityWords(quantity).scale;
}

QString answerText(const app::TargetAnswer& answer) {
  const app::MeasuredCandidate& chosen = answer.measured[answer.chosen];
  QStringList lines;
  for (const std::string& assignment : chosen.candidate.assignments) lines += settingText(assignment);
  if (lines.isEmpty()) lines += QObject::tr("The current settings already meet this.");
  QStringList kept;
  for (const app::Limit& limit : answer.limits) {
    const double bound = chosen.errors[app::indexOf(limit.quantity)].bound;
    if (std::isfinite(bound)) kept += keptText(limit, bound);
  }
  const double time = answer.expectedMilliseconds;
  const QString takes =
      QObject::tr("Render time about %1 ms; %2")
          .arg(numberText(time < 100.0 ? time : std::round(time / 10.0) * 10.0, 2 + (time >= 100.0 ? 4 : 0)),
               kept.join(", "));
  lines += takes;
  return lines.join('\n');
}

QString refusalText(const base::Error& error) {
  QString text = translatedWithParts(error.reason());
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString ignoredText(app::Quantity asked) {
  switch (asked) {
    case app::Quantity::light:
      return QObject::tr("This image uses no baked light; no settings to choose");
    case app::Quantity::curvature:
      return QObject::tr("This image uses no significant curvature; no settings to choose");
    default:
      break;
  }
  return QObject::tr("This image has no such error; no settings to choose");
}

QString nothingSeenText() {
  return QObject::tr("The first isosurface is not visible; no settings to choose");
}

}  // namespace isolux::ui
