// Built-in test volumes: a CT-like head and closed-form fields. Deterministic on every machine.
//
// The closed forms are evaluated at world positions (mm). They lie around the middle c of the voxel domain
// and scale with e, the length in mm of its shortest edge (of max(n-1, 1) voxels); q = p - c:
//   ball            R - |q|                                                   R = 0.35 e
//   torus           r - |(sqrt(qx^2 + qy^2) - R, qz)|                         R = 0.27 e, r = 0.12 e
//   cylinder        R - sqrt(qx^2 + qy^2)                                     R = 0.25 e
//   plane           -(2 qx + 3 qy + 6 qz) / 7
//   saddle          2 (qx^2 - qy^2) / e - qz
//   gyroid          sin X cos Y + sin Y cos Z + sin Z cos X                   (X,Y,Z) = 8 pi q / e
//   marschner_lobb  (1 - sin(pi Z/2) + (1 + cos(12 pi cos(pi r/2))) / 4) / 2.5
//                                                  (X,Y,Z) = 2 q / e, r = |(X,Y)|
//   two_balls       -(|q - R x|^2 - R^2) (|q + R x|^2 - R^2) / (8 R^3)        R = 0.2 e, x the unit vector
//   sheet           h - |distance to the z layer of voxels nearest to c|      h: half of sheetVoxels spacings
//   sheets          min(R - |q|, qy, p / 4 - |u q - the multiple of p nearest to it|)
//                                                  R = 0.4 e, p = e / 31.75, u = (2, 14, -5) / 15
//   wires           1000 exp(-d^2 / (2 w^2)), d the distance to the nearest of six rings of radius 0.3 e,
//   whose
//                   axes lean by 40 degrees, a sixth of a turn apart; w = 0.6 e / 127
// (Marschner & Lobb 1994 with f_M = 6, alpha = 1/4.) `noise` is smooth random plus white noise. `head` is
// a head of fixed size in mm, patient axes LPS, round the world's origin; its geometry by default shows all
// of it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "scene/world_axes.h"
#include "volume/grid.h"

namespace isolux::volume {

struct PhantomInfo {
  std::string_view name;     // "head", "ball", ...
  std::string_view meaning;  // one sentence
  std::string_view unit;     // "HU", "mm", ""
  double isovalue;           // a sensible one, data units
  int defaultSize;           // voxels per axis
  scene::WorldAxes axes = scene::WorldAxes::zUp;
};
std::span<const PhantomInfo> phantoms();
const PhantomInfo& phantomNamed(const std::string& name);  // throws Error{usage}

struct PhantomRequest {
  std::string name = "head";
  int size = 0;        // voxels per axis; 0: its default; range [2, 1024]
  double noise = 0.0;  // standard deviation of added Gaussian noise, data units
  std::uint64_t seed = 1;
  double sheetVoxels = 0.3;              // thickness of the phantom "sheet"
  std::optional<GridGeometry> geometry;  // overrides dims and placement (tests)
};
// Throws Error{usage} for an unknown name or size; Error{interrupted}.
Grid makePhantom(const PhantomRequest& request, base::Progress& progress);

// "NAME[:SIZE]" as it stands after "phantom:".
PhantomRequest parsePhantom(std::string_view text);

}  // namespace isolux::volume
