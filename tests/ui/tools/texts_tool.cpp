// Writes a C++ source that names the texts of tests/ui/language/listed_texts.h, for lupdate: ./dev texts.
#include <cstdio>
#include <exception>
#include <string>

#include "tests/ui/language/listed_texts.h"

namespace {

std::string literal(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

}  // namespace

int main() {
  try {
    for (const auto& [context, text] : isolux::test::listedTexts())
      std::printf("QT_TRANSLATE_NOOP(%s, %s)\n", literal(context).c_str(), literal(text).c_str());
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "isolux_texts: %s\n", error.what());
    return 1;
  }
}
