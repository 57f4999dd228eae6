// The second volume at the surface points (color.volume): its values, and the colours that stand for them.
#pragma once

#include <map>
#include <string>

#include "render/legend/legend.h"
#include "render/passes/frame_state.h"

namespace isolux::render {

// Value and world gradient at the surface points, looked up on the processor whoever casts the rays: nothing
// of that volume is uploaded.
class SecondVolumePass : public Pass {
 public:
  SecondVolumePass() : Pass("second volume", "", {.ofCrossing = true}) {}
  void declare(Declaring& d) const override;
  std::optional<LookInput> forLook(const scene::Scene& scene) const override;
  void run(FrameState& frame) override;
  bool isOn(const OnProcessor&) const override { return true; }
};

// An end of its colour map follows what the surface shows.
bool readsSecondRange(const scene::Scene& scene);
// Of points of the surfaces that can be seen.
glm::dvec2 automaticSecondRange(const FrameState& frame);
// The ends of the colour map.
glm::dvec2 secondRange(const FrameState& frame);
// Those that were automatic, by their paths.
void addSecondRange(const FrameState& frame, std::map<std::string, double>& found);

constexpr int kSecondColors = 256;
std::vector<glm::vec3> secondColors(const scene::Scene& scene);  // low to high, linear
Legend secondLegend(const FrameState& frame);

}  // namespace isolux::render
