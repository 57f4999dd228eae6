#include "volume/read/input/text.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "base/error.h"

namespace isolux::volume {

using base::throwInput;

namespace {
constexpr std::string_view kSpaces = " \t\r\n\f\v";

char lower(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}
std::string_view withoutPlus(std::string_view word) {
  return word.size() > 1 && word[0] == '+' && word[1] != '-' ? word.substr(1) : word;
}
template <class T>
std::optional<std::vector<T>> numbersOf(std::string_view text,
                                        std::optional<T> (*numberOf)(std::string_view)) {
  std::vector<T> numbers;
  for (const std::string_view word : wordsOf(text)) {
    const auto number = numberOf(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}
}  // namespace

std::string_view trimmed(std::string_view text) {
  text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
  return text.substr(0, text.find_last_not_of(kSpaces) + 1);
}

std::string lowered(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(), lower);
  return result;
}

bool sameIgnoringCase(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

std::string_view nextWord(std::string_view& line) {
  line.remove_prefix(std::min(line.find_first_not_of(kSpaces), line.size()));
  const std::string_view word = line.substr(0, line.find_first_of(kSpaces));
  line.remove_prefix(word.size());
  return word;
}

std::vector<std::string_view> wordsOf(std::string_view text) {
  std::vector<std::string_view> words;
  for (auto word = nextWord(text); !word.empty(); word = nextWord(text)) words.push_back(word);
  return words;
}

std::vector<std::string_view> splitAt(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> parts;
  for (;;) {
    const std::size_t end = text.find_first_of(separators);
    parts.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return parts;
    text.remove_prefix(end + 1);
  }
}

std::optional<std::int64_t> integerOf(std::string_view word) {
  word = withoutPlus(word);
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

std::optional<double> realOf(std::string_view word) {
  word = withoutPlus(word);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const auto exponent = word.find_first_of("eE");
    const bool small =
        exponent != std::string_view::npos && word.find('-', exponent) != std::string_view::npos;
    if (small) return 0.0;
    return (word.front() == '-' ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
  }
  return value;
}

std::optional<std::vector<std::int64_t>> integersOf(std::string_view text) {
  return numbersOf(text, integerOf);
}

std::optional<std::vector<double>> realsOf(std::string_view text) {
  return numbersOf(text, realOf);
}

std::string decodedBase64(std::string_view& text) {
  constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string bytes;
  std::uint32_t bits = 0;
  for (int have = 0; !text.empty(); text.remove_prefix(1)) {
    const std::size_t digit = letters.find(text.front());
    if (digit == std::string_view::npos) break;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    have += 6;
    if (have >= 8) bytes += static_cast<char>(bits >> (have -= 8) & 0xffu);
  }
  return bytes;
}

std::optional<std::string_view> Lines::next() {
  if (offset_ >= text_.size()) return std::nullopt;
  const std::size_t end = text_.find('\n', offset_);
  std::string_view line = text_.substr(offset_, end == std::string_view::npos ? end : end - offset_);
  offset_ = end == std::string_view::npos ? text_.size() : end + 1;
  ++number_;
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return line;
}

std::string linePlace(int line, std::string_view field) {
  std::string place = "line " + std::to_string(line);
  if (!field.empty()) place += " (" + std::string(field.substr(0, 40)) + ")";
  return place;
}

const HeaderField* HeaderFields::find(std::string_view name) const {
  const auto it = fields_.find(name);
  return it == fields_.end() ? nullptr : &it->second;
}

const HeaderField& HeaderFields::need(std::string_view name, std::string_view printed) const {
  const HeaderField* field = find(name);
  if (!field) throwInput(file_, std::string(printed.empty() ? name : printed), "is missing");
  return *field;
}

std::int64_t HeaderFields::integer(const HeaderField& field) const {
  const auto value = integerOf(field.value);
  if (!value) throwInput(file_, field.place(), inQuotes(field.value) + " is not a whole number");
  return *value;
}

void HeaderFields::add(const std::string& name, const HeaderField& field, const char* fields) {
  const auto [known, isNew] = fields_.emplace(name, field);
  if (fields_.size() > 1000)
    throwInput(file_, field.place(), std::string("the header has more than 1000 ") + fields);
  if (isNew) return;
  if (known->second.value != field.value)
    throwInput(file_, field.place(), "is given twice, with different values");
  warnings_.push_back(field.place() + ": is given twice");
}

std::vector<std::string> listedFiles(std::string_view text, const std::string& file,
                                     const std::string& place) {
  std::vector<std::string> files;
  Lines lines(text);
  while (const auto line = lines.next()) {
    if (const auto name = trimmed(*line); !name.empty()) files.emplace_back(name);
    if (files.size() > 65535) throwInput(file, place, "lists more than 65535 files");
  }
  if (files.empty()) throwInput(file, place, "the list of data files is empty");
  return files;
}

std::string inQuotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  return "\"" + std::string(text.substr(0, longest)) + (text.size() > longest ? "...\"" : "\"");
}

}  // namespace isolux::volume
