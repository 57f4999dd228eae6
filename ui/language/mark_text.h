// What a mark says, in the window's language: app/marks/mark_report.h has it in English.
#pragma once

#include <QString>

#include "app/marks/mark_report.h"

namespace isolux::ui {

// All of it, a line each.
QString markText(const scene::Mark& mark, const app::MarkReport& report);

}  // namespace isolux::ui
