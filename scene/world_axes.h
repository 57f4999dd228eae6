// What the axes of the world (millimetres) mean in a volume, and how that is written.
//
// Letters of anatomy (L, P, S for +x, +y, +z; R, A, I for the other ends) are for volumes whose file states
// where the patient lies. Everything else has +X, -X ...; then which axis is taken as up is a habit, no
// knowledge: z for voxels (layers of a stack, height of a simulation), y for meshes, as most modelling
// programs have it.
#pragma once

#include <string>

#include <glm/vec3.hpp>

namespace isolux::scene {

enum class WorldAxes { zUp, yUp, anatomical /* DICOM/LPS: +x left, +y posterior, +z superior */ };

// Unit vectors: up in a front view, and from the volume to who looks at its front. anatomical: superior and
// anterior.
glm::dvec3 upOf(WorldAxes axes);
glm::dvec3 frontOf(WorldAxes axes);

// "L" or "+X": the end of `axis` (0, 1, 2) that lies in its direction, or against it.
std::string axisEnd(WorldAxes axes, int axis, bool positive);
// The end that `direction` is nearest to.
std::string axisEnd(WorldAxes axes, glm::dvec3 direction);

}  // namespace isolux::scene
