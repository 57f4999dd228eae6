#include "app/mesh/mesh_export.h"

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "base/memory_budget.h"
#include "base/number_text.h"
#include "volume/extraction/surface_arrays.h"
#include "volume/visible/hidden_pieces.h"
#include "volume/write/mesh_writer.h"

namespace isolux::app {

namespace {

volume::SurfaceMesh extracted(const MeshRequest& asked, const scene::Scene& scene,
                              const volume::PreparedVolume& prepared, base::Progress& progress) {
  volume::SurfaceMeshRequest request;
  request.isovalue = scene.surfaces.front().value.value();
  request.inside = scene.isosurface.inside;
  request.field = scene.hit.field;
  const auto cubic = prepared.cubicFields->make(request.field, progress);
  if (cubic) request.coefficients = cubic->coefficients.get();
  const auto hidden = volume::hiddenOf(scene, *prepared.pieces, progress);
  request.hidden = volume::hiddenAt(hidden, request.isovalue).voxels;
  request.closed = asked.closed;
  request.toleranceMm = asked.toleranceMm;
  request.budgetBytes = base::allowedMemory() / 4;
  return volume::surfaceMesh(prepared.grid(), request, progress);
}

std::vector<volume::PointArray> arraysOf(const MeshRequest& asked, scene::Scene& scene,
                                         const volume::PreparedVolume& prepared,
                                         const volume::SurfaceMesh& found, base::Progress& progress) {
  const std::string ending = asked.file.extension().string();
  const bool curvature = ending == ".vtp";
  if (!curvature && ending != ".ply") return {};
  prepared.derivativeChoices->complete(scene, progress);
  std::vector<volume::PointArray> arrays =
      volume::surfaceArrays(prepared, scene, found.mesh.points, curvature, progress);
  if (curvature && !scene.color.volume.empty())
    arrays.push_back(volume::secondValueArray(prepared, scene, found.mesh.points, progress));
  return arrays;
}

}  // namespace

void addRounding(const std::filesystem::path& file, double voxelMm, volume::SurfaceMesh& found) {
  constexpr double mostVoxels = 1e-3;
  if (file.extension() != ".stl") return;
  const double shift = volume::singlePrecisionShift(found.mesh);
  if (!(shift <= mostVoxels * voxelMm))
    base::throwInput(file.string(), "",
                     "so far from the origin the single precision of .stl moves points by " +
                         base::shortText(shift, 2) +
                         " mm, over a thousandth of a voxel: write .ply, .obj or .vtp");
  found.largestDistanceMm += shift;
}

volume::SurfaceMesh exportMesh(const MeshRequest& asked, scene::Scene resolved,
                               const volume::PreparedVolume& volume, base::Progress& progress) {
  if (!volume::isMeshName(asked.file))
    base::throwUsage(asked.file.string(), "", "the name of a mesh must end in .stl, .ply, .obj or .vtp");
  progress.report(0.0, "making a mesh");
  volume::SurfaceMesh found = extracted(asked, resolved, volume, progress);
  if (found.mesh.triangles.empty())
    base::throwInput(
        resolved.source.path, "isosurface.value",
        "no surface at " + base::shortText(resolved.surfaces.front().value.value()) + "; no file is written");
  addRounding(asked.file, volume.grid().geometry().leastSpacingMm(), found);
  const std::vector<volume::PointArray> arrays = arraysOf(asked, resolved, volume, found, progress);
  progress.throwIfStopped();
  volume::writeMesh(found.mesh, arrays, asked.file);
  return found;
}

std::string meshText(const volume::SurfaceMesh& made) {
  return std::to_string(made.mesh.triangles.size()) + " triangles, " +
         std::to_string(made.mesh.points.size()) + " points; maximum deviation " +
         base::shortText(made.largestDistanceMm, 3) + " mm, " +
         (made.openEdges == 0 ? "closed" : std::to_string(made.openEdges) + " open edges");
}

std::string meshWarning(const volume::SurfaceMesh& made) {
  std::string text;
  if (made.beyond > 0)
    text = "tolerance " + base::shortText(made.toleranceMm, 3) + " mm not reached at " +
           std::to_string(made.beyond) + (made.beyond == 1 ? " place" : " places") + ": maximum deviation " +
           base::shortText(made.largestDistanceMm, 3) + " mm at " + base::shortText(made.farthest.x, 5) +
           "," + base::shortText(made.farthest.y, 5) + "," + base::shortText(made.farthest.z, 5);
  if (made.astray > 0)
    text += (text.empty() ? "" : "; ") + std::to_string(made.astray) +
            " points are off the surface: the spline is thinner there than its samples";
  return text;
}

}  // namespace isolux::app
