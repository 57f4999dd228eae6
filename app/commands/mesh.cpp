// isolux mesh PATH --out FILE: the isosurface, or surfaces of labels, as triangles, for printing and
// simulation.
#include <iostream>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/mesh/label_mesh.h"
#include "app/mesh/mesh_export.h"
#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/printable.h"
#include "scene/rules/automatic.h"
#include "volume/labels/mask_field.h"
#include "volume/labels/shown_labels.h"
#include "volume/write/mesh_writer.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

struct MeshOptions {
  std::string path, out;
  double tolerance = 0.0;
  bool closed = false, json = false, labels = false;
  std::optional<int> label;
  std::optional<double> smoothing;  // voxels; 1
  std::shared_ptr<SceneOptions> scene;
};

ordered_json meshJson(const MeshOptions& options, const scene::Scene& scene,
                      const volume::SurfaceMesh& found) {
  ordered_json json;
  json["file"] = options.out;
  json["isovalue"] = scene.surfaces.front().value.value();
  json["points"] = found.mesh.points.size();
  json["triangles"] = found.mesh.triangles.size();
  json["largest_distance_mm"] = found.largestDistanceMm;
  json["farthest_mm"] = found.farthest;
  json["places_beyond_tolerance"] = found.beyond;
  json["closed"] = found.openEdges == 0;
  json["open_edges"] = found.openEdges;
  json["points_beside_the_surface"] = found.astray;
  return json;
}

ordered_json labelMeshJson(const MeshOptions& options, const std::vector<LabelMesh>& made) {
  ordered_json json{{"file", options.out}, {"smoothing_voxels", options.smoothing.value_or(1.0)}};
  for (const LabelMesh& of : made)
    json["labels"].push_back({{"label", of.label},
                              {"name", of.name},
                              {"points", of.points},
                              {"triangles", of.triangles},
                              {"largest_distance_mm", of.surface.largestDistanceMm},
                              {"places_beyond_tolerance", of.surface.beyond},
                              {"closed", of.surface.openEdges == 0},
                              {"open_edges", of.surface.openEdges}});
  return json;
}

void printLabelMeshes(const std::vector<LabelMesh>& made) {
  std::vector<std::vector<std::string>> rows{
      {"label", "name", "triangles", "points", "maximum deviation mm", "open edges"}};
  for (const LabelMesh& of : made)
    rows.push_back({std::to_string(of.label), base::printable(of.name), std::to_string(of.triangles),
                    std::to_string(of.points), base::shortText(of.surface.largestDistanceMm, 3),
                    std::to_string(of.surface.openEdges)});
  printTable(std::cout, rows);
}

void runLabelMeshes(const MeshOptions& options, const scene::Scene& scene, base::Progress& progress) {
  const auto prepared = loadWithProgressBar(volume::withLabelsAsValues(scene.source), progress);
  std::vector<LabelMesh> made;
  {
    const ProgressBar bar(progress);
    made = exportLabelMeshes({options.out, options.tolerance, options.smoothing.value_or(1.0), options.label},
                             *prepared, scene.source.path, progress);
  }
  if (options.json)
    std::cout << jsonText(labelMeshJson(options, made));
  else
    printLabelMeshes(made);
  for (const LabelMesh& of : made)
    if (const std::string warning = meshWarning(of.surface); !warning.empty())
      printNote("label " + std::to_string(of.label) + ": " + warning);
  printWarnings(prepared->volume);
}

void runMesh(const MeshOptions& options, base::Progress& progress) {
  const std::filesystem::path out(options.out);
  if (!volume::isMeshName(out))
    base::throwUsage(options.out, "", "the name of a mesh must end in .stl, .ply, .obj or .vtp");
  requireSource(options.path, *options.scene);
  scene::Scene scene = sceneOf(options.path, *options.scene);
  const bool ofLabels = options.labels || options.label;
  if (options.smoothing && !ofLabels)
    base::throwUsage("", "--smoothing", "requires --labels or --label; add one or omit --smoothing");
  if (!ofLabels) refuseCuts(scene, "isolux mesh");
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, options.out, "--out");
  const OutputLock lock(options.out);
  if (ofLabels) {
    runLabelMeshes(options, scene, progress);
    return;
  }
  const auto prepared = loadWithProgressBar(scene.source, progress);
  scene = scene::resolve(std::move(scene), prepared->facts);
  volume::SurfaceMesh found;
  {
    const ProgressBar bar(progress);
    found = exportMesh({out, options.tolerance, options.closed}, scene, *prepared, progress);
  }
  if (options.json)
    std::cout << jsonText(meshJson(options, scene, found));
  else
    std::cout << meshText(found) << '\n';
  if (const std::string warning = meshWarning(found); !warning.empty()) printNote(warning);
  printWarnings(prepared->volume);
}

}  // namespace

Command makeMesh(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "mesh", "Write an isosurface, or labels, as triangles, for printing or simulation");
  auto options = std::make_shared<MeshOptions>();
  addPath(*parser, options->path, Opens::pictures);
  parser
      ->add_option("--out", options->out,
                   "A new .stl, .ply (with normals), .obj, or .vtp (with normals, kappa1, kappa2, "
                   "confidence; color_value if color.volume is set)")
      ->required();
  parser
      ->add_option("--tolerance", options->tolerance,
                   "Split triangles until they deviate from the surface by at most this, mm")
      ->check(CLI::Range(1e-6, 1e6));
  CLI::Option* const closed =
      parser->add_flag("--closed", options->closed, "Cap openings at the volume border");
  CLI::Option* const labels = parser->add_flag(
      "--labels", options->labels,
      "The surface of each label of a label map but 0 instead of an isosurface: an object of .obj, the array "
      "`label` of .ply and .vtp; closed");
  labels->excludes(closed);
  addOption(*parser, "--label", options->label, "N", "The surface of this label alone; also as .stl")
      ->excludes(labels)
      ->excludes(closed);
  addOption(*parser, "--smoothing", options->smoothing, "VOXELS",
            "Smoothing of the surfaces of labels, 0 to 2 voxels; default: 1")
      ->check(within(0.0, volume::kMostSmoothing));
  parser->add_flag("--json", options->json, "Print one JSON object about the mesh");
  options->scene = addSceneOptions(*parser);
  addThreadsOption(*parser);
  parser->footer(
      "Vertices are on the surface of hit.field, in world mm; components hidden by `pieces.` are omitted.\n"
      "Examples:\n"
      "  isolux mesh ct.nii.gz --isovalue 300 --out skull.stl --closed --tolerance 0.05\n"
      "  isolux mesh ct.nii.gz --isovalue 300 --out skull.vtp --json\n"
      "  isolux mesh segmentation.nii.gz --labels --out organs.obj");
  return {parser, [options](base::Progress& progress) { runMesh(*options, progress); }};
}

}  // namespace isolux::app
