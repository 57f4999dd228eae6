// Holds a label map of which some labels are shown: the map, its names, and the mask field of those that are.
//
// Immutable; any thread.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/labels/label_blocks.h"
#include "volume/labels/label_table.h"
#include "volume/labels/mask_field.h"

namespace isolux::volume {

struct ShownLabels {
  std::shared_ptr<const LabelBlocks> blocks;
  std::shared_ptr<const LabelTable> table;  // null: no names
  MaskField mask;

  const Grid& grid() const { return blocks->grid(); }  // of the labels
};

// Returns the source with that text: for reports of the file's own values.
scene::Source withLabelsAsValues(scene::Source source);

// Returns the labels that a text names, ascending: numbers, ranges and names, "2,4-7,liver", without regard
// to case; "" all but 0. Throws Error of kind usage with `path`, the setting of the text, if it names none,
// or one that the volume does not have.
std::vector<int> labelsNamed(const std::string& text, const LabelBlocks& blocks, const LabelTable* table,
                             const std::string& path = "source.labels");

// Return such a text of labels that the volume has, ascending: their numbers and ranges; and "" of all but 0.
std::string numbersOfLabels(const std::vector<int>& labels, const LabelBlocks& blocks);
std::string textOfLabels(const std::vector<int>& labels, const LabelBlocks& blocks);

// Shows those labels. `before`: what is shown of the same file and is not to be computed again, or null.
// Throws as labelsNamed() and makeMask().
std::shared_ptr<const ShownLabels> showLabels(std::shared_ptr<const LabelBlocks> blocks,
                                              std::shared_ptr<const LabelTable> table,
                                              const std::string& text, double smoothing,
                                              const ShownLabels* before, base::Progress& progress);

// Returns the label of a point of the shown surface: that with the largest sum of cubic B-spline weights
// among the shown labels of the 4 x 4 x 4 voxels around it; the smaller of equals. nullopt: none is shown
// there. `voxel`: in voxels, within the grid or up to half a voxel outside.
std::optional<int> labelAt(const ShownLabels& labels, const glm::dvec3& voxel);

// Returns the label at a point of a face that a cut lays open: labelAt() where the mask field, of which
// `value` is taken there, is inside; elsewhere that of the nearest voxel.
int labelOfFace(const ShownLabels& labels, const glm::dvec3& voxel, double value);

// Returns the colour of a label on slices and faces of cuts, linear RGB: its own if it is shown, else
// kHiddenLabel; black for 0.
inline constexpr float kHiddenLabel = 0.0612f;  // grey: 70 of 255 on a screen
glm::vec3 faceColor(const ShownLabels& labels, int label);

// Returns the mean colour of some labels, ascending, of the volume, linear RGB, weighted by their voxels to
// the power of 2/3, as surfaces grow.
glm::dvec3 meanColor(const ShownLabels& labels, const std::vector<int>& some);

}  // namespace isolux::volume
