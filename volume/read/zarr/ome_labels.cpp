#include "volume/read/zarr/ome_labels.h"

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

namespace isolux::volume {

namespace {

std::int64_t labelValueOf(const JsonField& entry) {
  const JsonField field = entry.at("label-value");
  const double number = field.number();
  constexpr double most = 9007199254740992.0;  // that a double tells apart
  if (!(std::abs(number) <= most) || number != std::floor(number)) field.refuse("is no whole number");
  return static_cast<std::int64_t>(number);
}

std::string nameIn(const nlohmann::json& properties) {
  for (const char* key : {"name", "class", "label"})
    if (properties.contains(key) && properties[key].is_string()) return properties[key].get<std::string>();
  return {};
}

}  // namespace

std::optional<LabelTable> imageLabelsOf(const JsonField& root) {
  if (!root.has("image-label")) return std::nullopt;
  const JsonField image = root.at("image-label");
  std::map<std::int64_t, Label> labels;
  const auto labelOf = [&](const JsonField& entry) -> Label& {
    const std::int64_t value = labelValueOf(entry);
    Label& label = labels[value];
    label.value = value;
    return label;
  };
  if (image.has("colors"))
    for (const JsonField& entry : image.at("colors").entries()) {
      Label& label = labelOf(entry);
      if (!entry.has("rgba")) continue;
      const std::vector<double> rgba = entry.at("rgba").numbers(4);
      label.color = linearFromSrgb({rgba[0] / 255.0, rgba[1] / 255.0, rgba[2] / 255.0});
    }
  if (image.has("properties"))
    for (const JsonField& entry : image.at("properties").entries())
      labelOf(entry).name = nameIn(entry.value());
  LabelTable table{.reason = "its metadata say image-label"};
  for (auto& [value, label] : labels) table.labels.push_back(std::move(label));
  return table;
}

}  // namespace isolux::volume
