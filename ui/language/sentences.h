// Sentences of the layers below into which they put numbers and names, in the window's language.
#pragma once

#include <span>
#include <string_view>

#include <QString>
#include <QStringList>

#include "app/marks/mark_report.h"

namespace isolux::ui {

// By the first pattern of knownSentences() that all of the text fits; what stands at %1, %2, %3 is taken over
// as it is. A text that fits none stays English.
QString translatedSentence(std::string_view english);

// The same where what is put in are lists of sentences of their own, separated by ", ".
QString translatedWithParts(std::string_view english);

// All that a mark says, a line each: app/marks/mark_report.h has it in English.
QString markText(const scene::Mark& mark, const app::MarkReport& report);

// "%1 min ago": texts of app/ and render/, each with %1 ... %3 where something is put in. A test looks
// whether they are still said.
std::span<const char* const> knownSentences();

// The headings <h4> and the cells <td> of an HTML text, each in the window's language; they do not hold one
// another, and end in the line that they begin in.
QString translatedCells(const char* context, const QString& html);
QStringList cellsOf(const QString& html);

}  // namespace isolux::ui
