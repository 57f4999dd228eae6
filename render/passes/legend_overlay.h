// Draws the legend of a scene into its finished image.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "render/legend/legend.h"
#include "render/passes/frame_state.h"
#include "volume/cast/picture_area.h"

namespace isolux::render {

// The colours of look.mode's measure for lookup in shaders: a row of samples, or a square.
struct MeasureColors {
  glm::ivec2 size{0};
  std::vector<glm::vec3> texels;
};
MeasureColors measureColors(const scene::Look& look);

// Returns the legend of the look's measure over this range.
Legend measureLegend(const scene::Scene& scene, glm::dvec2 range);

// Returns the size that the legend of an image of this size may take, in pixels; 0: it has none. Before the
// image is drawn, ends of the range and the scale may be unknown. The size then assumes the widest numbers.
glm::ivec2 legendReserve(const scene::Scene& scene, glm::ivec2 picture);

// Returns the lower left pixel of a legend of this size in an image, row 0 being the lowest. The legend is in
// the requested corner, or in the corner that shows least of the surface. If corners are equal, or show
// little, it is in the lower right one. `covered`: returns how many pixels of a rectangle show the surface;
// called only if the corner is automatic.
using CoveredPixels = std::function<std::int64_t(const volume::Rectangle&)>;
glm::ivec2 legendPlace(scene::LegendCorner corner, glm::ivec2 legend, glm::ivec2 picture,
                       const CoveredPixels& covered);

// Blends the legend into a corner of `picture` and returns its place in the whole image; nullopt if it would
// cover most of that. In a tile, the rest of the surface is unknown: the automatic corner is the lower right
// one.
std::optional<Tile> drawLegendOver(FrameState& frame, const Target& picture, const Legend& legend);

}  // namespace isolux::render
