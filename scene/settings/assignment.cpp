#include "scene/settings/assignment.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/decimal_text.h"
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

// "a,b,c" as a list of so many numbers; empty when it is none.
std::optional<json> numbersOf(std::string_view words, std::size_t count) {
  json list = json::array();
  std::size_t begin = 0;
  while (begin <= words.size() && list.size() <= count) {
    const std::size_t comma = std::min(words.find(',', begin), words.size());
    const std::optional<double> number = base::readNumber(trimmed(words.substr(begin, comma - begin)));
    if (!number) return std::nullopt;
    list.push_back(*number);
    begin = comma + 1;
  }
  return list.size() == count ? std::optional(list) : std::nullopt;
}

// "item; item; ..." as a list of what itemOf() reads; the text where it does not read one.
template <class ItemOf>
json listOf(std::string_view text, const ItemOf& itemOf) {
  json list = json::array();
  for (std::string_view rest = trimmed(text); !rest.empty();) {
    const std::size_t end = std::min(rest.find(';'), rest.size());
    const std::optional<json> item = itemOf(trimmed(rest.substr(0, end)));
    if (!item) return std::string(text);
    list.push_back(*item);
    rest = trimmed(rest.substr(std::min(end + 1, rest.size())));
  }
  return list;
}

// "a,b,c" as a list of texts.
json idsOf(std::string_view words) {
  json list = json::array();
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t comma = std::min(words.find(',', begin), words.size());
    list.push_back(std::string(trimmed(words.substr(begin, comma - begin))));
    begin = comma + 1;
  }
  return list;
}

// What the words of an assignment mean for this setting; a word that makes no sense stays a word, which
// Setting::set then refuses with the reason.
json valueOfWords(const SettingInfo& target, std::string_view text) {
  if (target.type == SettingType::text) return std::string(text);
  const std::string_view word = trimmed(text);
  if (target.type == SettingType::choice || (target.mayBeAutomatic && word == "auto"))
    return std::string(word);
  if (target.type == SettingType::planes && !word.starts_with('[')) return planesOf(word);
  if (target.type == SettingType::positions && !word.starts_with('[')) return positionsOf(word);
  if (target.type == SettingType::item && word == "none") return nullptr;
  if (target.type == SettingType::ids && !word.starts_with('[')) return idsOf(word);
  if (target.type >= SettingType::points) {  // a list, or an object
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
  const std::size_t components = std::max<std::size_t>(componentsOf(target.type), 1);
  const std::optional<json> numbers = numbersOf(word, components);
  if (!numbers) return std::string(word);
  return componentsOf(target.type) == 0 ? numbers->front() : *numbers;
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

nlohmann::json planesOf(std::string_view text) {
  return listOf(text, [](std::string_view plane) -> std::optional<json> {
    const std::size_t space = std::min(plane.find(' '), plane.size());
    std::optional<json> numbers = numbersOf(plane.substr(0, space), 3);
    const std::optional<json> normal = numbersOf(plane.substr(space), 3);
    if (!numbers || !normal) return std::nullopt;
    numbers->insert(numbers->end(), normal->begin(), normal->end());
    return numbers;
  });
}

nlohmann::json positionsOf(std::string_view text) {
  return listOf(text, [](std::string_view position) { return numbersOf(position, 3); });
}

std::string_view pathOf(std::string_view assignment) {
  return trimmed(assignment.substr(0, std::min(assignment.find('='), assignment.size())));
}

nlohmann::json valueOf(const SettingInfo& target, std::string_view assignment) {
  const auto equals = assignment.find('=');
  if (equals == std::string_view::npos) base::throwUsage("", std::string(assignment), "expected PATH=VALUE");
  return valueOfWords(target, assignment.substr(equals + 1));
}

}  // namespace isolux::scene
