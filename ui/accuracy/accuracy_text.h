// How accurate a picture is, and what settings keep an error or a time, in the window's words.
#pragma once

#include <QString>

#include "app/accuracy/accuracy.h"
#include "app/error_budget/target_search.h"
#include "base/error.h"

namespace isolux::ui {

// "Depth ± 0.23 µm · normal ± 0.0004° · 0.02 % not certain": bounds that 99 % of what is seen keep, and the
// share of pixels. `curvature`: the look shows it.
QString accuracyText(const app::Accuracy& accuracy, bool curvature);
// What those figures mean, and what noise adds.
QString accuracyMeaning(const app::Accuracy& accuracy);

// "mm (depth)", "% of the light".
QString unitTextOf(app::Quantity quantity);
// What 1 of that unit is in a Limit's number.
double unitOf(app::Quantity quantity);
// What a choice changes, a line each; that nothing changes; then what is kept and what a picture takes.
QString answerText(const app::TargetAnswer& answer);
// Why a search found nothing, as a sentence.
QString refusalText(const base::Error& error);
QString ignoredText(app::Quantity asked);  // that the picture does not have
QString nothingSeenText();

}  // namespace isolux::ui
