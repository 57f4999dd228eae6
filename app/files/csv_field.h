// Writes texts as fields of CSV files.
#pragma once

#include <string>

namespace isolux::app {

// Returns the text on one line, in quotes if it holds what separates fields.
std::string csvField(std::string text);
// The same of text of other people: what a spreadsheet would take for a formula begins with an apostrophe,
// its mark of a text.
std::string csvWords(const std::string& text);

}  // namespace isolux::app
