// One setting taken through evenly spaced values: "isosurface.value=100:300:9".
#pragma once

#include <string>

#include "scene/scene.h"

namespace isolux::app {

struct Sweep {
  std::string path;  // a setting that is a number
  double low = 0.0, high = 0.0;
  int count = 1;

  double value(int index) const;  // low for a count of 1
  void apply(scene::Scene& scene, int index) const;
};
// Throws base::Error{usage} for anything but PATH=LOW:HIGH:COUNT of a number of the scene, COUNT 1 to 100000,
// whose values all lie in its range.
Sweep parseSweep(const std::string& text);

}  // namespace isolux::app
