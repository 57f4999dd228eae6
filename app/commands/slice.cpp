// isolux slice PATH --plane PLANE --out FILE: the values on a plane with the curves of the isosurfaces;
// without GL.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/files/number_rows.h"
#include "app/runtime/progress_bar.h"
#include "app/slices/slice_labels.h"
#include "app/slices/slice_picture.h"
#include "app/version.h"
#include "base/error.h"
#include "scene/rules/automatic.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

struct SliceOptions {
  std::string path, plane, out, stats;
  std::optional<double> at;
  std::optional<std::string> size;
  std::shared_ptr<SceneOptions> scene;
};

// axial, coronal, sagittal; or a point and a normal.
struct PlaneChoice {
  std::optional<volume::SliceDirection> direction;
  glm::dvec3 pointMm{0.0}, normal{0.0, 0.0, 1.0};
};

PlaneChoice parsePlane(const std::string& text) {
  using volume::SliceDirection;
  if (text == "axial") return {SliceDirection::axial};
  if (text == "coronal") return {SliceDirection::coronal};
  if (text == "sagittal") return {SliceDirection::sagittal};
  if (text.find_first_of("0123456789") == std::string::npos)
    base::throwUsage("", "--plane",
                     '"' + text + "\" is not axial, coronal, sagittal or \"px,py,pz nx,ny,nz\"");
  const auto points = parsePoints(text, "--plane", 2, 2);
  const double length = glm::length(points[1]);
  if (!(length > 0.0 && std::isfinite(length)))
    base::throwUsage("", "--plane", "needs a normal of some length: " + text);
  return {std::nullopt, points[0], points[1] / length};
}

bool isExr(const std::string& file) {
  return std::filesystem::path(file).extension() == ".exr";
}

volume::SlicePlane planeOf(const SliceOptions& options, const scene::Scene& scene,
                           const volume::PreparedVolume& prepared) {
  const PlaneChoice choice = parsePlane(options.plane);
  const volume::GridGeometry& geometry = prepared.grid().geometry();
  const scene::WorldAxes axes = prepared.volume.axes;
  volume::SliceFrame frame;
  glm::dvec3 point = choice.pointMm;
  if (choice.direction) {
    frame = sliceFrame(*choice.direction, axes, scene.slice.convention);
    point = slicePosition(scene, geometry);
    if (options.at) point[axisOf(*choice.direction)] = *options.at;
  } else {
    frame = volume::sliceFrame(choice.normal, axes, scene.slice.convention);
    point += options.at.value_or(0.0) * choice.normal;
  }
  if (isExr(options.out) && !options.size) return nativeSlice(geometry, frame, point);
  return fittedSlice(geometry, frame, point, pictureSize(options.size, options.path, *options.scene));
}

double lengthMm(const volume::SliceCurve& curve, const volume::GridGeometry& geometry) {
  double sum = 0.0;
  const glm::dmat3 toWorld(geometry.worldFromVoxel);
  for (std::size_t i = curve.closed ? 0 : 1; i < curve.points.size(); ++i)
    sum += glm::length(toWorld *
                       (curve.points[i] - curve.points[(i + curve.points.size() - 1) % curve.points.size()]));
  return sum;
}

ordered_json contoursJson(const SliceContent& content, const volume::GridGeometry& geometry) {
  ordered_json json = ordered_json::array();
  for (const SurfaceOnSlice& surface : content.surfaces) {
    double length = 0.0;
    std::size_t closed = 0, points = 0;
    for (const volume::SliceCurve& curve : surface.curves.curves) {
      length += lengthMm(curve, geometry);
      closed += curve.closed;
      points += curve.points.size();
    }
    json.push_back({{"isovalue", surface.isovalue},
                    {"curves", surface.curves.curves.size()},
                    {"closed", closed},
                    {"points", points},
                    {"length_mm", length}});
  }
  return json;
}

ordered_json valuesJson(const volume::SliceValues& slice) {
  std::size_t pixels = 0;
  double least = 0.0, most = 0.0;
  for (const float value : slice.values) {
    if (std::isnan(value)) continue;
    least = pixels == 0 ? value : std::min<double>(least, value);
    most = pixels == 0 ? value : std::max<double>(most, value);
    ++pixels;
  }
  ordered_json json{{"pixels_with_value", pixels}};
  json["range"] = pixels > 0 ? ordered_json{least, most} : ordered_json();
  return json;
}

ordered_json statsJson(const SliceOptions& options, const scene::Scene& scene, const SliceContent& content,
                       const volume::PreparedVolume& prepared, const SliceWords& words) {
  const volume::SlicePlane& plane = content.plane;
  const volume::GridGeometry& geometry = prepared.grid().geometry();
  ordered_json json{{"version", version()},
                    {"file", options.out},
                    {"size", plane.size},
                    {"origin_mm", plane.originMm},
                    {"right_mm", plane.rightMm},
                    {"down_mm", plane.downMm},
                    {"level", content.window.level},
                    {"width", content.window.width},
                    {"unit", prepared.volume.unit},
                    {"field", scene::setting("slice.field").get(scene)},
                    {"slab_mm", scene.slice.slab},
                    {"slab_mode", scene::setting("slice.slab_mode").get(scene)}};
  json["convention"] = conventionText(scene.slice.convention, prepared.volume.axes);
  json["letters"] = {{"left", words.letters.left},
                     {"right", words.letters.right},
                     {"top", words.letters.top},
                     {"bottom", words.letters.bottom}};
  json.update(valuesJson(content.values));
  if (content.band) json["noise_band"] = {content.band->first, content.band->second};
  json["contours"] = contoursJson(content, geometry);
  return json;
}

void runSlice(const SliceOptions& options, base::Progress& progress) {
  const std::string extension = std::filesystem::path(options.out).extension().string();
  if (extension != ".png" && extension != ".exr")
    base::throwUsage(options.out, "", "the name of a slice must end in .png or .exr");
  parsePlane(options.plane);
  if (options.at && !std::isfinite(*options.at)) base::throwUsage("", "--at", "must be a finite number");
  if (options.size) parseSize(*options.size);
  requireSource(options.path, *options.scene);
  scene::Scene scene = sceneOf(options.path, *options.scene);
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, options.out, "--out");
  checkOutput(guard, options.stats, "--stats");
  const auto prepared = loadWithProgressBar(scene.source, progress);
  scene = scene::resolve(std::move(scene), prepared->facts);
  const volume::GridGeometry& geometry = prepared->grid().geometry();
  const ProgressBar bar(progress);
  const SliceContent content = sliceContent(*prepared, scene, planeOf(options, scene, *prepared), progress);
  const SliceWords words = wordsOf(content, content.plane, scene.slice, prepared->volume);
  if (isExr(options.out)) {
    writeExr(content.plane.size, {{"value", content.values.values}}, options.out, "");
  } else {
    render::ColorImage picture = slicePicture(content, scene.slice, geometry, progress);
    drawWords(words, picture);
    writePng(picture, options.out, "");
  }
  const ordered_json stats = statsJson(options, scene, content, *prepared, words);
  if (!options.stats.empty()) writeTextFile(options.stats, jsonText(stats));
  if (stats["pixels_with_value"] == 0) printNote("the plane does not meet the volume");
  printWarnings(prepared->volume);
}

}  // namespace

Command makeSlice(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "slice", "Draw a slice with the isosurfaces' contours, or write its values as numbers");
  auto options = std::make_shared<SliceOptions>();
  addPath(*parser, options->path, Opens::pictures);
  addOption(*parser, "--plane", options->plane, "PLANE",
            "axial, coronal or sagittal (normal to the world's z, y, x), or a point and a normal \"px,py,pz "
            "nx,ny,nz\", mm")
      ->required();
  addOption(*parser, "--at", options->at, "MM",
            "Position on that axis, mm; with a point and a normal: distance along the normal. Default: "
            "slice.position; 0");
  addOption(*parser, "--out", options->out, "FILE",
            "A new .png (grey values through window level and width, isocontours with their isovalues, "
            "orientation labels, ruler), or a .exr with one channel `value`")
      ->required();
  addOption(*parser, "--size", options->size, "WxH",
            "Pixels; default: 1024x768 for a .png, voxel size for a .exr");
  addOption(*parser, "--stats", options->stats, "FILE",
            "Write the position of the pixels, level, width and contours as JSON");
  options->scene = addSceneOptions(*parser, Draws::slice);
  addThreadsOption(*parser);
  parser->footer(
      "The settings of slice. (`isolux settings slice`) choose what is shown. No graphics context is "
      "needed.\n"
      "Examples:\n"
      "  isolux slice head.nii.gz --plane axial --at 12 --out axial.png --isovalue 300\n"
      "  isolux slice head.nii.gz --plane \"0,0,0 0,1,1\" --set slice.slab=5 --out slab.exr --stats "
      "slab.json");
  return {parser, [options](base::Progress& progress) { runSlice(*options, progress); }};
}

}  // namespace isolux::app
