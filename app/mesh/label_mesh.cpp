#include "app/mesh/label_mesh.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <stop_token>
#include <utility>

#include "app/mesh/mesh_export.h"
#include "base/error.h"
#include "base/memory_budget.h"
#include "base/printable.h"
#include "volume/labels/label_surface.h"
#include "volume/mesh/triangle_mesh.h"
#include "volume/prepared/prepared_labels.h"
#include "volume/write/mesh_writer.h"

namespace isolux::app {

namespace {

std::vector<volume::LabelExtent> labelsToMesh(const volume::LabelBlocks& blocks,
                                              const LabelMeshRequest& asked, const std::string& source) {
  std::vector<volume::LabelExtent> labels;
  for (const volume::LabelExtent& label : blocks.list())
    if (asked.label ? label.label == *asked.label : label.label != 0) labels.push_back(label);
  if (labels.empty())
    base::throwUsage(source, "--label", "it has no label " + std::to_string(asked.label.value_or(0)));
  return labels;
}

volume::SurfaceMesh meshOfLabel(const volume::Grid& grid, const volume::LabelExtent& label,
                                const LabelMeshRequest& asked, base::Progress& progress) {
  const volume::LabelSurface surface = labelSurface(grid, label, asked.smoothing, progress);
  volume::SurfaceMeshRequest request;
  request.toleranceMm = asked.toleranceMm;
  request.budgetBytes = base::allowedMemory() / 4;
  return volume::surfaceMesh(*surface.mask.grid, request, progress);
}

void append(const volume::TriangleMesh& mesh, volume::TriangleMesh& all, const LabelMeshRequest& asked) {
  if (mesh.points.size() + all.points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
    base::throwInput(asked.file.string(), "",
                     "the meshes of all labels have over 2147483647 points; write fewer with --label");
  const int first = static_cast<int>(all.points.size());
  all.points.insert(all.points.end(), mesh.points.begin(), mesh.points.end());
  for (const volume::Triangle& triangle : mesh.triangles) all.triangles.push_back(triangle + first);
}

}  // namespace

std::vector<LabelMesh> exportLabelMeshes(const LabelMeshRequest& asked,
                                         const volume::PreparedVolume& prepared, const std::string& source,
                                         base::Progress& progress) {
  if (asked.file.extension() == ".stl" && !asked.label)
    base::throwUsage(asked.file.string(), "",
                     ".stl holds one surface; choose a label with --label, or write .obj, .ply or .vtp");
  const auto blocks = labelBlocksOf(prepared, source, progress);
  const std::vector<volume::LabelExtent> labels = labelsToMesh(*blocks, asked, source);
  std::vector<LabelMesh> made;
  volume::TriangleMesh all;
  std::vector<volume::MeshObject> objects;
  for (const volume::LabelExtent& label : labels) {
    progress.report(static_cast<double>(made.size()) / static_cast<double>(labels.size()), "making meshes");
    base::Progress own;  // its fractions are those of one label
    const std::stop_callback stop(progress.token(), [&own] { own.requestStop(); });
    LabelMesh mesh{label.label, volume::labelName(prepared.volume.labelTable.get(), label.label),
                   meshOfLabel(blocks->grid(), label, asked, own)};
    addRounding(asked.file, blocks->grid().geometry().leastSpacingMm(), mesh.surface);
    const std::string name = base::printable(mesh.name);
    objects.push_back(
        {name.empty() ? "label_" + std::to_string(label.label) : name, label.label, all.triangles.size()});
    append(mesh.surface.mesh, all, asked);
    mesh.points = mesh.surface.mesh.points.size();
    mesh.triangles = mesh.surface.mesh.triangles.size();
    mesh.surface.mesh = {};
    made.push_back(std::move(mesh));
  }
  progress.throwIfStopped();
  volume::writeMesh(all, {}, asked.file, objects);
  return made;
}

}  // namespace isolux::app
