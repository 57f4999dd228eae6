#include "volume/read/mesh/mesh_formats.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.h"

namespace isolux::volume {

using base::throwInput;

std::string wholeText(const Bytes& bytes, const base::Progress& progress) {
  constexpr std::size_t piece = std::size_t{4} << 20;
  const auto size = static_cast<std::size_t>(bytes.size());
  std::string text;
  text.reserve(size);
  while (text.size() < size) {
    progress.throwIfStopped();
    const std::size_t done = text.size(), count = std::min(piece, size - done);
    text.resize(done + count);
    bytes.read(done, std::as_writable_bytes(std::span(text).subspan(done)));
  }
  return text;
}

void addPoint(TriangleMesh& mesh, const glm::dvec3& point, const std::string& file,
              const std::string& place) {
  constexpr double farthest = 1e12;  // mm, as for volumes
  for (int axis = 0; axis < 3; ++axis)
    if (!(std::abs(point[axis]) <= farthest))
      throwInput(file, place, "a coordinate is not finite or beyond 1e12 mm");
  mesh.points.push_back(point);
}

void addPolygon(TriangleMesh& mesh, const std::vector<std::int64_t>& corners, const std::string& file,
                const std::string& place) {
  if (corners.size() < 3) throwInput(file, place, "a face has fewer than three corners");
  for (const std::int64_t corner : corners)
    if (corner < 0 || corner >= static_cast<std::int64_t>(mesh.points.size()) ||
        corner > std::numeric_limits<int>::max())
      throwInput(file, place,
                 "a face names point " + std::to_string(corner) + ", there are " +
                     std::to_string(mesh.points.size()) + " (counted from 0)");
  for (std::size_t i = 2; i < corners.size(); ++i)
    mesh.triangles.emplace_back(static_cast<int>(corners[0]), static_cast<int>(corners[i - 1]),
                                static_cast<int>(corners[i]));
}

bool looksLikePolyData(const std::string& head) {
  const std::size_t tag = head.find("<VTKFile");
  if (tag == std::string::npos) return false;
  const std::string_view attributes = std::string_view(head).substr(tag, head.find('>', tag) - tag);
  return attributes.find("\"PolyData\"") != std::string_view::npos ||
         attributes.find("'PolyData'") != std::string_view::npos;
}

}  // namespace isolux::volume
