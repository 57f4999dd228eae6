// Each mesh format, read back byte by byte by what its description says. VTK and other programs' readers are
// asked by tests/app/commands/mesh_command_test.cpp.
#include "volume/write/mesh_writer.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <sstream>
#include <string_view>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "tests/support/test_data.h"

namespace isolux::volume {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

// A corner of a cube whose numbers no float has, and a triangle without an area.
const TriangleMesh kMesh{{{0.1, 0.2, 0.3}, {1.0 / 3.0, 0.2, 0.3}, {0.1, 7e3 + 0.1, 0.3}, {0.1, 0.2, -1e-7}},
                         {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {0, 0, 1}}};
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
const std::vector<PointArray> kArrays{{"kappa1", 1, {1.0f, kNone, 3.0f, 4.0f}},
                                      {kNormalsName, 3, {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -1}}};

std::string written(const char* name, const std::vector<MeshObject>& objects = {}) {
  const fs::path file = test::temporaryFolder() / name;
  writeMesh(kMesh, kArrays, file, objects);
  std::ostringstream bytes;
  bytes << std::ifstream(file, std::ios::binary).rdbuf();
  return bytes.str();
}

class Cursor {
 public:
  explicit Cursor(std::string_view bytes) : bytes_(bytes) {}
  template <class T>
  T next() {
    T value{};
    EXPECT_LE(sizeof(T), bytes_.size());
    if (sizeof(T) > bytes_.size()) return value;
    std::memcpy(static_cast<void*>(&value), bytes_.data(), sizeof(T));
    bytes_.remove_prefix(sizeof(T));
    return value;
  }
  bool atEnd() const { return bytes_.empty(); }
  std::string_view rest() const { return bytes_; }

 private:
  std::string_view bytes_;
};

TEST(MeshWriter, StlHasTrianglesWithTheirNormals) {
  const std::string stl = written("m.stl");
  ASSERT_EQ(stl.size(), 84 + 50 * kMesh.triangles.size());
  Cursor at(std::string_view(stl).substr(80));
  EXPECT_EQ(at.next<std::uint32_t>(), kMesh.triangles.size());
  for (const Triangle& triangle : kMesh.triangles) {
    const auto normal = at.next<glm::vec3>();
    const glm::dvec3 across = glm::cross(kMesh.corner(triangle, 1) - kMesh.corner(triangle, 0),
                                         kMesh.corner(triangle, 2) - kMesh.corner(triangle, 0));
    const double length = glm::length(across);
    if (length > 0.0)
      EXPECT_LT(glm::length(glm::dvec3(normal) - across / length), 1e-6);
    else
      EXPECT_EQ(normal, glm::vec3(0.0f));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(at.next<glm::vec3>(), glm::vec3(kMesh.corner(triangle, i)));
    EXPECT_EQ(at.next<std::uint16_t>(), 0);
  }
  EXPECT_TRUE(at.atEnd());
}

TEST(MeshWriter, PlyHasDoublesAndNormals) {
  const std::string ply = written("m.ply");
  const std::size_t end = ply.find("end_header\n");
  ASSERT_NE(end, std::string::npos);
  const std::string head = ply.substr(0, end);
  EXPECT_THAT(head, testing::StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(head, HasSubstr("element vertex 4\nproperty double x\n"));
  EXPECT_THAT(head, HasSubstr("property float nz\nelement face 4\n"));
  Cursor at(std::string_view(ply).substr(end + 11));
  for (std::size_t i = 0; i < kMesh.points.size(); ++i) {
    EXPECT_EQ(at.next<glm::dvec3>(), kMesh.points[i]);
    for (std::size_t c = 0; c < 3; ++c) EXPECT_EQ(at.next<float>(), kArrays[1].values[3 * i + c]);
  }
  for (const Triangle& triangle : kMesh.triangles) {
    EXPECT_EQ(at.next<std::uint8_t>(), 3);
    EXPECT_EQ(at.next<glm::ivec3>(), triangle);
  }
  EXPECT_TRUE(at.atEnd());
}

TEST(MeshWriter, ObjCountsFromOneAndLosesNoDigit) {
  std::istringstream obj(written("m.obj"));
  std::vector<glm::dvec3> points;
  std::vector<Triangle> triangles;
  for (std::string line; std::getline(obj, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      points.emplace_back();
      words >> points.back().x >> points.back().y >> points.back().z;
    } else if (kind == "f") {
      triangles.emplace_back();
      words >> triangles.back().x >> triangles.back().y >> triangles.back().z;
      triangles.back() -= 1;
    } else {
      EXPECT_EQ(kind, "#");
    }
  }
  EXPECT_EQ(points, kMesh.points);
  EXPECT_EQ(triangles, kMesh.triangles);
}

TEST(MeshWriter, VtpHasEveryArrayWhereItsTagSays) {
  const std::string vtp = written("m.vtp");
  EXPECT_THAT(vtp, HasSubstr("NumberOfPoints=\"4\""));
  EXPECT_THAT(vtp, HasSubstr("NumberOfPolys=\"4\""));
  EXPECT_THAT(vtp, HasSubstr("<PointData Normals=\"normals\">"));
  EXPECT_THAT(vtp, testing::EndsWith("</AppendedData>\n</VTKFile>\n"));
  const auto at = [&](const std::string& name) {
    const std::size_t tag = vtp.find("Name=\"" + name + "\""), offset = vtp.find("offset=\"", tag) + 8;
    EXPECT_NE(tag, std::string::npos);
    const std::size_t begin = vtp.find('_', vtp.find("<AppendedData")) + 1;
    return Cursor(std::string_view(vtp).substr(begin + std::stoul(vtp.substr(offset))));
  };
  Cursor points = at("points");
  EXPECT_EQ(points.next<std::uint64_t>(), 96u);
  for (const glm::dvec3& point : kMesh.points) EXPECT_EQ(points.next<glm::dvec3>(), point);
  Cursor corners = at("connectivity");
  EXPECT_EQ(corners.next<std::uint64_t>(), 48u);
  for (const Triangle& triangle : kMesh.triangles) EXPECT_EQ(corners.next<glm::ivec3>(), triangle);
  Cursor offsets = at("offsets");
  EXPECT_EQ(offsets.next<std::uint64_t>(), 32u);
  for (std::int64_t i = 1; i <= 4; ++i) EXPECT_EQ(offsets.next<std::int64_t>(), 3 * i);
  Cursor kappa = at("kappa1");
  EXPECT_EQ(kappa.next<std::uint64_t>(), 16u);
  EXPECT_EQ(kappa.next<float>(), 1.0f);
  EXPECT_TRUE(std::isnan(kappa.next<float>()));
  Cursor normals = at("normals");
  EXPECT_EQ(normals.next<std::uint64_t>(), 48u);
  for (const float value : kArrays[1].values) EXPECT_EQ(normals.next<float>(), value);
}

const std::vector<MeshObject> kObjects{{"left kidney", 7, 0}, {"label_-3", -3, 1}};
constexpr std::int32_t kLabels[] = {7, -3, -3, -3};  // of the triangles

TEST(MeshWriter, ObjNamesObjects) {
  std::istringstream obj(written("m.obj", kObjects));
  std::string order;
  for (std::string line; std::getline(obj, line);)
    if (line[0] == 'o' || line[0] == 'f') order += line[0] == 'f' ? "f" : line + ';';
  EXPECT_EQ(order, "o left kidney;fo label_-3;fff");
}

TEST(MeshWriter, PlyHasTheLabelOfEachFace) {
  const std::string ply = written("m.ply", kObjects);
  const std::size_t end = ply.find("end_header\n");
  EXPECT_THAT(ply.substr(0, end), HasSubstr("vertex_indices\nproperty int label\n"));
  Cursor at(std::string_view(ply).substr(end + 11 + kMesh.points.size() * (24 + 12)));
  for (std::size_t i = 0; i < kMesh.triangles.size(); ++i) {
    EXPECT_EQ(at.next<std::uint8_t>(), 3);
    EXPECT_EQ(at.next<glm::ivec3>(), kMesh.triangles[i]);
    EXPECT_EQ(at.next<std::int32_t>(), kLabels[i]);
  }
  EXPECT_TRUE(at.atEnd());
}

TEST(MeshWriter, VtpHasTheLabelOfEachCell) {
  const std::string vtp = written("m.vtp", kObjects);
  EXPECT_THAT(vtp, HasSubstr("</PointData>\n<CellData>\n<DataArray type=\"Int32\" Name=\"label\""));
  EXPECT_THAT(written("m.vtp"), testing::Not(HasSubstr("CellData")));
  const std::size_t tag = vtp.find("Name=\"label\""), offset = vtp.find("offset=\"", tag) + 8;
  const std::size_t begin = vtp.find('_', vtp.find("<AppendedData")) + 1;
  Cursor at(std::string_view(vtp).substr(begin + std::stoul(vtp.substr(offset))));
  EXPECT_EQ(at.next<std::uint64_t>(), 16u);
  for (const std::int32_t label : kLabels) EXPECT_EQ(at.next<std::int32_t>(), label);
  EXPECT_EQ(at.rest(), "\n</AppendedData>\n</VTKFile>\n");
}

TEST(MeshWriter, OtherNamesAreRefusedAndLeaveNothing) {
  const fs::path folder = test::temporaryFolder();
  EXPECT_THROW(writeMesh(kMesh, {}, folder / "m.txt"), base::Error);
  EXPECT_THROW(writeMesh(kMesh, {}, folder / "none" / "m.stl"), base::Error);
  EXPECT_TRUE(fs::is_empty(folder));
}

}  // namespace
}  // namespace isolux::volume
