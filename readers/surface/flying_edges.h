// Triangles of the isosurface of samples, by VTK's flying edges (Schroeder, Maynard & Geveci 2015).
#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "base/progress.h"
#include "volume/mesh/triangle_mesh.h"

namespace isolux::readers {

// readers::Abilities::contour. Points lie on edges between samples, shared by the triangles around them.
volume::TriangleMesh flyingEdges(std::span<const float> samples, glm::ivec3 dims, base::Progress& progress);

}  // namespace isolux::readers
