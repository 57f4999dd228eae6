// Holds names and colours of labels, and what states that the values of a volume are labels.
//
// A label is a whole number that names a region. Label 0 is the background. Any thread; no errors.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

namespace isolux::volume {

struct Label {
  std::int64_t value = 0;            // of its voxels, data units
  std::string name{};                // "": none
  std::optional<glm::vec3> color{};  // linear RGB, each in [0, 1]; nullopt: labelColor() chooses
  int layer = 0;  // of files that keep labels that overlap in several volumes: source.component
};

struct LabelTable {
  std::string reason;  // why values are labels, a clause: "its header lists segments"; "": nothing states it
  std::string source{};         // of the names: a file's name; "": the volume's own file, or there are none
  std::vector<Label> labels{};  // each value once in a layer, in the order of the file
};

// Returns whether anything states that values are labels. `table` may be null.
inline bool statesLabels(const LabelTable* table) {
  return table && !table->reason.empty();
}

// Returns a copy with the labels of one layer alone, by ascending value.
LabelTable labelsOfLayer(const LabelTable& table, int layer);

// Return what the table says of a label: its name, "" if it has none; its colour, else one whose hue differs
// from those of the labels next to it (the golden ratio of the circle of hues apart). `table` may be null.
std::string labelName(const LabelTable* table, std::int64_t value);
glm::vec3 labelColor(const LabelTable* table, std::int64_t value);

// Returns linear RGB of an sRGB colour with channels in [0, 1]; others are clamped, NaN becomes 0.
glm::vec3 linearFromSrgb(const glm::dvec3& srgb);

}  // namespace isolux::volume
