#include "app/study_report/study_report.h"

#include <sstream>
#include <string_view>

#include <tbb/task_arena.h>
#include <nlohmann/json.hpp>

#include "app/files/files.h"
#include "app/files/json_text.h"
#include "app/study/scale_study.h"
#include "app/study_report/study_advice.h"
#include "app/study_report/study_table.h"
#include "app/version.h"
#include "base/number_text.h"
#include "base/printable.h"
#include "scene/rules/automatic.h"
#include "scene/settings/settings.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

constexpr double kBusy = 1.1;  // wall time per processor time: on a machine with nothing else to do at most 1

std::string processorName() {
  constexpr std::string_view key = "model name";
  const std::string text = readBeginning("/proc/cpuinfo", 4096);
  const std::size_t at = text.find(key);
  if (at == std::string::npos) return "unknown";
  const std::size_t begin = text.find_first_not_of(" :\t", at + key.size());
  return begin == std::string::npos ? "unknown" : text.substr(begin, text.find('\n', begin) - begin);
}

// ---- JSON; a number that is not defined (no pixel) is null.

ordered_json spreadJson(const Spread& spread) {
  return {{"pixels", spread.pixels},
          {"median", spread.median},
          {"rms", spread.rms},
          {"quantile_99", spread.most99},
          {"maximum", spread.maximum}};
}

ordered_json errorsJson(const Errors& errors) {
  return {{"surface_pixels", errors.surface},
          {"missed_pixels", errors.missed},
          {"missed_ppm", errors.missedPpm()},
          {"invented_pixels", errors.invented},
          {"invented_ppm", errors.inventedPpm()},
          {"undecided_pixels", errors.undecided},
          {"depth_voxels", spreadJson(errors.depthVoxels)},
          {"depth_mm", spreadJson(errors.depthMm)},
          {"normal_degrees", spreadJson(errors.normalDegrees)},
          {"curvature_relative", spreadJson(errors.curvature)}};
}

ordered_json pictureJson(const ImageErrors& errors) {
  ordered_json json{{"flip_mean", errors.flip}, {"rms", errors.rms}};
  if (errors.edgePixels > 0) json.update({{"edge_rms", errors.edgeRms}, {"edge_pixels", errors.edgePixels}});
  return json;
}

// [25 %, 75 %]; null without times.
ordered_json quartilesJson(const std::vector<double>& times) {
  if (times.empty()) return nullptr;
  const TimeSpread spread = spreadOfTimes(times);
  return {spread.low, spread.high};
}

ordered_json lightCostJson(const LightCost& cost) {
  return {{"bake_seconds", cost.bakeSeconds},
          {"bake_seconds_quartiles", quartilesJson(cost.bakeTimes)},
          {"rays", cost.rays},
          {"texels", cost.texels},
          {"lookup_milliseconds", cost.lookupMilliseconds},
          {"lookup_milliseconds_quartiles", quartilesJson(cost.lookupTimes)},
          {"lattice_bytes", cost.latticeBytes},
          {"gpu_bytes", cost.gpuBytes}};
}

// `size` of the picture, for the place of the largest error.
ordered_json lightErrorsJson(const LightErrors& errors, glm::ivec2 size) {
  return {{"pixels", errors.pixels},
          {"mean_irradiance", errors.mean},
          {"truth_noise", errors.truthNoise},
          {"rmse", errors.rmse},
          {"rmse_standard_error", errors.rmseStandardError},
          {"rmse_relative", errors.relative(errors.rmse)},
          {"bias", errors.bias},
          {"bias_standard_error", errors.biasStandardError},
          {"bias_relative", errors.relative(errors.bias)},
          {"quantile_99", errors.most99},
          {"maximum", errors.maximum},
          {"maximum_z", errors.maximumZ},
          {"maximum_pixel", volume::Extent2{size}.at(errors.maximumPixel)}};
}

ordered_json scaleJson(const StudySetting& setting) {
  const ScaleCost& cost = setting.scale.value();
  const NoiseErrors& errors = setting.errors.noise;
  return {{"scale_mm", cost.scaleMm},
          {"build_seconds", cost.buildSeconds},
          {"unknown_share", cost.unknown},
          {"points", errors.curvature.pixels / kNoiseSeeds},
          {"seeds", kNoiseSeeds},
          {"curvature_median_relative", errors.curvature.median},
          {"curvature_99_relative", errors.curvature.most99},
          {"normal_rms_degrees", errors.normalDegrees.rms},
          {"normal_99_degrees", errors.normalDegrees.most99}};
}

ordered_json settingJson(const QualitySetting& quality, const StudySetting& setting, glm::ivec2 size) {
  ordered_json json{{"value", setting.value},
                    {"default", setting.isDefault},
                    {"setting_default", setting.isDefault || setting.settingDefault},
                    {"comparison", setting.comparison},
                    {"frame_milliseconds", setting.frameMilliseconds},
                    {"frame_milliseconds_quartiles", quartilesJson(setting.frameTimes)},
                    {"picture", pictureJson(setting.errors.picture)}};
  if (!setting.processorTimes.empty()) {
    json["processor_milliseconds"] = spreadOfTimes(setting.processorTimes).median;
    json["processor_milliseconds_quartiles"] = quartilesJson(setting.processorTimes);
  }
  if (setting.light) {
    json["light"] = lightCostJson(*setting.light);
    json["errors"] = lightErrorsJson(setting.errors.light, size);
    return json;
  }
  json["pass_milliseconds"] = setting.passMilliseconds;
  for (const auto& [name, times] : setting.passTimes)
    json["pass_milliseconds_quartiles"][name] = quartilesJson(times);
  if (setting.scale)
    json["scale"] = scaleJson(setting);
  else if (quality.measure == Measure::hits || quality.measure == Measure::shape)
    json["errors"] = errorsJson(setting.errors);
  if (setting.fieldErrors) json["field_errors"] = errorsJson(*setting.fieldErrors);
  return json;
}

ordered_json truthJson(const QualityStudy& study) {
  const Measure measure = study.quality.measure;
  if (measure == Measure::light)
    return {{"truth", {{"samples", study.truthSamples}, {"bounces", study.truthBounces}}}};
  if (measure == Measure::scale)
    return {{"added_noise", study.addedNoise}, {"compared_with", study.knowsTruth ? "phantom" : "itself"}};
  if (measure != Measure::hits && measure != Measure::shape) return ordered_json::object();
  ordered_json json{{"passes", panelsOf(study.quality)[0].passes},
                    {"method", study.quality.sampled() ? "sampled" : "as in the scene"}};
  if (measure == Measure::shape)
    json["scales_mm"] = {{"normals", study.normalScaleMm}, {"curvature", study.curvatureScaleMm}};
  return json;
}

ordered_json qualityJson(const QualityStudy& study, glm::ivec2 size) {
  const auto& panels = panelsOf(study.quality);
  ordered_json json{
      {"name", study.quality.name}, {"setting", study.quality.setting}, {"label", study.quality.label}};
  if (!study.skipped.empty()) {
    json["skipped"] = study.skipped;
    json["settings"] = ordered_json::array();
    return json;
  }
  json.update(truthJson(study));
  const std::string reference = study.quality.reference;
  json["picture_reference"] = reference.empty() ? "256 rays per pixel" : reference;
  json["settings"] = ordered_json::array();
  for (const StudySetting& setting : study.settings)
    json["settings"].push_back(settingJson(study.quality, setting, size));
  json["reach"] = ordered_json::array();
  for (const double error : errorsToReach(study.quality.measure)) {
    const StudySetting* const setting = cheapest(study, error);
    ordered_json reach{{"error", panels[0].key}, {"at_most", error}};
    reach["value"] = setting ? ordered_json(setting->value) : ordered_json();
    if (setting) reach["comparison"] = setting->comparison;
    json["reach"].push_back(reach);
  }
  json["advice"] = adviceOf(study);
  if (const std::string note = noteOf(study); !note.empty()) json["note"] = note;
  if (!study.plot.empty()) json["plot"] = study.plot;
  return json;
}

// ---- Markdown

void reachLine(std::ostream& out, const QualityStudy& study) {
  const Panel& panel = panelsOf(study.quality)[0];
  out << "\nThe cheapest whose " << panel.noun << " is at most ";
  bool first = true;
  for (const double error : errorsToReach(study.quality.measure)) {
    const StudySetting* const setting = cheapest(study, error);
    out << (first ? "" : "; ") << errorText(panel, error) << ": ";
    first = false;
    if (!setting) {
      out << "none";
      continue;
    }
    out << '`' << setting->value << "` (" << costText(study.quality, costOf(study.quality, *setting, panel));
    if (study.quality.measure == Measure::hits) out << ", " << judged(*setting).missed << " missed";
    out << ')';
  }
  out << ".\n";
}

void closing(std::ostream& out, const QualityStudy& study) {
  // Of a scan more smoothing is always less error, of what can be counted.
  const bool blind = study.quality.measure == Measure::scale && !study.knowsTruth;
  if (study.quality.measure != Measure::shadow && !blind) reachLine(out, study);
  if (const std::string note = noteOf(study); !note.empty()) out << '\n' << note << '\n';
  out << "\n"
         "**Recommendation.** "
      << adviceOf(study) << '\n';
}

// A file's words in Markdown: no HTML, no link, no table of their own.
std::string markdownText(const std::string& text) {
  std::string escaped;
  for (const char letter : base::printable(text)) {
    if (std::string_view("\\`*[]<>&|").find(letter) != std::string_view::npos) escaped += '\\';
    escaped += letter;
  }
  return escaped;
}

}  // namespace

std::string studyJson(const StudySubject& subject, const render::ContextDescription& context,
                      const std::vector<QualityStudy>& studies, bool complete) {
  const volume::Grid& grid = subject.volume->grid();
  ordered_json json;
  json["isolux_study"] = 1;
  json["version"] = version();
  json["complete"] = complete;
  json["machine"] = {{"processor", processorName()}, {"threads", tbb::this_task_arena::max_concurrency()}};
  addContext(json, context);
  json["volume"] = {{"name", subject.volume->volume.name},
                    {"data_hash", base::hexText(grid.hash())},
                    {"dims", grid.dims()},
                    {"spacing_mm", grid.geometry().spacingMm()}};
  json["size"] = subject.size;
  json["repeat"] = subject.repeat;
  json["units"] = {{"milliseconds", "ms, median"},
                   {"quartiles", "the same unit, 25 and 75 %"},
                   {"processor_milliseconds", "ms that the processor worked, all threads together, median"},
                   {"flip_mean", "1, mean FLIP at 67 pixels per degree"},
                   {"rms, edge_rms", "1, sRGB values in parts of the full range"},
                   {"ppm", "parts per million of the picture's pixels"},
                   {"depth_voxels", "voxels along the ray"},
                   {"depth_mm", "mm along the ray"},
                   {"normal_degrees", "degrees"},
                   {"curvature_relative", "1"},
                   {"rmse, bias, quantile_99, maximum", "irradiance, linear RGB radiance times steradian"},
                   {"lookup_milliseconds", "ms of the pass irradiance, median"}};
  json["wall_per_processor_time"] = timesAsLong(studies);
  json["knobs"] = ordered_json::array();
  for (const QualityStudy& study : studies) json["knobs"].push_back(qualityJson(study, subject.size));
  json["scene"] = scene::toJson(scene::resolve(subject.scene, subject.volume->facts));
  return jsonText(json);
}

std::string studyMarkdown(const StudySubject& subject, const render::ContextDescription& context,
                          const std::vector<QualityStudy>& studies, bool complete) {
  const glm::ivec3 dims = subject.volume->grid().dims();
  const scene::Scene resolved = scene::resolve(subject.scene, subject.volume->facts);
  std::ostringstream out;
  out << "# What accuracy costs: " << markdownText(subject.volume->volume.name) << "\n\n"
      << dims.x << " x " << dims.y << " x " << dims.z << " voxels, isovalue "
      << tableNumber(*resolved.surfaces.front().value, 6) << ", picture " << subject.size.x << " x "
      << subject.size.y << ". " << context.renderer << ", " << processorName() << "; medians of "
      << subject.repeat << " frames of each setting in turns.\n"
      << "Errors of surfaces are relative to double precision on the same fields, errors of light to path "
         "tracing. FLIP: perceived difference of images, 0 to 1 (mean). Quartiles: half of all measured "
         "times are between them; rows with overlapping quartiles are taken to cost the same. study.json has "
         "all other figures.\n";
  if (const double ratio = timesAsLong(studies); ratio > kBusy)
    out << "\n"
           "**The computer was busy**: frames took "
        << tableNumber(ratio, 2)
        << " times as long as their CPU time. Times are uncertain; errors are not.\n";
  if (!complete) out << "\n*Not complete: the study was stopped, or is still running.*\n";
  for (const QualityStudy& study : studies) {
    out << "\n## " << study.quality.name << " (`" << study.quality.setting << "`)\n\n";
    if (!study.skipped.empty()) {
      out << "Not studied: " << study.skipped << ".\n";
      continue;
    }
    writeQualityTable(out, study);
    closing(out, study);
    if (!study.plot.empty()) out << "\n![" << study.quality.label << "](" << study.plot << ")\n";
  }
  writeLightReach(out, studies);
  return out.str();
}

}  // namespace isolux::app
