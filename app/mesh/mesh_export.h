// The isosurface of a scene as a triangle mesh in a file: .stl, .ply (with normals), .obj, or .vtp (with
// normals, kappa1, kappa2, confidence, and color_value where there is a color.volume). Pieces that `pieces.`
// hides are left out; cuts are not followed. Lengths in mm, in the volume's world.
#pragma once

#include <filesystem>
#include <string>

#include "base/progress.h"
#include "scene/scene.h"
#include "volume/extraction/surface_mesh.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct MeshRequest {
  std::filesystem::path file;  // a new one
  double toleranceMm = 0.0;    // triangles are split until they come so near to the surface; 0: none is
  bool closed = false;         // where the surface leaves the volume, too
};

// `resolved` by scene::resolve of that volume. Writes the file and returns what is in it. Throws base::Error:
// usage (another ending), input (no surface there, a file that
// cannot be written), memory, interrupted.
volume::SurfaceMesh exportMesh(const MeshRequest& request, scene::Scene resolved,
                               const volume::PreparedVolume& volume, base::Progress& progress);

// Adds what .stl, which has single precision, makes of a mesh to its distance from the surface. Throws
// Error{input} where that is over a thousandth of `voxelMm`: far from the origin triangles would collapse.
void addRounding(const std::filesystem::path& file, double voxelMm, volume::SurfaceMesh& found);
// "12345 triangles, 6789 points; no farther from the surface than 0.02 mm, closed".
std::string meshText(const volume::SurfaceMesh& made);
// What to say besides; empty: nothing.
std::string meshWarning(const volume::SurfaceMesh& made);

}  // namespace isolux::app
