#include "base/error.h"

#include <utility>

#include "base/printable.h"

namespace isolux::base {

namespace {
// One line, whatever a hostile file put into the strings; long parts are cut.
std::string brief(std::string text) {
  constexpr std::size_t longest = 400;
  if (text.size() > longest) text.replace(longest, std::string::npos, "...");
  return printable(std::move(text));
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
    : std::runtime_error(joined(brief(file), brief(place), brief(reason))),
      kind_(kind),
      file_(brief(std::move(file))),
      place_(brief(std::move(place))),
      reason_(brief(std::move(reason))) {}

void throwInput(const std::string& file, const std::string& place, const std::string& reason) {
  throw Error(ErrorKind::input, file, place, reason);
}

void throwUsage(const std::string& file, const std::string& place, const std::string& reason) {
  throw Error(ErrorKind::usage, file, place, reason);
}

}  // namespace isolux::base
