// Finds what a coarser level of a volume may hide of a picture, pixel by pixel (volume/large/level_gaps.h).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/accuracy/picture_errors.h"
#include "render/graph/frame.h"
#include "render/renderer.h"
#include "volume/large/level_gaps.h"

namespace isolux::app {

inline constexpr const char* kHiddenStructure = "hidden_structure";  // of --aov
inline constexpr const char* kStructureOverlay = "structure";        // of --error-overlay

// One ray through the centre of each pixel, row 0 at the top.
struct HiddenStructure {
  glm::ivec2 size{0};
  std::vector<std::uint8_t>
      hides;  // 1 where the ray passes a gap before what it hits, and within what cuts keep
  std::vector<std::uint8_t> seen;  // 1 where it hits
  std::size_t blocks = 0;          // of 8^3 cells of the volume that are gaps
  double thinnestMm = 0.0;         // what is thinner than that may be missing: two voxels of the level

  double share() const;  // of the picture's pixels
};

// `drawn`: the scene of the picture, as measureErrors() takes it, of a volume that is a level of `whole`.
// gaps: of scene::seenIsovalues(drawn). Throws as render::drawStill().
HiddenStructure hiddenStructure(render::Renderer& renderer, const scene::Scene& drawn,
                                const render::FrameRequest& request, const volume::PreparedVolume& level,
                                const volume::IndexedVolume& whole, const volume::LevelGaps& gaps,
                                base::Progress& progress);

std::string structureLine(const HiddenStructure& structure);

// Hatching, and a legend in the corner that look.legend_corner says; as paintErrors().
std::optional<render::Tile> paintStructure(const HiddenStructure& structure, scene::LegendCorner corner,
                                           const std::optional<render::Tile>& taken,
                                           render::ColorImage& image);

}  // namespace isolux::app
