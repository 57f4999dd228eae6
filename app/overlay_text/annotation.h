// What stands on a finished picture, by picture.letters, picture.scale_bar, picture.isovalue and
// picture.caveats: which ends of the axes lie at its edges, a length, which isovalues are shown, and what the
// picture leaves out or nobody measured.
//
// Pictures in pixels, row 0 at the top. Any thread; no errors.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "render/graph/frame.h"
#include "scene/camera.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

// A round length of at most `longest` pixels in a picture `pictureHeight` high. In perspective a length holds
// at one depth only, that of the camera's target: the text says so. Nothing where no length can be told.
struct ScaleBar {
  double mm = 0.0, pixels = 0.0;
  std::string text;  // "50 mm at the centre"
};
std::optional<ScaleBar> scaleBarOf(const scene::CameraFrame& frame, double pictureHeight, double longest);

// A surface that is shown: "300 HU", and its own colour (linear).
struct ShownValue {
  std::string text;
  glm::dvec3 color{0.0};
};

// What the picture leaves out, and what of it nobody measured.
struct Caveats {
  std::vector<std::string> invented;   // "13 gaps interpolated"; worst first
  std::size_t pieces = 0, hidden = 0;  // of the isosurfaces that are shown, where pieces are hidden

  // A line each: the above, then "156 of 161 pieces hidden".
  std::vector<std::string> lines() const;
};
Caveats caveatsOf(const scene::Scene& resolved, const volume::PreparedVolume& volume);

struct Annotation {
  scene::EdgeLetters letters;  // empty: none
  std::optional<ScaleBar> scaleBar;
  std::vector<ShownValue> values;
  std::vector<std::string> caveats;
  bool empty() const;
};
// `resolved` by scene::resolve of that volume.
Annotation annotationOf(const scene::Scene& resolved, const volume::PreparedVolume& volume, glm::ivec2 size);

// Writes it as large as the picture's smaller side allows, clear of the legend: dark with a bright rim on
// bright backgrounds and where there is none, else bright with a dark rim. Pictures with a side below 160
// pixels have the letters alone, those below 48 nothing.
void drawAnnotation(const Annotation& annotation, const scene::Scene& resolved,
                    const std::optional<render::Tile>& legend, render::ColorImage& image);

// Both, for a picture of `resolved` that was reported so.
void annotate(const scene::Scene& resolved, const volume::PreparedVolume& volume,
              const render::FrameReport& report, render::ColorImage& image);

}  // namespace isolux::app
