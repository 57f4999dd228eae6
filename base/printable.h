// Makes text from files and file names safe to print on a terminal.
#pragma once

#include <string>

namespace isolux::base {

// Replaces control characters (C0, DEL, and C1 as UTF-8 encodes them) by '?'. They could move the cursor or
// change a title; without them one line stays one line.
std::string printable(std::string text);

}  // namespace isolux::base
