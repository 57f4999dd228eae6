// Computes the view-dependent opacity of an isosurface.
//
// opacity(c) = opacity · (f + (1 − f)(1 − c)²), c = |n·v|, f = facing opacity. This is the silhouette
// enhancement of Ebert and Rheingans, Volume Illustration (IEEE Visualization 2000), with k_sc = f, k_ss = 1
// − f and k_se = 2. resources/shaders/look/shade.frag.glsl computes the same.
#pragma once

#include "scene/scene.h"

namespace isolux::scene {

// Returns the opacity in [0, 1]. `cosine`: between normal and view, in [0, 1].
constexpr double opacityAt(double opacity, double facingOpacity, double cosine) {
  const double edge = (1.0 - cosine) * (1.0 - cosine);
  return opacity * (facingOpacity + (1.0 - facingOpacity) * edge);
}

// Returns the opacity for uniform light: the cosine-weighted mean over the hemisphere, where 2 ∫ c (1 − c)²
// dc = 1/6.
constexpr double meanOpacity(double opacity, double facingOpacity) {
  return opacity * (facingOpacity + (1.0 - facingOpacity) / 6.0);
}

// Returns whether the surface (Isosurface or ExtraIsosurface) hides everything behind it, from every
// direction.
template <class S>
constexpr bool isOpaque(const S& surface) {
  return surface.opacity >= 1.0 && surface.facingOpacity >= 1.0;
}
// Returns whether the surface is visible and partly transparent.
template <class S>
constexpr bool isSeenThrough(const S& surface) {
  return surface.opacity > 0.0 && !isOpaque(surface);
}
// Returns whether the opacity depends on the angle.
template <class S>
constexpr bool variesByAngle(const S& surface) {
  return surface.opacity > 0.0 && surface.facingOpacity < 1.0;
}

// Returns whether the opacity of any shown surface depends on the angle.
bool variesByAngle(const Scene& scene);

}  // namespace isolux::scene
