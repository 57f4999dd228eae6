// Triangle meshes from files: STL (text and binary), Wavefront OBJ, PLY (text and binary) and VTK XML
// PolyData (.vtp).
//
// STL, OBJ and PLY are parsed here: VTK 9.1 ends the program on damaged PLY files, takes point numbers out
// of range from OBJ, and reads truncated binary STL without a word. PolyData are read by VTK, in a process of
// its own (foreign.h), after a check of what they claim. Polygons become fans, strips become triangles;
// lines, vertices and attributes are passed over. All points of the result are finite and all indices in
// range. Errors: base::Error{input} with line or byte.
#pragma once

#include <string>

#include "base/progress.h"
#include "volume/mesh/triangle_mesh.h"
#include "volume/read/input/bytes.h"

namespace isolux::volume {

bool looksLikePly(const std::string& head);
bool looksLikePolyData(const std::string& head);
bool looksLikeStlText(const std::string& head);

TriangleMesh readStlMesh(const Bytes& bytes, const base::Progress& progress);
TriangleMesh readObjMesh(const Bytes& bytes, const base::Progress& progress);
TriangleMesh readPlyMesh(const Bytes& bytes, const base::Progress& progress);

// What the readers share.
std::string wholeText(const Bytes& bytes, const base::Progress& progress);  // throws Error{interrupted}
// Throws naming `place` unless finite.
void addPoint(TriangleMesh& mesh, const glm::dvec3& point, const std::string& file, const std::string& place);
// A polygon as a fan round its first corner. Throws naming `place` for an index that is no point's.
void addPolygon(TriangleMesh& mesh, const std::vector<std::int64_t>& corners, const std::string& file,
                const std::string& place);

}  // namespace isolux::volume
