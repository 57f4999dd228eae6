// Planes and boxes that a user asks for, and what may be done to one. Pure functions; world mm.
//
// A new plane takes away what lies between it and the viewer, so that its face is seen.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "scene/rules/automatic.h"
#include "volume/grid.h"

namespace isolux::app {

// Corners of what is cut: bit a of the index says on which side of axis a.
using BoxCorners = std::array<glm::dvec3, 8>;

// Through which point planes are put: where the user has put the crosshair, else the camera's target, in any
// case within the box of what there is to see.
glm::dvec3 cutPoint(const scene::Scene& resolved, const scene::VolumeFacts& facts);

// `back`: from the picture toward the viewer (scene::CameraFrame).
scene::ClipPlane planeAcross(int axis, const glm::dvec3& point,
                             const glm::dvec3& back);  // world axis 0, 1, 2
scene::ClipPlane planeFacing(const glm::dvec3& back, const glm::dvec3& point);
// None: the points lie on a line, to a part in a million of their distance.
std::optional<scene::ClipPlane> planeThrough(std::span<const glm::dvec3, 3> points, const glm::dvec3& back);
// The points of the marks that come last in the list, in its order; fewer where there are no more.
std::vector<glm::dvec3> lastMarked(const std::vector<scene::Mark>& marks, std::size_t count);

scene::ClipPlane flipped(scene::ClipPlane plane);  // the other side is gone
// The middle of what the plane has of the box; where they do not meet, the foot of the box's middle.
glm::dvec3 middleOf(const scene::ClipPlane& plane, const BoxCorners& box);
// The corners of that part, in order about it; none where they do not meet.
std::vector<glm::dvec3> outlineOf(const scene::ClipPlane& plane, const BoxCorners& box);
// The same of what the other planes and the box leave of it, planes[plane]; where they leave nothing, of all
// of it.
std::vector<glm::dvec3> faceOf(const scene::Clip& clip, std::size_t plane, const BoxCorners& box);
glm::dvec3 middleOfFace(const scene::Clip& clip, std::size_t plane, const BoxCorners& box);
// Turned about middleOf(): the normal becomes the world axis that it is nearest to, or points to the viewer.
scene::ClipPlane alignedToAxis(const scene::ClipPlane& plane, const BoxCorners& box);
scene::ClipPlane alignedToViewer(const scene::ClipPlane& plane, const BoxCorners& box,
                                 const glm::dvec3& back);

// A box about the middle of what there is to see, of three quarters its size, not turned.
void addBox(scene::Clip& clip, const scene::VolumeFacts& facts);
// The octant from the point toward the viewer is removed, to a tenth of the volume's diagonal beyond it.
// Needs room in clip.removed.
void addCorner(scene::Clip& clip, const glm::dvec3& point, const glm::dvec3& back, const BoxCorners& volume);
void removeCorner(scene::Clip& clip, std::size_t number);  // none where there is no such one

// A box: its middle, half its size, and its axes in columns. Number 0 is clip.box, which must be there; -1
// and below are the boxes that are removed.
struct TurnedBox {
  glm::dvec3 middle{0.0}, half{0.0};
  glm::dmat3 axes{1.0};
  glm::dvec3 corner(int index) const;  // as BoxCorners count
  // Return the outward normal and the middle of a face, numbered as CutGrip::index.
  glm::dvec3 outward(int face) const { return (face % 2 ? 1.0 : -1.0) * axes[face / 2]; }
  glm::dvec3 faceMiddle(int face) const { return middle + half[face / 2] * outward(face); }
};
TurnedBox turnedBox(const scene::Clip& clip, int number = 0);

}  // namespace isolux::app
