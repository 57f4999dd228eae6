#include "volume/read/mesh/mesh.h"

#include <algorithm>

#include "base/error.h"
#include "volume/mesh/mesh_repair.h"
#include "volume/read/input/payload.h"
#include "volume/read/input/text.h"
#include "volume/read/mesh/mesh_formats.h"
#include "volume/read/process/foreign.h"

namespace isolux::volume {

using base::throwInput;

namespace {

enum class MeshFormat { stl, obj, ply, polyData };

std::optional<MeshFormat> formatOf(const std::string& head, const std::string& extension) {
  if (looksLikePly(head)) return MeshFormat::ply;
  if (looksLikePolyData(head)) return MeshFormat::polyData;
  if (looksLikeStlText(head) || extension == ".stl") return MeshFormat::stl;
  if (extension == ".obj") return MeshFormat::obj;
  if (extension == ".ply") return MeshFormat::ply;
  if (extension == ".vtp") return MeshFormat::polyData;
  return std::nullopt;
}

struct MeshFile {
  TriangleMesh mesh;
  const char* format;
};

void checkMesh(const TriangleMesh& mesh, const std::string& file) {
  constexpr std::size_t most = std::size_t{1} << 29;  // sides are counted in int
  if (mesh.triangles.empty()) throwInput(file, "", "the mesh has no triangles");
  if (mesh.triangles.size() > most) throwInput(file, "", "the mesh has more than 2^29 triangles");
  const glm::dvec3 extent = boundsOf(mesh).size();
  if (!(std::max({extent.x, extent.y, extent.z}) > 1e-9))
    throwInput(file, "", "all triangles coincide in one point");
}

MeshFile readTriangles(const std::filesystem::path& path, const ReadOptions& options,
                       base::Progress& progress) {
  progress.report(0.0, "reading");
  const FileBytes bytes(path);
  // Points, triangles and their sides take about ten times the bytes of the densest file.
  checkBudget(10 * bytes.size(), "this mesh", "", bytes.name(), options);
  const auto format = formatOf(bytes.head(4096), lowered(path.extension().string()));
  if (format == MeshFormat::obj) return {readObjMesh(bytes, progress), "OBJ mesh"};
  if (format == MeshFormat::ply) return {readPlyMesh(bytes, progress), "PLY mesh"};
  if (format == MeshFormat::polyData)
    return {readPolyDataMesh(path, options.budgetBytes, progress), "VTK PolyData mesh"};
  return {readStlMesh(bytes, progress), "STL mesh"};
}

GridGeometry geometryFor(const TriangleMesh& mesh, const ReadOptions& options) {
  if (options.grid && hasCubicVoxels(*options.grid)) return *options.grid;
  BoxMm box = boundsOf(mesh);
  if (options.alsoHold) box.add(*options.alsoHold);
  return gridAround(box, options.meshVoxels);
}

}  // namespace

bool isMesh(const std::string& head, const std::string& extension) {
  return formatOf(head, extension).has_value();
}

BoxMm readMeshBounds(const std::filesystem::path& path, const ReadOptions& options,
                     base::Progress& progress) {
  const TriangleMesh mesh = readTriangles(path, options, progress).mesh;
  checkMesh(mesh, path.string());
  return boundsOf(mesh);
}

Volume readMesh(const std::filesystem::path& path, const ReadOptions& options, base::Progress& progress) {
  MeshFile file = readTriangles(path, options, progress);
  return distanceVolume(std::move(file.mesh), file.format, path.string(), options, progress);
}

Volume distanceVolume(TriangleMesh mesh, const std::string& format, const std::string& file,
                      const ReadOptions& options, base::Progress& progress) {
  checkMesh(mesh, file);
  Volume volume;
  volume.format = format;
  volume.fileType = VoxelType::float32;
  volume.unit = "mm";
  volume.axes = scene::WorldAxes::yUp;
  volume.isovalue = 0.0;
  volume.isMesh = true;
  volume.warnings.emplace_back("a mesh: turned into its signed distance, positive inside; 1 unit = 1 mm");
  const GridGeometry geometry = geometryFor(mesh, options);
  checkBudget(geometry.voxelCount() * sizeof(float), "the distance field",
              "a lower source.mesh_voxels needs less", file, options);
  const TriangleMesh closed = closedMesh(std::move(mesh), volume.warnings, progress);
  if (closed.triangles.empty()) throwInput(file, "", "no triangle has an area");
  volume.grid = std::make_shared<Grid>(signedDistance(closed, geometry, progress));
  if (volume.grid->maximum() <= 0.0) {
    volume.isovalue = -2.0 * geometry.spacingMm().x;
    volume.warnings.emplace_back(
        "the mesh holds no voxel inside: a shell of two voxels round it is shown instead");
  }
  return volume;
}

}  // namespace isolux::volume
