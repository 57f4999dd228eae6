// isolux probe PATH: what a volume says at points, and where rays first hit its isosurface.
#include <algorithm>
#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/files/csv_field.h"
#include "app/files/number_rows.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/rules/automatic.h"
#include "volume/clip/surface_cut.h"
#include "volume/edge/surface_edges.h"
#include "volume/hit/exact_hit.h"
#include "volume/labels/label_table.h"
#include "volume/labels/shown_labels.h"
#include "volume/measure/point_probe.h"
#include "volume/measure/surface_point.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

struct ProbeOptions {
  std::string path, points, rays;
  bool json = false;
  std::shared_ptr<SceneOptions> scene;
};

struct Probes {
  const volume::PointProbe& points;
  const volume::EdgeFinder& edges;
  const volume::ShownLabels* labels;  // null: the volume is no label map
};

// Of a label map. `isHit`: the label that the surface shows there, else that of the nearest voxel.
void addLabel(ordered_json& json, const volume::ShownLabels& labels, const volume::ProbedPoint& point,
              bool isHit) {
  const int label = volume::labelOfFace(labels, point.voxel, isHit ? 0.0 : -1.0);
  json["label"] = label;
  json["label_name"] = volume::labelName(labels.table.get(), label);
}

// What is unknown is null.
void addPoint(ordered_json& json, const Probes& probes, glm::dvec3 world,
              const std::optional<volume::ProbedPoint>& point, bool isHit = false) {
  json["position_mm"] = world;
  for (const char* key : {"voxel", "value", "gradient", "normal", "kappa", "flowline_curvature", "confidence",
                          "scale_mm", "edge_offset_mm", "edge_strength"})
    json[key] = nullptr;
  if (probes.labels)
    for (const char* key : {"label", "label_name"}) json[key] = nullptr;
  if (!point) return;
  if (probes.labels) addLabel(json, *probes.labels, *point, isHit);
  json["voxel"] = point->voxel;
  json["value"] = point->value;
  json["gradient"] = point->gradient;
  json["confidence"] = point->confidence;
  json["scale_mm"] = point->scaleMm;
  if (point->curvature.normal == glm::dvec3(0.0)) return;
  json["normal"] = point->curvature.normal;
  json["kappa"] = {point->curvature.kappa1, point->curvature.kappa2};
  json["flowline_curvature"] = point->curvature.flowline;
  const volume::Edge edge = probes.edges.at(point->voxel);
  json["edge_offset_mm"] = edge.offsetMm;
  json["edge_strength"] = edge.strength;
}

// The first hit with what `cut` leaves of the trilinear isosurface, and how far along the ray it may be
// wrong.
ordered_json hitJson(const volume::PreparedVolume& prepared, const volume::SurfaceOf& surface,
                     const Probes& probes, const volume::SurfaceCut& cut, glm::dvec3 origin,
                     glm::dvec3 direction) {
  const glm::dmat4 voxelFromWorld = prepared.grid().geometry().voxelFromWorld();
  const glm::dvec3 from(voxelFromWorld * glm::dvec4(origin, 1.0)),
      along(voxelFromWorld * glm::dvec4(direction, 0.0));
  std::optional<volume::RayHit> hit;
  for (const auto& [begin, end] : cut.segmentsOf(surface.isovalue, {from, along})) {
    hit = volume::firstHit(prepared.grid(), *prepared.blocks, surface.isovalue, {from, along, begin, end});
    if (hit) break;
  }
  if (!hit) return nullptr;
  const glm::dvec3 world = origin + direction * hit->t;
  ordered_json json;
  addPoint(json, probes, world, probes.points.at(world), true);
  json["t_mm"] = hit->t;
  json["entering"] = hit->entering == (surface.inside == scene::Inside::above);
  const auto point = volume::surfacePoint(surface, world);
  const double cosine = point ? std::abs(glm::dot(point->normal, direction)) : 0.0;
  json["t_error_mm"] =
      point && cosine > 0.0 ? ordered_json(volume::offsetError(*point) / cosine) : ordered_json();
  json["offset_error_mm"] = point ? ordered_json(volume::offsetError(*point)) : ordered_json();
  return json;
}

// Numbers and names of an object that is flat but for short arrays, in columns.
void addColumns(const ordered_json& json, std::string& names, std::string& values) {
  for (const auto& [key, value] : json.items()) {
    if (value.is_object()) {
      addColumns(value, names, values);
      continue;
    }
    const std::size_t width = value.is_array()                                         ? value.size()
                              : key == "kappa"                                         ? 2
                              : key == "voxel" || key == "gradient" || key == "normal" ? 3
                                                                                       : 1;
    for (std::size_t i = 0; i < width; ++i) {
      names += (names.empty() ? "" : ",") + key + (width > 1 ? "_" + std::to_string(i + 1) : "");
      const ordered_json& one = value.is_array() ? value[i] : value;
      values += (values.empty() ? "" : ",");
      if (one.is_number()) values += base::shortestText(one.get<double>());
      if (one.is_boolean()) values += one.get<bool>() ? "1" : "0";
      if (one.is_string()) values += csvWords(one.get<std::string>());
    }
  }
}

// What is printed: objects for JSON, else lines of a table, which take a fifth of their memory.
class Rows {
 public:
  explicit Rows(bool asJson) : asJson_(asJson) {}
  void add(ordered_json row) {
    if (asJson_) return objects_.push_back(std::move(row));
    std::string names, values;
    addColumns(row, names, values);
    lines_.emplace_back(std::move(values), std::ranges::count(names, ','));
    if (names.size() > header_.size()) header_ = names;
  }
  const ordered_json& objects() const { return objects_; }
  // Rows without a hit have fewer columns than the others.
  void printTable() const {
    if (lines_.empty()) return;
    const auto columns = std::ranges::count(header_, ',');
    std::cout << header_ << '\n';
    for (const auto& [line, separators] : lines_)
      std::cout << line << std::string(static_cast<std::size_t>(columns - separators), ',') << '\n';
  }

 private:
  bool asJson_;
  ordered_json objects_ = ordered_json::array();
  std::string header_;
  std::vector<std::pair<std::string, std::ptrdiff_t>> lines_;  // and how many separators each has
};

struct Probed {
  Rows points, rays;
};

Probed probed(const ProbeOptions& options, const scene::Scene& scene,
              const std::shared_ptr<const volume::PreparedVolume>& prepared, base::Progress& progress) {
  const auto points = options.points.empty() ? std::vector<NumberRow>{} : readNumberRows(options.points, 3);
  const auto rays = options.rays.empty() ? std::vector<NumberRow>{} : readNumberRows(options.rays, 6);
  const volume::PointProbe probe(prepared, scene, progress);
  const volume::SurfaceEdges edges(prepared, scene, progress);
  const Probes probes{probe, edges.finder(), prepared->labels.get()};
  Probed result{Rows(options.json), Rows(options.json)};
  std::size_t outside = 0, missed = 0, firstOutside = 0, firstMissed = 0;
  for (const NumberRow& row : points) {
    const glm::dvec3 world(row.numbers[0], row.numbers[1], row.numbers[2]);
    const auto point = probe.at(world);
    if (!point && outside++ == 0) firstOutside = row.line;
    ordered_json probed = ordered_json::object();
    addPoint(probed, probes, world, point);
    result.points.add(std::move(probed));
  }
  const double isovalue = scene.surfaces.front().value.value_or(0.0);
  const volume::SurfaceOf surface{prepared->grid(),
                                  isovalue,
                                  scene.isosurface.inside,
                                  {{isovalue}, {scene.derivatives.noise.value_or(0.0)}, glm::dvec3(0.0)}};
  const volume::SurfaceCut cut =
      rays.empty() ? volume::SurfaceCut() : volume::SurfaceCut(scene, prepared->grid().geometry());
  for (const NumberRow& row : rays) {
    const glm::dvec3 origin(row.numbers[0], row.numbers[1], row.numbers[2]);
    const glm::dvec3 direction(row.numbers[3], row.numbers[4], row.numbers[5]);
    if (!(glm::length(direction) > 0.0))
      base::throwInput(options.rays, "line " + std::to_string(row.line), "a ray needs a direction");
    ordered_json hit = hitJson(*prepared, surface, probes, cut, origin, glm::normalize(direction));
    if (hit.is_null() && missed++ == 0) firstMissed = row.line;
    result.rays.add({{"origin_mm", origin}, {"direction", direction}, {"hit", hit}});
  }
  if (outside > 0)
    printNote(std::to_string(outside) + " of " + std::to_string(points.size()) +
              " points are outside the volume or next to missing voxels, the first in line " +
              std::to_string(firstOutside));
  if (missed > 0)
    printNote(std::to_string(missed) + " of " + std::to_string(rays.size()) +
              " rays hit nothing, the first in line " + std::to_string(firstMissed));
  return result;
}

void runProbe(const ProbeOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  if (options.points.empty() && options.rays.empty())
    base::throwUsage("", "--points", "or --rays is required");
  scene::Scene scene = sceneOf(options.path, *options.scene);
  const auto prepared = loadWithProgressBar(scene.source, progress);
  scene = scene::resolve(scene, prepared->facts);
  prepared->derivativeChoices->complete(scene, progress);
  const Probed result = probed(options, scene, prepared, progress);
  const ordered_json &points = result.points.objects(), &rays = result.rays.objects();
  if (!options.json) {
    result.points.printTable();
    result.rays.printTable();
  } else if (!options.points.empty() && !options.rays.empty()) {
    std::cout << jsonText({{"points", points}, {"rays", rays}});
  } else {
    std::cout << jsonText(options.rays.empty() ? points : rays);
  }
  printWarnings(prepared->volume);
}

}  // namespace

Command makeProbe(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "probe", "Sample a volume at points of the world, and find where rays hit its isosurface");
  auto options = std::make_shared<ProbeOptions>();
  addPath(*parser, options->path);
  addOption(*parser, "--points", options->points, "FILE.csv", "Rows of x,y,z: positions in world mm");
  addOption(*parser, "--rays", options->rays, "FILE.csv",
            "Rows of x,y,z,dx,dy,dz: origin in world mm and direction; gives the first hit");
  parser->add_flag("--json", options->json, "Print JSON instead of a table (docs/reference/outputs.md)");
  options->scene = addSceneOptions(*parser);
  addThreadsOption(*parser);
  parser->footer("Example:\n  isolux probe head.nii.gz --points points.csv --json");
  return {parser, [options](base::Progress& progress) { runProbe(*options, progress); }};
}

}  // namespace isolux::app
