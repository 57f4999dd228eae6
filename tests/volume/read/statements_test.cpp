// The statementTables of docs/reference/formats.md: what every format says about itself is honoured, warned
// about or refused, and each cell names tests that are there.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/paths.h"

namespace isolux {
namespace {

namespace fs = std::filesystem;

std::string textOfFile(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

using TableRow = std::vector<std::string>;  // cells
std::vector<std::vector<TableRow>> statementTables() {
  const std::string page =
      textOfFile(fs::path(ISOLUX_SOURCE_DIR) / "tests" / "volume" / "read" / "statements.md");
  const std::size_t begin = page.find("## What a file says about itself");
  if (begin == std::string::npos) return {};
  std::istringstream lines(page.substr(begin, page.find("\n## ", begin + 3) - begin));
  std::vector<std::vector<TableRow>> found;
  bool inside = false;
  for (std::string line; std::getline(lines, line); inside = line.starts_with('|')) {
    if (!line.starts_with('|')) continue;
    if (!inside) found.emplace_back();
    TableRow cells;
    std::istringstream parts(line.substr(1));
    for (std::string cell; std::getline(parts, cell, '|');) {
      const std::size_t first = cell.find_first_not_of(' ');
      cells.push_back(
          first == std::string::npos ? "" : cell.substr(first, cell.find_last_not_of(' ') + 1 - first));
    }
    if (!cells.empty() && cells[0].starts_with("---")) continue;
    found.back().push_back(cells);
  }
  return found;
}

// "Suite.Name" of all tests, and "compare_chunked.py: name" of its parts.
std::set<std::string> namesOfTests() {
  std::set<std::string> names;
  const std::regex test(R"(TEST(?:_F|_P)?\((\w+),\s*(\w+)\))"), part(R"(\ndef (\w+)\()");
  const fs::path folder = fs::path(ISOLUX_SOURCE_DIR) / "tests" / "volume";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
    const std::string content = entry.is_regular_file() ? textOfFile(entry.path()) : "";
    const bool python = entry.path().extension() == ".py";
    for (auto it = std::sregex_iterator(content.begin(), content.end(), python ? part : test);
         it != std::sregex_iterator(); ++it)
      names.insert(python ? entry.path().filename().string() + ": " + (*it)[1].str()
                          : (*it)[1].str() + '.' + (*it)[2].str());
  }
  return names;
}

TEST(Statements, OfEveryFormatHaveAnAnswerAndATestThatIsThere) {
  const std::set<std::string> known = namesOfTests();
  ASSERT_GT(known.size(), 100u);
  const std::regex named(R"(`(\w+\.\w+|\w+\.py: \w+)`)");
  const auto all = statementTables();
  ASSERT_GE(all.size(), 3u);
  int tests = 0;
  for (const std::vector<TableRow>& table : all) {
    ASSERT_GE(table.size(), 15u) << "a head and fourteen statements";
    for (const TableRow& row : table) {
      ASSERT_EQ(row.size(), table.front().size()) << row[0];
      const bool head = &row == &table.front();
      for (const std::string& cell : row) {
        EXPECT_NE(cell, "") << row[0];
        const int before = tests;
        for (auto it = std::sregex_iterator(cell.begin(), cell.end(), named); it != std::sregex_iterator();
             ++it, ++tests)
          EXPECT_TRUE(known.contains((*it)[1].str())) << row[0] << ": " << (*it)[1];
        if (!head && &cell != &row.front()) {
          EXPECT_TRUE(tests > before || cell.starts_with("cannot occur"))
              << row[0] << ": \"" << cell << "\" names no test";
        }
      }
    }
    for (std::size_t i = 1; i < table.size(); ++i)
      EXPECT_EQ(table[i][0], all.front()[i][0]) << "every table has the same statements";
  }
  EXPECT_GT(tests, 60);
}

}  // namespace
}  // namespace isolux
