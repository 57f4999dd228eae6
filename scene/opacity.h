// How much of what lies behind it an isosurface hides, by the angle it is seen under.
//
// opacity(c) = opacity · (f + (1 − f)(1 − c)²), c = |n·v|, f = facing opacity: the silhouette enhancement of
// Ebert and Rheingans, Volume Illustration (IEEE Visualization 2000), with k_sc = f, k_ss = 1 − f and
// k_se = 2. resources/shaders/look/shade.frag.glsl has the same.
#pragma once

#include "scene/scene.h"

namespace isolux::scene {

// In [0, 1], as the cosine between normal and view.
constexpr double opacityAt(double opacity, double facingOpacity, double cosine) {
  const double edge = (1.0 - cosine) * (1.0 - cosine);
  return opacity * (facingOpacity + (1.0 - facingOpacity) * edge);
}

// Of light that comes from everywhere alike: the mean over the hemisphere, weighted with the cosine.
// 2 ∫ c (1 − c)² dc = 1/6.
constexpr double meanOpacity(double opacity, double facingOpacity) {
  return opacity * (facingOpacity + (1.0 - facingOpacity) / 6.0);
}

// Of Isosurface and ExtraIsosurface: hides all that lies behind it, from every side.
template <class S>
constexpr bool isOpaque(const S& surface) {
  return surface.opacity >= 1.0 && surface.facingOpacity >= 1.0;
}
// Is there, and lets something of what lies behind it through.
template <class S>
constexpr bool isSeenThrough(const S& surface) {
  return surface.opacity > 0.0 && !isOpaque(surface);
}
// Its opacity depends on the angle.
template <class S>
constexpr bool variesByAngle(const S& surface) {
  return surface.opacity > 0.0 && surface.facingOpacity < 1.0;
}

// Of any surface that is shown.
bool variesByAngle(const Scene& scene);

}  // namespace isolux::scene
