// isolux mesh PATH --out FILE: the isosurface as triangles, for printing and simulation.
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/mesh/mesh_export.h"
#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "scene/rules/automatic.h"
#include "volume/write/mesh_writer.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

struct MeshOptions {
  std::string path, out;
  double tolerance = 0.0;
  bool closed = false, json = false;
  std::shared_ptr<SceneOptions> scene;
};

ordered_json meshJson(const MeshOptions& options, const scene::Scene& scene,
                      const volume::SurfaceMesh& found) {
  ordered_json json;
  json["file"] = options.out;
  json["isovalue"] = scene.isosurface.value.value();
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

void runMesh(const MeshOptions& options, base::Progress& progress) {
  const std::filesystem::path out(options.out);
  if (!volume::isMeshName(out))
    base::throwUsage(options.out, "", "the name of a mesh must end in .stl, .ply, .obj or .vtp");
  requireSource(options.path, *options.scene);
  scene::Scene scene = sceneOf(options.path, *options.scene);
  refuseCuts(scene, "isolux mesh");
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, options.out, "--out");
  const OutputLock lock(options.out);
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
  CLI::App* const parser =
      program.add_subcommand("mesh", "Write an isosurface as triangles, for printing or simulation");
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
  parser->add_flag("--closed", options->closed, "Cap openings at the volume border");
  parser->add_flag("--json", options->json, "Print one JSON object about the mesh");
  options->scene = addSceneOptions(*parser);
  addThreadsOption(*parser);
  parser->footer(
      "Vertices are on the surface of hit.field, in world mm; components hidden by `pieces.` are omitted.\n"
      "Examples:\n"
      "  isolux mesh ct.nii.gz --isovalue 300 --out skull.stl --closed --tolerance 0.05\n"
      "  isolux mesh ct.nii.gz --isovalue 300 --out skull.vtp --json");
  return {parser, [options](base::Progress& progress) { runMesh(*options, progress); }};
}

}  // namespace isolux::app
