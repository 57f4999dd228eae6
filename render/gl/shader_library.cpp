#include "render/gl/shader_library.h"

#include <set>
#include <sstream>
#include <stdexcept>

namespace isolux::render {

namespace {

std::string_view textOf(std::string_view name) {
  for (int i = 0; i < embeddedShaderCount; ++i)
    if (name == embeddedShaders[i].name) return embeddedShaders[i].text;
  throw std::logic_error("no embedded shader " + std::string(name));
}

void append(std::string& out, std::string_view name, std::set<std::string>& seen) {
  if (!seen.insert(std::string(name)).second) return;
  std::istringstream lines{std::string(textOf(name))};
  std::string line;
  int number = 0;
  while (std::getline(lines, line)) {
    ++number;
    constexpr std::string_view directive = "#include \"";
    if (line.rfind(directive, 0) == 0) {
      append(out, line.substr(directive.size(), line.find('"', directive.size()) - directive.size()), seen);
      out += "#line " + std::to_string(number + 1) + "\n";
    } else {
      out += line + "\n";
    }
  }
}

}  // namespace

std::string shaderSource(std::string_view name, std::string_view defines) {
  std::string out = "#version 450 core\n" + std::string(defines) + "#line 1\n";
  std::set<std::string> seen;
  append(out, name, seen);
  return out;
}

}  // namespace isolux::render
