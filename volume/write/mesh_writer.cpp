#include "volume/write/mesh_writer.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "base/pending_file.h"

namespace isolux::volume {

namespace {

namespace fs = std::filesystem;

// The bytes of a number or a vector of them.
template <class T>
void put(const T& value, base::OutputFile& out) {
  out.write(&value, sizeof value);
}
template <class T>
void putAll(const std::vector<T>& values, base::OutputFile& out) {
  out.write(values.data(), values.size() * sizeof(T));
}

void putStl(const TriangleMesh& mesh, base::OutputFile& out) {
  std::array<char, 80> header{};
  const std::string_view words = "Isolux, binary STL, mm";
  std::copy(words.begin(), words.end(), header.begin());
  put(header, out);
  put(static_cast<std::uint32_t>(mesh.triangles.size()), out);
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 across =
        glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
    const double length = glm::length(across);
    put(glm::vec3(length > 0.0 ? across / length : glm::dvec3(0.0)), out);
    for (int i = 0; i < 3; ++i) put(glm::vec3(mesh.corner(t, i)), out);
    put(std::uint16_t{0}, out);
  }
}

const PointArray* normalsOf(const std::vector<PointArray>& arrays) {
  const auto found = std::ranges::find_if(arrays, [](const PointArray& a) { return a.name == kNormalsName; });
  return found == arrays.end() ? nullptr : &*found;
}

// The label of each triangle; empty without objects.
std::vector<std::int32_t> labelsOfTriangles(const TriangleMesh& mesh,
                                            const std::vector<MeshObject>& objects) {
  std::vector<std::int32_t> labels;
  if (!objects.empty()) labels.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < objects.size(); ++i) {
    const std::size_t end = i + 1 < objects.size() ? objects[i + 1].firstTriangle : labels.size();
    std::fill(labels.begin() + static_cast<std::ptrdiff_t>(objects[i].firstTriangle),
              labels.begin() + static_cast<std::ptrdiff_t>(end), objects[i].label);
  }
  return labels;
}

void putPly(const TriangleMesh& mesh, const std::vector<PointArray>& arrays,
            const std::vector<MeshObject>& objects, base::OutputFile& out) {
  const std::vector<std::int32_t> labels = labelsOfTriangles(mesh, objects);
  const PointArray* const normals = normalsOf(arrays);
  out.write("ply\nformat binary_little_endian 1.0\ncomment Isolux, mm\nelement vertex " +
            std::to_string(mesh.points.size()) +
            "\nproperty double x\nproperty double y\nproperty double z\n" +
            (normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "") + "element face " +
            std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\n" +
            (labels.empty() ? "" : "property int label\n") + "end_header\n");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    put(mesh.points[i], out);
    if (normals)
      for (std::size_t c = 0; c < 3; ++c) put(normals->values[3 * i + c], out);
  }
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    put(std::uint8_t{3}, out);
    put(mesh.triangles[i], out);
    if (!labels.empty()) put(labels[i], out);
  }
}

void putObj(const TriangleMesh& mesh, const std::vector<MeshObject>& objects, base::OutputFile& out) {
  out.write("# Isolux, mm\n");
  for (const glm::dvec3& p : mesh.points)
    out.write("v " + base::shortestText(p.x) + " " + base::shortestText(p.y) + " " + base::shortestText(p.z) +
              "\n");
  auto object = objects.begin();
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (; object != objects.end() && object->firstTriangle == i; ++object)
      out.write("o " + object->name + "\n");
    const Triangle& t = mesh.triangles[i];
    out.write("f " + std::to_string(t.x + 1) + " " + std::to_string(t.y + 1) + " " + std::to_string(t.z + 1) +
              "\n");
  }
}

void putVtp(const TriangleMesh& mesh, const std::vector<PointArray>& arrays,
            const std::vector<MeshObject>& objects, base::OutputFile& out) {
  const std::vector<std::int32_t> labels = labelsOfTriangles(mesh, objects);
  const std::uint64_t points = mesh.points.size(), triangles = mesh.triangles.size();
  std::uint64_t offset = 0;  // of the next array in the appended data, behind the number of its bytes
  const auto array = [&](const std::string& type, const std::string& name, int components,
                         std::uint64_t bytes) {
    std::string tag = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                      std::to_string(components) + "\" format=\"appended\" offset=\"" +
                      std::to_string(offset) + "\"/>\n";
    offset += sizeof(std::uint64_t) + bytes;
    return tag;
  };
  std::string head =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
      std::to_string(points) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
      std::to_string(triangles) + "\">\n<Points>\n";
  head += array("Float64", "points", 3, 24 * points);
  head += "</Points>\n<Polys>\n";
  head += array("Int32", "connectivity", 1, 12 * triangles);
  head += array("Int64", "offsets", 1, 8 * triangles);
  head += "</Polys>\n<PointData";
  if (normalsOf(arrays) != nullptr) head += std::string(" Normals=\"") + kNormalsName + "\"";
  head += ">\n";
  for (const PointArray& a : arrays) head += array("Float32", a.name, a.components, 4 * a.values.size());
  head += "</PointData>\n";
  if (!labels.empty())
    head += "<CellData>\n" + array("Int32", "label", 1, 4 * labels.size()) + "</CellData>\n";
  head += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  out.write(head);
  put(24 * points, out);
  putAll(mesh.points, out);
  put(12 * triangles, out);
  putAll(mesh.triangles, out);
  put(8 * triangles, out);
  for (std::uint64_t i = 1; i <= triangles; ++i) put(static_cast<std::int64_t>(3 * i), out);
  for (const PointArray& a : arrays) {
    put(static_cast<std::uint64_t>(4 * a.values.size()), out);
    putAll(a.values, out);
  }
  if (!labels.empty()) {
    put(static_cast<std::uint64_t>(4 * labels.size()), out);
    putAll(labels, out);
  }
  out.write("\n</AppendedData>\n</VTKFile>\n");
}

}  // namespace

double singlePrecisionShift(const TriangleMesh& mesh) {
  double largest = 0.0;
  for (const glm::dvec3& point : mesh.points)
    largest = std::max(largest, glm::length(glm::dvec3(glm::vec3(point)) - point));
  return largest;
}

bool isMeshName(const fs::path& path) {
  const fs::path extension = path.extension();
  return extension == ".stl" || extension == ".ply" || extension == ".obj" || extension == ".vtp";
}

void writeMesh(const TriangleMesh& mesh, const std::vector<PointArray>& arrays, const fs::path& path,
               const std::vector<MeshObject>& objects) {
  if (!isMeshName(path))
    base::throwUsage(path.string(), "", "the name of a mesh must end in .stl, .ply, .obj or .vtp");
  base::OutputFile out(path);
  const fs::path extension = path.extension();
  if (extension == ".stl") putStl(mesh, out);
  if (extension == ".ply") putPly(mesh, arrays, objects, out);
  if (extension == ".obj") putObj(mesh, objects, out);
  if (extension == ".vtp") putVtp(mesh, arrays, objects, out);
  out.commit();
}

}  // namespace isolux::volume
