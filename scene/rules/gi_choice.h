// What global illumination a scene calls for: the least that gives its picture, and why.
//
// A pure function of the Scene (resolved or not). Who plans the bake, the renderer, `--explain`
// and the settings that act all ask here, so that they agree. Wyman et al. 2006 has irradiance, transfer and
// vicinity as separate choices of its user.
#pragma once

#include <string>

#include "scene/scene.h"

namespace isolux::scene {

struct GiChoice {
  bool wanted = false;  // a look reads stored light
  // What is stored of the sky's light: off, irradiance, transfer, vicinity or shadow; never automatic.
  GiMode sky = GiMode::off;
  bool unitSky = false;  // stored under a sky of radiance 1; its colour is laid on in the picture
  int channels = 3;      // of what is stored of the sky: 1 where light stays grey
  bool onShown = false;  // texels are lit where the shown isosurface passes them, not each on its own
  bool lamps = false;    // lamps shine: their irradiance is stored beside the sky's
  int bounces = 0;       // that are traced
  std::string reason;    // one clause a decision, joined by "; "
};

GiChoice giChoiceOf(const Scene& scene);
bool showsOneIsosurface(const Scene& scene);

}  // namespace isolux::scene
