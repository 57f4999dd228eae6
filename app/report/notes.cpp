#include "app/report/notes.h"

#include <algorithm>
#include <cstddef>
#include <iomanip>
#include <iostream>

#include "base/printable.h"

namespace isolux::app {

void printWarnings(const volume::Volume& volume) {
  for (const std::string& warning : volume.warnings) printNote(warning);
}

void printRow(std::ostream& out, std::string_view name, const std::string& text, std::size_t column) {
  out << name << std::string(name.size() < column ? column - name.size() : 1, ' ') << base::printable(text)
      << '\n';
}

void printTable(std::ostream& out, const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::vector<std::string>& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) {
      if (i == widths.size()) widths.push_back(0);
      widths[i] = std::max(widths[i], row[i].size());
    }
  for (const std::vector<std::string>& row : rows) {
    for (std::size_t i = 0; i + 1 < row.size(); ++i)
      out << "  " << std::left << std::setw(static_cast<int>(widths[i])) << row[i];
    out << "  " << row.back() << '\n';
  }
}

void printNote(const std::string& text) {
  std::cerr << "isolux: note: " << base::printable(text) << '\n';
}

}  // namespace isolux::app
