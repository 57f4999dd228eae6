// isolux measure PATH: area and volume of the isosurface, distances, angles, circles and thicknesses, each
// with its error; or the labels of a label map.
#include <filesystem>
#include <iostream>
#include <optional>
#include <sstream>
#include <utility>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/files/number_rows.h"
#include "app/marks/mark_evaluator.h"
#include "app/marks/markups_file.h"
#include "app/report/curvature_report.h"
#include "app/report/label_measures.h"
#include "app/report/measure_points.h"
#include "app/report/measure_report.h"
#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/printable.h"
#include "scene/rules/automatic.h"
#include "volume/labels/mask_field.h"
#include "volume/labels/shown_labels.h"
#include "volume/measure/surface_measure.h"
#include "volume/measure/voxel_noise.h"
#include "volume/pieces/shown_pieces.h"
#include "volume/read/input/spacing_reliability.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;
using volume::PreparedVolume;

struct MeasureOptions {
  std::string path, box, marks, out;
  std::vector<std::string> distances, angles, circles, thicknesses;
  bool json = false, closed = false, anyway = false;
  bool curvature = false;
  bool labels = false;
  double smoothing = 1.0;        // voxels
  std::string histograms, plot;  // files of its distribution; either asks for it, too
  std::optional<std::size_t> piece;
  std::shared_ptr<SceneOptions> scene;

  bool wantsCurvature() const { return curvature || !histograms.empty() || !plot.empty(); }
};

std::optional<volume::WorldBox> boxOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto corners = parsePoints(text, "--box", 2, 2);
  const volume::WorldBox box{glm::min(corners[0], corners[1]), glm::max(corners[0], corners[1])};
  const glm::dvec3 size = box.highMm - box.lowMm;
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0)) base::throwUsage("", "--box", "is empty: " + text);
  return box;
}

void refuseWhatIsNoSurface(const MeasureOptions& options, const MeasuredSurface& measured,
                           const volume::SurfaceMeasure& surface) {
  const std::string at = "isovalue " + base::shortText(measured.surface.isovalue);
  if (surface.cells == 0 && options.box.empty())
    base::throwInput(measured.file, at, volume::whyNoSurface(measured.prepared.grid()));
  if (options.closed && surface.open())
    base::throwInput(measured.file, at, "the surface is open: " + openReason(surface));
}

// What of the surface counts, its curvature, and the files that were asked for of it.
ordered_json curvatureOf(const MeasureOptions& options, scene::Scene scene, const PreparedVolume& prepared,
                         base::Progress& progress) {
  prepared.derivativeChoices->complete(scene, progress);
  const auto pieces =
      prepared.pieces->at(scene.surfaces.front().value.value(), scene.isosurface.inside, progress);
  volume::CurvaturePart part{{}, boxOf(options.box)};
  std::string title = prepared.volume.name + " at " + base::shortText(scene.surfaces.front().value.value()) +
                      (prepared.volume.unit.empty() ? "" : " " + prepared.volume.unit);
  if (options.piece) {
    const std::size_t id = *options.piece, count = pieces->list().size();
    if (id >= count)
      base::throwUsage("", "--piece",
                       "unknown piece " + std::to_string(id) + ": the surface has " + std::to_string(count));
    part.shown.assign(count, false);
    part.shown[id] = true;
    title += ", piece " + std::to_string(id);
  } else if (volume::hidesPieces(scene.pieces)) {
    part.shown = prepared.pieces->shown(*pieces, scene.pieces, progress);
  }
  const volume::CurvatureDistribution curvature =
      curvatureDistribution(prepared, scene, *pieces, part, progress);
  if (!options.histograms.empty()) writeTextFile(options.histograms, curvatureTable(curvature));
  if (!options.plot.empty())
    plotCurvature(curvature,
                  "Curvature of " + title + ", scale " + base::shortText(curvature.scaleMm, 3) + " mm",
                  options.plot, progress);
  return curvatureJson(curvature);
}

// The isosurface of the scene as a whole or in the box, then what was asked about points.
ordered_json measure(const MeasureOptions& options, const scene::Scene& scene, const PreparedVolume& prepared,
                     base::Progress& progress) {
  const double isovalue = scene.surfaces.front().value.value_or(prepared.facts.suggestedIsovalue);
  const auto doubt = volume::spacingDoubt(prepared.volume.warnings);
  if (doubt && !options.anyway)
    base::throwInput(scene.source.path, "",
                     "lengths are doubtful: " + *doubt + "; --anyway measures all the same");
  const volume::SurfaceQuestion question{isovalue,
                                         scene.isosurface.inside,
                                         boxOf(options.box),
                                         volume::voxelNoise(prepared, scene, progress),
                                         {}};
  MeasuredSurface measured{
      scene.source.path, prepared, {prepared.grid(), isovalue, question.inside, question.noise}};
  const SizedSurface sized = sizedSurface(prepared, scene, question, progress);
  refuseWhatIsNoSurface(options, measured, sized.whole);
  ordered_json json = surfaceJson(prepared, question, sized, doubt);
  if (options.wantsCurvature()) json["curvature"] = curvatureOf(options, scene, prepared, progress);
  for (const std::string& text : options.distances)
    json["distances"].push_back(distanceJson(measured, text, progress));
  for (const std::string& text : options.angles) json["angles"].push_back(angleJson(measured, text));
  for (const std::string& text : options.circles) json["circles"].push_back(circleJson(measured, text));
  for (const std::string& text : options.thicknesses)
    json["thicknesses"].push_back(thicknessJson(measured, text, progress));
  return json;
}

// Those of the Markups file, or, where its name is empty, of the scene (a session has them).
ReadMarks marksToMeasure(const std::string& file, const scene::Scene& scene) {
  if (file.empty()) return {scene.marks, {}};
  ReadMarks read = readMarkups(file);
  for (std::string& note : read.notes) note.insert(0, file + ": ");
  return read;
}

void printMarks(const std::vector<scene::Mark>& marks, const std::vector<MarkReport>& reports) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    std::istringstream lines(fullText(marks[i], reports[i]));
    for (std::string line; std::getline(lines, line);) std::cout << base::printable(line) << '\n';
  }
}

void checkPoints(const MeasureOptions& options) {  // before the volume is read
  for (const std::string& text : options.distances) parsePoints(text, "--distance", 2, 2);
  for (const std::string& text : options.angles) parsePoints(text, "--angle", 3, 4);
  for (const std::string& text : options.circles) parsePoints(text, "--circle", 3, 3);
  for (const std::string& text : options.thicknesses) parsePoints(text, "--thickness", 1, 1);
  boxOf(options.box);
}

void checkCurvatureFiles(const MeasureOptions& options, const scene::Scene& scene) {
  const auto mustEnd = [](const std::string& file, const char* option, const char* ending) {
    if (!file.empty() && std::filesystem::path(file).extension() != ending)
      base::throwUsage(file, option, std::string("the name must end in ") + ending);
  };
  mustEnd(options.histograms, "--histograms", ".csv");
  mustEnd(options.plot, "--plot", ".svg");
  if (options.piece && !options.wantsCurvature())
    base::throwUsage("", "--piece", "requires --curvature; add it or omit --piece");
  if (!options.plot.empty()) requireGnuplot(options.plot);
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, options.histograms, "--histograms");
  checkOutput(guard, options.plot, "--plot");
}

void addMeasureOptions(CLI::App& parser, MeasureOptions& options) {
  addPath(parser, options.path);
  parser.add_flag("--json", options.json,
                  "Print one JSON object instead of text (docs/reference/outputs.md)");
  addOption(parser, "--box", options.box, "\"x,y,z x,y,z\"",
            "Measure only inside this box of the world, two corners in mm");
  const auto points = [&parser](const char* name, std::vector<std::string>& into, const char* type,
                                const char* help) {
    addOption(parser, name, into, type, help)->expected(1)->take_all();
  };
  points("--distance", options.distances, "\"P Q\"",
         "Distance between two points, straight and along the surface; may be repeated");
  points("--angle", options.angles, "\"A B C [D]\"",
         "Angle at B, or between the planes ABC and BCD; may be repeated");
  points("--circle", options.circles, "\"A B C\"", "Circle through three points; may be repeated");
  points("--thickness", options.thicknesses, "P",
         "Thickness at a surface point: along the inward normal, and diameter of the inscribed sphere; may "
         "be repeated");
  parser.add_flag("--curvature", options.curvature,
                  "Curvature distribution: fractions of the surface area per curvature");
  addOption(parser, "--histograms", options.histograms, "FILE",
            "Write the curvature distribution as a table: a new .csv");
  addOption(parser, "--plot", options.plot, "FILE",
            "Plot the curvature distribution: a new .svg; needs gnuplot");
  addOption(
      parser, "--piece", options.piece, "ID",
      "Curvature of this connected component only (piece id, 0: the largest); default: all that are shown");
  CLI::Option* const labels =
      parser.add_flag("--labels", options.labels,
                      "Measure each label of a label map instead of an isosurface: a row for each but 0");
  addOption(parser, "--smoothing", options.smoothing, "VOXELS",
            "Smoothing of the surfaces of labels, 0 to 2 voxels; default: 1")
      ->check(within(0.0, volume::kMostSmoothing))
      ->needs(labels);
  addOption(parser, "--marks", options.marks, "FILE.mrk.json",
            "Measure the marks of this file instead of the session's");
  addOption(parser, "--out", options.out, "FILE.csv", "Write the values of the marks, or labels, as a table");
  parser.add_flag("--closed", options.closed,
                  "Reject an open surface instead of measuring the part inside the data");
  parser.add_flag("--anyway", options.anyway, "Measure even if spacing was assumed or slices were resampled");
}

void refuseWhatIsOfIsosurfaces(const MeasureOptions& options) {
  const std::pair<bool, const char*> others[] = {{!options.box.empty(), "--box"},
                                                 {!options.distances.empty(), "--distance"},
                                                 {!options.angles.empty(), "--angle"},
                                                 {!options.circles.empty(), "--circle"},
                                                 {!options.thicknesses.empty(), "--thickness"},
                                                 {options.curvature, "--curvature"},
                                                 {!options.histograms.empty(), "--histograms"},
                                                 {!options.plot.empty(), "--plot"},
                                                 {options.piece.has_value(), "--piece"},
                                                 {!options.marks.empty(), "--marks"},
                                                 {options.closed, "--closed"}};
  for (const auto& [given, name] : others)
    if (given) base::throwUsage("", name, "measures an isosurface, --labels does not; omit one of them");
}

void runLabels(const MeasureOptions& options, const scene::Scene& scene, base::Progress& progress) {
  if (!options.out.empty()) {
    OutputGuard guard = outputGuard(options.path, *options.scene, scene);
    checkOutput(guard, options.out, "--out");
  }
  const auto prepared = loadWithProgressBar(volume::withLabelsAsValues(scene.source), progress);
  ordered_json json;
  {
    const ProgressBar bar(progress);
    json = labelMeasuresJson(*prepared, scene.source.path, options.smoothing, options.anyway, progress);
  }
  if (!options.out.empty()) writeTextFile(options.out, labelMeasuresCsv(json));
  if (options.json)
    std::cout << jsonText(json);
  else
    printLabelMeasures(json, std::cout);
  printWarnings(prepared->volume);
}

void runMeasure(const MeasureOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  checkPoints(options);
  const scene::Scene scene = sceneOf(options.path, *options.scene);
  checkCurvatureFiles(options, scene);
  if (options.labels) {
    refuseWhatIsOfIsosurfaces(options);
    runLabels(options, scene, progress);
    return;
  }
  refuseCuts(scene, "isolux measure");
  const ReadMarks wanted = marksToMeasure(options.marks, scene);
  const std::vector<scene::Mark>& marks = wanted.marks;
  if (!options.out.empty()) {
    if (marks.empty()) base::throwUsage("", "--out", "there are no marks to write");
    OutputGuard guard = outputGuard(options.path, *options.scene, scene);
    if (!options.marks.empty()) guard.reads(options.marks, "the file of marks");
    checkOutput(guard, options.out, "--out");
  }
  const auto prepared = loadWithProgressBar(scene.source, progress);
  ordered_json json;
  std::vector<MarkReport> reports;
  {
    const ProgressBar bar(progress);
    const scene::Scene resolved = scene::resolve(scene, prepared->facts);
    json = measure(options, resolved, *prepared, progress);
    MarkEvaluator evaluator(prepared, resolved, options.anyway);
    for (const scene::Mark& mark : marks) reports.push_back(evaluator.evaluate(mark, progress));
  }
  for (std::size_t i = 0; i < marks.size(); ++i) json["marks"].push_back(markJson(marks[i], reports[i]));
  if (!options.out.empty()) writeTextFile(options.out, marksCsv(marks, reports));
  if (options.json) {
    std::cout << jsonText(json);
  } else {
    printMeasures(json, std::cout);
    printMarks(marks, reports);
  }
  if (json["open"].get<bool>()) printNote("the surface is open: " + json["open_reason"].get<std::string>());
  for (const std::string& note : wanted.notes) printNote(note);
  printWarnings(prepared->volume);
}

}  // namespace

Command makeMeasure(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "measure", "Measure the isosurface or labels: area, volume, distances, angles, thickness, with errors");
  auto options = std::make_shared<MeasureOptions>();
  addMeasureOptions(*parser, *options);
  options->scene = addSceneOptions(*parser);
  addThreadsOption(*parser);
  parser->footer(
      "Points are x,y,z in world mm.\n\nExample:\n  isolux measure head.nii.gz --isovalue 300 --distance "
      "\"0,-90,20 0,90,20\"");
  return {parser, [options](base::Progress& progress) { runMeasure(*options, progress); }};
}

}  // namespace isolux::app
