// Wavefront OBJ: `v` and `f` lines; all else (normals, texture coordinates, materials, groups) is passed
// over.
#include "base/error.h"
#include "volume/read/input/text.h"
#include "volume/read/mesh/mesh_formats.h"

namespace isolux::volume {

using base::throwInput;

namespace {

// "7", "7/1", "7//3" or "-1/..": counted from 1, or backwards from the last point so far. From 0 on return.
std::int64_t pointOf(std::string_view corner, std::size_t points, const std::string& file, int line) {
  const auto number = integerOf(corner.substr(0, corner.find('/')));
  if (!number || *number == 0) throwInput(file, linePlace(line), inQuotes(corner) + " names no point");
  return *number > 0 ? *number - 1 : *number + static_cast<std::int64_t>(points);
}

}  // namespace

TriangleMesh readObjMesh(const Bytes& bytes, const base::Progress& progress) {
  const std::string text = wholeText(bytes, progress);
  const std::string& file = bytes.name();
  TriangleMesh mesh;
  Lines lines(text);
  std::string joined;
  std::vector<std::int64_t> corners;
  for (std::size_t passed = 0; auto line = lines.next(); ++passed) {
    if (passed % 16384 == 0) progress.throwIfStopped();
    if (line->ends_with('\\')) {  // goes on in the next line
      joined.clear();
      while (line && line->ends_with('\\')) {
        if (joined.size() / 65536 != (joined.size() + line->size()) / 65536) progress.throwIfStopped();
        joined.append(line->substr(0, line->size() - 1)).append(1, ' ');
        line = lines.next();
      }
      if (line) joined.append(*line);
      line = joined;
    }
    const std::string_view word = nextWord(*line);
    if (word == "v") {
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        const auto number = realOf(nextWord(*line));
        if (!number) throwInput(file, linePlace(lines.number()), "a point needs three numbers");
        point[axis] = *number;
      }
      addPoint(mesh, point, file, linePlace(lines.number()));
    } else if (word == "f") {
      corners.clear();
      for (std::string_view corner = nextWord(*line); !corner.empty() && corner.front() != '#';
           corner = nextWord(*line))
        corners.push_back(pointOf(corner, mesh.points.size(), file, lines.number()));
      addPolygon(mesh, corners, file, linePlace(lines.number()));
    }
  }
  return mesh;
}

}  // namespace isolux::volume
