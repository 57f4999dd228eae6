// Looks up the second volume at the surface points (color.volume), and provides its colours.
#pragma once

#include <map>
#include <string>

#include "render/legend/legend.h"
#include "render/passes/frame_state.h"

namespace isolux::render {

// Looks up value and world gradient at the surface points. Always runs on the CPU: nothing of that volume is
// uploaded.
Pass secondVolumePass();

// Returns whether an end of its colour map is automatic and follows the surface.
bool readsSecondRange(const scene::Scene& scene);
// Returns the range over visible surface points.
glm::dvec2 automaticSecondRange(const FrameState& frame);
// Returns the ends of the colour map.
glm::dvec2 secondRange(const FrameState& frame);
// Adds those ends that were automatic, by their paths.
void addSecondRange(const FrameState& frame, std::map<std::string, double>& found);

constexpr int kSecondColors = 256;
std::vector<glm::vec3> secondColors(const scene::Scene& scene);  // low to high, linear
Legend secondLegend(const FrameState& frame);

}  // namespace isolux::render
