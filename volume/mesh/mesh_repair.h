// Makes any triangle mesh a closed, oriented surface, so that "inside" has a meaning; says what it had to do.
//
// As a chain: an edge run through by as many triangles one way as the other is closed, whatever their
// number. What remains are closed loops (the boundary of a chain has no boundary), and each is spanned by a
// patch of the smallest area (Barequet & Sharir 1995), so that no winding number leaks.
#pragma once

#include <string>
#include <vector>

#include "base/progress.h"
#include "volume/mesh/triangle_mesh.h"

namespace isolux::volume {

// Merges points nearer than 1e-6 of the mesh's size, turns triangles to agree with their neighbours, and
// closes holes. Triangles without area stay, they may hold the surface together. One line in `warnings` for
// each kind of fault. Throws Error{interrupted}.
TriangleMesh closedMesh(TriangleMesh mesh, std::vector<std::string>& warnings,
                        const base::Progress& progress);

}  // namespace isolux::volume
