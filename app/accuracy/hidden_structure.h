// Finds what a coarser level of a volume may hide of a picture, pixel by pixel
// (volume/large/lost_structure.h).
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec2.hpp>

#include "app/accuracy/error_overlay.h"
#include "app/accuracy/picture_errors.h"
#include "render/graph/frame.h"
#include "render/renderer.h"
#include "volume/large/lost_structure.h"

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

// `drawn`: as measureErrors() takes it, of a volume that is a level of `whole`. gaps: of
// scene::seenIsovalues(drawn.scene). Throws as render::drawStill().
HiddenStructure hiddenStructure(render::Renderer& renderer, const ShownPicture& drawn,
                                const volume::IndexedVolume& whole, const volume::LostStructure& gaps,
                                base::Progress& progress);

std::string structureLine(const HiddenStructure& structure);

// Hatching, and a legend in the corner that look.legend_corner says; as paintErrors().
std::optional<render::Tile> paintStructure(const HiddenStructure& structure, scene::LegendCorner corner,
                                           const std::optional<render::Tile>& taken,
                                           render::ColorImage& image);

// Keeps what outlives a picture: the next task of the same volume takes it over. All null: nothing is known
// yet.
struct KnownStructure {
  std::shared_ptr<const volume::IndexedVolume> whole;
  std::shared_ptr<const volume::LostStructure> gaps;  // of `isovalues`
  std::vector<double> isovalues;
};

// Finds what the level hides of the picture on screen and marks it, on a background thread, with a renderer
// of its own that casts on the processor.
struct StructureSubject {
  std::shared_ptr<const volume::PreparedVolume> volume;  // the level
  scene::Scene scene;                                    // resolved, as it is shown in motion
  std::function<render::ColorImage()> picture;           // copied out on the thread
  std::optional<render::Tile> taken;                     // by the picture's own legend
  KnownStructure known;
};
struct FoundStructure {
  std::optional<HiddenStructure> structure;  // none: the volume has no index
  MarkedPicture marked;
  KnownStructure known;
};
using StructureTask = base::Task<FoundStructure>;
std::unique_ptr<StructureTask> structureTask(StructureSubject asked);

}  // namespace isolux::app
