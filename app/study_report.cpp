#include "app/study_report.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <sstream>

#include <tbb/task_arena.h>
#include <nlohmann/json.hpp>

#include "app/commands/command.h"
#include "app/files.h"
#include "app/version.h"
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

ordered_json settingJson(const StudySetting& setting) {
  ordered_json json{{"value", setting.value},
                    {"default", setting.isDefault},
                    {"comparison", setting.comparison},
                    {"frame_milliseconds", setting.frameMilliseconds},
                    {"pass_milliseconds", setting.passMilliseconds},
                    {"errors", errorsJson(setting.errors)}};
  if (setting.fieldErrors) json["field_errors"] = errorsJson(*setting.fieldErrors);
  return json;
}

ordered_json knobJson(const KnobStudy& study) {
  const auto& panels = panelsOf(study.knob.measure);
  ordered_json json{{"name", study.knob.name},
                    {"setting", study.knob.setting},
                    {"label", study.knob.label},
                    {"passes", panels[0].passes},
                    {"method", study.knob.sampled ? "sampled" : "as in the scene"}};
  json["settings"] = ordered_json::array();
  for (const StudySetting& setting : study.settings) json["settings"].push_back(settingJson(setting));
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

std::string number(double value, int digits = 3) {
  if (!std::isfinite(value)) return "–";
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*g", digits, value);
  return text.data();
}

std::string passNames(const Panel& panel) {
  std::string names;
  for (const char* const pass : panel.passes) names += (names.empty() ? "" : " + ") + std::string(pass);
  return names;
}

std::string marked(const StudySetting& setting) {
  return setting.isDefault ? "**" + setting.value + "** (default)" : setting.value;
}

void errorCells(std::ostream& out, const Errors& errors) {
  out << errors.missed << " | " << errors.invented << " | " << errors.undecided << " | "
      << number(errors.depthVoxels.median) << " | " << number(errors.depthVoxels.rms) << " | "
      << number(errors.depthVoxels.most99) << " | " << number(errors.depthVoxels.maximum) << " | "
      << number(errors.depthMm.rms) << " | " << number(errors.normalDegrees.rms) << " | "
      << number(100.0 * errors.curvature.median) << " | " << number(100.0 * errors.curvature.most99)
      << " |\n";
}

constexpr const char* kErrorHeads =
    "missed | invented | undecided | depth median, voxels | RMS | 99 % | largest | depth RMS, mm | normal "
    "RMS, ° | "
    "curvature median, % | 99 % |\n";
constexpr const char* kErrorRule = "---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";

void table(std::ostream& out, const KnobStudy& study) {
  const auto& panels = panelsOf(study.knob.measure);
  const bool twice = panels[0].passes != panels[1].passes;
  out << "| " << study.knob.label << " | frame, ms | " << passNames(panels[0]) << ", ms | ";
  if (twice) out << passNames(panels[1]) << ", ms | ";
  out << kErrorHeads << "|---|---:|---:|" << (twice ? "---:|" : "") << kErrorRule;
  for (const StudySetting& setting : study.settings) {
    out << "| " << marked(setting) << " | " << number(setting.frameMilliseconds) << " | "
        << number(milliseconds(setting, panels[0])) << " | ";
    if (twice) out << number(milliseconds(setting, panels[1])) << " | ";
    errorCells(out, setting.errors);
  }
}

void fieldTable(std::ostream& out, const KnobStudy& study) {
  out << "\nAgainst `cubic_interpolating` in double precision, the field that passes through every "
         "sample:\n\n| "
      << study.knob.label << " | " << kErrorHeads << "|---|" << kErrorRule;
  for (const StudySetting& setting : study.settings)
    if (setting.fieldErrors) {
      out << "| " << marked(setting) << " | ";
      errorCells(out, *setting.fieldErrors);
    }
}

void reachLine(std::ostream& out, const KnobStudy& study) {
  const Panel& panel = panelsOf(study.knob.measure)[0];
  out << "\nThe cheapest with a " << panel.label << ", of at most ";
  bool first = true;
  for (const double error : errorsToReach(study.knob.measure)) {
    const StudySetting* const setting = cheapest(study, error);
    out << (first ? "" : "; ") << numberText(error) << ": ";
    first = false;
    if (setting)
      out << '`' << setting->value << "` (" << number(milliseconds(*setting, panel)) << " ms, "
          << judged(*setting).missed << " missed)";
    else
      out << "none";
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
                    {"data_hash", hashText(grid.hash())},
                    {"dims", {grid.dims().x, grid.dims().y, grid.dims().z}},
                    {"spacing_mm", {spacing.x, spacing.y, spacing.z}}};
  json["size"] = {subject.size.x, subject.size.y};
  json["repeat"] = subject.repeat;
  json["units"] = {{"milliseconds", "ms, median"},
                   {"ppm", "parts per million of the picture's pixels"},
                   {"depth_voxels", "voxels along the ray"},
                   {"depth_mm", "mm along the ray"},
                   {"normal_degrees", "degrees"},
                   {"curvature_relative", "1"}};
  json["knobs"] = ordered_json::array();
  for (const KnobStudy& study : studies) json["knobs"].push_back(knobJson(study));
  json["scene"] = scene::toJson(subject.scene);
  return jsonText(json);
}

std::string studyMarkdown(const StudySubject& subject, const std::vector<KnobStudy>& studies, bool complete) {
  const glm::ivec3 dims = subject.volume->grid().dims();
  std::ostringstream out;
  out << "# What accuracy costs: " << subject.volume->volume.name << "\n\n"
      << dims.x << " x " << dims.y << " x " << dims.z << " voxels, isovalue "
      << number(*subject.scene.isosurface.value, 6) << ", picture " << subject.size.x << " x "
      << subject.size.y << ". " << subject.context.renderer << ", " << processorName() << "; medians of "
      << subject.repeat << " frames of each setting in turns.\n"
      << "Errors are against double precision on the same fields. Undecided: pixels whose answer hangs on "
         "the "
         "rounding of the ray.\n";
  if (!complete) out << "\n*Not complete: the study was stopped, or is still running.*\n";
  for (const KnobStudy& study : studies) {
    out << "\n## " << study.knob.name << " (`" << study.knob.setting << "`)\n\n";
    table(out, study);
    if (study.knob.field) fieldTable(out, study);
    reachLine(out, study);
    if (!study.plot.empty()) out << "\n![" << study.knob.label << "](" << study.plot << ")\n";
  }
  return out.str();
}

}  // namespace isolux::app
