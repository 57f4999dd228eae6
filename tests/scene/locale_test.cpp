// Reads every source of the tree: none writes or reads a decimal number in the form of the process's locale,
// which a program that loads the Python module chooses. base/decimal_text.h and base/number_text.h know no
// locale.
#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;
using testing::IsEmpty;

constexpr std::array kNames{"strto", "sto", "atof", "scanf", "printf"};

// std::printf writes what commands print, and no command sets a locale.
std::vector<std::string> localeIn(const std::string& path, const std::string& content) {
  static const std::regex calls(R"(\b(strto(d|f|ld)|sto(d|f|ld)|atof|v?sscanf)\()"),
      formats(R"(\bv?s?n?printf\([^;]*%[-+ #0-9.*]*[aefgAEFG])"), comment(R"(//.*)"),
      whole(R"(\bsscanf\([^;]*"[^"efgEFG]*")"), toOutput(R"(std::printf\()");
  std::vector<std::string> found;
  std::stringstream lines(content);
  int number = 0;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (std::none_of(kNames.begin(), kNames.end(),
                     [&](const char* name) { return line.find(name) != line.npos; }))
      continue;  // an expression takes its time
    line = std::regex_replace(line, comment, "");
    const bool integers = std::regex_search(line, whole);
    const bool format = std::regex_search(line, formats) && !std::regex_search(line, toOutput);
    if ((std::regex_search(line, calls) && !integers) || format)
      found.push_back(path + ':' + std::to_string(number) + ": " + line);
  }
  return found;
}

TEST(NumbersInEveryLocale, NoSourceAsksTheLocale) {
  const fs::path root(ISOLUX_SOURCE_DIR);
  int files = 0;
  for (const char* folder : {"base", "scene", "volume", "gi", "render", "readers", "app", "ui", "python"})
    for (const auto& entry : fs::recursive_directory_iterator(root / folder)) {
      const std::string extension = entry.path().extension().string();
      if (extension != ".cpp" && extension != ".h") continue;
      std::stringstream content;
      content << std::ifstream(entry.path()).rdbuf();
      EXPECT_THAT(localeIn(fs::relative(entry.path(), root).generic_string(), content.str()), IsEmpty());
      ++files;
    }
  EXPECT_GT(files, 500) << "the test does not look where the sources are";
}

TEST(NumbersInEveryLocale, FindsEachKind) {
  for (const char* text :
       {"x = std::strtod(t, nullptr);", "x = std::stod(t);", "x = atof(t);", "std::sscanf(t, \"%lf\", &x);",
        "std::snprintf(t, sizeof t, \"%.*f\", 2, x);", "std::snprintf(t, n, \"%d of %.3g\", i, x);"})
    EXPECT_EQ(localeIn("a.cpp", text).size(), 1u) << text;
  for (const char* text : {"std::printf(\"%.3g s\\n\", x);", "std::snprintf(t, n, \"%05d\", i);",
                           "std::sscanf(at, \"%5[0-9]%*1[x_-]%5[0-9]\", x, y);", "// strtod( knows it"})
    EXPECT_THAT(localeIn("a.cpp", text), IsEmpty()) << text;
}

}  // namespace
}  // namespace isolux
