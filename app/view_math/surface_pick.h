// The surface point under a place of the picture, found by a ray of its own in double precision: it needs no
// picture that has been drawn, and says the same whatever size and accuracy that one has.
#pragma once

#include <optional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.h"
#include "scene/scene.h"
#include "volume/hit/cell_walk.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct Pick {
  glm::dvec3 worldMm{0.0}, voxel{0.0};
  double value = 0.0;     // of the trilinear field there, data units
  double isovalue = 0.0;  // of the isosurface that was hit
};

// The camera's ray through `ndc`, each in [-1, 1], x to the right, y up; voxel coordinates, in units of mm
// from the eye. aspect: width by height of the picture. startMm: where it starts, ViewUniforms::rayStartMm.
volume::Ray viewRay(const volume::GridGeometry& geometry, const scene::CameraFrame& frame, glm::dvec2 ndc,
                    double aspect, double startMm);

// The nearest crossing of the isosurfaces that are shown, of which the field is there. `resolved`:
// scene::resolve of this volume.
std::optional<Pick> pickSurface(const volume::PreparedVolume& volume, const scene::Scene& resolved,
                                glm::dvec2 ndc, double aspect);

// The camera moved so that the point lies in the picture's centre: the view direction and the eye's depth
// stay.
scene::Camera centredOn(const scene::Camera& resolved, const glm::dvec3& pointMm);

}  // namespace isolux::app
