// Writes a triangle mesh to a file, format by extension: .stl (binary), .ply (binary), .obj, .vtp (VTK XML
// PolyData, raw appended data).
//
// World coordinates in mm: double precision in .ply, .obj and .vtp, single in .stl, which knows no other.
// Arrays of numbers at the points go into .vtp; .ply takes the normals among them. Objects are "o NAME" in
// .obj, the cell array "label" in .vtp and the face property "label" in .ply; .stl holds none. The file is
// written beside its name and renamed when complete.
#pragma once

#include <cstddef>
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
// A part of a mesh that is a label's surface: its triangles from `firstTriangle` on, up to the next part's.
struct MeshObject {
  std::string name;  // one line, not empty
  int label = 0;
  std::size_t firstTriangle = 0;
};
inline constexpr const char* kNormalsName = "normals";

// The largest distance, mm, by which the single precision of .stl moves a point; infinite beyond its range.
double singlePrecisionShift(const TriangleMesh& mesh);

bool isMeshName(const std::filesystem::path& path);
// Throws Error{usage} for an unknown extension and Error{input} when the file cannot be written.
// `objects`: none, or in the order of their triangles, the first from triangle 0 on.
void writeMesh(const TriangleMesh& mesh, const std::vector<PointArray>& arrays,
               const std::filesystem::path& path, const std::vector<MeshObject>& objects = {});

}  // namespace isolux::volume
