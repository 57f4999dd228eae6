// What a scene's cuts take away of its isosurfaces.
#pragma once

#include <cstdint>
#include <vector>

#include "volume/clip/clip_region.h"
#include "volume/hit/cell_walk.h"

namespace isolux::volume {

// Isosurfaces of one volume. Where no value is known to be one of them, the nearest decides: light is stored
// on isosurfaces between those that are shown, too.
class SurfaceCut {
 public:
  SurfaceCut() = default;  // nothing is cut
  // Of a resolved scene: the first isosurface and those further ones that are shown.
  SurfaceCut(const scene::Scene& resolved, const GridGeometry& geometry);

  bool cuts() const { return region_.cuts(); }          // some isosurface
  const ClipRegion& region() const { return region_; }  // voxel coordinates
  // What is kept of the isosurface: the region, or all of space.
  bool cuts(double isovalue) const;
  // In t of the ray, between its ends.
  ClipRegion::RaySegments segmentsOf(double isovalue, const Ray& ray) const {
    const ClipRegion& region = cuts(isovalue) ? region_ : kWhole;
    return region.segmentsOf(ray.origin, ray.direction, {ray.tMinimum, ray.tMaximum});
  }
  bool keeps(double isovalue, const glm::dvec3& voxel) const {
    return !cuts(isovalue) || region_.contains(voxel);
  }
  std::uint64_t key() const;  // of equal cuts of equal isosurfaces; 0: nothing is cut

 private:
  struct Surface {
    double isovalue;  // data units
    bool clipped;
  };
  static inline const ClipRegion kWhole{};
  ClipRegion region_;
  std::vector<Surface> surfaces_;
  bool alike_ = true;  // all are cut
};

}  // namespace isolux::volume
