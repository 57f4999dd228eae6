// What this machine offers, and what Isolux would use, as text.
#pragma once

#include <ostream>

#include "base/progress.h"

namespace isolux::app {

// Makes graphics contexts on the calling thread. Throws Error{interrupted}.
void printDoctor(std::ostream& out, base::Progress& progress);

}  // namespace isolux::app
