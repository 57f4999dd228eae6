// isolux mesh PATH --out FILE: the isosurface as triangles, for printing and simulation.
#include <iostream>

#include "app/commands/command.h"
#include "app/commands/progress_bar.h"
#include "base/error.h"
#include "base/memory_budget.h"
#include "base/number_text.h"
#include "scene/rules/automatic.h"
#include "volume/mesh/surface_arrays.h"
#include "volume/mesh/surface_mesh.h"
#include "volume/pieces/hidden_pieces.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

struct MeshOptions {
  std::string path, out;
  double tolerance = 0.0;
  bool closed = false, json = false;
  std::shared_ptr<SceneOptions> scene;
};

volume::SurfaceMesh extracted(const MeshOptions& options, const scene::Scene& scene,
                              const volume::PreparedVolume& prepared, base::Progress& progress) {
  volume::SurfaceMeshRequest request;
  request.isovalue = scene.isosurface.value.value();
  request.inside = scene.isosurface.inside;
  request.field = scene.hit.field;
  const auto cubic = prepared.cubicFields->make(request.field, progress);
  if (cubic && cubic->coefficients) request.coefficients = &*cubic->coefficients;
  const auto hidden = volume::hiddenOf(scene, *prepared.pieces, progress);
  request.hidden = volume::hiddenAt(hidden, request.isovalue).voxels;
  request.closed = options.closed;
  request.toleranceMm = options.tolerance;
  request.budgetBytes = base::allowedMemory() / 4;
  return volume::surfaceMesh(prepared.grid(), request, progress);
}

ordered_json meshJson(const MeshOptions& options, const scene::Scene& scene,
                      const volume::SurfaceMesh& found) {
  ordered_json json;
  json["file"] = options.out;
  json["isovalue"] = scene.isosurface.value.value();
  json["points"] = found.mesh.points.size();
  json["triangles"] = found.mesh.triangles.size();
  json["largest_distance_mm"] = found.largestDistanceMm;
  json["closed"] = found.openEdges == 0;
  json["open_edges"] = found.openEdges;
  json["points_beside_the_surface"] = found.astray;
  return json;
}

void printMesh(const volume::SurfaceMesh& found) {
  std::cout << found.mesh.triangles.size() << " triangles, " << found.mesh.points.size()
            << " points; no farther from the surface than " << base::shortText(found.largestDistanceMm, 3)
            << " mm, " << (found.openEdges == 0 ? "closed" : std::to_string(found.openEdges) + " open edges")
            << '\n';
}

void runMesh(const MeshOptions& options, base::Progress& progress) {
  const std::filesystem::path out(options.out);
  if (!volume::isMeshName(out))
    throw base::Error(base::ErrorKind::usage, options.out, "",
                      "the name of a mesh must end in .stl, .ply, .obj or .vtp");
  requireSource(options.path, *options.scene);
  scene::Scene scene = sceneOf(options.path, *options.scene);
  refuseCuts(scene, "isolux mesh");
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, options.out, "--out");
  const auto prepared = loadWithProgressBar(scene.source, progress);
  scene = scene::resolve(std::move(scene), prepared->facts);
  volume::SurfaceMesh found;
  std::vector<volume::PointArray> arrays;
  {
    progress.report(0.0, "making a mesh");
    const ProgressBar bar(progress);
    found = extracted(options, scene, *prepared, progress);
    if (found.mesh.triangles.empty())
      throw base::Error(base::ErrorKind::input, scene.source.path, "isosurface.value",
                        "there is no surface at " + base::shortText(scene.isosurface.value.value()) +
                            ": nothing is written");
    const bool curvature = out.extension() == ".vtp";
    if (curvature || out.extension() == ".ply") {
      prepared->derivativeChoices->complete(scene, progress);
      arrays = volume::surfaceArrays(*prepared, scene, found.mesh.points, curvature, progress);
      if (curvature && !scene.color.volume.empty())
        arrays.push_back(volume::secondValueArray(*prepared, scene, found.mesh.points, progress));
    }
  }
  volume::writeMesh(found.mesh, arrays, out);
  if (options.json)
    std::cout << jsonText(meshJson(options, scene, found));
  else
    printMesh(found);
  if (found.astray > 0)
    printNote(std::to_string(found.astray) +
              " points lie beside the surface: the spline's is thinner there than its samples'");
  printWarnings(prepared->volume);
}

}  // namespace

Command makeMesh(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("mesh", "Write an isosurface as triangles, for printing or simulation");
  auto options = std::make_shared<MeshOptions>();
  parser->add_option(
      "PATH", options->path,
      "A volume file, a DICOM folder, phantom:NAME[:SIZE], a session, or a .png that carries one");
  parser
      ->add_option("--out", options->out,
                   "A new .stl, .ply (with normals), .obj, or .vtp (with normals, kappa1, kappa2, "
                   "confidence, and color_value "
                   "where there is a color.volume)")
      ->required();
  parser
      ->add_option("--tolerance", options->tolerance,
                   "Split triangles until they lie no farther from the surface, mm")
      ->check(CLI::Range(1e-6, 1e6));
  parser->add_flag("--closed", options->closed, "Close the surface where it leaves the volume");
  parser->add_flag("--json", options->json, "Say what was written as one JSON object");
  options->scene = addSceneOptions(*parser);
  addThreadsOption(*parser);
  parser->footer(
      "Points lie on the surface of hit.field, mm, in the volume's world; pieces that `pieces.` hides are "
      "left out. "
      "Examples:\n"
      "  isolux mesh ct.nii.gz --isovalue 300 --out skull.stl --closed --tolerance 0.05\n"
      "  isolux mesh ct.nii.gz --isovalue 300 --out skull.vtp --json");
  return {parser, [options](base::Progress& progress) { runMesh(*options, progress); }};
}

}  // namespace isolux::app
