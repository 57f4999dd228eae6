// isolux info PATH: what a volume is, as text or JSON.
#include <algorithm>
#include <iostream>

#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/commands/series_report.h"
#include "app/ready/ready_fields.h"
#include "app/report/derivative_report.h"
#include "app/report/label_report.h"
#include "app/report/piece_report.h"
#include "app/runtime/progress_bar.h"
#include "base/number_text.h"
#include "base/words.h"
#include "scene/rules/automatic.h"
#include "scene/rules/needs.h"
#include "scene/settings/choice_names.h"
#include "volume/edge/surface_edges.h"
#include "volume/labels/shown_labels.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;
using volume::PreparedVolume;

struct InfoOptions {
  std::string path;
  bool json = false, pieces = false, edge = false, series = false, anonymous = false;
  std::shared_ptr<SceneOptions> scene;
};

std::size_t activeBlocksAt(const PreparedVolume& prepared, double isovalue) {
  std::vector<std::uint8_t> flags;
  return prepared.blocks->activeBlocks(prepared.grid().storedIsovalue(isovalue), flags);
}

struct InfoMeasures {
  scene::NoiseModel noise;
  volume::DerivativeChoice choice;
};

ordered_json infoJson(const PreparedVolume& prepared, const InfoMeasures& measured) {
  const volume::Volume& v = prepared.volume;
  const volume::Grid& grid = prepared.grid();
  const volume::GridGeometry& geometry = grid.geometry();
  const double isovalue = prepared.facts.suggestedIsovalue;
  ordered_json directions = ordered_json::array();
  for (int axis = 0; axis < 3; ++axis) directions.push_back(geometry.directions()[axis]);

  ordered_json json;
  json["name"] = v.name;
  json["format"] = v.format;
  json["dims"] = grid.dims();
  json["type"] = volume::nameOf(v.fileType);
  json["stored_type"] = volume::nameOf(grid.storedType());
  json["spacing_mm"] = geometry.spacingMm();
  json["origin_mm"] = geometry.originMm();
  json["directions"] = directions;                                      // one unit vector per voxel axis
  json["orientation_stated"] = v.axes == scene::WorldAxes::anatomical;  // then the world is LPS
  json["unit"] = v.unit;
  json["kind"] = scene::choiceName(prepared.kind.kind);
  json["kind_reason"] = prepared.kind.reason;
  json["slope"] = grid.slope();
  json["intercept"] = grid.intercept();
  json["range"] = {grid.minimum(), grid.maximum()};
  json["missing"] = grid.missingCount();
  json["labels"] = v.labels;
  json["suggested_isovalue"] = isovalue;
  json["contrast_isovalue"] = prepared.facts.contrastIsovalue;
  const scene::NoiseModel& noise = measured.noise;
  json["noise"] = {{"values", noise.values},
                   {"deviations", noise.deviations},
                   {"at_suggested", noise.at(isovalue)},
                   {"blur_voxels", noise.correlation}};
  json["derivatives_at_suggested"] = choiceJson(measured.choice);
  json["histogram"] = {{"minimum", prepared.histogram.minimum},
                       {"maximum", prepared.histogram.maximum},
                       {"counts", prepared.histogram.counts},
                       {"peaks", prepared.histogram.peaks}};
  json["blocks"] = {{"cells", prepared.blocks->blockCells()},
                    {"dims", prepared.blocks->dims()},
                    {"total", prepared.blocks->count()},
                    {"active_at_suggested", activeBlocksAt(prepared, isovalue)}};
  json["components"] = v.components;
  json["time_steps"] = v.timeSteps;
  json["series"] = v.seriesChoices;
  json["data_hash"] = base::hexText(grid.hash());
  json["warnings"] = v.warnings;
  return json;
}

std::string vectorText(glm::dvec3 v, const char* between = ", ") {
  return base::shortText(v.x) + between + base::shortText(v.y) + between + base::shortText(v.z);
}

std::string noiseText(const scene::NoiseModel& noise, double isovalue, const std::string& unit) {
  std::string text = base::shortText(noise.at(isovalue), 3) + unit + " at the suggested isovalue";
  if (noise.values.size() > 1) {
    const auto [least, most] = std::minmax_element(noise.deviations.begin(), noise.deviations.end());
    text += ", " + base::shortText(*least, 3) + " to " + base::shortText(*most, 3) + " over the values";
  }
  if (noise.correlation != glm::dvec3(0.0))
    text += ", blurred by " + vectorText(noise.correlation, " x ") + " voxels";
  return text;
}

std::string scaleText(double scaleMm, const std::string& reason) {
  return base::shortText(scaleMm, 3) + " mm" + (reason.empty() ? "" : " (" + reason + ")");
}

std::string peaksText(const volume::Histogram& histogram) {
  if (histogram.peaks.empty()) return "none";
  return base::joined(histogram.peaks, ", ", [](double peak) { return base::shortText(peak); });
}

std::string typeText(const volume::Volume& v) {
  std::string text(volume::nameOf(v.fileType));
  const auto stored = volume::nameOf(v.grid->storedType());
  if (stored != text) text += ", kept as " + std::string(stored);
  return text;
}

// "x to L, y to P, z to S", by the nearest axes.
std::string orientationText(const volume::Volume& v) {
  if (v.axes != scene::WorldAxes::anatomical) return "not stated";
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
    text += (axis ? ", " : "") + std::string(1, "xyz"[axis]) + " to " +
            axisEnd(v.axes, v.grid->geometry().directions()[axis]);
  return text;
}

// How often the values occur, on a log scale: one line of 60 columns.
std::string histogramBar(const volume::Histogram& histogram) {
  constexpr std::size_t columns = 60;
  constexpr const char* levels[] = {" ", "▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
  const std::size_t bins = histogram.counts.size();
  if (bins == 0) return {};
  const std::size_t width = std::min(columns, bins);
  std::vector<double> heights(width, 0.0);
  for (std::size_t bin = 0; bin < bins; ++bin)
    heights[bin * width / bins] += static_cast<double>(histogram.counts[bin]);
  for (double& height : heights) height = std::log1p(height);
  const double highest = std::max(*std::ranges::max_element(heights), 1e-9);
  std::string bar;
  for (const double height : heights)
    bar += levels[static_cast<std::size_t>(std::ceil(height / highest * 8.0))];
  return bar;
}

std::string suggestionText(const PreparedVolume& prepared, const std::string& unit) {
  const auto [first, clearest] = std::pair(prepared.facts.suggestedIsovalue, prepared.facts.contrastIsovalue);
  const std::string text = base::shortText(first) + unit + " (suggested";
  if (first == clearest) return text + ")";
  return text + ": the border of the whole object; the clearest border within it is at " +
         base::shortText(clearest) + unit + ")";
}

void printText(const PreparedVolume& prepared, const InfoMeasures& measured, std::ostream& out) {
  const volume::Volume& v = prepared.volume;
  const volume::Grid& grid = prepared.grid();
  const volume::GridGeometry& geometry = grid.geometry();
  const glm::ivec3 dims = grid.dims();
  const double isovalue = prepared.facts.suggestedIsovalue;
  const std::string unit = v.unit.empty() ? "" : " " + v.unit;
  const auto row = [&out](std::string_view name, const std::string& text) { printRow(out, name, text); };
  row("name", v.name);
  row("format", v.format);
  row("dims", std::to_string(dims.x) + " x " + std::to_string(dims.y) + " x " + std::to_string(dims.z));
  row("type", typeText(v));
  row("spacing", vectorText(geometry.spacingMm(), " x ") + " mm");
  const bool anatomical = v.axes == scene::WorldAxes::anatomical;
  row("origin", vectorText(geometry.originMm()) + (anatomical ? " mm (LPS)" : " mm"));
  for (int axis = 0; axis < 3; ++axis) {
    const std::string name = std::string("direction ") + "xyz"[axis];
    row(name, vectorText(geometry.directions()[axis]));
  }
  if (geometry.leftHanded()) row("", "left-handed");
  row("orientation", orientationText(v));
  row("kind", std::string(scene::choiceName(prepared.kind.kind)) + " (" + prepared.kind.reason + ")");
  row("range", base::shortText(grid.minimum()) + " to " + base::shortText(grid.maximum()) + unit);
  if (grid.slope() != 1.0 || grid.intercept() != 0.0)
    row("rescale",
        "value = " + base::shortText(grid.slope()) + " * stored + " + base::shortText(grid.intercept()));
  row("missing", std::to_string(grid.missingCount()) + " voxels");
  row("histogram", histogramBar(prepared.histogram));
  row("peaks", peaksText(prepared.histogram));
  row("isovalue", suggestionText(prepared, unit));
  row("noise", noiseText(measured.noise, isovalue, unit));
  row("curvature at", scaleText(measured.choice.scaleMm, measured.choice.scaleReason));
  row("normals at", scaleText(measured.choice.normalScaleMm, measured.choice.normalReason));
  row("blocks", std::to_string(activeBlocksAt(prepared, isovalue)) + " of " +
                    std::to_string(prepared.blocks->count()) + " active there, " +
                    std::to_string(prepared.blocks->blockCells()) + " cells per axis each");
  if (v.components > 1) row("components", std::to_string(v.components));
  if (v.timeSteps > 1) row("time steps", std::to_string(v.timeSteps));
  for (std::string series : v.seriesChoices) {
    std::ranges::replace(series, '\t', ' ');
    row("series", series);
  }
  row("memory", base::memoryText(grid.bytes()));
  row("hash", base::hexText(grid.hash()));
  for (const std::string& warning : v.warnings) row("warning", warning);
}

// How far the isosurface lies from the edge of its object.
struct EdgeReport {
  scene::Scene scene;     // complete
  double searchMm = 0.0;  // each way
  volume::EdgeStatistics edges;
};

std::string millimetres(double mm) {
  return base::shortText(mm, 2) + " mm";
}

// Of the scene's first isosurface, at points that can be seen from somewhere.
EdgeReport measureEdges(scene::Scene scene, const std::shared_ptr<const volume::PreparedVolume>& volume,
                        base::Progress& progress) {
  EdgeReport report{scene::resolve(std::move(scene), volume->facts), 0.0, {}};
  completeFields(report.scene, *volume, true, progress);
  const volume::SurfaceEdges edges(volume, report.scene, progress);
  report.searchMm = report.scene.edge.search.value_or(
      volume::automaticEdgeSearch(volume->grid().geometry(), scene::derivativesScale(report.scene)));
  report.edges = volume::edgeStatistics(
      edges.finder(),
      volume::visiblePoints(volume->grid(), *volume->blocks, *report.scene.surfaces.front().value));
  return report;
}

ordered_json edgeJson(const EdgeReport& report) {
  const volume::EdgeStatistics& edges = report.edges;
  ordered_json json;
  json["isovalue"] = *report.scene.surfaces.front().value;
  json["scale_mm"] = scene::derivativesScale(report.scene);
  json["search_mm"] = report.searchMm;
  json["contrast"] = report.scene.edge.contrast;
  json["points"] = edges.points;
  json["without_edge"] = edges.without;
  json["half_within_mm"] = edges.within50;
  json["90_percent_within_mm"] = edges.within90;
  json["offset_mm"] = {{"5_percent", edges.low}, {"median", edges.median}, {"95_percent", edges.high}};
  json["median_strength"] = edges.strength;
  return json;
}

// "half of this surface lies within 0.1 mm of an edge, 90 % within 0.4 mm, 3 % have none within 3 mm"
std::string edgeText(const EdgeReport& report) {
  const volume::EdgeStatistics& edges = report.edges;
  const std::string surface = "the surface of " + base::shortText(*report.scene.surfaces.front().value);
  if (edges.points == 0) return surface + " is empty";
  std::string text;
  if (edges.within50)
    text += "half of " + surface + " is within " + millimetres(*edges.within50) + " of an edge, ";
  if (edges.within90) text += "90 % within " + millimetres(*edges.within90) + ", ";
  const double without = 100.0 * static_cast<double>(edges.without) / static_cast<double>(edges.points);
  text += base::shortText(without, 2) + " % " + (edges.within50 ? "" : "of " + surface + " ") +
          "have none within " + millimetres(report.searchMm);
  if (edges.median)
    text += "; the edge is " + millimetres(std::abs(*edges.median)) +
            (*edges.median < 0.0 ? " inside" : " outside") + " (median), from " +
            base::shortText(*edges.low, 2) + " to " + millimetres(*edges.high) + " (5 % to 95 %)";
  return text;
}

void runInfo(const InfoOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  const scene::Scene scene = sceneOf(options.path, *options.scene);
  if (options.series)
    return printSeries(scene.source.path, options.json, options.anonymous, progress, std::cout);
  const auto prepared = loadWithProgressBar(volume::withLabelsAsValues(scene.source), progress);
  InfoMeasures measured;
  ordered_json pieces, labels;
  std::optional<EdgeReport> edges;
  {
    const ProgressBar bar(progress);
    progress.report(0.0, "measuring noise");
    const volume::DerivativeChoices& choices = *prepared->derivativeChoices;
    measured = {choices.noise(progress),
                choices.choose({prepared->facts.suggestedIsovalue, scene.derivatives.field}, progress)};
    labels = labelTableJson(*prepared, progress);
    if (options.pieces) {
      progress.report(0.0, "finding pieces");
      pieces = piecesJson(*prepared, scene::resolve(scene, prepared->facts), progress);
    }
    if (options.edge) {
      progress.report(0.0, "looking for edges");
      edges = measureEdges(scene, prepared, progress);
    }
  }
  if (options.json) {
    ordered_json json = infoJson(*prepared, measured);
    json["label_table"] = labels;
    if (options.pieces) json["pieces"] = pieces;
    if (edges) json["edge"] = edgeJson(*edges);
    std::cout << jsonText(json);
    return;
  }
  printText(*prepared, measured, std::cout);
  if (!labels.is_null()) printLabelTable(labels, std::cout);
  if (edges) printRow(std::cout, "edge", edgeText(*edges));
  if (options.pieces) printPieceTable(pieces, *prepared, std::cout);
}

}  // namespace

Command makeInfo(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("info", "Print a volume's size, spacing, orientation and values");
  auto options = std::make_shared<InfoOptions>();
  addPath(*parser, options->path);
  parser->add_flag("--json", options->json,
                   "Print one JSON object instead of text (docs/reference/outputs.md)");
  parser->add_flag(
      "--pieces", options->pieces,
      "List the connected components (pieces) inside the isosurface, largest first: volume, area, bounds");
  parser->add_flag(
      "--edge", options->edge,
      "Print the distance from the isosurface to the edge of the object, and the strength of that edge");
  parser->add_flag("--series", options->series,
                   "List the DICOM series of a folder or disc, by patient and study, without reading voxels");
  parser->add_flag("--anonymous", options->anonymous, "With --series: omit the patients' names");
  options->scene = addSceneOptions(*parser);
  addThreadsOption(*parser);
  parser->footer("Example:\n  isolux info head.nii.gz --json");
  return {parser, [options](base::Progress& progress) { runInfo(*options, progress); }};
}

}  // namespace isolux::app
