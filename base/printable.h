// Text from files and file names, made harmless for a terminal.
#pragma once

#include <string>

namespace isolux::base {

// Control characters (C0, DEL, and C1 as UTF-8 writes them), which could move the cursor or change a title,
// become '?'; so one line stays one line.
std::string printable(std::string text);

}  // namespace isolux::base
