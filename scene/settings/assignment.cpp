#include "scene/settings/assignment.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/number_text.h"

namespace isolux::scene {

namespace {

using nlohmann::json;

std::string_view trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// A whole word as a finite number; empty when it is none.
std::optional<double> numberOf(std::string_view word) {
  word = trimmed(word);
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

json numberOrWord(std::string_view word) {
  const std::optional<double> number = numberOf(word);
  return number ? json(*number) : json(std::string(word));
}

// "a,b,c" as a list of so many numbers; empty when it is none.
std::optional<json> numbersOf(std::string_view words, std::size_t count) {
  json list = json::array();
  std::size_t begin = 0;
  while (begin <= words.size() && list.size() <= count) {
    const std::size_t comma = std::min(words.find(',', begin), words.size());
    const std::optional<double> number = numberOf(words.substr(begin, comma - begin));
    if (!number) return std::nullopt;
    list.push_back(*number);
    begin = comma + 1;
  }
  return list.size() == count ? std::optional(list) : std::nullopt;
}

// What the words of an assignment mean for this setting; a word that makes no sense stays a word, which
// Setting::set then refuses with the reason.
json valueOfWords(const SettingInfo& target, std::string_view text) {
  if (target.type == SettingType::text) return std::string(text);
  const std::string_view word = trimmed(text);
  if (target.type == SettingType::choice || (target.mayBeAutomatic && word == "auto"))
    return std::string(word);
  if (target.type == SettingType::planes && !word.starts_with('[')) return planesOf(word);
  if (target.type == SettingType::points || target.type == SettingType::color_points ||
      target.type == SettingType::marks || target.type == SettingType::planes) {
    json list = json::parse(word, nullptr, false);
    return list.is_discarded() ? json(std::string(word)) : list;
  }
  if (target.type == SettingType::positions) {
    if (!word.starts_with('[')) return positionsOf(word);
    json list = json::parse(word, nullptr, false);
    return list.is_discarded() ? json(std::string(word)) : list;
  }
  const bool yes = word == "true" || word == "on", no = word == "false" || word == "off";
  if (target.type == SettingType::toggle) {
    if (yes || word == "1") return true;
    if (no || word == "0") return false;
    return std::string(word);
  }
  // A strength from 0 to 1 is also switched by word.
  if (target.type == SettingType::number && target.minimum == 0.0 && target.maximum == 1.0 && (yes || no))
    return yes ? 1.0 : 0.0;
  const std::size_t components = componentsOf(target.type);
  if (components == 0) return numberOrWord(word);
  return numbersOf(word, components).value_or(json(std::string(word)));
}

}  // namespace

std::string textOfPositions(const nlohmann::json& positions) {
  std::string text;
  for (const json& position : positions) {
    if (!text.empty()) text += "; ";
    for (std::size_t axis = 0; axis < 3; ++axis)
      text += (axis ? "," : "") + base::shortestText(position[axis].get<double>());
  }
  return text;
}

std::string textOfPlanes(const nlohmann::json& planes) {
  std::string text;
  for (const json& plane : planes)
    for (std::size_t i = 0; i < 6; ++i)
      text += (i == 0   ? (text.empty() ? "" : "; ")
               : i == 3 ? " "
                        : ",") +
              base::shortestText(plane[i].get<double>());
  return text;
}

nlohmann::json planesOf(std::string_view text) {
  json list = json::array();
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::string_view plane = trimmed(rest.substr(0, end));
    const std::size_t space = std::min(plane.find(' '), plane.size());
    std::optional<json> numbers = numbersOf(plane.substr(0, space), 3);
    const std::optional<json> normal = numbersOf(plane.substr(space), 3);
    if (!numbers || !normal) return std::string(text);
    for (const json& number : *normal) numbers->push_back(number);
    list.push_back(*numbers);
    rest = trimmed(rest.substr(std::min(end + 1, rest.size())));
  }
  return list;
}

nlohmann::json positionsOf(std::string_view text) {
  json list = json::array();
  std::string_view rest = trimmed(text);
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::optional<json> position = numbersOf(rest.substr(0, end), 3);
    if (!position) return std::string(text);
    list.push_back(*position);
    rest = trimmed(rest.substr(std::min(end + 1, rest.size())));
  }
  return list;
}

std::string_view pathOf(std::string_view assignment) {
  return trimmed(assignment.substr(0, std::min(assignment.find('='), assignment.size())));
}

nlohmann::json valueOf(const SettingInfo& target, std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos)
    throw base::Error(base::ErrorKind::usage, "", std::string(assignment), "expected PATH=VALUE");
  return valueOfWords(target, assignment.substr(equals + 1));
}

}  // namespace isolux::scene
