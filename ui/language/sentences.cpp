#include "ui/language/sentences.h"

#include <vector>

#include <QCoreApplication>
#include <QRegularExpression>

#include "app/marks/mark_kinds.h"
#include "ui/language/translated.h"

namespace isolux::ui {

namespace {

constexpr const char* sentences[] = {
    // why a picture is empty
    QT_TRANSLATE_NOOP("sentences", "No surface: the volume has only one voxel along an axis"),
    QT_TRANSLATE_NOOP("sentences", "No surface: all voxels are missing"),
    QT_TRANSLATE_NOOP("sentences", "No surface at %1: the data range is %2 to %3"),
    QT_TRANSLATE_NOOP("sentences", "The camera looks away from the volume"),
    QT_TRANSLATE_NOOP("sentences", "The volume is outside the image"),
    QT_TRANSLATE_NOOP("sentences", "No surface is visible from here"),
    QT_TRANSLATE_NOOP("sentences", "Every isosurface is fully transparent"),
    QT_TRANSLATE_NOOP("sentences", "The isosurface is fully transparent"),
    // how it is known what kind of data a volume is
    QT_TRANSLATE_NOOP("sentences", "source.kind is set"),
    QT_TRANSLATE_NOOP("sentences", "its values are few whole numbers that fill regions"),
    QT_TRANSLATE_NOOP("sentences", "its header lists segments"),
    QT_TRANSLATE_NOOP("sentences", "its header has a table of labels"),
    QT_TRANSLATE_NOOP("sentences", "its metadata say image-label"),
    QT_TRANSLATE_NOOP("sentences", "its intent_code is %1, labels"),
    QT_TRANSLATE_NOOP("sentences", "it is a DICOM segmentation"),
    QT_TRANSLATE_NOOP("sentences", "its name ends in %1"),
    QT_TRANSLATE_NOOP("sentences", "its name is that of FreeSurfer's labels"),
    QT_TRANSLATE_NOOP("sentences", "%1 beside it names labels"),
    QT_TRANSLATE_NOOP("sentences", "%1 names labels"),
    QT_TRANSLATE_NOOP("sentences", "its file states it"),
    QT_TRANSLATE_NOOP("sentences", "it was made from a mesh"),
    QT_TRANSLATE_NOOP("sentences", "its values are in mm"),
    QT_TRANSLATE_NOOP("sentences", "its values are in %1"),
    QT_TRANSLATE_NOOP("sentences", "its data range is that of a CT"),
    QT_TRANSLATE_NOOP("sentences", "most of its voxels have the value of soft tissue, as in a CT"),
    QT_TRANSLATE_NOOP("sentences", "it is a scan of a patient, and its values are not those of a CT"),
    QT_TRANSLATE_NOOP("sentences", "its voxels are smaller than 2 micrometres"),
    QT_TRANSLATE_NOOP("sentences", "its values have no noise"),
    QT_TRANSLATE_NOOP("sentences", "there is no other evidence"),
    // how long ago an autosave was written
    QT_TRANSLATE_NOOP("sentences", "%1 s ago"), QT_TRANSLATE_NOOP("sentences", "%1 min ago"),
    QT_TRANSLATE_NOOP("sentences", "%1 h ago"), QT_TRANSLATE_NOOP("sentences", "%1 days ago"),
    // what marks measure
    QT_TRANSLATE_NOOP("sentences", "straight"), QT_TRANSLATE_NOOP("sentences", "straight %1 %2"),
    QT_TRANSLATE_NOOP("sentences", "along surface"), QT_TRANSLATE_NOOP("sentences", "along surface %1 %2"),
    QT_TRANSLATE_NOOP("sentences", "angle"), QT_TRANSLATE_NOOP("sentences", "radius"),
    QT_TRANSLATE_NOOP("sentences", "centre %1"), QT_TRANSLATE_NOOP("sentences", "ray"),
    QT_TRANSLATE_NOOP("sentences", "ball"), QT_TRANSLATE_NOOP("sentences", "volume"),
    QT_TRANSLATE_NOOP("sentences", "area"), QT_TRANSLATE_NOOP("sentences", "piece"),
    QT_TRANSLATE_NOOP("sentences", "pieces"), QT_TRANSLATE_NOOP("sentences", "surface"),
    QT_TRANSLATE_NOOP("sentences", "surface distance"), QT_TRANSLATE_NOOP("sentences", "value"),
    QT_TRANSLATE_NOOP("sentences", "confidence"), QT_TRANSLATE_NOOP("sentences", "scale"),
    QT_TRANSLATE_NOOP("sentences", "edge offset"), QT_TRANSLATE_NOOP("sentences", "edge strength"),
    // why they do not, or doubtfully
    QT_TRANSLATE_NOOP("sentences", "the point is not on the surface: no surface within three voxels"),
    QT_TRANSLATE_NOOP("sentences", "point %1 is not on the surface: no surface within three voxels"),
    QT_TRANSLATE_NOOP("sentences", "the point is %1 mm off the surface"),
    QT_TRANSLATE_NOOP("sentences", "point %1 is %2 mm off the surface"),
    QT_TRANSLATE_NOOP("sentences", "no isosurface of %1 within three voxels of the point"),
    QT_TRANSLATE_NOOP("sentences", "no isosurface of %1 within three voxels of point %2"),
    QT_TRANSLATE_NOOP("sentences", "the point is outside the volume or next to missing voxels"),
    QT_TRANSLATE_NOOP("sentences", "no path along the surface from point %1 to point %2"),
    QT_TRANSLATE_NOOP("sentences", "two of the points coincide"),
    QT_TRANSLATE_NOOP("sentences", "the points are on a line"),
    QT_TRANSLATE_NOOP("sentences", "the inside behind the point extends beyond the data"),
    QT_TRANSLATE_NOOP("sentences", "the point is in no connected component at isovalue %1"),
    QT_TRANSLATE_NOOP("sentences", "the component is open: it extends beyond the data"),
    QT_TRANSLATE_NOOP("sentences", "not enough memory"), QT_TRANSLATE_NOOP("sentences", "stopped"),
    // what a picture leaves out, and what of it nobody measured
    QT_TRANSLATE_NOOP("sentences", "%1 of %2 pieces hidden"),
    QT_TRANSLATE_NOOP("sentences", "%1 gap interpolated"),
    QT_TRANSLATE_NOOP("sentences", "%1 gaps interpolated"),
    QT_TRANSLATE_NOOP("sentences", "uneven slices resampled"),
    QT_TRANSLATE_NOOP("sentences", "parts missing"),
    // why no settings keep an error or a time, and the errors in it
    QT_TRANSLATE_NOOP("sentences",
                      "no settings keep %1 ms; the fastest take about %2 ms; choose a smaller image"),
    QT_TRANSLATE_NOOP("sentences",
                      "no settings keep %1; the smallest guaranteed error is %2; a larger image, gi.samples "
                      "above 1024 or gi.lattice_scale above 2 may keep it"),
    QT_TRANSLATE_NOOP("sentences", "no settings keep %1; the smallest guaranteed error is %2"),
    QT_TRANSLATE_NOOP("sentences", "depth at most %1 mm"), QT_TRANSLATE_NOOP("sentences", "depth %1 mm"),
    QT_TRANSLATE_NOOP("sentences", "depth at most %1 voxels"),
    QT_TRANSLATE_NOOP("sentences", "depth %1 voxels"), QT_TRANSLATE_NOOP("sentences", "missed at most %1 %"),
    QT_TRANSLATE_NOOP("sentences", "missed %1 %"),
    QT_TRANSLATE_NOOP("sentences", "normal at most %1 degrees"),
    QT_TRANSLATE_NOOP("sentences", "normal %1 degrees"),
    QT_TRANSLATE_NOOP("sentences", "curvature at most %1 %"),
    QT_TRANSLATE_NOOP("sentences", "curvature %1 %"), QT_TRANSLATE_NOOP("sentences", "light at most %1 %"),
    QT_TRANSLATE_NOOP("sentences", "light %1 %")};

struct Pattern {
  const char* text;
  QRegularExpression matches;
};

const std::vector<Pattern>& patterns() {
  static const std::vector<Pattern> list = [] {
    std::vector<Pattern> made;
    for (const char* const text : sentences) {
      QString expression = QRegularExpression::escape(QString::fromUtf8(text));
      for (const char* const place : {"\\%1", "\\%2", "\\%3"}) expression.replace(place, "(.+?)");
      made.push_back({text, QRegularExpression(QRegularExpression::anchoredPattern(expression),
                                               QRegularExpression::DotMatchesEverythingOption)});
    }
    return made;
  }();
  return list;
}

QRegularExpressionMatchIterator cellsIn(const QString& html) {
  static const QRegularExpression cell("<(td|h4)>(.*?)</\\1>");
  return cell.globalMatch(html);
}

}  // namespace

namespace {

// Each captured text as `shown` shows it.
template <class Shown>
QString translatedBy(std::string_view english, const Shown& shown) {
  const QString text = QString::fromUtf8(english.data(), static_cast<qsizetype>(english.size()));
  for (const Pattern& pattern : patterns()) {
    const QRegularExpressionMatch match = pattern.matches.match(text);
    if (!match.hasMatch()) continue;
    const QString translation = QCoreApplication::translate("sentences", pattern.text);
    const auto part = [&](int i) -> QString { return shown(match.captured(i)); };
    switch (match.lastCapturedIndex()) {
      case 1:
        return translation.arg(part(1));
      case 2:
        return translation.arg(part(1), part(2));
      case 3:
        return translation.arg(part(1), part(2), part(3));
      default:
        return translation;
    }
  }
  return text;
}

}  // namespace

QString translatedSentence(std::string_view english) {
  return translatedBy(english, [](const QString& part) { return part; });
}

QString translatedWithParts(std::string_view english) {
  return translatedBy(english, [](const QString& list) {
    QStringList parts = list.split(", ");
    for (QString& part : parts) part = translatedSentence(part.toStdString());
    return parts.join(", ");
  });
}

QString markText(const scene::Mark& mark, const app::MarkReport& report) {
  QString text =
      QString("%1 (%2)\n")
          .arg(QString::fromStdString(mark.name), translated(texts::marks, app::markKind(mark.kind).name));
  const auto add = [&text](const QString& line) { text += "  " + line + '\n'; };
  if (!report.place.empty()) add(QString::fromStdString(report.place));
  for (const app::MarkQuantity& quantity : report.quantities)
    add(translatedSentence(QString::fromStdString(quantity.name).replace('_', ' ').toStdString()) + ": " +
        QString::fromStdString(app::quantityText(quantity)));
  if (!report.problem.empty()) add(QObject::tr("not measured: %1").arg(translatedSentence(report.problem)));
  for (const std::string& note : report.notes) add(QObject::tr("note: %1").arg(translatedSentence(note)));
  return text;
}

std::span<const char* const> knownSentences() {
  return sentences;
}

QString translatedCells(const char* context, const QString& html) {
  QString text;
  qsizetype done = 0;
  for (auto cells = cellsIn(html); cells.hasNext();) {
    const QRegularExpressionMatch cell = cells.next();
    text += html.mid(done, cell.capturedStart(2) - done) +
            QCoreApplication::translate(context, cell.captured(2).toUtf8().constData());
    done = cell.capturedEnd(2);
  }
  return text + html.mid(done);
}

QStringList cellsOf(const QString& html) {
  QStringList list;
  for (auto cells = cellsIn(html); cells.hasNext();) list += cells.next().captured(2);
  return list;
}

}  // namespace isolux::ui
