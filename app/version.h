// The program's name and version, as `isolux --version` and --stats print them.
#pragma once

#include <string_view>

namespace isolux::app {

std::string_view version();  // "0.2.0"

}  // namespace isolux::app
