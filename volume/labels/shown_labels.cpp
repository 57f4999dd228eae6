#include "volume/labels/shown_labels.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include <glm/common.hpp>

#include "base/error.h"
#include "base/words.h"
#include "volume/field/cubic_weights.h"

namespace isolux::volume {

namespace {

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  return text;
}

struct LabelRange {
  int low = 0, high = 0;
};

// "7", "-2", "4-7".
std::optional<LabelRange> rangeOf(std::string_view text) {
  LabelRange range;
  const char* const end = text.data() + text.size();
  auto read = std::from_chars(text.data(), end, range.low);
  if (read.ec != std::errc()) return std::nullopt;
  range.high = range.low;
  if (read.ptr == end) return range;
  if (*read.ptr != '-') return std::nullopt;
  read = std::from_chars(read.ptr + 1, end, range.high);
  if (read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return range;
}

}  // namespace

scene::Source withLabelsAsValues(scene::Source source) {
  source.labels = scene::kLabelsAsValues;
  return source;
}

std::vector<int> labelsNamed(const std::string& text, const LabelBlocks& blocks, const LabelTable* table,
                             const std::string& path) {
  std::vector<int> named;
  const auto addWhere = [&](const auto& wanted) {
    const std::size_t before = named.size();
    for (const LabelExtent& of : blocks.list())
      if (wanted(of.label)) named.push_back(of.label);
    return named.size() > before;
  };
  const auto addNamed = [&](const std::string& name) {
    std::vector<std::int64_t> values;
    if (!table) return false;
    for (const Label& label : table->labels)
      if (label.name.size() == name.size() && base::lowerCase(label.name) == name)
        values.push_back(label.value);
    return !values.empty() && addWhere([&](int label) { return std::ranges::count(values, label) > 0; });
  };
  if (trimmed(text).empty()) addWhere([](int label) { return label != 0; });
  for (std::string_view rest = text; !rest.empty();) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::string word(trimmed(rest.substr(0, comma)));
    rest.remove_prefix(std::min(comma + 1, rest.size()));
    if (word.empty()) continue;
    const std::string name = base::lowerCase(word);
    bool found = addNamed(name);
    if (const auto range = rangeOf(word); !found && range)
      found = addWhere([&](int label) { return label >= range->low && label <= range->high; });
    if (found) continue;
    std::vector<std::string> names;
    for (const LabelExtent& of : blocks.list()) names.push_back(base::lowerCase(labelName(table, of.label)));
    base::throwUsage("", path, "the volume has no label \"" + word + '"' + base::didYouMean(name, names, ""));
  }
  std::ranges::sort(named);
  const auto twice = std::ranges::unique(named);
  named.erase(twice.begin(), twice.end());
  if (named.empty()) base::throwUsage("", path, "names no label of the volume");
  return named;
}

std::string textOfLabels(const std::vector<int>& labels, const LabelBlocks& blocks) {
  const auto isUsual = [&](const LabelExtent& of) {
    return std::ranges::binary_search(labels, of.label) == (of.label != 0);
  };
  return std::ranges::all_of(blocks.list(), isUsual) ? "" : numbersOfLabels(labels, blocks);
}

std::string numbersOfLabels(const std::vector<int>& labels, const LabelBlocks& blocks) {
  const auto isShown = [&](int label) { return std::ranges::binary_search(labels, label); };
  const std::vector<LabelExtent>& list = blocks.list();
  std::string text;
  for (std::size_t i = 0; i < list.size();) {
    std::size_t end = i;
    while (end < list.size() && isShown(list[end].label)) ++end;
    if (end > i) {
      text += (text.empty() ? "" : ",") + std::to_string(list[i].label);
      if (end > i + 1) text += '-' + std::to_string(list[end - 1].label);
    }
    i = end + 1;
  }
  return text;
}

std::shared_ptr<const ShownLabels> showLabels(std::shared_ptr<const LabelBlocks> blocks,
                                              std::shared_ptr<const LabelTable> table,
                                              const std::string& text, double smoothing,
                                              const ShownLabels* before, base::Progress& progress) {
  auto shown = std::make_shared<ShownLabels>();
  const std::vector<int> labels = labelsNamed(text, *blocks, table.get());
  const bool near = before != nullptr && before->blocks == blocks && before->mask.smoothing == smoothing;
  shown->mask = near ? changedMask(before->mask, *blocks, labels, progress)
                     : makeMask(*blocks, labels, smoothing, progress);
  shown->blocks = std::move(blocks);
  shown->table = std::move(table);
  return shown;
}

std::optional<int> labelAt(const ShownLabels& labels, const glm::dvec3& voxel) {
  const Grid& grid = labels.grid();
  const glm::ivec3 last = glm::ivec3(grid.geometry().dims) - 1;
  const glm::dvec3 low = glm::floor(voxel);
  const CubicWeights<double> weights[3] = {cubicWeights(voxel.x - low.x), cubicWeights(voxel.y - low.y),
                                           cubicWeights(voxel.z - low.z)};
  std::array<std::pair<int, double>, 64> sums;
  std::size_t count = 0;
  for (int k = 0; k < 64; ++k) {
    const glm::ivec3 tap(k & 3, k >> 2 & 3, k >> 4);
    const glm::ivec3 at = glm::clamp(glm::ivec3(low) + tap - 1, glm::ivec3(0), last);
    if (!(labels.mask.grid->stored(at) > 0.0)) continue;
    const int label = static_cast<int>(grid.value(at));
    const double weight = weights[0].w[tap.x] * weights[1].w[tap.y] * weights[2].w[tap.z];
    std::size_t i = 0;
    while (i < count && sums[i].first != label) ++i;
    if (i == count) sums[count++] = {label, 0.0};
    sums[i].second += weight;
  }
  if (count == 0) return std::nullopt;
  const auto better = [](const auto& a, const auto& b) {
    return a.second != b.second ? a.second < b.second : a.first > b.first;
  };
  return std::max_element(sums.begin(), sums.begin() + static_cast<std::ptrdiff_t>(count), better)->first;
}

int labelOfFace(const ShownLabels& labels, const glm::dvec3& voxel, double value) {
  if (value >= 0.0)
    if (const std::optional<int> shown = labelAt(labels, voxel)) return *shown;
  const glm::ivec3 nearest(glm::floor(voxel + 0.5));
  return static_cast<int>(labels.grid().value(glm::clamp(nearest, glm::ivec3(0), labels.grid().dims() - 1)));
}

glm::vec3 faceColor(const ShownLabels& labels, int label) {
  if (std::ranges::binary_search(labels.mask.labels, label)) return labelColor(labels.table.get(), label);
  return glm::vec3(label == 0 ? 0.0f : kHiddenLabel);
}

glm::dvec3 meanColor(const ShownLabels& labels, const std::vector<int>& some) {
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  for (const LabelExtent& label : labels.blocks->list()) {
    if (!std::ranges::binary_search(some, label.label)) continue;
    const double weight = std::pow(static_cast<double>(label.voxels), 2.0 / 3.0);
    sum += weight * glm::dvec3(labelColor(labels.table.get(), label.label));
    weights += weight;
  }
  return weights > 0.0 ? sum / weights : glm::dvec3(0.5);
}

}  // namespace isolux::volume
