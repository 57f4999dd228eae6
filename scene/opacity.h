// Computes the opacity of an isosurface, which depends on the view, and the light that comes through it.
//
// opacity(c) = opacity · (f + (1 − f)(1 − c)²), c = |n·v|, f = facing opacity. This is the silhouette
// enhancement of Ebert and Rheingans, Volume Illustration (IEEE Visualization 2000), with k_sc = f, k_ss = 1
// − f and k_se = 2. resources/shaders/look/shade.frag.glsl computes the same.
// Under global illumination a transparent surface is a layer of one thickness: at an angle, light crosses
// more of it, 1 − (1 − opacity(c))^(1/c).
#pragma once

#include "scene/scene.h"

namespace isolux::scene {

// Returns the opacity in [0, 1]. `cosine`: between normal and view, in [0, 1].
constexpr double opacityAt(double opacity, double facingOpacity, double cosine) {
  const double edge = (1.0 - cosine) * (1.0 - cosine);
  return opacity * (facingOpacity + (1.0 - facingOpacity) * edge);
}

// Returns the opacity of that layer for uniform light: the cosine-weighted mean over the hemisphere.
double meanOpacity(double opacity, double facingOpacity);
// Returns how much of the shadow that a surface casts on itself is shown, in [0, 1], for its mean opacity. Up
// to a half it is none, and no light is baked for the surface: what is left out is at most a quarter of that
// shadow in the image.
constexpr double shadowShown(double meanOpacity) {
  return meanOpacity > 0.5 ? 2.0 * meanOpacity - 1.0 : 0.0;
}
// Returns uniform light behind a closed layer in units of that before it: what comes through, and what its
// inner side scatters back. `meanOpacity` < 1; exact where nothing else is behind it.
constexpr double lightThrough(double meanOpacity, double albedo) {
  return (1.0 - meanOpacity) / (1.0 - meanOpacity * albedo);
}

// Returns whether the surface hides everything behind it, from every
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

// Returns how much of its own shadow the surface shows.
template <class S>
double shadowShown(const S& surface) {
  return isOpaque(surface) ? 1.0 : shadowShown(meanOpacity(surface.opacity, surface.facingOpacity));
}
// Returns whether its light is baked.
template <class S>
bool bakesLight(const S& surface) {
  return surface.opacity > 0.0 && shadowShown(surface) > 0.0;
}

// Returns whether the opacity of any shown surface depends on the angle.
bool variesByAngle(const Scene& scene);

}  // namespace isolux::scene
