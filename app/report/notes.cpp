#include "app/report/notes.h"

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

void printNote(const std::string& text) {
  std::cerr << "isolux: note: " << base::printable(text) << '\n';
}

}  // namespace isolux::app
