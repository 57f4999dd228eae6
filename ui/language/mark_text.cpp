#include "ui/language/mark_text.h"

#include <QObject>

#include "app/marks/mark_kinds.h"
#include "ui/language/sentences.h"
#include "ui/language/translated.h"

namespace isolux::ui {

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

}  // namespace isolux::ui
