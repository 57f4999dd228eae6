// Constructive solid geometry of two volumes on the first one's grid.
//
// A volume f with isovalue v is the solid f >= v. Let v1 and v2 be the isovalues of the two, and
//   h = v1 + k (f2 - v2),
// the second in the first one's units: k = 1 where both have the same unit, else the ratio of how steep they
// are at their surfaces, so that a step of the isovalue moves both surfaces by the same distance. Then
//   union         max(f1, h)
//   intersection  min(f1, h)
//   difference    min(f1, 2 v1 - h)
// have at the isovalue v1 exactly the combined solid's surface, and at others near by the one with both
// surfaces moved. For distance fields, v1 = v2 = 0 and k = 1, these are the usual max(f1, f2), min(f1, f2)
// and min(f1, -f2).
//
// A blend with weight w,
//   blend         (1 - w) f1 + w h,
// has the first one's surface for w = 0, the second's for w = 1 and a metamorphosis between them.
#pragma once

#include <optional>

#include "base/progress.h"
#include "scene/choices.h"
#include "volume/volume.h"

namespace isolux::volume {

// Returns whether parts of the second's surface outside the first are in the result.
bool showsBoth(scene::Csg op);

struct CsgResult {
  Volume volume;                         // float32, on the first one's grid, with v1 as its isovalue
  std::optional<double> secondIsovalue;  // v2
};

struct CsgRequest {
  scene::Csg op;                              // not none
  std::optional<double> secondIsovalue = {};  // v2; none: that suggested for the second
  double weight = 0.5;                        // w of a blend
};

// v1 is the isovalue suggested for the first. On another grid the second is interpolated (trilinear) at the
// first one's voxels; where it is missing or ends, there is none of it: f2 is its minimum. Missing voxels of
// the first stay missing. Throws Error{interrupted}.
CsgResult combined(const Volume& first, const Volume& second, const CsgRequest& request,
                   base::Progress& progress);

}  // namespace isolux::volume
