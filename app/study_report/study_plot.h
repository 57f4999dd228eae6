// A quality setting's study as a picture: error against time, by gnuplot and resources/plots/study.gp.
#pragma once

#include <filesystem>
#include <string>

#include "app/study/study.h"

namespace isolux::app {

// The whole script, data included, that draws to `picture`.
std::string plotScript(const QualityStudy& study, const std::string& subject, const std::string& picture);

// Writes `picture` (.svg) by `gnuplot`. False where gnuplot fails; `reason` is what it said last.
bool writePlot(const std::filesystem::path& gnuplot, const QualityStudy& study, const std::string& subject,
               const std::filesystem::path& picture, base::Progress& progress, std::string& reason);

}  // namespace isolux::app
