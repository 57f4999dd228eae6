// Prints notes on stderr.
#pragma once

#include <string>

#include "volume/volume.h"

namespace isolux::app {

// Prints "isolux: note: TEXT", always one line.
void printNote(const std::string& text);
// Prints the import warnings as notes: only after success, so that a failure stays one line.
void printWarnings(const volume::Volume& volume);

}  // namespace isolux::app
