#include "app/report/notes.h"

#include <iostream>

#include "base/printable.h"

namespace isolux::app {

void printWarnings(const volume::Volume& volume) {
  for (const std::string& warning : volume.warnings) printNote(warning);
}

void printNote(const std::string& text) {
  std::cerr << "isolux: note: " << base::printable(text) << '\n';
}

}  // namespace isolux::app
