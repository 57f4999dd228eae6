// Plots by gnuplot, a program of its own: whole pictures or none.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "base/progress.h"

namespace isolux::app {

// A word of gnuplot's language.
std::string gnuplotText(const std::string& text);

// Runs the script that `script` makes for the name of an .svg; the finished one stands at `picture`. Says why
// there is none; nothing: it is there. Throws Error{input} where the folder cannot be written,
// Error{interrupted}.
std::optional<std::string> drawPlot(const std::filesystem::path& gnuplot,
                                    const std::filesystem::path& picture,
                                    const std::function<std::string(const std::string& picture)>& script,
                                    base::Progress& progress);

}  // namespace isolux::app
