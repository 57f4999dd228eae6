#include "app/files/csv_field.h"

#include <string_view>
#include <utility>

#include "base/printable.h"

namespace isolux::app {

std::string csvField(std::string text) {
  text = base::printable(std::move(text));
  if (text.find_first_of(",;\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csvWords(const std::string& text) {
  const bool formula = !text.empty() && std::string_view("=+-@").find(text.front()) != std::string_view::npos;
  return csvField(formula ? '\'' + text : text);
}

}  // namespace isolux::app
