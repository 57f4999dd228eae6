// STL: text ("solid ... endsolid") or binary (80 bytes, a count, 50 bytes per facet, little endian).
#include "base/error.h"
#include "volume/read/input/text.h"
#include "volume/read/mesh/mesh_formats.h"

namespace isolux::volume {

using base::throwInput;

namespace {

constexpr std::uint64_t kHeaderBytes = 84, kFacetBytes = 50;

TriangleMesh readBinary(const std::string& data, const std::string& file, const base::Progress& progress) {
  if (data.size() < kHeaderBytes) throwInput(file, "byte 80", "truncated: the number of facets is missing");
  const std::uint64_t facets = numberAt<std::uint32_t>(data.data() + 80, false);
  if (data.size() < kHeaderBytes + facets * kFacetBytes)
    throwInput(file, "byte 80",
               "truncated: " + std::to_string(facets) + " facets are announced, the file holds " +
                   std::to_string((data.size() - kHeaderBytes) / kFacetBytes));
  TriangleMesh mesh;
  mesh.points.reserve(static_cast<std::size_t>(3 * facets));
  for (std::uint64_t facet = 0; facet < facets; ++facet) {
    if (facet % 65536 == 0) progress.throwIfStopped();
    const std::uint64_t at = kHeaderBytes + facet * kFacetBytes;
    const auto first = static_cast<std::int64_t>(mesh.points.size());
    const std::string place = "facet " + std::to_string(facet);
    for (std::uint64_t corner = 0; corner < 3; ++corner) {
      const auto number = [&](std::uint64_t axis) {  // behind the normal
        return numberAt<float>(data.data() + at + 12 * (corner + 1) + 4 * axis, false);
      };
      addPoint(mesh, {number(0), number(1), number(2)}, file, place);
    }
    addPolygon(mesh, {first, first + 1, first + 2}, file, place);
  }
  return mesh;
}

TriangleMesh readText(const std::string& data, const std::string& file, const base::Progress& progress) {
  TriangleMesh mesh;
  Lines lines(data);
  std::vector<std::int64_t> loop;
  bool open = false;  // a solid that has not ended
  while (auto line = lines.next()) {
    if (lines.number() % 16384 == 0) progress.throwIfStopped();
    const std::string_view word = nextWord(*line);
    if (word == "solid") {
      open = true;
    } else if (word == "endsolid") {
      open = false;
    } else if (word == "outer") {
      loop.clear();
    } else if (word == "vertex") {
      glm::dvec3 point;
      for (int axis = 0; axis < 3; ++axis) {
        const auto number = realOf(nextWord(*line));
        if (!number) throwInput(file, linePlace(lines.number()), "a vertex needs three numbers");
        point[axis] = *number;
      }
      loop.push_back(static_cast<std::int64_t>(mesh.points.size()));
      addPoint(mesh, point, file, linePlace(lines.number()));
    } else if (word == "endloop") {
      addPolygon(mesh, loop, file, linePlace(lines.number()));
      loop.clear();
    } else if (!word.empty() && word != "facet" && word != "endfacet") {
      throwInput(file, linePlace(lines.number()), inQuotes(word) + " does not belong in an STL file");
    }
  }
  if (open || !loop.empty()) throwInput(file, linePlace(lines.number()), "truncated: endsolid is missing");
  return mesh;
}

}  // namespace

bool looksLikeStlText(const std::string& head) {
  return trimmed(head).starts_with("solid") && head.find("facet") != std::string::npos;
}

TriangleMesh readStlMesh(const Bytes& bytes, const base::Progress& progress) {
  const std::string data = wholeText(bytes, progress);
  // Binary files may begin with "solid" too, but their count of facets has a zero byte.
  const std::string_view beginning = std::string_view(data).substr(0, 1024);
  const bool text = trimmed(beginning).starts_with("solid") && beginning.find('\0') == std::string_view::npos;
  return text ? readText(data, bytes.name(), progress) : readBinary(data, bytes.name(), progress);
}

}  // namespace isolux::volume
