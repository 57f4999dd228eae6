#include "scene/scene.h"

namespace isolux::scene {

// Caps, ridges, saddles, valleys and cups, around a flat middle: kappa1 >= kappa2, so the points lie on and
// below the diagonal.
std::vector<CurvaturePoint> Look::defaultCurvaturePoints() {
  return {{0.0, 0.0, {0.82, 0.82, 0.80}},  {1.0, 1.0, {0.85, 0.30, 0.12}},  {1.0, 0.0, {0.95, 0.72, 0.25}},
          {1.0, -1.0, {0.45, 0.72, 0.35}}, {0.0, -1.0, {0.20, 0.50, 0.72}}, {-1.0, -1.0, {0.30, 0.16, 0.52}}};
}

}  // namespace isolux::scene
