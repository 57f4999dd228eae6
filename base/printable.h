// Makes text from files and file names safe to print on a terminal.
#pragma once

#include <string>

namespace isolux::base {

// Replaces control characters (C0, DEL, and C1 as UTF-8 encodes them) by '?'. Control characters could move
// the cursor, change a title or break the line.
std::string printable(std::string text);

}  // namespace isolux::base
