// Meshes for tests: closed shapes with known distances, in the formats the readers know.
#pragma once

#include <filesystem>
#include <string>

#include "volume/mesh/triangle_mesh.h"

namespace isolux::test {

volume::TriangleMesh icosphere(double radiusMm, int subdivisions, glm::dvec3 centreMm = glm::dvec3(0.0));
volume::TriangleMesh torus(double radiusMm, double tubeMm, int around, int across);
volume::TriangleMesh box(glm::dvec3 low, glm::dvec3 high);
volume::TriangleMesh joined(const volume::TriangleMesh& a, const volume::TriangleMesh& b);
volume::TriangleMesh turned(volume::TriangleMesh mesh);  // inside out

// Points and triangles of a plain OBJ file, without any check.
volume::TriangleMesh parsedObj(const std::filesystem::path& path);

std::string asObj(const volume::TriangleMesh& mesh);
std::string asStlText(const volume::TriangleMesh& mesh);
std::string asStlBinary(const volume::TriangleMesh& mesh);
std::string asPlyText(const volume::TriangleMesh& mesh);
std::string asPlyBinary(const volume::TriangleMesh& mesh, bool big);
std::string asVtp(const volume::TriangleMesh& mesh);

// By brute force over all triangles, in double precision.
double distanceTo(const volume::TriangleMesh& mesh, glm::dvec3 p);
// Generalized winding number: the sum of solid angles over 4 pi (Van Oosterom & Strackee 1983).
double windingNumber(const volume::TriangleMesh& mesh, glm::dvec3 p);

}  // namespace isolux::test
