// isolux measure PATH: area and volume of the isosurface, distances, angles, circles and thicknesses, each
// with its error.
#include <filesystem>
#include <iostream>
#include <optional>

#include <glm/common.hpp>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/files/number_rows.h"
#include "app/process/progress_bar.h"
#include "app/report/curvature_report.h"
#include "app/report/measure_marks.h"
#include "app/report/measure_points.h"
#include "app/report/measure_report.h"
#include "app/report/piece_report.h"
#include "base/error.h"
#include "base/number_text.h"
#include "scene/rules/automatic.h"
#include "volume/measure/piece_measure.h"
#include "volume/measure/surface_measure.h"
#include "volume/measure/voxel_noise.h"
#include "volume/pieces/shown_pieces.h"
#include "volume/read/input/length_doubt.h"

namespace isolux::app {

namespace {

using base::Error;
using base::ErrorKind;
using nlohmann::ordered_json;
using volume::PreparedVolume;
using volume::SurfaceOf;

struct MeasureOptions {
  std::string path, box, marks, out;
  std::vector<std::string> distances, angles, circles, thicknesses;
  bool json = false, closed = false, anyway = false;
  bool curvature = false;
  std::string histograms, plot;  // files of its distribution; either asks for it, too
  std::optional<std::size_t> piece;

  bool wantsCurvature() const { return curvature || !histograms.empty() || !plot.empty(); }
};

std::optional<volume::WorldBox> boxOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto corners = parsePoints(text, "--box", 2, 2);
  const volume::WorldBox box{glm::min(corners[0], corners[1]), glm::max(corners[0], corners[1])};
  const glm::dvec3 size = box.highMm - box.lowMm;
  if (!(size.x > 0.0 && size.y > 0.0 && size.z > 0.0))
    throw Error(ErrorKind::usage, "", "--box", "is empty: " + text);
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

struct SizedSurface {
  volume::SurfaceMeasure whole;
  ordered_json pieces = ordered_json::array();  // those that are shown, not within a box
};

// Whether a piece that is shown has a corner of the cell.
bool holdsShown(const volume::Pieces& pieces, const std::vector<bool>& shown, glm::ivec3 cell) {
  for (int i = 0; i < 8; ++i) {
    const std::uint32_t id = pieces.ofVoxel(cell + glm::ivec3(i & 1, i >> 1 & 1, i >> 2));
    if (id < shown.size() && shown[id]) return true;
  }
  return false;
}

SizedSurface sizedSurface(const MeasureOptions& options, const scene::Scene& scene,
                          const MeasuredSurface& measured, base::Progress& progress) {
  const PreparedVolume& prepared = measured.prepared;
  const SurfaceOf& of = measured.surface;
  volume::SurfaceQuestion question{of.isovalue, of.inside, boxOf(options.box), of.noise, {}};
  SizedSurface sized;
  if (question.box && !volume::hidesPieces(scene.pieces)) {
    sized.whole = measureSurface(prepared.grid(), *prepared.blocks, question, progress);
    return sized;
  }
  const auto pieces = prepared.pieces->at(of.isovalue, of.inside, progress);
  std::vector<bool> shown;
  if (volume::hidesPieces(scene.pieces)) shown = prepared.pieces->shown(*pieces, scene.pieces, progress);
  if (question.box) {
    question.keeps = [&](glm::ivec3 cell) { return holdsShown(*pieces, shown, cell); };
    sized.whole = measureSurface(prepared.grid(), *prepared.blocks, question, progress);
    return sized;
  }
  const volume::PieceMeasures measures = measurePieces(*pieces, *prepared.blocks, question, shown, progress);
  sized.whole = measures.whole;
  for (std::size_t id = 0; id < measures.pieces.size(); ++id) {
    if (!shown.empty() && !shown[id]) continue;
    sized.pieces.push_back(pieceJson(id, measures.pieces[id]));
  }
  return sized;
}

// What of the surface counts, its curvature, and the files that were asked for of it.
ordered_json curvatureOf(const MeasureOptions& options, scene::Scene scene, const PreparedVolume& prepared,
                         base::Progress& progress) {
  prepared.derivativeChoices->complete(scene, progress);
  const auto pieces = prepared.pieces->at(scene.isosurface.value.value(), scene.isosurface.inside, progress);
  volume::CurvaturePart part{{}, boxOf(options.box)};
  std::string title = prepared.volume.name + " at " + base::shortText(scene.isosurface.value.value()) +
                      (prepared.volume.unit.empty() ? "" : " " + prepared.volume.unit);
  if (options.piece) {
    const std::size_t id = *options.piece, count = pieces->list().size();
    if (id >= count)
      throw Error(ErrorKind::usage, "", "--piece",
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
  const double isovalue = scene.isosurface.value.value_or(prepared.facts.suggestedIsovalue);
  const auto doubt = volume::lengthDoubt(prepared.volume.warnings);
  if (doubt && !options.anyway)
    base::throwInput(scene.source.path, "",
                     "lengths are doubtful: " + *doubt + "; --anyway measures all the same");
  MeasuredSurface measured{
      scene.source.path,
      prepared,
      {prepared.grid(), isovalue, scene.isosurface.inside, volume::voxelNoise(prepared, scene, progress)}};
  const SizedSurface sized = sizedSurface(options, scene, measured, progress);
  const volume::SurfaceMeasure& surface = sized.whole;
  refuseWhatIsNoSurface(options, measured, surface);
  ordered_json json{{"isovalue", isovalue},
                    {"unit", prepared.volume.unit},
                    {"inside", scene.isosurface.inside == scene::Inside::above ? "above" : "below"},
                    {"noise", measured.surface.noise.at(isovalue)}};
  if (doubt) json["doubt"] = *doubt;
  json.update(surfaceJson(surface));
  if (options.box.empty()) json["pieces"] = sized.pieces;
  if (options.wantsCurvature()) json["curvature"] = curvatureOf(options, scene, prepared, progress);
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

void checkCurvatureFiles(const MeasureOptions& options, const SceneOptions& sceneOptions,
                         const scene::Scene& scene) {
  const auto mustEnd = [](const std::string& file, const char* option, const char* ending) {
    if (!file.empty() && std::filesystem::path(file).extension() != ending)
      throw Error(ErrorKind::usage, file, option, std::string("the name must end in ") + ending);
  };
  mustEnd(options.histograms, "--histograms", ".csv");
  mustEnd(options.plot, "--plot", ".svg");
  if (options.piece && !options.wantsCurvature())
    throw Error(ErrorKind::usage, "", "--piece", "requires --curvature; add it or omit --piece");
  if (!options.plot.empty()) requireGnuplot(options.plot);
  OutputGuard guard = outputGuard(options.path, sceneOptions, scene);
  checkOutput(guard, options.histograms, "--histograms");
  checkOutput(guard, options.plot, "--plot");
}

void addMeasureOptions(CLI::App& parser, MeasureOptions& options) {
  parser.add_option("PATH", options.path, "A volume file, a DICOM folder, phantom:NAME[:SIZE], or a session");
  parser.add_flag("--json", options.json,
                  "Print one JSON object instead of text (docs/reference/outputs.md)");
  parser.add_option("--box", options.box, "Measure only inside this box of the world, two corners in mm")
      ->type_name("\"x,y,z x,y,z\"");
  const auto points = [&parser](const char* name, std::vector<std::string>& into, const char* type,
                                const char* help) {
    parser.add_option(name, into, help)->type_name(type)->expected(1)->take_all();
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
  parser
      .add_option("--histograms", options.histograms,
                  "Write the curvature distribution as a table: a new .csv")
      ->type_name("FILE");
  parser.add_option("--plot", options.plot, "Plot the curvature distribution: a new .svg; needs gnuplot")
      ->type_name("FILE");
  parser
      .add_option("--piece", options.piece,
                  "Curvature of this connected component only (piece id, 0: the largest); default: all that "
                  "are shown")
      ->type_name("ID");
  parser.add_option("--marks", options.marks, "Measure the marks of this file instead of the session's")
      ->type_name("FILE.mrk.json");
  parser.add_option("--out", options.out, "Write the values of the marks as a table")->type_name("FILE.csv");
  parser.add_flag("--closed", options.closed,
                  "Reject an open surface instead of measuring the part inside the data");
  parser.add_flag("--anyway", options.anyway, "Measure even if spacing was assumed or slices were resampled");
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
            checkCurvatureFiles(*options, *sceneOptions, scene);
            refuseCuts(scene, "isolux measure");
            const WantedMarks wanted = marksToMeasure(options->marks, scene);
            if (!options->out.empty()) {
              if (wanted.marks.empty())
                throw Error(ErrorKind::usage, "", "--out", "there are no marks to write");
              OutputGuard guard = outputGuard(options->path, *sceneOptions, scene);
              if (!options->marks.empty()) guard.reads(options->marks, "the file of marks");
              checkOutput(guard, options->out, "--out");
            }
            const auto prepared = loadWithProgressBar(scene.source, progress);
            ordered_json json;
            MeasuredMarks marks;
            {
              const ProgressBar bar(progress);
              const scene::Scene resolved = scene::resolve(scene, prepared->facts);
              json = measure(*options, resolved, *prepared, progress);
              marks = measuredMarks(wanted.marks, prepared, resolved, options->anyway, progress);
            }
            if (!marks.marks.empty()) json["marks"] = marksJson(marks);
            if (!options->out.empty()) writeTextFile(options->out, marksCsv(marks.marks, marks.reports));
            if (options->json) {
              std::cout << jsonText(json);
            } else {
              printMeasures(json, std::cout);
              printMarks(marks, std::cout);
            }
            if (json["open"].get<bool>())
              printNote("the surface is open: " + json["open_reason"].get<std::string>());
            for (const std::string& note : wanted.notes) printNote(note);
            printWarnings(prepared->volume);
          }};
}

}  // namespace isolux::app
