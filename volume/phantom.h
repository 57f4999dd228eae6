// Built-in test volumes: a CT-like head and closed-form fields. Deterministic on every machine.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/progress.h"
#include "volume/grid.h"

namespace isolux::volume {

struct PhantomInfo {
  std::string_view name;     // "head", "ball", ...
  std::string_view meaning;  // one sentence
  std::string_view unit;     // "HU", "mm", ""
  double isovalue;           // a sensible one, data units
  int defaultSize;           // voxels per axis
};
std::span<const PhantomInfo> phantoms();

struct PhantomRequest {
  std::string name = "head";
  int size = 0;                             // voxels per axis; 0: its default; range [2, 1024]
  double noise = 0.0;                       // standard deviation of added Gaussian noise, data units
  std::uint64_t seed = 1;
  std::optional<GridGeometry> geometry;     // overrides dims and placement (tests)
};
// Throws Error{usage} for an unknown name or size; Error{interrupted}.
Grid makePhantom(const PhantomRequest& request, scene::Progress& progress);

// "NAME[:SIZE]" as it stands after "phantom:".
PhantomRequest parsePhantom(std::string_view text);

}  // namespace isolux::volume
