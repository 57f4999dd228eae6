// Returns the version of the program, as `isolux --version` and --stats print it.
#pragma once

#include <string_view>

namespace isolux::app {

std::string_view version();  // "0.2.0"

}  // namespace isolux::app
