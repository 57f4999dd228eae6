// Says what a quality setting's table suggests to do, in a sentence or two of Markdown.
#pragma once

#include <string>

#include "app/study/study_results.h"

namespace isolux::app {

// "Leave `hit.rate` at ...: ...": what the measured rows say about the default. A row is more accurate where
// its error is below 0.9 of the other's (of light also by two standard errors) and it misses no more pixels;
// cheaper where the quartiles of its cost lie below. Of a study with at least one row.
std::string adviceOf(const QualityStudy& study);
// Why sampled hits become worse by finer steps, where they do; else "".
std::string noteOf(const QualityStudy& study);

}  // namespace isolux::app
