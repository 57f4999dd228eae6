// What this machine offers, and what Isolux would use, as text.
#pragma once

#include <ostream>
#include <string>

#include "base/progress.h"

namespace isolux::app {

// Makes graphics contexts on the calling thread. `window`: how the window would show images; empty: not said.
// Throws Error{interrupted}.
void printDoctor(std::ostream& out, const std::string& window, base::Progress& progress);

}  // namespace isolux::app
