// The manual page isolux(1), made of what the parser knows, so that it says what --help says.
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace isolux::app {

// In roff (man macros). The build calls `isolux --man-page` for it, which --help does not show.
std::string manPage(const CLI::App& program, const std::string& version);

}  // namespace isolux::app
