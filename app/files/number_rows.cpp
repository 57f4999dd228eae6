#include "app/files/number_rows.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "app/files/files.h"
#include "base/decimal_text.h"
#include "base/error.h"

namespace isolux::app {

namespace {

constexpr std::size_t kLongestFile = std::size_t{256} << 20;

constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";  // spreadsheets begin their UTF-8 with it
constexpr std::string_view kColumnSeparators = ",; \t\r";

// Between any of the separators, without quotes.
std::vector<std::string_view> splitWords(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;
       at = text.find_first_not_of(separators, at)) {
    std::string_view word = text.substr(at, text.find_first_of(separators, at) - at);
    at += word.size();
    if (word.size() > 1 && word.starts_with('"') && word.ends_with('"'))
      word = word.substr(1, word.size() - 2);
    words.push_back(word);
  }
  return words;
}

// Nothing where a word is no finite number.
std::optional<std::vector<double>> numbersOf(std::string_view text, std::string_view separators) {
  std::vector<double> numbers;
  for (const std::string_view word : splitWords(text, separators)) {
    const auto number = base::readNumber(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

// A number, also with a unit behind it, or one that is not finite.
bool beginsAsNumber(std::string_view word) {
  if (word.starts_with('+') || word.starts_with('-')) word.remove_prefix(1);
  double value = 0.0;
  const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  const bool whole = rest == word.data() + word.size();
  return error != std::errc::invalid_argument && (whole || std::isfinite(value));
}

bool isLineOfNames(std::string_view line) {
  const auto words = splitWords(line, kColumnSeparators);
  return std::ranges::none_of(words, beginsAsNumber);
}

}  // namespace

std::vector<NumberRow> readNumberRows(const std::filesystem::path& file, std::size_t columns) {
  std::string text = readTextFile(file, kLongestFile);
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  std::istringstream lines(text);
  std::vector<NumberRow> rows;
  std::size_t number = 0;
  bool first = true;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const auto numbers = numbersOf(line, kColumnSeparators);
    const bool header = first && isLineOfNames(line);
    first = false;
    if (header) continue;
    if (!numbers || numbers->size() != columns)
      base::throwInput(file.string(), "line " + std::to_string(number),
                       std::to_string(columns) + " finite numbers are needed");
    rows.push_back({*numbers, number});
  }
  if (rows.empty()) base::throwInput(file.string(), "", "holds no rows of numbers");
  return rows;
}

std::vector<glm::dvec3> parsePoints(const std::string& text, const std::string& option, std::size_t fewest,
                                    std::size_t most) {
  std::istringstream words(text);
  std::vector<glm::dvec3> points;
  for (std::string word; words >> word;) {
    const auto numbers = numbersOf(word, ",");
    if (!numbers || numbers->size() != 3)
      base::throwUsage("", option, '"' + word + "\" is not a position x,y,z in mm");
    points.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  }
  if (points.size() >= fewest && points.size() <= most) return points;
  const std::string wanted =
      fewest == most ? std::to_string(fewest) : std::to_string(fewest) + " or " + std::to_string(most);
  base::throwUsage("", option,
                   wanted + (most == 1 ? " position" : " positions") + " x,y,z are needed, not " +
                       std::to_string(points.size()));
}

}  // namespace isolux::app
