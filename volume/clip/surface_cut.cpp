#include "volume/clip/surface_cut.h"

#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "scene/rules/needs.h"
#include "scene/shown_surfaces.h"

namespace isolux::volume {

SurfaceCut::SurfaceCut(const scene::Scene& resolved, const GridGeometry& geometry) {
  for (const auto& surface : scene::shownSurfaces(resolved))
    surfaces_.push_back({surface.value.value(), surface.clipped});
  const auto clipped = [](const Surface& surface) { return surface.clipped; };
  alike_ = std::all_of(surfaces_.begin(), surfaces_.end(), clipped);
  if (scene::cutsSurfaces(resolved)) region_ = ClipRegion(resolved.clip).inVoxels(geometry);
}

bool SurfaceCut::cuts(double isovalue) const {
  if (!cuts()) return false;
  if (alike_) return true;
  const auto farther = [&](const Surface& a, const Surface& b) {
    return std::abs(a.isovalue - isovalue) < std::abs(b.isovalue - isovalue);
  };
  return std::min_element(surfaces_.begin(), surfaces_.end(), farther)->clipped;
}

std::uint64_t SurfaceCut::key() const {
  if (!cuts()) return 0;
  base::Hasher hash;
  hash.add(region_.key());
  if (!alike_)
    for (const Surface& surface : surfaces_) hash.add(surface.isovalue).add(surface.clipped);
  return hash;
}

}  // namespace isolux::volume
