// isolux measure PATH: area and volume of the isosurface, distances, angles, circles and thicknesses, each
// with its error.
#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>

#include "app/commands/command.h"
#include "app/commands/measure_report.h"
#include "app/commands/progress_bar.h"
#include "app/files/number_rows.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/rules/automatic.h"
#include "volume/measure/geodesic.h"
#include "volume/measure/points.h"
#include "volume/measure/surface_measure.h"
#include "volume/measure/thickness.h"
#include "volume/read/length_doubt.h"

namespace isolux::app {

namespace {

using base::Error;
using base::ErrorKind;
using nlohmann::ordered_json;
using volume::Measured;
using volume::PreparedVolume;
using volume::SurfaceGraph;
using volume::SurfaceOf;
using volume::SurfacePoint;
using volume::UncertainPoint;

struct MeasureOptions {
  std::string path, box;
  std::vector<std::string> distances, angles, circles, thicknesses;
  bool json = false, closed = false, anyway = false;
};

// The volume, the isosurface, and the way-finding graph once somebody asks for it.
struct MeasuredSurface {
  std::string file;
  const PreparedVolume& prepared;
  SurfaceOf surface;
  std::optional<SurfaceGraph> graph = std::nullopt;

  const SurfaceGraph& graphOnce(base::Progress& progress) {
    if (!graph) graph = surfaceGraph(prepared.grid(), *prepared.blocks, surface.isovalue, progress);
    return *graph;
  }
};

std::string pointText(glm::dvec3 p) {
  return base::shortText(p.x) + "," + base::shortText(p.y) + "," + base::shortText(p.z);
}

// A position is one of the surface where that passes within half a voxel's diagonal; then it may be wrong by
// what the surface is.
UncertainPoint uncertain(const SurfaceOf& surface, glm::dvec3 world) {
  const auto near = nearestPoint(surface, world);
  const double reach = 0.5 * glm::length(surface.grid.geometry().spacingMm());
  if (!near || glm::length(near->world - world) > reach) return {world, 0.0};
  return {world, offsetError(*near)};
}

SurfacePoint pointOfSurface(const MeasuredSurface& measured, glm::dvec3 world, const std::string& option) {
  if (auto near = nearestPoint(measured.surface, world)) return *near;
  base::throwInput(measured.file, option,
                   "no isosurface of " + base::shortText(measured.surface.isovalue) +
                       " within three voxels of " + pointText(world));
}

ordered_json distanceJson(MeasuredSurface& measured, const std::string& text, base::Progress& progress) {
  const auto points = parsePoints(text, "--distance", 2, 2);
  const SurfaceOf& surface = measured.surface;
  const Measured straight = straightDistance(uncertain(surface, points[0]), uncertain(surface, points[1]));
  ordered_json json{{"from_mm", vectorOf(points[0])},
                    {"to_mm", vectorOf(points[1])},
                    {"straight_mm", measuredJson(straight)}};
  const auto from = nearestPoint(surface, points[0]), to = nearestPoint(surface, points[1]);
  json["along_surface_mm"] = nullptr;
  if (!from || !to) {
    json["along_surface_reason"] = "no isosurface within three voxels of " + pointText(points[from ? 1 : 0]);
    return json;
  }
  const auto way = geodesic(surface, measured.graphOnce(progress), from->world, to->world, progress);
  if (!way) {
    json["along_surface_reason"] = "no way along the surface leads from one to the other";
    return json;
  }
  json["along_surface_mm"] = measuredJson(way->lengthMm, way->parts);
  json["along_surface_from_mm"] = vectorOf(from->world);
  json["along_surface_to_mm"] = vectorOf(to->world);
  ordered_json& path = json["path_mm"] = ordered_json::array();
  for (const glm::dvec3& point : way->path) path.push_back(vectorOf(point));
  return json;
}

ordered_json angleJson(const MeasuredSurface& measured, const std::string& text) {
  const auto points = parsePoints(text, "--angle", 3, 4);
  std::vector<UncertainPoint> at;
  for (const glm::dvec3& point : points) at.push_back(uncertain(measured.surface, point));
  const auto angle =
      at.size() == 3 ? angleDegrees(at[0], at[1], at[2]) : dihedralDegrees(at[0], at[1], at[2], at[3]);
  if (!angle) throw Error(ErrorKind::usage, "", "--angle", "has points on a line or in one place: " + text);
  return {{"points_mm", vectorsOf(points)}, {"degrees", measuredJson(*angle)}};
}

ordered_json circleJson(const MeasuredSurface& measured, const std::string& text) {
  const auto points = parsePoints(text, "--circle", 3, 3);
  const auto circle =
      circleThrough(uncertain(measured.surface, points[0]), uncertain(measured.surface, points[1]),
                    uncertain(measured.surface, points[2]));
  if (!circle) throw Error(ErrorKind::usage, "", "--circle", "has its points on a line: " + text);
  return {{"points_mm", vectorsOf(points)},
          {"radius_mm", measuredJson(circle->radiusMm)},
          {"centre_mm", vectorOf(circle->centre)},
          {"normal", vectorOf(circle->normal)}};
}

ordered_json thicknessJson(MeasuredSurface& measured, const std::string& text, base::Progress& progress) {
  const glm::dvec3 world = parsePoints(text, "--thickness", 1, 1)[0];
  const SurfacePoint point = pointOfSurface(measured, world, "--thickness");
  ordered_json json{{"point_mm", vectorOf(point.world)}, {"normal", vectorOf(point.normal)}};
  const auto ray = thicknessByRay(measured.surface, *measured.prepared.blocks, point);
  const auto ball = inscribedBall(measured.surface, measured.graphOnce(progress), point);
  json["ray_mm"] = ray ? measuredJson(ray->mm) : ordered_json();
  json["exit_mm"] = ray ? vectorOf(ray->exit) : ordered_json();
  json["ball_mm"] = ball ? measuredJson(ball->diameterMm) : ordered_json();
  json["centre_mm"] = ball ? vectorOf(ball->centre) : ordered_json();
  json["touches_mm"] = ball ? vectorOf(ball->touches) : ordered_json();
  return json;
}

std::optional<volume::WorldBox> boxOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto corners = parsePoints(text, "--box", 2, 2);
  const volume::WorldBox box{glm::min(corners[0], corners[1]), glm::max(corners[0], corners[1])};
  const glm::dvec3 size = box.highMm - box.lowMm;
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0))
    throw Error(ErrorKind::usage, "", "--box", "is empty: " + text);
  return box;
}

std::string openReason(const volume::SurfaceMeasure& surface) {
  if (surface.meetsBorder) return "the inside goes on beyond the volume's border";
  return "the inside goes on where voxels are missing";
}

void refuseWhatIsNoSurface(const MeasureOptions& options, const MeasuredSurface& measured,
                           const volume::SurfaceMeasure& surface) {
  const std::string at = "isovalue " + base::shortText(measured.surface.isovalue);
  if (surface.cells == 0 && options.box.empty())
    base::throwInput(measured.file, at,
                     "there is no surface; values reach from " +
                         base::shortText(measured.prepared.grid().minimum()) + " to " +
                         base::shortText(measured.prepared.grid().maximum()));
  if (options.closed && surface.open())
    base::throwInput(measured.file, at, "the surface is open: " + openReason(surface));
}

ordered_json surfaceJson(const volume::SurfaceMeasure& surface) {
  ordered_json json;
  json["area_mm2"] = measuredJson(surface.areaMm2, surface.areaParts);
  json["volume_mm3"] = measuredJson(surface.volumeMm3, surface.volumeParts);
  json["volume_per_value_mm3"] = surface.volumePerValue;
  json["cells"] = surface.cells;
  json["open"] = surface.open();
  if (surface.open()) json["open_reason"] = openReason(surface);
  return json;
}

scene::NoiseModel noiseOf(const PreparedVolume& prepared, const scene::Scene& scene,
                          base::Progress& progress) {
  scene::NoiseModel noise = prepared.derivativeChoices->noise(progress);
  if (scene.derivatives.noise) {
    noise.values = {0.0};
    noise.deviations = {*scene.derivatives.noise};
  }
  return noise;
}

// The isosurface of the scene as a whole or in the box, then what was asked about points.
ordered_json measure(const MeasureOptions& options, const scene::Scene& scene, const PreparedVolume& prepared,
                     base::Progress& progress) {
  const double isovalue = scene.isosurface.value.value_or(prepared.facts.suggestedIsovalue);
  const auto doubt = volume::lengthDoubt(prepared.volume.warnings);
  if (doubt && !options.anyway)
    base::throwInput(scene.source.path, "",
                     "lengths are doubtful: " + *doubt + "; --anyway measures all the same");
  MeasuredSurface measured{
      scene.source.path,
      prepared,
      {prepared.grid(), isovalue, scene.isosurface.inside, noiseOf(prepared, scene, progress)}};
  const volume::SurfaceMeasure surface = measureSurface(
      prepared.grid(), *prepared.blocks,
      {isovalue, scene.isosurface.inside, boxOf(options.box), measured.surface.noise, {}}, progress);
  refuseWhatIsNoSurface(options, measured, surface);
  ordered_json json{{"isovalue", isovalue},
                    {"unit", prepared.volume.unit},
                    {"inside", scene.isosurface.inside == scene::Inside::above ? "above" : "below"},
                    {"noise", measured.surface.noise.at(isovalue)}};
  if (doubt) json["doubt"] = *doubt;
  json.update(surfaceJson(surface));
  for (const std::string& text : options.distances)
    json["distances"].push_back(distanceJson(measured, text, progress));
  for (const std::string& text : options.angles) json["angles"].push_back(angleJson(measured, text));
  for (const std::string& text : options.circles) json["circles"].push_back(circleJson(measured, text));
  for (const std::string& text : options.thicknesses)
    json["thicknesses"].push_back(thicknessJson(measured, text, progress));
  return json;
}

void checkPoints(const MeasureOptions& options) {  // before the volume is read
  for (const std::string& text : options.distances) parsePoints(text, "--distance", 2, 2);
  for (const std::string& text : options.angles) parsePoints(text, "--angle", 3, 4);
  for (const std::string& text : options.circles) parsePoints(text, "--circle", 3, 3);
  for (const std::string& text : options.thicknesses) parsePoints(text, "--thickness", 1, 1);
  boxOf(options.box);
}

void addMeasureOptions(CLI::App& parser, MeasureOptions& options) {
  parser.add_option("PATH", options.path, "A volume file, a DICOM folder, phantom:NAME[:SIZE], or a session");
  parser.add_flag("--json", options.json, "Print one JSON object instead of text (docs/commands.md)");
  parser.add_option("--box", options.box, "Only within this box of the world, two corners in mm")
      ->type_name("\"x,y,z x,y,z\"");
  const auto points = [&parser](const char* name, std::vector<std::string>& into, const char* type,
                                const char* help) {
    parser.add_option(name, into, help)->type_name(type)->expected(1)->take_all();
  };
  points("--distance", options.distances, "\"P Q\"",
         "Between two points, straight and along the surface; may be repeated");
  points("--angle", options.angles, "\"A B C [D]\"",
         "At B, or between the planes ABC and BCD; may be repeated");
  points("--circle", options.circles, "\"A B C\"", "Through three points; may be repeated");
  points(
      "--thickness", options.thicknesses, "P",
      "At a point of the surface: along the inward normal, and of the largest ball inside; may be repeated");
  parser.add_flag("--closed", options.closed,
                  "Refuse an open surface instead of measuring what the data hold");
  parser.add_flag("--anyway", options.anyway,
                  "Measure where spacing was assumed or slices were resampled, too");
}

}  // namespace

Command makeMeasure(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "measure", "Measure the isosurface: area, volume, distances, angles, thickness, with errors");
  auto options = std::make_shared<MeasureOptions>();
  addMeasureOptions(*parser, *options);
  const auto sceneOptions = addSceneOptions(*parser);
  addThreadsOption(*parser);
  parser->footer(
      "Points are x,y,z in world mm.\n\nExample:\n  isolux measure head.nii.gz --isovalue 300 --distance "
      "\"0,-90,20 0,90,20\"");
  return {parser, [options, sceneOptions](base::Progress& progress) {
            requireSource(options->path, *sceneOptions);
            checkPoints(*options);
            const scene::Scene scene = sceneOf(options->path, *sceneOptions);
            const auto prepared = loadWithProgressBar(scene.source, progress);
            ordered_json json;
            {
              const ProgressBar bar(progress);
              json = measure(*options, scene::resolve(scene, prepared->facts), *prepared, progress);
            }
            if (options->json)
              std::cout << jsonText(json);
            else
              printMeasures(json, std::cout);
            if (json["open"].get<bool>())
              printNote("the surface is open: " + json["open_reason"].get<std::string>());
            printWarnings(prepared->volume);
          }};
}

}  // namespace isolux::app
