#include "app/files/number_rows.h"

#include <charconv>
#include <cmath>
#include <optional>
#include <sstream>

#include "app/files/files.h"
#include "base/error.h"

namespace isolux::app {

namespace {

using base::Error;
using base::ErrorKind;

constexpr std::size_t kLongestFile = std::size_t{256} << 20;

// Numbers between any of the separators; nothing where a word is no finite number.
std::optional<std::vector<double>> numbersOf(std::string_view text, std::string_view separators) {
  std::vector<double> numbers;
  for (std::size_t at = text.find_first_not_of(separators); at != std::string_view::npos;
       at = text.find_first_not_of(separators, at)) {
    const std::string_view word = text.substr(at, text.find_first_of(separators, at) - at);
    double value = 0.0;
    const char* const end = word.data() + word.size();
    const char* const begin = word.front() == '+' ? word.data() + 1 : word.data();
    const auto [stop, error] = std::from_chars(begin, end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    at += word.size();
  }
  return numbers;
}

}  // namespace

std::vector<NumberRow> readNumberRows(const std::filesystem::path& file, std::size_t columns) {
  const std::string text = readTextFile(file, kLongestFile);
  std::istringstream lines(text);
  std::vector<NumberRow> rows;
  std::size_t number = 0;
  bool first = true;
  for (std::string line; std::getline(lines, line);) {
    ++number;
    if (line.find_first_not_of(" \t\r") == std::string::npos || line.front() == '#') continue;
    const auto numbers = numbersOf(line, ",; \t\r");
    const bool header = first && !numbers;
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
      throw Error(ErrorKind::usage, "", option, '"' + word + "\" is no position x,y,z in mm");
    points.emplace_back((*numbers)[0], (*numbers)[1], (*numbers)[2]);
  }
  if (points.size() >= fewest && points.size() <= most) return points;
  const std::string wanted =
      fewest == most ? std::to_string(fewest) : std::to_string(fewest) + " or " + std::to_string(most);
  throw Error(ErrorKind::usage, "", option,
              wanted + (most == 1 ? " position" : " positions") + " x,y,z are needed, not " +
                  std::to_string(points.size()));
}

}  // namespace isolux::app
