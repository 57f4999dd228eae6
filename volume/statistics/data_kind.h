// What kind of data a volume is: a CT, an MR scan, a simulation; decided once, when it is loaded, by what its
// file says and else by its values. Presets, first isovalues and the window ask here alone.
#pragma once

#include <optional>
#include <string>

#include <glm/vec2.hpp>

#include "scene/choices.h"
#include "scene/noise.h"
#include "volume/statistics/histogram.h"
#include "volume/volume.h"

namespace isolux::volume {

// True when values said to be Hounsfield units are those plus 1024 (or 1000), as scanners store them before
// the rescale: air, at least 5 % of the voxels, at 0 instead of -1000; soft tissue, at least 5 % again, round
// 1050; in between less than there; `minimum`, the least value, not below 0. Empty counts: false.
bool looksOffsetBy1024(const Histogram& histogram, double minimum);

// The value of soft tissue in a CT whose values are not Hounsfield units: 40 % of all voxels but air lie
// within 5 % of the range of values, where those of other scans spread. Data units; nothing in other scans.
std::optional<double> softTissueOf(const Histogram& histogram);

struct FoundKind {
  scene::DataKind kind = scene::DataKind::other;  // never automatic
  std::string reason;                             // a clause: "its file says so"
  // Of a CT: value = x + y * HU. Exact where values are Hounsfield units; else by air and soft tissue.
  std::optional<glm::dvec2> hounsfield{};
};

// Volume::kind where that is not automatic, else: labels, units, the range of values, meshes, where a patient
// lies, voxels smaller than 2 micrometres, and whether there is noise.
FoundKind dataKindOf(const Volume& volume, const Histogram& histogram, const scene::NoiseModel& noise);

}  // namespace isolux::volume
