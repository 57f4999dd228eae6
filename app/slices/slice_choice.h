// Which plane a view of slices shows: through the crosshair, or one of the scene's cuts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "scene/scene.h"
#include "volume/slice/slice_plane.h"

namespace isolux::app {

struct SliceChoice {
  enum class Kind { straight, oblique, cut };
  Kind kind = Kind::straight;
  volume::SliceDirection direction = volume::SliceDirection::axial;  // straight: across an axis of the world
  glm::dvec3 normal{0.0, 0.0, 1.0};                                  // oblique: any length but 0
  std::size_t cut = 0;                                               // of clip.planes
  bool operator==(const SliceChoice&) const = default;
};

// A plane of the world, and how its picture lies.
struct ChosenPlane {
  glm::dvec3 pointMm{0.0};
  volume::SliceFrame frame;
  glm::dvec3 normal() const { return frame.normal(); }
};
// Straight and oblique planes pass through the crosshair (slicePosition()); the point is the one nearest to
// the volume's middle, so that moving within the plane leaves it as it is. None for a cut that the scene has
// not.
std::optional<ChosenPlane> chosenPlane(const SliceChoice& choice, const scene::Scene& resolved,
                                       const volume::GridGeometry& geometry, scene::WorldAxes axes);

// A point of the plane as the crosshair: of straight planes exactly on them, and in the volume's bounds.
glm::dvec3 crosshairAt(const SliceChoice& choice, const scene::Scene& resolved,
                       const volume::GridGeometry& geometry, glm::dvec3 worldMm);

// Moves the plane by so many voxels across it (volume::voxelAlong()), towards the positive end of the axis it
// is nearest to: the crosshair, within the volume's bounds, or the cut. `scene` is the one to edit.
void stepPlane(scene::Scene& scene, const SliceChoice& choice, const scene::Scene& resolved,
               const volume::GridGeometry& geometry, scene::WorldAxes axes, double voxels);

// Where another plane crosses a picture: two points of its border, in pixels (centres are whole numbers);
// none where it passes beside the picture or lies in its plane.
std::optional<std::array<glm::dvec2, 2>> crossingLine(const volume::SlicePlane& picture,
                                                      const ChosenPlane& other);

}  // namespace isolux::app
