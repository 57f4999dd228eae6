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
#include "scene/rules/ghosts.h"
#include "volume/bricks/brick_source.h"
#include "volume/cast/surface_caster.h"

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
  return {{"read", source.bricksRead()},
          {"bytes", source.brickBytes()},
          {"file_bytes", source.bytesRead()},
          {"kept_bytes", source.bytesKept()},
          {"budget_bytes", source.budgetBytes()}};
}

}  // namespace

ordered_json renderJson(const scene::Scene& scene, const render::FrameRequest& request,
                        const volume::PreparedVolume& prepared, const render::ContextDescription& context,
                        const Drawn& drawn, const LightController& light, const DerivativeFacts& derivatives,
                        const std::optional<Accuracy>& accuracy) {
  ordered_json passes = ordered_json::array();
  for (const render::PassReport& pass : drawn.picture.report.passes)
    passes.push_back({{"name", pass.name},
                      {"state", render::nameOf(pass.state)},
                      {"reason", pass.reason},
                      {"milliseconds", pass.milliseconds},
                      {"bytes", pass.bytes},
                      {"executor", pass.onProcessor ? "cpu" : "gpu"}});
  ordered_json json;
  json["version"] = version();
  addContext(json, context);
  json["size"] = {request.size.x, request.size.y};
  json["supersampling"] = request.supersampling;
  json["isovalue"] = *scene.isosurface.value;
  json["passes"] = passes;
  json["frame_milliseconds"] = drawn.milliseconds;
  json["repeat"] = drawn.repeat;
  json["blocks"] = {{"active", drawn.picture.report.blocksActive},
                    {"total", drawn.picture.report.blocksTotal}};
  const render::BrickReport& bricks = drawn.picture.report.bricks;
  json["bricks"] = {
      {"active", bricks.active},   {"resident", bricks.resident}, {"uploaded", bricks.uploaded},
      {"evicted", bricks.evicted}, {"slots", bricks.slots},       {"total", bricks.total},
      {"missing", bricks.missing}, {"lost", bricks.lost},         {"lost_bricks", bricks.lostBricks}};
  const std::optional<render::EmptyPicture>& empty = drawn.picture.report.empty;
  json["empty"] = empty ? ordered_json(empty->reason) : ordered_json(nullptr);
  json["derivatives"] = derivativesJson(derivatives);
  json["hits"] = restJson(scene, prepared);
  json["bake"] = bakeJson(light.state());
  json["exposure"] = exposureJson(scene, light.light().get());
  json["accuracy"] = accuracy ? accuracyJson(*accuracy) : ordered_json(nullptr);
  const render::ProgramCounts& programs = drawn.picture.report.programs;
  json["programs"] = {{"compiled", programs.compiled}, {"cached", programs.cached}};
  json["image_bytes"] = drawn.picture.report.imageBytes;
  json["gpu_bytes"] = drawn.picture.report.gpuBytes;
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
  std::string processor;
  for (const render::PassReport& pass : report.passes)
    if (pass.onProcessor && pass.state != render::PassState::skipped)
      processor += (processor.empty() ? "" : ", ") + pass.name;
  if (!processor.empty())
    std::printf("on the CPU (%s): %s\n", volume::SurfaceCaster::target(), processor.c_str());
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

void noteOfPicture(const scene::Scene& scene, const render::FrameReport& report) {
  if (const int missing = scene::ghostsWithoutRoom(scene))
    printNote("isosurface.ghost: " + std::to_string(missing) +
              " of the two ghosts is missing, because further isosurfaces are shown");
  if (report.empty) printNote("the image is empty: " + report.empty->reason);
  for (const std::string& error : report.glErrors)
    printNote("the graphics driver reports an error: " + error);
  if (report.bricks.missing > 0.0)
    printNote(base::shortText(100.0 * report.bricks.missing, 2) +
              " % of the image is missing: memory.gpu_budget_mb is too small for this view; raise it");
}

}  // namespace isolux::app
