// Chooses the global illumination of a scene: the least that produces its image, and the reason.
//
// A pure function of the Scene (resolved or not). The bake planner, the renderer, `--explain` and the rules
// of active settings all call it, so that they agree. In Wyman et al. 2006, the user chooses irradiance,
// transfer or vicinity.
#pragma once

#include <string>

#include "scene/scene.h"

namespace isolux::scene {

struct GiChoice {
  bool wanted = false;  // a look reads baked lighting
  bool traced = false;  // exposure and gloss trace rays: light is baked, or needs no bake without shadows
  // The baked quantity of the sky's light: off, irradiance, transfer, vicinity or shadow; never automatic.
  GiMode sky = GiMode::off;
  bool unitSky = false;  // baked under a sky of radiance 1; the frame multiplies by its colour
  int channels = 3;      // of the sky's baked light: 1 if it stays grey
  bool onShown = false;  // texels are lit on the isosurface of litIsovalue(), not each on its own
  bool lamps = false;    // there are light sources: their irradiance is baked in addition to the sky's
  int bounces = 0;       // traced
  std::string reason;    // one clause per decision, joined by "; "
};

GiChoice giChoiceOf(const Scene& scene);

// Returns whether light is baked for one isosurface alone: the only one that is shown, or the only one that
// is not too transparent (scene/opacity.h).
bool litAlone(const Scene& scene);
// Returns the isovalue of that surface; the first one's where there are several. Requires a resolved scene.
double litIsovalue(const Scene& resolved);

}  // namespace isolux::scene
