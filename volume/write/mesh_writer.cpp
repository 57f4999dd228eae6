#include "volume/write/mesh_writer.h"

#include <algorithm>
#include <array>
#include <cstdint>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/number_text.h"
#include "base/pending_file.h"

namespace isolux::volume {

namespace {

namespace fs = std::filesystem;

// Gathers small pieces.
class GatheredBytes {
 public:
  explicit GatheredBytes(base::OutputFile& file) : file_(file) {}
  template <class T>
  void put(const T& value) {
    const auto* begin = reinterpret_cast<const char*>(&value);
    text(std::string_view(begin, sizeof(T)));
  }
  void text(std::string_view piece) {
    constexpr std::size_t most = std::size_t{1} << 20;
    gathered_.append(piece);
    if (gathered_.size() >= most) flush();
  }
  void flush() {
    file_.write(gathered_);
    gathered_.clear();
  }

 private:
  base::OutputFile& file_;
  std::string gathered_;
};

void putStl(const TriangleMesh& mesh, GatheredBytes& out) {
  std::array<char, 80> header{};
  const std::string_view words = "Isolux, binary STL, mm";
  std::copy(words.begin(), words.end(), header.begin());
  out.put(header);
  out.put(static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 across =
        glm::cross(mesh.corner(t, 1) - mesh.corner(t, 0), mesh.corner(t, 2) - mesh.corner(t, 0));
    const double length = glm::length(across);
    out.put(glm::vec3(length > 0.0 ? across / length : glm::dvec3(0.0)));
    for (int i = 0; i < 3; ++i) out.put(glm::vec3(mesh.corner(t, i)));
    out.put(std::uint16_t{0});
  }
}

const PointArray* normalsOf(const std::vector<PointArray>& arrays) {
  const auto found = std::ranges::find_if(arrays, [](const PointArray& a) { return a.name == kNormalsName; });
  return found == arrays.end() ? nullptr : &*found;
}

void putPly(const TriangleMesh& mesh, const std::vector<PointArray>& arrays, GatheredBytes& out) {
  const PointArray* const normals = normalsOf(arrays);
  out.text("ply\nformat binary_little_endian 1.0\ncomment Isolux, mm\nelement vertex " +
           std::to_string(mesh.points.size()) +
           "\nproperty double x\nproperty double y\nproperty double z\n" +
           (normals ? "property float nx\nproperty float ny\nproperty float nz\n" : "") + "element face " +
           std::to_string(mesh.triangles.size()) + "\nproperty list uchar int vertex_indices\nend_header\n");
  for (std::size_t i = 0; i < mesh.points.size(); ++i) {
    out.put(mesh.points[i]);
    if (normals)
      for (std::size_t c = 0; c < 3; ++c) out.put(normals->values[3 * i + c]);
  }
  for (const Triangle& t : mesh.triangles) {
    out.put(std::uint8_t{3});
    out.put(t);
  }
}

void putObj(const TriangleMesh& mesh, GatheredBytes& out) {
  out.text("# Isolux, mm\n");
  for (const glm::dvec3& p : mesh.points)
    out.text("v " + base::shortestText(p.x) + " " + base::shortestText(p.y) + " " + base::shortestText(p.z) +
             "\n");
  for (const Triangle& t : mesh.triangles)
    out.text("f " + std::to_string(t.x + 1) + " " + std::to_string(t.y + 1) + " " + std::to_string(t.z + 1) +
             "\n");
}

// Appended data: each array after the number of its bytes.
class VtpLayout {
 public:
  std::string array(const std::string& type, const std::string& name, int components, std::uint64_t bytes) {
    std::string tag = "<DataArray type=\"" + type + "\" Name=\"" + name + "\" NumberOfComponents=\"" +
                      std::to_string(components) + "\" format=\"appended\" offset=\"" +
                      std::to_string(offset_) + "\"/>\n";
    offset_ += sizeof(std::uint64_t) + bytes;
    return tag;
  }

 private:
  std::uint64_t offset_ = 0;
};

void putVtp(const TriangleMesh& mesh, const std::vector<PointArray>& arrays, GatheredBytes& out) {
  const std::uint64_t points = mesh.points.size(), triangles = mesh.triangles.size();
  VtpLayout layout;  // its arrays in their order
  std::string head =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n<Piece NumberOfPoints=\"" +
      std::to_string(points) +
      "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\"" +
      std::to_string(triangles) + "\">\n<Points>\n";
  head += layout.array("Float64", "points", 3, 24 * points);
  head += "</Points>\n<Polys>\n";
  head += layout.array("Int32", "connectivity", 1, 12 * triangles);
  head += layout.array("Int64", "offsets", 1, 8 * triangles);
  head += "</Polys>\n<PointData";
  if (normalsOf(arrays) != nullptr) head += std::string(" Normals=\"") + kNormalsName + "\"";
  head += ">\n";
  for (const PointArray& a : arrays)
    head += layout.array("Float32", a.name, a.components, 4 * a.values.size());
  head += "</PointData>\n</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  out.text(head);
  out.put(24 * points);
  for (const glm::dvec3& p : mesh.points) out.put(p);
  out.put(12 * triangles);
  for (const Triangle& t : mesh.triangles) out.put(t);
  out.put(8 * triangles);
  for (std::uint64_t i = 1; i <= triangles; ++i) out.put(static_cast<std::int64_t>(3 * i));
  for (const PointArray& a : arrays) {
    out.put(static_cast<std::uint64_t>(4 * a.values.size()));
    for (const float value : a.values) out.put(value);
  }
  out.text("\n</AppendedData>\n</VTKFile>\n");
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

void writeMesh(const TriangleMesh& mesh, const std::vector<PointArray>& arrays, const fs::path& path) {
  if (!isMeshName(path))
    throw base::Error(base::ErrorKind::usage, path.string(), "",
                      "the name of a mesh must end in .stl, .ply, .obj or .vtp");
  base::OutputFile file(path);
  GatheredBytes out(file);
  const fs::path extension = path.extension();
  if (extension == ".stl") putStl(mesh, out);
  if (extension == ".ply") putPly(mesh, arrays, out);
  if (extension == ".obj") putObj(mesh, out);
  if (extension == ".vtp") putVtp(mesh, arrays, out);
  out.flush();
  file.commit();
}

}  // namespace isolux::volume
