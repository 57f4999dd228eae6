// Parses words and numbers in headers strictly, independently of the locale, with few allocations.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolux::volume {

std::string_view trimmed(std::string_view text);
std::string lowered(std::string_view text);
bool sameIgnoringCase(std::string_view a, std::string_view b);
std::vector<std::string_view> wordsOf(std::string_view text);

// Return the number that the whole of `word` spells, or nullopt. Reals: "nan" and "inf" are numbers, too
// large becomes infinite, too small becomes 0.
std::optional<std::int64_t> integerOf(std::string_view word);
std::optional<double> realOf(std::string_view word);
// Return the numbers, or nullopt unless every word is a number.
std::optional<std::vector<std::int64_t>> integersOf(std::string_view text);
std::optional<std::vector<double>> realsOf(std::string_view text);

// Splits a header into lines, without "\n" or "\r\n".
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}
  std::optional<std::string_view> next();
  int number() const { return number_; }          // of the line last returned, from 1
  std::size_t offset() const { return offset_; }  // of the byte after it

 private:
  std::string_view text_;
  std::size_t offset_ = 0;
  int number_ = 0;
};

// Returns "line 3" or "line 3 (DimSize)".
std::string linePlace(int line, std::string_view field = {});

// Returns text for messages: quoted and cut to a readable length.
std::string inQuotes(std::string_view text);

}  // namespace isolux::volume
