#include "app/report/render_report.h"

#include <sys/resource.h>

#include <algorithm>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "app/accuracy/accuracy_report.h"
#include "app/files/json_text.h"
#include "app/light/light_report.h"
#include "app/report/notes.h"
#include "app/version.h"
#include "base/number_text.h"
#include "base/words.h"
#include "volume/bricks/brick_source.h"
#include "volume/cast/surface_caster.h"
#include "volume/labels/shown_labels.h"

namespace isolux::app {

using nlohmann::ordered_json;

namespace {

std::uint64_t peakBytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

// Of a volume that stays in its file: what was read of it.
ordered_json partsJson(const volume::Grid& grid) {
  if (grid.isWhole()) return nullptr;
  const volume::BrickSource& source = *grid.source();
  const volume::BrickSource::Reads reads = source.reads();
  return {{"read", reads.bricks},
          {"bytes", reads.brickBytes},
          {"file_bytes", reads.fileBytes},
          {"kept_bytes", reads.keptBytes},
          {"budget_bytes", source.budgetBytes()}};
}

}  // namespace

ordered_json renderJson(const FinishedPicture& picture, const render::ContextDescription& context,
                        const LightController& light, const DerivativeFacts& derivatives) {
  const scene::Scene& scene = picture.inputs.scene;
  const volume::PreparedVolume& prepared = *picture.inputs.volume;
  const render::FrameReport& report = picture.still.report;
  ordered_json passes = ordered_json::array();
  for (const render::PassReport& pass : report.passes)
    passes.push_back({{"name", pass.name},
                      {"state", render::nameOf(pass.state)},
                      {"reason", pass.reason},
                      {"milliseconds", pass.milliseconds},
                      {"bytes", pass.bytes},
                      {"executor", pass.onProcessor ? "cpu" : "gpu"}});
  ordered_json json;
  json["version"] = version();
  addContext(json, context);
  json["size"] = picture.inputs.request.size;
  json["supersampling"] = picture.inputs.request.supersampling;
  json["isovalue"] = *scene.surfaces.front().value;
  json["passes"] = passes;
  json["frame_milliseconds"] = picture.milliseconds;
  json["repeat"] = picture.inputs.repeat;
  json["blocks"] = {{"active", report.blocksActive}, {"total", report.blocksTotal}};
  const render::BrickReport& bricks = report.bricks;
  json["bricks"] = {
      {"active", bricks.active},   {"resident", bricks.resident}, {"uploaded", bricks.uploaded},
      {"evicted", bricks.evicted}, {"slots", bricks.slots},       {"total", bricks.total},
      {"missing", bricks.missing}, {"lost", bricks.lost},         {"lost_bricks", bricks.lostBricks}};
  json["empty"] = report.empty ? ordered_json(report.empty->reason) : ordered_json();
  json["derivatives"] = derivativesJson(derivatives);
  json["hits"] = restJson(scene, prepared);
  json["bake"] = bakeJson(light.state());
  json["exposure"] = exposureJson(scene, light.light().get());
  json["accuracy"] = picture.accuracy ? accuracyJson(*picture.accuracy) : ordered_json();
  json["programs"] = {{"compiled", report.programs.compiled}, {"cached", report.programs.cached}};
  json["image_bytes"] = report.imageBytes;
  json["gpu_bytes"] = report.gpuBytes;
  json["peak_bytes"] = peakBytes();
  json["parts"] = partsJson(prepared.grid());
  json["data_hash"] = base::hexText(prepared.grid().hash());
  json["read_seconds"] = prepared.readSeconds;
  json["prepare_seconds"] = prepared.prepareSeconds;
  return json;
}

ordered_json levelJson(int level, const volume::Grid& grid, const std::optional<HiddenStructure>& structure) {
  if (level == 0) return nullptr;
  const glm::dvec3 thin = 2.0 * grid.geometry().spacingMm();
  ordered_json json{{"level", level}, {"may_hide_thinner_than_mm", std::max({thin.x, thin.y, thin.z})}};
  json["hides"] = structure ? ordered_json{{"blocks", structure->blocks}, {"share", structure->share()}}
                            : ordered_json(nullptr);
  return json;
}

void printPasses(const render::FrameReport& report) {
  std::size_t width = 4;
  for (const render::PassReport& pass : report.passes) width = std::max(width, pass.name.size());
  std::printf("%-*s  %-7s  %10s  %s\n", static_cast<int>(width), "pass", "state", "ms", "reason");
  for (const render::PassReport& pass : report.passes)
    std::printf("%-*s  %-7s  %10.3f  %s\n", static_cast<int>(width), pass.name.c_str(),
                render::nameOf(pass.state), pass.milliseconds, pass.reason.c_str());
  std::vector<std::string> processor;
  for (const render::PassReport& pass : report.passes)
    if (pass.onProcessor && pass.state != render::PassState::skipped) processor.push_back(pass.name);
  if (!processor.empty())
    std::printf("on the CPU (%s): %s\n", volume::SurfaceCaster::target(), base::joined(processor).c_str());
  const render::BrickReport& bricks = report.bricks;
  if (bricks.inUse)
    std::printf(
        "bricks: %zu of %zu hold the surface, %zu are resident in %zu slots, %zu uploaded, %zu replaced\n",
        bricks.active, bricks.total, bricks.resident, bricks.slots, bricks.uploaded, bricks.evicted);
  std::fflush(stdout);
}

std::string lostLine(const render::BrickReport& bricks) {
  return base::shortText(100.0 * bricks.lost, 2) +
         " % of the image is hatched, because the volume cannot be read there: " + bricks.lostReason;
}

std::vector<std::string> notesOf(const render::FrameReport& report) {
  std::vector<std::string> notes;
  if (report.empty) notes.push_back("the image is empty: " + report.empty->reason);
  for (const std::string& error : report.glErrors)
    notes.push_back("the graphics driver reports an error: " + error);
  if (report.bricks.missing > 0.0)
    notes.push_back(base::shortText(100.0 * report.bricks.missing, 2) +
                    " % of the image is missing: memory.gpu_budget_mb is too small for this view; raise it");
  return notes;
}

void noteOfPicture(const scene::Scene& scene, const render::FrameReport& report) {
  const bool labels = scene.source.kind == scene::DataKind::labels;
  const auto unnamed = std::ranges::count_if(scene.surfaces, [](const auto& s) { return s.labels.empty(); });
  if (labels && scene.source.labels != scene::kLabelsAsValues && unnamed > 1)
    printNote("surfaces: of those that name no labels (surfaces.ID.labels), only the first is drawn");
  for (const std::string& note : notesOf(report)) printNote(note);
}

}  // namespace isolux::app
