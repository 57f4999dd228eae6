// Writes a triangle mesh to a file, format by extension: .stl (binary), .ply (binary), .obj, .vtp (VTK XML
// PolyData, raw appended data).
//
// World coordinates in mm: double precision in .ply, .obj and .vtp, single in .stl, which knows no other.
// Arrays of numbers at the points go into .vtp; .ply takes the normals among them. The file is written
// beside its name and renamed when complete.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "volume/mesh/triangle_mesh.h"

namespace isolux::volume {

struct PointArray {
  std::string name;           // letters, digits, '_'
  int components = 1;         // 1 or 3
  std::vector<float> values;  // components for each point; NaN where there is none
};
inline constexpr const char* kNormalsName = "normals";

// The largest distance, mm, by which the single precision of .stl moves a point; infinite beyond its range.
double singlePrecisionShift(const TriangleMesh& mesh);

bool isMeshName(const std::filesystem::path& path);
// Throws Error{usage} for an unknown extension and Error{input} when the file cannot be written.
void writeMesh(const TriangleMesh& mesh, const std::vector<PointArray>& arrays,
               const std::filesystem::path& path);

}  // namespace isolux::volume
