// isolux render PATH --out FILE: one picture, or its deferred images, without a window.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/derivative_report.h"
#include "app/commands/progress_bar.h"
#include "app/documents/session.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/jobs/field_job.h"
#include "app/jobs/rest_scene.h"
#include "app/light/light_picture.h"
#include "app/light/light_report.h"
#include "app/version.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/quantiles.h"
#include "render/renderer.h"
#include "render/still_picture.h"
#include "scene/rules/automatic.h"
#include "scene/rules/ghosts.h"
#include "volume/cast/surface_caster.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorKind;
using nlohmann::ordered_json;

struct RenderOptions {
  std::string path, light, out, aov, stats;
  std::optional<std::string> size;
  bool explain = false;
  int repeat = 0;
  std::shared_ptr<render::ContextChoice> context;
  std::shared_ptr<SceneOptions> scene;
};

// Checked before anything slow starts.
render::FrameRequest requestOf(const RenderOptions& options, const scene::Scene& scene) {
  const std::string extension = fs::path(options.out).extension().string();
  if (extension != ".png" && extension != ".exr")
    throw Error(ErrorKind::usage, options.out, "", "the name of a picture must end in .png or .exr");
  render::FrameRequest request;
  request.size = pictureSize(options.size, options.path, *options.scene);
  request.supersampling = scene.picture.supersampling;
  request.linear = extension == ".exr";
  if (!options.aov.empty()) {
    request.linear = false;
    request.aovs = render::parseAovList(options.aov);
    if (extension != ".exr") throw Error(ErrorKind::usage, options.out, "", "--aov writes .exr files only");
    request.color = false;
    request.supersampling = 1;
  }
  return request;
}

struct Drawn {
  render::StillPicture picture;  // the last one
  double milliseconds = 0.0;     // median of the measured pictures
};

// One picture; or, to measure, one to warm up and `repeat` in which every pass runs again.
Drawn draw(render::Renderer& renderer, const scene::Scene& scene, const render::FrameRequest& request,
           int repeat, base::Progress& progress) {
  Drawn drawn;
  drawn.picture = render::drawStill(renderer, scene, request, progress);
  drawn.milliseconds = drawn.picture.report.milliseconds;
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    progress.throwIfStopped();
    progress.report(static_cast<double>(i) / repeat, "measuring");
    renderer.invalidate();
    drawn.picture = render::drawStill(renderer, scene, request, progress);
    times.push_back(drawn.picture.report.milliseconds);
  }
  if (!times.empty()) drawn.milliseconds = base::median(std::move(times));
  return drawn;
}

std::uint64_t peakBytes() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::uint64_t>(usage.ru_maxrss) * 1024;  // Linux counts in KiB
}

ordered_json statsJson(const RenderOptions& options, const scene::Scene& scene,
                       const render::FrameRequest& request, const volume::PreparedVolume& prepared,
                       const render::ContextDescription& context, const Drawn& drawn,
                       const LightController& light, const DerivativeFacts& derivatives) {
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
  json["repeat"] = options.repeat;
  json["blocks"] = {{"active", drawn.picture.report.blocksActive},
                    {"total", drawn.picture.report.blocksTotal}};
  const render::BrickReport& bricks = drawn.picture.report.bricks;
  json["bricks"] = {{"active", bricks.active},   {"resident", bricks.resident}, {"uploaded", bricks.uploaded},
                    {"evicted", bricks.evicted}, {"slots", bricks.slots},       {"total", bricks.total},
                    {"missing", bricks.missing}};
  const std::optional<render::EmptyPicture>& empty = drawn.picture.report.empty;
  json["empty"] = empty ? ordered_json(empty->reason) : ordered_json(nullptr);
  json["derivatives"] = derivativesJson(derivatives);
  json["hits"] = restJson(scene, prepared);
  json["bake"] = bakeJson(light.state());
  json["exposure"] = exposureJson(scene, light.light().get());
  json["gpu_bytes"] = drawn.picture.report.gpuBytes;
  json["peak_bytes"] = peakBytes();
  json["data_hash"] = base::hexText(prepared.grid().hash());
  json["read_seconds"] = prepared.readSeconds;
  json["prepare_seconds"] = prepared.prepareSeconds;
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
    std::printf("on the processor (%s): %s\n", volume::SurfaceCaster::target(), processor.c_str());
  const render::BrickReport& bricks = report.bricks;
  if (bricks.inUse)
    std::printf(
        "bricks: %zu of %zu hold the surface, %zu are resident in %zu slots, %zu uploaded, %zu replaced\n",
        bricks.active, bricks.total, bricks.resident, bricks.slots, bricks.uploaded, bricks.evicted);
  std::fflush(stdout);
}

void writePicture(const render::StillPicture& picture, const render::FrameRequest& request,
                  const RenderOptions& options, const scene::Scene& scene) {
  const fs::path out(options.out);
  const std::string session = sessionText(scene, out.parent_path());
  if (out.extension() == ".png")
    writePng(picture.color, out, session);
  else
    writeExr(request.linear ? &picture.linear : nullptr, picture.aovs, out, session);
}

void runRender(const RenderOptions& options, base::Progress& progress) {
  requireSource(options.path, *options.scene);
  scene::Scene scene = sceneOf(options.path, *options.scene);
  const scene::Machine machine = machineOf(*options.scene);
  const render::FrameRequest request = requestOf(options, scene);
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);  // before anything slow starts
  guard.reads(options.light, "the stored light");
  checkOutput(guard, options.out, "--out");
  checkOutput(guard, options.stats, "--stats");

  const auto prepared = loadWithProgressBar(scene.source, progress);
  const scene::Derivatives asked = scene.derivatives;
  scene = scene::resolve(std::move(scene), prepared->facts);
  const auto context = render::OffscreenContext::create(*options.context);
  context->makeCurrent();
  render::Renderer renderer(context->gl());
  renderer.setMachine(machine);
  renderer.setVolume(prepared);
  LightController light({.threads = machine.threads});
  Drawn drawn;
  std::optional<scene::Scene> shown;  // at rest
  {
    progress.report(0.0, "drawing");
    const ProgressBar bar(progress);
    if (!options.light.empty()) {
      light.setScene(litScene(scene, request), prepared);
      light.load(options.light, progress);
    }
    completeFields(scene, *prepared, !request.aovs.empty(), progress);
    lightPicture(light, renderer, scene, request, prepared, progress);
    if (request.aovs.empty()) shown = atRest(scene, *prepared, progress);
    progress.report(0.0, "drawing");
    drawn = draw(renderer, shown.value_or(scene), request, options.repeat, progress);
    progress.throwIfStopped();
    writePicture(drawn.picture, request, options, scene);
  }
  std::optional<DerivativeFacts> derivatives;
  if (!options.stats.empty() || options.explain)
    derivatives = derivativeFacts(renderer, asked, scene, request, drawn.picture.report, *prepared);
  if (!options.stats.empty())
    writeTextFile(options.stats, jsonText(statsJson(options, scene, request, *prepared,
                                                    context->description(), drawn, light, *derivatives)));
  if (options.explain) {
    printPasses(drawn.picture.report);
    printDerivatives(*derivatives);
    printRest(scene, *prepared);
    printBake(light.state());
    printExposure(scene, light.light().get());
  }
  for (const std::string& warning : light.state().warnings) printNote(warning);
  printWarnings(prepared->volume);
  if (const int missing = scene::ghostsWithoutRoom(scene))
    printNote("isosurface.ghost: " + std::to_string(missing) +
              " of the two ghosts is missing, because further isosurfaces are shown");
  if (drawn.picture.report.empty)
    std::fprintf(stderr, "isolux: note: the picture is empty: %s\n",
                 drawn.picture.report.empty->reason.c_str());
  for (const std::string& error : drawn.picture.report.glErrors)
    std::fprintf(stderr, "isolux: note: the graphics driver reports an error: %s\n", error.c_str());
  if (drawn.picture.report.bricks.missing > 0.0)
    std::fprintf(
        stderr,
        "isolux: note: %.2g %% of the picture is missing: memory.gpu_budget_mb is too small for this view\n",
        100.0 * drawn.picture.report.bricks.missing);
}

}  // namespace

Command makeRender(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("render", "Draw one picture to a file, without a window");
  auto options = std::make_shared<RenderOptions>();
  parser->add_option(
      "PATH", options->path,
      "A volume file, a DICOM folder, phantom:NAME[:SIZE], a session, or a .png that carries one");
  parser
      ->add_option("--out", options->out,
                   "The picture to write: .png (8 bit sRGB, with its session) or .exr (float)")
      ->type_name("FILE")
      ->required();
  parser
      ->add_option("--size", options->size,
                   "Pixels; default: those of the .png that the session comes from, else 1024x768")
      ->type_name("WxH");
  std::string known;
  for (const render::AovInfo& info : render::aovs())
    known += (known.empty() ? "" : ",") + std::string(info.name);
  parser
      ->add_option("--aov", options->aov,
                   "Write these deferred images to the .exr instead of the colours: " + known)
      ->type_name("LIST");
  parser
      ->add_option("--stats", options->stats,
                   "Write what was computed and what it cost as JSON (docs/commands.md)")
      ->type_name("FILE");
  parser
      ->add_option("--light", options->light,
                   "Take stored light from this file of `isolux bake`; what is missing is baked")
      ->type_name("FILE");
  parser->add_flag("--explain", options->explain,
                   "Print each pass, whether it ran, and why; and what is stored of the light");
  parser
      ->add_option("--repeat", options->repeat,
                   "Draw N frames after one to warm up; --stats has their median time")
      ->type_name("N")
      ->check(CLI::Range(0, 100000).description(""));
  options->context = addContextOption(*parser);
  addThreadsOption(*parser);
  options->scene = addSceneOptions(*parser);
  parser->footer(
      "Examples:\n"
      "  isolux render ct.nii.gz --isovalue 300 --out skull.png --size 1600x1200\n"
      "  isolux render phantom:torus --out torus.exr --aov position,normal\n"
      "  isolux render skull.png --set look.mode=normal --out normals.png");
  return {parser, [options](base::Progress& progress) { runRender(*options, progress); }};
}

}  // namespace isolux::app
