// What cuts leave of space: an intersection of half-spaces, so that of each ray one stretch is kept.
//
// The planes of scene::Clip and the six faces of its turned box; without any all of space is kept. A point on
// a face is kept. Positions are world mm, or voxel coordinates after inVoxels(). A plain value, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/scene.h"
#include "volume/grid.h"

namespace isolux::volume {

class ClipRegion {
 public:
  static constexpr std::size_t kMostFaces = scene::kClipPlanes + 6;
  // Between which t a ray is in the region; none where begin > end.
  struct Stretch {
    double begin = -std::numeric_limits<double>::infinity(), end = std::numeric_limits<double>::infinity();
    bool empty() const { return begin > end; }
    bool holds(double t) const { return t >= begin && t <= end; }
  };

  ClipRegion() = default;                                   // all of space
  explicit ClipRegion(const scene::Clip& clip);             // world mm
  ClipRegion inVoxels(const GridGeometry& geometry) const;  // of one in world mm

  bool cuts() const { return count_ > 0; }
  // Kept is where dot(face, (p, 1)) <= 0 for all of them.
  std::span<const glm::dvec4> faces() const { return {faces_.data(), count_}; }
  bool contains(const glm::dvec3& p) const;
  Stretch stretchOf(const glm::dvec3& origin, const glm::dvec3& direction) const;
  std::uint64_t key() const;  // of equal regions; 0: nothing is cut

 private:
  void add(const glm::dvec3& point, const glm::dvec3& normal);

  std::array<glm::dvec4, kMostFaces> faces_{};
  std::size_t count_ = 0;
};

}  // namespace isolux::volume
