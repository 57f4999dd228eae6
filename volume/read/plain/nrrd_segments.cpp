#include "volume/read/plain/nrrd_segments.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "base/error.h"

namespace isolux::volume {

namespace {

constexpr std::string_view kSegmentPrefix = "Segment";

// "Segment12_Name" -> 12, "Name"; nothing for other keys.
std::optional<std::pair<std::int64_t, std::string_view>> segmentKey(std::string_view key) {
  const std::size_t underscore = key.find('_');
  if (!key.starts_with(kSegmentPrefix) || underscore == std::string_view::npos) return std::nullopt;
  const auto number = integerOf(key.substr(kSegmentPrefix.size(), underscore - kSegmentPrefix.size()));
  if (!number || *number < 0 || *number > std::numeric_limits<int>::max()) return std::nullopt;
  return std::pair(*number, key.substr(underscore + 1));
}

std::int64_t numberOfSegment(const HeaderField& field, const std::string& file) {
  const auto number = integerOf(trimmed(field.value));
  if (!number) base::throwInput(file, field.place(), inQuotes(field.value) + " is not a whole number");
  return *number;
}

}  // namespace

std::optional<LabelTable> segmentsOf(const NrrdKeys& keys, std::int64_t layers, const std::string& file,
                                     std::vector<std::string>& warnings) {
  const auto source = keys.find("Segmentation_SourceRepresentation");
  if (source != keys.end() && source->second.value.find("Fractional") != std::string_view::npos)
    return std::nullopt;
  struct Segment {
    Label label{.value = 1};
    const HeaderField* layer = nullptr;
  };
  std::map<std::int64_t, Segment> segments;
  bool badColor = false;
  for (const auto& [key, field] : keys) {
    const auto part = segmentKey(key);
    if (!part) continue;
    const auto& [number, what] = *part;
    Segment& segment = segments[number];
    if (what == "Name") segment.label.name = trimmed(field.value);
    if (what == "LabelValue") segment.label.value = numberOfSegment(field, file);
    if (what == "Layer") segment.layer = &field;
    if (what != "Color") continue;
    const auto color = realsOf(field.value);
    if (color && color->size() == 3)
      segment.label.color = linearFromSrgb({(*color)[0], (*color)[1], (*color)[2]});
    else
      badColor = true;
  }
  if (segments.empty()) return std::nullopt;
  if (badColor) warnings.emplace_back("a segment's color is not three numbers; an automatic one is used");
  LabelTable table{.reason = "its header lists segments", .source = "", .labels = {}};
  for (auto& [number, segment] : segments) {
    std::int64_t layer = layers > 1 ? number : 0;
    if (segment.layer) layer = numberOfSegment(*segment.layer, file);
    if (layer < 0 || layer >= layers)
      base::throwInput(
          file, segment.layer ? segment.layer->place() : "Segment" + std::to_string(number),
          "layer " + std::to_string(layer) + " does not exist; the file has " + std::to_string(layers));
    segment.label.layer = static_cast<int>(layer);
    table.labels.push_back(std::move(segment.label));
  }
  return table;
}

}  // namespace isolux::volume
