#include "volume/labels/label_table.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "base/color.h"

namespace isolux::volume {

namespace {

// HSV with a saturation of 0.48 and a value of 0.86, of sRGB: soft, as large surfaces are looked at.
glm::dvec3 srgbOfHue(double turns) {
  constexpr double saturation = 0.48, value = 0.86;
  const auto channel = [&](double shift) {
    const double k = std::fmod(6.0 * turns + shift, 6.0);
    return value * (1.0 - saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0));
  };
  return {channel(5.0), channel(3.0), channel(1.0)};
}

const Label* labelIn(const LabelTable* table, std::int64_t value) {
  if (!table) return nullptr;
  const auto found = std::ranges::find(table->labels, value, &Label::value);
  return found == table->labels.end() ? nullptr : &*found;
}

}  // namespace

LabelTable labelsOfLayer(const LabelTable& table, int layer) {
  LabelTable result{table.reason, table.source, {}};
  std::ranges::copy_if(table.labels, std::back_inserter(result.labels),
                       [layer](const Label& label) { return label.layer == layer; });
  std::ranges::stable_sort(result.labels, {}, &Label::value);
  const auto repeated = std::ranges::unique(result.labels, {}, &Label::value);
  result.labels.erase(repeated.begin(), repeated.end());
  return result;
}

std::string labelName(const LabelTable* table, std::int64_t value) {
  const Label* const label = labelIn(table, value);
  return label ? label->name : std::string();
}

glm::vec3 labelColor(const LabelTable* table, std::int64_t value) {
  if (const Label* const label = labelIn(table, value); label && label->color) return *label->color;
  constexpr double goldenRatio = 0.6180339887498949;
  const double turns = static_cast<double>(value) * goldenRatio;
  return linearFromSrgb(srgbOfHue(turns - std::floor(turns)));
}

glm::vec3 linearFromSrgb(const glm::dvec3& srgb) {
  glm::vec3 linear(0.0f);
  for (int i = 0; i < 3; ++i)
    if (srgb[i] > 0.0) linear[i] = static_cast<float>(base::decodeSrgb(std::min(srgb[i], 1.0)));
  return linear;
}

}  // namespace isolux::volume
