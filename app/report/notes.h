// Prints rows of reports, and notes on stderr.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "volume/volume.h"

namespace isolux::app {

// Prints a row of a report: the name in a column of this width, and the text on one line.
void printRow(std::ostream& out, std::string_view name, const std::string& text, std::size_t column = 14);
// Prints rows of equally many cells in columns, each as wide as its longest cell; the first row names them.
void printTable(std::ostream& out, const std::vector<std::vector<std::string>>& rows);
// Prints "isolux: note: TEXT", always one line.
void printNote(const std::string& text);
// Prints the import warnings as notes: only after success, so that a failure stays one line.
void printWarnings(const volume::Volume& volume);

}  // namespace isolux::app
