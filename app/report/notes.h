// Prints rows of reports, and notes on stderr.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "volume/volume.h"

namespace isolux::app {

// Prints a row of a report: the name in a column of this width, and the text on one line.
void printRow(std::ostream& out, std::string_view name, const std::string& text, std::size_t column = 14);
// Prints "isolux: note: TEXT", always one line.
void printNote(const std::string& text);
// Prints the import warnings as notes: only after success, so that a failure stays one line.
void printWarnings(const volume::Volume& volume);

}  // namespace isolux::app
