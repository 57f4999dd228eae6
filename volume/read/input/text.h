// Parses words and numbers in headers strictly, independently of the locale, with few allocations.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace isolux::volume {

std::string_view trimmed(std::string_view text);
std::string lowered(std::string_view text);
bool sameIgnoringCase(std::string_view a, std::string_view b);
std::string_view nextWord(std::string_view& line);  // taken off the line; empty at its end
std::vector<std::string_view> wordsOf(std::string_view text);
// Returns the parts between any of these characters, empty ones too.
std::vector<std::string_view> splitAt(std::string_view text, std::string_view separators);

// Return the number that the whole of `word` spells, or nullopt. Reals: "nan" and "inf" are numbers, too
// large becomes infinite, too small becomes 0.
std::optional<std::int64_t> integerOf(std::string_view word);
std::optional<double> realOf(std::string_view word);
// Return the numbers, or nullopt unless every word is a number.
std::optional<std::vector<std::int64_t>> integersOf(std::string_view text);
std::optional<std::vector<double>> realsOf(std::string_view text);

// Decodes base64, taken off the front of `text` up to the first other character.
std::string decodedBase64(std::string_view& text);

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

struct HeaderField {
  std::string_view name, value;
  int line = 0;
  std::string place() const { return linePlace(line, name); }
};
// The fields of a header by the names that its format gives them. Throws base::Error{input}.
class HeaderFields {
 public:
  explicit HeaderFields(std::string file) : file_(std::move(file)) {}
  const HeaderField* find(std::string_view name) const;
  // `printed`: in the error where it is missing, if not the name.
  const HeaderField& need(std::string_view name, std::string_view printed = {}) const;
  std::int64_t integer(const HeaderField& field) const;

 protected:
  // Of a field that is given twice the first counts, with a warning; values that differ throw. `fields`: what
  // the format calls them.
  void add(const std::string& name, const HeaderField& field, const char* fields);

  std::string file_;
  std::vector<std::string> warnings_;

 private:
  std::map<std::string, HeaderField, std::less<>> fields_;
};
// Returns the names of data files that stand behind a header, one a line. Throws base::Error{input} at
// `place` unless there are 1 to 65535.
std::vector<std::string> listedFiles(std::string_view text, const std::string& file,
                                     const std::string& place);

// Returns text for messages: quoted and cut to a readable length.
std::string inQuotes(std::string_view text);

}  // namespace isolux::volume
