// Triangle meshes as volumes: the file, closed and oriented, as a signed distance
// (volume/mesh/mesh_distance.h).
//
// One unit of the file is taken as 1 mm, its axes as the world's. Throws base::Error (input, memory,
// interrupted).
#pragma once

#include <filesystem>
#include <string>

#include "volume/mesh/mesh_distance.h"
#include "volume/read/input/read_options.h"
#include "volume/volume.h"

namespace isolux::volume {

// By the first bytes of the file, else by its name's ending (lower case, ".stl").
bool isMesh(const std::string& head, const std::string& extension);

Volume readMesh(const std::filesystem::path& path, const ReadOptions& options, base::Progress& progress);

// The volume of triangles that a file held; `file` is for messages.
Volume distanceVolume(TriangleMesh mesh, const std::string& format, const std::string& file,
                      const ReadOptions& options, base::Progress& progress);

// The box of the triangles of a file that isMesh().
BoxMm readMeshBounds(const std::filesystem::path& path, const ReadOptions& options, base::Progress& progress);

}  // namespace isolux::volume
