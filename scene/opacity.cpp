#include "scene/opacity.h"

#include <algorithm>
#include <cmath>

#include "scene/shown_surfaces.h"

namespace isolux::scene {

double meanOpacity(double opacity, double facingOpacity) {
  constexpr int steps = 64;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double cosine = (i + 0.5) / steps;
    sum += 2.0 * cosine * (1.0 - std::pow(1.0 - opacityAt(opacity, facingOpacity, cosine), 1.0 / cosine));
  }
  return sum / steps;
}

bool variesByAngle(const Scene& scene) {
  return std::ranges::any_of(shownSurfaces(scene), variesByAngle<Surface>);
}

}  // namespace isolux::scene
