// The smoothed surfaces of labels as triangle meshes in one file: .obj, .ply or .vtp with an object for each
// label, or one label in any format. Lengths in mm, in the volume's world.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "volume/extraction/surface_mesh.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

struct LabelMeshRequest {
  std::filesystem::path file;  // a new one
  double toleranceMm = 0.0;    // triangles are split until they come so near to the surface; 0: none is
  double smoothing = 1.0;      // voxels, 0 to volume::kMostSmoothing
  std::optional<int> label;    // nullopt: every one but 0
};

struct LabelMesh {
  int label = 0;
  std::string name;
  volume::SurfaceMesh surface;  // largest deviation, open edges ...; its mesh is in the file alone
  std::size_t points = 0, triangles = 0;
};

// Writes the file and returns what is in it, in ascending order of label. Throws base::Error: usage (another
// ending, several labels in .stl, a label that the volume does not have), input (`source`: values that are no
// labels; a file that cannot be written), memory, interrupted.
std::vector<LabelMesh> exportLabelMeshes(const LabelMeshRequest& request,
                                         const volume::PreparedVolume& prepared, const std::string& source,
                                         base::Progress& progress);

}  // namespace isolux::app
