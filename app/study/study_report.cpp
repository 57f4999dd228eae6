#include "app/study/study_report.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <tbb/task_arena.h>
#include <nlohmann/json.hpp>

#include "app/files/files.h"
#include "app/files/json_text.h"
#include "app/study/study_light_report.h"
#include "app/study/study_scale_report.h"
#include "app/study/study_table.h"
#include "app/version.h"
#include "base/number_text.h"
#include "scene/settings.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;

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

ordered_json settingJson(const StudySetting& setting, glm::ivec2 size) {
  if (setting.light)
    return {{"value", setting.value},
            {"default", setting.isDefault},
            {"frame_milliseconds", setting.frameMilliseconds},
            {"light", lightCostJson(*setting.light)},
            {"errors", lightErrorsJson(setting.errors.light, size)}};
  if (setting.scale)
    return {{"value", setting.value},
            {"default", setting.isDefault},
            {"frame_milliseconds", setting.frameMilliseconds},
            {"pass_milliseconds", setting.passMilliseconds},
            {"scale", scaleJson(setting)}};
  ordered_json json{{"value", setting.value},
                    {"default", setting.isDefault},
                    {"comparison", setting.comparison},
                    {"frame_milliseconds", setting.frameMilliseconds},
                    {"pass_milliseconds", setting.passMilliseconds},
                    {"errors", errorsJson(setting.errors)}};
  if (setting.fieldErrors) json["field_errors"] = errorsJson(*setting.fieldErrors);
  return json;
}

ordered_json knobJson(const KnobStudy& study, glm::ivec2 size) {
  const auto& panels = panelsOf(study.knob);
  ordered_json json{{"name", study.knob.name}, {"setting", study.knob.setting}, {"label", study.knob.label}};
  if (!study.skipped.empty()) {
    json["skipped"] = study.skipped;
    json["settings"] = ordered_json::array();
    return json;
  }
  if (study.knob.measure == Measure::light)
    json["truth"] = {{"samples", study.truthSamples}, {"bounces", study.truthBounces}};
  else if (study.knob.measure == Measure::scale)
    json.update(
        {{"added_noise", study.addedNoise}, {"compared_with", study.knowsTruth ? "phantom" : "itself"}});
  else
    json.update(
        {{"passes", panels[0].passes}, {"method", study.knob.sampled ? "sampled" : "as in the scene"}});
  json["settings"] = ordered_json::array();
  for (const StudySetting& setting : study.settings) json["settings"].push_back(settingJson(setting, size));
  json["reach"] = ordered_json::array();
  for (const double error : errorsToReach(study.knob.measure)) {
    const StudySetting* const setting = cheapest(study, error);
    ordered_json reach{{"error", panels[0].key}, {"at_most", error}};
    reach["value"] = setting ? ordered_json(setting->value) : ordered_json();
    json["reach"].push_back(reach);
  }
  if (!study.plot.empty()) json["plot"] = study.plot;
  return json;
}

// ---- Markdown

std::string passNames(const Panel& panel) {
  std::string names;
  for (const char* const pass : panel.passes) names += (names.empty() ? "" : " + ") + std::string(pass);
  return names;
}

void errorCells(std::ostream& out, const Errors& errors) {
  out << errors.missed << " | " << errors.invented << " | " << errors.undecided << " | "
      << tableNumber(errors.depthVoxels.median) << " | " << tableNumber(errors.depthVoxels.rms) << " | "
      << tableNumber(errors.depthVoxels.most99) << " | " << tableNumber(errors.depthVoxels.maximum) << " | "
      << tableNumber(errors.depthMm.rms) << " | " << tableNumber(errors.normalDegrees.rms) << " | "
      << tableNumber(100.0 * errors.curvature.median) << " | " << tableNumber(100.0 * errors.curvature.most99)
      << " |\n";
}

constexpr const char* kErrorHeads =
    "missed | invented | undecided | depth median, voxels | RMS | 99 % | largest | depth RMS, mm | normal "
    "RMS, ° | "
    "curvature median, % | 99 % |\n";
constexpr const char* kErrorRule = "---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";

void table(std::ostream& out, const KnobStudy& study) {
  const auto& panels = panelsOf(study.knob);
  const bool twice = panels[0].passes != panels[1].passes;
  out << "| " << study.knob.label << " | frame, ms | " << passNames(panels[0]) << ", ms | ";
  if (twice) out << passNames(panels[1]) << ", ms | ";
  out << kErrorHeads << "|---|---:|---:|" << (twice ? "---:|" : "") << kErrorRule;
  for (const StudySetting& setting : study.settings) {
    out << "| " << markedValue(setting) << " | " << tableNumber(setting.frameMilliseconds) << " | "
        << tableNumber(milliseconds(setting, panels[0])) << " | ";
    if (twice) out << tableNumber(milliseconds(setting, panels[1])) << " | ";
    errorCells(out, setting.errors);
  }
}

void fieldTable(std::ostream& out, const KnobStudy& study) {
  out << "\nAgainst `cubic_interpolating` in double precision, the field that passes through every "
         "sample:\n\n| "
      << study.knob.label << " | " << kErrorHeads << "|---|" << kErrorRule;
  for (const StudySetting& setting : study.settings)
    if (setting.fieldErrors) {
      out << "| " << markedValue(setting) << " | ";
      errorCells(out, *setting.fieldErrors);
    }
}

void reachLine(std::ostream& out, const KnobStudy& study) {
  const Panel& panel = panelsOf(study.knob)[0];
  out << "\nThe cheapest with a " << panel.label << ", of at most ";
  bool first = true;
  for (const double error : errorsToReach(study.knob.measure)) {
    const StudySetting* const setting = cheapest(study, error);
    out << (first ? "" : "; ") << base::shortestText(error) << ": ";
    first = false;
    if (!setting)
      out << "none";
    else if (setting->light)
      out << '`' << setting->value << "` (" << costText(study.knob, costOf(study.knob, *setting, panel))
          << ')';
    else
      out << '`' << setting->value << "` (" << tableNumber(milliseconds(*setting, panel)) << " ms"
          << (setting->scale ? "" : ", " + std::to_string(judged(*setting).missed) + " missed") << ')';
  }
  out << ".\n";
}

}  // namespace

std::string studyJson(const StudySubject& subject, const std::vector<KnobStudy>& studies, bool complete) {
  const volume::Grid& grid = subject.volume->grid();
  const glm::dvec3 spacing = grid.geometry().spacingMm();
  const render::ContextDescription& context = subject.context;
  ordered_json json;
  json["isolux_study"] = 1;
  json["version"] = version();
  json["complete"] = complete;
  json["machine"] = {{"processor", processorName()}, {"threads", tbb::this_task_arena::max_concurrency()}};
  addContext(json, context);
  json["volume"] = {{"name", subject.volume->volume.name},
                    {"data_hash", base::hexText(grid.hash())},
                    {"dims", {grid.dims().x, grid.dims().y, grid.dims().z}},
                    {"spacing_mm", {spacing.x, spacing.y, spacing.z}}};
  json["size"] = {subject.size.x, subject.size.y};
  json["repeat"] = subject.repeat;
  json["units"] = {{"milliseconds", "ms, median"},
                   {"ppm", "parts per million of the picture's pixels"},
                   {"depth_voxels", "voxels along the ray"},
                   {"depth_mm", "mm along the ray"},
                   {"normal_degrees", "degrees"},
                   {"curvature_relative", "1"},
                   {"rmse, bias, quantile_99, maximum", "irradiance, linear RGB radiance times steradian"},
                   {"lookup_milliseconds", "ms of the pass irradiance, median"}};
  json["knobs"] = ordered_json::array();
  for (const KnobStudy& study : studies) json["knobs"].push_back(knobJson(study, subject.size));
  json["scene"] = scene::toJson(subject.scene);
  return jsonText(json);
}

std::string studyMarkdown(const StudySubject& subject, const std::vector<KnobStudy>& studies, bool complete) {
  const glm::ivec3 dims = subject.volume->grid().dims();
  std::ostringstream out;
  out << "# What accuracy costs: " << subject.volume->volume.name << "\n\n"
      << dims.x << " x " << dims.y << " x " << dims.z << " voxels, isovalue "
      << tableNumber(*subject.scene.isosurface.value, 6) << ", picture " << subject.size.x << " x "
      << subject.size.y << ". " << subject.context.renderer << ", " << processorName() << "; medians of "
      << subject.repeat << " frames of each setting in turns.\n"
      << "Errors of surfaces are against double precision on the same fields, those of light against path "
         "tracing. "
         "Undecided: pixels whose answer hangs on "
         "the "
         "rounding of the ray.\n";
  if (!complete) out << "\n*Not complete: the study was stopped, or is still running.*\n";
  for (const KnobStudy& study : studies) {
    out << "\n## " << study.knob.name << " (`" << study.knob.setting << "`)\n\n";
    if (!study.skipped.empty()) {
      out << "Not studied: " << study.skipped << ".\n";
      continue;
    }
    if (study.knob.measure == Measure::light)
      writeLightTable(out, study, subject.size);
    else if (study.knob.measure == Measure::scale)
      writeScaleTable(out, study);
    else
      table(out, study);
    if (study.knob.field) fieldTable(out, study);
    reachLine(out, study);
    if (!study.plot.empty()) out << "\n![" << study.knob.label << "](" << study.plot << ")\n";
  }
  writeLightReach(out, studies);
  return out.str();
}

}  // namespace isolux::app
