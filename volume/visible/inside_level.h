// Which stored values are inside an isosurface, and how far: one sign for both sides of an isovalue and both
// signs of a grid's slope.
#pragma once

#include "scene/choices.h"
#include "volume/grid.h"

namespace isolux::volume {

// `level` is the stored isovalue as rays compare with it: a float. Missing voxels (NaN) are outside.
struct InsideLevel {
  float level = 0.0f;
  bool high = true;  // inside is stored >= level; else stored <= level

  static InsideLevel of(const Grid& grid, double isovalue, scene::Inside inside) {
    return {static_cast<float>(grid.storedOfValue(isovalue)),
            (inside == scene::Inside::above) == (grid.slope() > 0.0)};
  }
  bool holds(float stored) const { return high ? stored >= level : stored <= level; }
  // >= 0 inside; |stored - isovalue|, exact for stored integers.
  double depth(double stored) const {
    return high ? stored - static_cast<double>(level) : static_cast<double>(level) - stored;
  }
  bool operator==(const InsideLevel&) const = default;
};

}  // namespace isolux::volume
