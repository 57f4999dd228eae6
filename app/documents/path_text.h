// Paths as JSON can hold them. A file's name is any bytes, a JSON text is UTF-8.
#pragma once

#include <string>

namespace isolux::app {

// The path itself where it is UTF-8; else "bytes:" and the path with all but plain ASCII as %XX. So is one
// that begins with "bytes:".
std::string pathText(const std::string& path);
std::string pathOfText(const std::string& text);

}  // namespace isolux::app
