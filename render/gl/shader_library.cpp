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

void append(std::string& out, std::string_view text, std::set<std::string>& seen) {
  std::istringstream lines{std::string(text)};
  std::string line;
  int number = 0;
  while (std::getline(lines, line)) {
    ++number;
    constexpr std::string_view directive = "#include \"";
    if (line.rfind(directive, 0) == 0) {
      const std::string name =
          line.substr(directive.size(), line.find('"', directive.size()) - directive.size());
      if (seen.insert(name).second) append(out, textOf(name), seen);
      out += "#line " + std::to_string(number + 1) + "\n";
    } else {
      out += line + "\n";
    }
  }
}

}  // namespace

std::string shaderSource(std::string_view name, std::string_view defines) {
  return shaderSourceOf(textOf(name), defines);
}

std::string shaderSourceOf(std::string_view text, std::string_view defines) {
  std::string out = "#version 450 core\n" + std::string(defines) + "#line 1\n";
  std::set<std::string> seen;
  append(out, text, seen);
  return out;
}

}  // namespace isolux::render
