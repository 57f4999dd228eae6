#include "scene/world_axes.h"

#include <cmath>

namespace isolux::scene {

glm::dvec3 upOf(WorldAxes axes) {
  return axes == WorldAxes::yUp ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(0.0, 0.0, 1.0);
}

glm::dvec3 frontOf(WorldAxes axes) {
  return axes == WorldAxes::yUp ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(0.0, -1.0, 0.0);
}

std::string axisEnd(WorldAxes axes, int axis, bool positive) {
  if (axes == WorldAxes::anatomical) return {positive ? "LPS"[axis] : "RAI"[axis]};
  return std::string(positive ? "+" : "−") + "XYZ"[axis];
}

std::string axisEnd(WorldAxes axes, glm::dvec3 direction) {
  int main = 0;
  for (int i = 1; i < 3; ++i)
    if (std::abs(direction[i]) > std::abs(direction[main])) main = i;
  return axisEnd(axes, main, direction[main] > 0.0);
}

}  // namespace isolux::scene
