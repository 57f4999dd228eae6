#include "tests/volume/mesh/mesh_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>

#include <glm/geometric.hpp>

#include "tests/volume/read/reader_support.h"

namespace isolux::test {

using volume::Triangle;
using volume::TriangleMesh;

TriangleMesh icosphere(double radius, int subdivisions, glm::dvec3 centre) {
  const double g = std::numbers::phi;
  TriangleMesh mesh;
  mesh.points = {{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                 {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
  mesh.triangles = {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
                    {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
                    {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}};
  for (int step = 0; step < subdivisions; ++step) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [at, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.points.size()));
      if (isNew)
        mesh.points.push_back(
            0.5 * (mesh.points[static_cast<std::size_t>(a)] + mesh.points[static_cast<std::size_t>(b)]));
      return at->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& t : mesh.triangles) {
      const int ab = middle(t.x, t.y), bc = middle(t.y, t.z), ca = middle(t.z, t.x);
      for (const Triangle& part :
           {Triangle(t.x, ab, ca), Triangle(t.y, bc, ab), Triangle(t.z, ca, bc), Triangle(ab, bc, ca)})
        finer.push_back(part);
    }
    mesh.triangles = finer;
    for (glm::dvec3& p : mesh.points) p = glm::normalize(p);
  }
  for (glm::dvec3& p : mesh.points) p = centre + radius * glm::normalize(p);
  return mesh;
}

TriangleMesh torus(double radius, double tube, int around, int across) {
  TriangleMesh mesh;
  const double step = 2.0 * std::numbers::pi;
  for (int i = 0; i < around; ++i)
    for (int j = 0; j < across; ++j) {
      const double u = step * i / around, v = step * j / across;
      const double r = radius + tube * std::cos(v);
      mesh.points.emplace_back(r * std::cos(u), r * std::sin(u), tube * std::sin(v));
      const auto at = [&](int a, int b) { return (a % around) * across + b % across; };
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j), at(i + 1, j + 1));
      mesh.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i, j + 1));
    }
  return mesh;
}

TriangleMesh box(glm::dvec3 low, glm::dvec3 high) {
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
    mesh.points.emplace_back((corner & 1) ? high.x : low.x, (corner & 2) ? high.y : low.y,
                             (corner & 4) ? high.z : low.z);
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
  TriangleMesh mesh = a;
  mesh.points.insert(mesh.points.end(), b.points.begin(), b.points.end());
  for (const Triangle& t : b.triangles) mesh.triangles.push_back(t + static_cast<int>(a.points.size()));
  return mesh;
}

TriangleMesh turned(TriangleMesh mesh) {
  for (Triangle& t : mesh.triangles) std::swap(t.y, t.z);
  return mesh;
}

TriangleMesh parsedObj(const std::filesystem::path& path) {
  TriangleMesh mesh;
  std::ifstream in(path);
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (word == "v") {
      glm::dvec3 p;
      words >> p.x >> p.y >> p.z;
      mesh.points.push_back(p);
    } else if (word == "f") {
      std::vector<int> corners;
      while (words >> word) corners.push_back(std::stoi(word) - 1);
      for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.emplace_back(corners[0], corners[i - 1], corners[i]);
    }
  }
  return mesh;
}

std::string asObj(const TriangleMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << "# a test\nmtllib none.mtl\n";
  for (const glm::dvec3& p : mesh.points) out << "v " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const Triangle& t : mesh.triangles)
    out << "f " << t.x + 1 << "/1/1 " << t.y + 1 << "//1 " << t.z + 1 << '\n';
  return out.str();
}

std::string asStlText(const TriangleMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << "solid a test\n";
  for (const Triangle& t : mesh.triangles) {
    out << "  facet normal 0 0 0\n    outer loop\n";
    for (int i = 0; i < 3; ++i) {
      const glm::dvec3& p = mesh.corner(t, i);
      out << "      vertex " << p.x << ' ' << p.y << ' ' << p.z << '\n';
    }
    out << "    endloop\n  endfacet\n";
  }
  out << "endsolid a test\n";
  return out.str();
}

std::string asStlBinary(const TriangleMesh& mesh) {
  std::string out = "solid, but binary";  // a known trap
  out.resize(80, ' ');
  out += bytesOf<std::uint32_t>({static_cast<std::uint32_t>(mesh.triangles.size())});
  for (const Triangle& t : mesh.triangles) {
    std::vector<float> numbers(3, 0.0F);
    for (int i = 0; i < 3; ++i)
      for (int axis = 0; axis < 3; ++axis) numbers.push_back(static_cast<float>(mesh.corner(t, i)[axis]));
    out += bytesOf(numbers) + std::string(2, '\0');
  }
  return out;
}

namespace {
std::string plyHeader(const TriangleMesh& mesh, const std::string& format) {
  return "ply\nformat " + format + " 1.0\ncomment a test\nelement vertex " +
         std::to_string(mesh.points.size()) +
         "\nproperty uchar red\nproperty float x\nproperty double y\nproperty float z\nelement face " +
         std::to_string(mesh.triangles.size()) +
         "\nproperty list uchar int vertex_indices\nproperty short part\nend_header\n";
}
}  // namespace

std::string asPlyText(const TriangleMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << plyHeader(mesh, "ascii");
  for (const glm::dvec3& p : mesh.points) out << "7 " << p.x << ' ' << p.y << ' ' << p.z << '\n';
  for (const Triangle& t : mesh.triangles) out << "3 " << t.x << ' ' << t.y << ' ' << t.z << " -1\n";
  return out.str();
}

std::string asPlyBinary(const TriangleMesh& mesh, bool big) {
  std::string out = plyHeader(mesh, big ? "binary_big_endian" : "binary_little_endian");
  for (const glm::dvec3& p : mesh.points)
    out += '\7' + bytesOf<float>({static_cast<float>(p.x)}, big) + bytesOf<double>({p.y}, big) +
           bytesOf<float>({static_cast<float>(p.z)}, big);
  for (const Triangle& t : mesh.triangles)
    out += '\3' + bytesOf<std::int32_t>({t.x, t.y, t.z}, big) + bytesOf<std::int16_t>({-1}, big);
  return out;
}

std::string asVtp(const TriangleMesh& mesh) {
  std::ostringstream out;
  out.precision(17);
  out << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\">"
         "<PolyData><Piece NumberOfPoints=\""
      << mesh.points.size() << "\" NumberOfPolys=\"" << mesh.triangles.size()
      << "\"><Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">";
  for (const glm::dvec3& p : mesh.points) out << p.x << ' ' << p.y << ' ' << p.z << ' ';
  out << "</DataArray></Points><Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">";
  for (const Triangle& t : mesh.triangles) out << t.x << ' ' << t.y << ' ' << t.z << ' ';
  out << "</DataArray><DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">";
  for (std::size_t i = 1; i <= mesh.triangles.size(); ++i) out << 3 * i << ' ';
  out << "</DataArray></Polys></Piece></PolyData></VTKFile>\n";
  return out.str();
}

namespace {
double distanceToSegment(glm::dvec3 p, glm::dvec3 a, glm::dvec3 b) {
  const double length = glm::dot(b - a, b - a);
  const double t = length > 0.0 ? std::clamp(glm::dot(p - a, b - a) / length, 0.0, 1.0) : 0.0;
  return glm::distance(p, a + t * (b - a));
}
}  // namespace

double distanceTo(const TriangleMesh& mesh, glm::dvec3 p) {
  double best = std::numeric_limits<double>::infinity();
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = mesh.corner(t, 0), b = mesh.corner(t, 1), c = mesh.corner(t, 2);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    const auto side = [&](glm::dvec3 from, glm::dvec3 to) {
      return glm::dot(glm::cross(to - from, p - from), n) >= 0.0;
    };
    if (glm::dot(n, n) > 0.0 && side(a, b) && side(b, c) && side(c, a))
      best = std::min(best, std::abs(glm::dot(p - a, glm::normalize(n))));
    best =
        std::min({best, distanceToSegment(p, a, b), distanceToSegment(p, b, c), distanceToSegment(p, c, a)});
  }
  return best;
}

double windingNumber(const TriangleMesh& mesh, glm::dvec3 p) {
  double sum = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const glm::dvec3 a = mesh.corner(t, 0) - p, b = mesh.corner(t, 1) - p, c = mesh.corner(t, 2) - p;
    const double la = glm::length(a), lb = glm::length(b), lc = glm::length(c);
    sum += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                            la * lb * lc + glm::dot(a, b) * lc + glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return sum / (4.0 * std::numbers::pi);
}

}  // namespace isolux::test
