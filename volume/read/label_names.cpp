#include "volume/read/label_names.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "volume/read/input/text.h"

namespace isolux::volume {

using base::throwInput;

namespace {

std::optional<glm::vec3> colorOfBytes(std::string_view red, std::string_view green, std::string_view blue) {
  glm::dvec3 srgb(0.0);
  int axis = 0;
  for (const std::string_view word : {red, green, blue}) {
    const auto byte = integerOf(word);
    if (!byte || *byte < 0 || *byte > 255) return std::nullopt;
    srgb[axis++] = static_cast<double>(*byte) / 255.0;
  }
  return linearFromSrgb(srgb);
}

int hexDigit(char c) {
  constexpr std::string_view digits = "0123456789abcdef";
  const std::size_t at = digits.find(c);
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

std::optional<glm::vec3> colorOfHex(std::string_view text) {
  const std::string hex = lowered(trimmed(text));
  if (hex.size() != 7 || hex[0] != '#') return std::nullopt;
  glm::dvec3 srgb(0.0);
  for (std::size_t i = 0; i < 3; ++i) {
    const int high = hexDigit(hex[1 + 2 * i]), low = hexDigit(hex[2 + 2 * i]);
    if (high < 0 || low < 0) return std::nullopt;
    srgb[static_cast<int>(i)] = (16 * high + low) / 255.0;
  }
  return linearFromSrgb(srgb);
}

std::int64_t labelNumber(std::string_view word, const std::string& file, int line) {
  const auto number = integerOf(trimmed(word));
  if (!number) throwInput(file, linePlace(line), inQuotes(word) + " is not the number of a label");
  return *number;
}

std::vector<Label> labelsOfBids(std::string_view text, const std::string& file) {
  Lines lines(text);
  const auto head = lines.next();
  const auto columns = splitAt(head.value_or(""), "\t");
  const auto column = [&](std::string_view name) {
    return static_cast<std::size_t>(
        std::distance(columns.begin(), std::ranges::find_if(columns, [name](std::string_view column) {
                        return sameIgnoringCase(trimmed(column), name);
                      })));
  };
  const std::size_t index = column("index"), name = column("name"), color = column("color");
  if (index == columns.size() || name == columns.size())
    throwInput(file, "line 1", "has no columns \"index\" and \"name\", separated by tabs");
  std::vector<Label> labels;
  while (const auto line = lines.next()) {
    if (trimmed(*line).empty()) continue;
    const auto cells = splitAt(*line, "\t");
    if (cells.size() <= std::max(index, name))
      throwInput(file, linePlace(lines.number()), "has fewer columns than the first line");
    labels.push_back({.value = labelNumber(cells[index], file, lines.number()),
                      .name = std::string(trimmed(cells[name])),
                      .color = color < cells.size() ? colorOfHex(cells[color]) : std::nullopt});
  }
  return labels;
}

std::vector<Label> labelsOfDataset(std::string_view text, const std::string& file) {
  const auto json = nlohmann::json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains("labels") || !json["labels"].is_object())
    throwInput(file, "labels", "are missing, or no object of names and numbers");
  std::vector<Label> labels;
  for (const auto& [key, value] : json["labels"].items()) {
    if (value.is_number_integer()) {
      labels.push_back({.value = value.get<std::int64_t>(), .name = key});
    } else if (const auto number = integerOf(key); number && value.is_string()) {
      labels.push_back({.value = *number, .name = value.get<std::string>()});
    } else if (!value.is_array()) {  // regions are made of several labels
      throwInput(file, "labels", inQuotes(key) + " has no number");
    }
  }
  return labels;
}

// ITK-SNAP's lines end with a name in quotes; those of colour tables have it behind the number.
std::vector<Label> labelsOfLines(std::string_view text, const std::string& file) {
  Lines lines(text);
  std::vector<Label> labels;
  while (const auto line = lines.next()) {
    const std::string_view content = trimmed(*line);
    if (content.empty() || content[0] == '#') continue;
    const std::size_t quote = content.find('"');
    const auto words = wordsOf(content.substr(0, quote));
    Label label;
    if (quote != std::string_view::npos) {
      if (words.size() < 4)
        throwInput(file, linePlace(lines.number()), "has no number, colour and name of a label");
      const std::string_view name = content.substr(quote + 1);
      label.name = name.substr(0, name.rfind('"'));
      label.color = colorOfBytes(words[1], words[2], words[3]);
    } else {
      if (words.size() != 6)
        throwInput(file, linePlace(lines.number()), "is not a label's number, name, RGB and opacity");
      label.name = words[1];
      label.color = colorOfBytes(words[2], words[3], words[4]);
    }
    label.value = labelNumber(words[0], file, lines.number());
    if (!label.color) throwInput(file, linePlace(lines.number()), "has no colour from 0 to 255");
    labels.push_back(std::move(label));
  }
  return labels;
}

}  // namespace

std::vector<Label> labelNamesIn(std::string_view text, const std::string& file) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  const std::string name = lowered(file);
  const auto labels = name.ends_with(".tsv")    ? labelsOfBids(text, file)
                      : name.ends_with(".json") ? labelsOfDataset(text, file)
                                                : labelsOfLines(text, file);
  if (labels.empty()) throwInput(file, "", "names no labels");
  return labels;
}

}  // namespace isolux::volume
