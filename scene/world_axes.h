// Defines the meaning of the world axes (millimetres) in a volume, and their labels.
//
// Anatomical labels (L, P, S for +x, +y, +z; R, A, I for the other ends) apply to volumes whose file states
// the patient orientation. The labels of all others are +X, -X ... Their up axis is a convention, not
// information from the file. It is z for voxels (layers of a stack, height of a simulation), and y for
// meshes, as in most modelling programs.
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace isolux::scene {

enum class WorldAxes { zUp, yUp, anatomical /* DICOM/LPS: +x left, +y posterior, +z superior */ };

// Return unit vectors: up in a front view, and from the volume to a viewer of its front. anatomical: superior
// and anterior.
glm::dvec3 upOf(WorldAxes axes);
glm::dvec3 frontOf(WorldAxes axes);

// Returns the label ("L" or "+X") of the positive or negative end of `axis` (0, 1, 2).
std::string axisEnd(WorldAxes axes, int axis, bool positive);
// Returns the label of the axis end nearest to `direction`.
std::string axisEnd(WorldAxes axes, glm::dvec3 direction);

}  // namespace isolux::scene
