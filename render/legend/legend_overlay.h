// Puts the legend of a scene into its finished picture.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "render/legend/legend.h"
#include "render/passes/frame_state.h"
#include "volume/cast/picture_area.h"

namespace isolux::render {

// The colours of look.mode's measure, as the shaders look them up: a row of samples, or a square.
struct MeasureColors {
  glm::ivec2 size{0};
  std::vector<glm::vec3> texels;
};
MeasureColors measureColors(const scene::Look& look);

// Of the look's measure over this range.
Legend measureLegend(const scene::Scene& scene, glm::dvec2 range);

// How much of a picture of this size its legend may take, in pixels; 0: it gets none. Before the picture is
// drawn ends of the range and scale may be unknown: numbers are taken to be as wide as they get.
glm::ivec2 legendReserve(const scene::Scene& scene, glm::ivec2 picture);

// The lower left pixel of a legend of this size in a picture, row 0 being the lowest: in the corner asked
// for, or in that which shows least of the surface; where they are alike, or it is little, in the lower right
// one. `covered`: how many pixels of a rectangle show it; asked only where the corner is automatic.
using CoveredPixels = std::function<std::int64_t(const volume::Rectangle&)>;
glm::ivec2 legendPlace(scene::LegendCorner corner, glm::ivec2 legend, glm::ivec2 picture,
                       const CoveredPixels& covered);

// Blends the legend into a corner of `picture`, and says where it stands in the whole picture; nothing where
// it would cover most of that. Of a tile it is not known where the rest of the surface lies: what is
// automatic is the lower right corner.
std::optional<Tile> drawLegendOver(FrameState& frame, const Target& picture, const Legend& legend);

}  // namespace isolux::render
