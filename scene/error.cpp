#include "scene/error.h"

#include <algorithm>

namespace isolux::scene {

namespace {
// One line, whatever a hostile file put into the strings: control characters become '?', long parts are cut.
std::string printable(std::string text) {
  constexpr std::size_t longest = 400;
  if (text.size() > longest) text.replace(longest, std::string::npos, "...");
  std::replace_if(
      text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
  return text;
}

std::string joined(const std::string& file, const std::string& place, const std::string& reason) {
  std::string line = file;
  for (const std::string* part : {&place, &reason}) {
    if (part->empty()) continue;
    if (!line.empty()) line += ": ";
    line += *part;
  }
  return line;
}
}  // namespace

Error::Error(ErrorKind kind, std::string file, std::string place, std::string reason)
    : std::runtime_error(joined(printable(file), printable(place), printable(reason))),
      kind_(kind),
      file_(printable(std::move(file))),
      place_(printable(std::move(place))),
      reason_(printable(std::move(reason))) {}

void throwInput(const std::string& file, const std::string& place, const std::string& reason) {
  throw Error(ErrorKind::input, file, place, reason);
}

}  // namespace isolux::scene
