// Colours, hatching and a legend on a finished picture: what overlays are painted with.
//
// Pictures in pixels, row 0 at the top.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec2.hpp>

#include "render/graph/frame.h"
#include "render/passes/legend_overlay.h"
#include "scene/choices.h"

namespace isolux::app {

inline constexpr int kOverlayColors = 256;

class OverlayPainter {
 public:
  explicit OverlayPainter(render::ColorImage& image);

  // Colours of the logarithm of a bound within a range (cividis), as bright as the picture is there. NaN: the
  // pixel keeps its own; infinite: grey.
  void color(const std::vector<double>& bounds, glm::dvec2 range);
  void hatch(const std::vector<std::uint8_t>& hatched);  // of each pixel whether it is
  // Where the legend stands, as render::FrameReport has it; none where there is no room for one. `seen`: of
  // each pixel whether it shows a surface; `taken`: what else is not to be covered.
  std::optional<render::Tile> addLegend(const render::Legend& legend, scene::LegendCorner corner,
                                        const std::vector<std::uint8_t>& seen,
                                        const std::optional<render::Tile>& taken);

 private:
  render::ColorImage& image_;
  int lineWidth_;
};

}  // namespace isolux::app
