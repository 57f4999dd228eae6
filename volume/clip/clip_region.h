// What cuts leave of space: an intersection of half-spaces less some boxes, so that of each ray some
// segments are kept.
//
// The half-spaces are those of the planes of scene::Clip and of the six faces of its turned box; without any
// all of space is kept. A point on one of their faces is kept. A removed box takes what lies from its low
// corner to below its high one, along the world's axes: boxes that touch have nothing between them, and one
// without thickness removes nothing. Positions are world mm, or voxel coordinates after inVoxels(). A plain
// value, any thread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/scene.h"
#include "volume/grid.h"

namespace isolux::volume {

class ClipRegion {
 public:
  static constexpr std::size_t kMostFaces = scene::kClipPlanes + 6;
  static constexpr std::size_t kMostRemoved = scene::kRemovedBoxes;
  // Between which t a ray is in the region; none where begin > end.
  struct Segment {
    double begin = -std::numeric_limits<double>::infinity(), end = std::numeric_limits<double>::infinity();
    bool empty() const { return begin > end; }
    bool holds(double t) const { return t >= begin && t <= end; }
  };
  // Those of a ray, in order, none of them empty.
  class RaySegments {
   public:
    const Segment* begin() const { return list_.data(); }
    const Segment* end() const { return list_.data() + count_; }
    bool empty() const { return count_ == 0; }
    bool hold(double t) const;
    void add(const Segment& segment) { list_[count_++] = segment; }

   private:
    std::array<Segment, kMostRemoved + 1> list_;
    std::size_t count_ = 0;
  };
  // A removed box. Its axes are those of the world, measured from voxel 0.
  struct Removed {
    glm::dvec3 low, high;
    // Between which t a ray is in the box; empty, or of one point, where it is not. `closed`: one that runs
    // along a face is in it there, too, not only along the low one.
    Segment segmentOf(const glm::dvec3& origin, const glm::dvec3& direction, bool closed) const;
  };

  ClipRegion() = default;                                   // all of space
  explicit ClipRegion(const scene::Clip& clip);             // world mm
  ClipRegion inVoxels(const GridGeometry& geometry) const;  // of one in world mm

  bool cuts() const { return count_ > 0 || removedCount_ > 0; }
  // Kept is where dot(face, (p, 1)) <= 0 for all of them, and axes() * p is in no removed box.
  std::span<const glm::dvec4> faces() const { return {faces_.data(), count_}; }
  std::span<const Removed> removed() const { return {removed_.data(), removedCount_}; }
  const glm::dmat3& axes() const { return axes_; }
  bool contains(const glm::dvec3& p) const;
  // What is kept of a ray, or of `whole` of it.
  RaySegments segmentsOf(const glm::dvec3& origin, const glm::dvec3& direction) const {
    return segmentsOf(origin, direction, Segment{});
  }
  RaySegments segmentsOf(const glm::dvec3& origin, const glm::dvec3& direction, Segment whole) const;
  std::uint64_t key() const;  // of equal regions; 0: nothing is cut

 private:
  void add(const glm::dvec3& point, const glm::dvec3& normal);
  Segment betweenFaces(const glm::dvec3& origin, const glm::dvec3& direction, Segment whole) const;

  std::array<glm::dvec4, kMostFaces> faces_{};
  std::size_t count_ = 0;
  std::array<Removed, kMostRemoved> removed_{};
  std::size_t removedCount_ = 0;
  glm::dmat3 axes_{1.0};
};

}  // namespace isolux::volume
