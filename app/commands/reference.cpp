// isolux reference PATH --out FILE: every pixel path traced, without stored light.
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/commands/command.h"
#include "app/documents/picture_scene.h"
#include "app/documents/session.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/files/reference_image.h"
#include "app/runtime/progress_bar.h"
#include "app/version.h"
#include "base/clock.h"
#include "base/color.h"
#include "base/error.h"
#include "base/number_text.h"
#include "gi/reference/reference.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using Clock = std::chrono::steady_clock;

constexpr double kSecondsBetweenWrites = 5.0;  // of the picture so far, which an interrupt leaves

struct ReferenceOptions {
  std::string path, out, stats;
  std::optional<std::string> size;
  std::uint32_t samples = 256;
  std::shared_ptr<SceneOptions> scene;
};

ordered_json statsJson(const ReferenceOptions& options, const gi::ReferenceImage& image,
                       std::size_t litPixels, int threads, double seconds,
                       const volume::PreparedVolume& prepared) {
  std::size_t hits = 0;
  double sum = 0.0, variance = 0.0, errors = 0.0;
  for (std::size_t i = 0; i < image.hit.size(); ++i) {
    if (!image.hit[i]) continue;
    ++hits;
    sum += base::luminance(glm::dvec3(image.irradiance[i]));
    if (image.samples[i] < 2) continue;
    variance += static_cast<double>(image.variance[i]);
    errors += 1.0;
  }
  ordered_json json;
  json["version"] = version();
  json["size"] = image.size;
  json["samples"] = options.samples;
  json["pixels_hit"] = hits;
  json["pixels_traced"] = litPixels;
  json["mean_irradiance"] = hits > 0 ? ordered_json(sum / static_cast<double>(hits)) : ordered_json();
  // Root mean square over the pixels; luminance of E.
  json["standard_error"] = errors > 0.0 ? ordered_json(std::sqrt(variance / errors)) : ordered_json();
  json["rays"] = image.rays;
  json["capped_paths"] = image.cappedPaths;
  json["seconds"] = seconds;
  json["threads"] = threads;
  json["data_hash"] = base::hexText(prepared.grid().hash());
  return json;
}

void writePicture(const gi::ReferenceImage& image, const scene::Scene& scene, const fs::path& out,
                  const std::string& session) {
  if (out.extension() == ".png")
    writePng(screenImage(image, scene), out, session);
  else
    writeReferenceExr(image, out, session);
}

void runReference(const ReferenceOptions& options, base::Progress& progress) {
  const fs::path out(options.out);
  if (out.extension() != ".exr" && out.extension() != ".png")
    base::throwUsage(options.out, "", "the name of a reference image must end in .exr or .png");
  requireSource(options.path, *options.scene);
  scene::Scene scene = sceneOf(options.path, *options.scene);
  gi::Reference::Options reference{pictureSize(options.size, options.path, *options.scene),
                                   hostSettingsOf(*options.scene).threads.value_or(threadsInForce())};
  reference.meterView = !startsFromSession(options.path, *options.scene);  // as `isolux render` does
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);    // before anything slow starts
  checkOutput(guard, options.out, "--out");
  checkOutput(guard, options.stats, "--stats");
  const OutputLock lock(out);
  const auto prepared = loadWithProgressBar(scene.source, progress);
  const scene::Scene given = sceneOf(options.path, *options.scene, *prepared);
  scene = resolvedSceneOf(options.path, *options.scene, *prepared, reference.size, progress);
  const Clock::time_point start = Clock::now();
  double seconds = 0.0;
  gi::ReferenceImage image;
  std::size_t litPixels = 0;
  {
    progress.report(0.0, "preparing");
    const ProgressBar bar(progress);
    const auto environment = gi::loadEnvironment(scene.light.environment);
    const auto tracer = gi::lightTracerOf(scene, prepared, progress);
    gi::Reference picture(prepared, tracer, environment, scene, reference, progress);
    litPixels = picture.litPixels();
    scene::Scene carried = carriedScene(given, scene);
    if (reference.meterView) carried.picture.exposure = picture.exposure();
    const std::string session = sessionText(carried, out.parent_path());
    std::optional<Clock::time_point> written;
    double done = 0.0;
    for (const std::uint32_t round : gi::referenceRounds(options.samples)) {
      const double to = static_cast<double>(round) / options.samples;
      if (!picture.refineTo(round, progress, done, to)) break;
      done = to;
      if (round == options.samples || (written && base::secondsSince(*written) < kSecondsBetweenWrites))
        continue;
      writePicture(picture.image(), scene, out, session);  // an interrupt leaves it
      written = Clock::now();
    }
    seconds = base::secondsSince(start);
    image = picture.image();
    progress.report(1.0, "writing");
    writePicture(image, scene, out, session);
  }
  if (!options.stats.empty())
    writeTextFile(options.stats,
                  jsonText(statsJson(options, image, litPixels, reference.threads, seconds, *prepared)));
  progress.throwIfStopped();
  printWarnings(prepared->volume);
  if (image.cappedPaths > 0)
    std::fprintf(stderr,
                 "isolux: note: %llu paths were ended after %d bounces: light is missing where they were\n",
                 static_cast<unsigned long long>(image.cappedPaths), gi::kMostBounces);
}

}  // namespace

Command makeReference(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "reference", "Path trace every pixel, without baked light: the reference for look gi");
  auto options = std::make_shared<ReferenceOptions>();
  addPath(*parser, options->path, Opens::pictures);
  addOption(*parser, "--out", options->out, "FILE",
            "Image to write: .exr (float; channels: docs/reference/outputs.md) or .png (8 bit sRGB)")
      ->required();
  addOption(*parser, "--spp", options->samples, "N", "Light paths per pixel; default 256")
      ->check(within(1, 1000000));
  addOption(*parser, "--size", options->size, "WxH",
            "Pixels; default: those of the session's .png, otherwise 1024x768");
  addOption(*parser, "--stats", options->stats, "FILE",
            "Write results and costs as JSON (docs/reference/outputs.md)");
  addThreadsOption(*parser);
  options->scene = addSceneOptions(*parser);
  addVolumeOptions(*parser, options->scene);
  parser->footer(
      "Ctrl-C keeps the image as of at most a few seconds before. Examples:\n"
      "  isolux reference phantom:head --set light.environment.file=sky.hdr --out head.exr\n"
      "  isolux reference picture.png --spp 4096 --set gi.bounces=4 --out truth.exr");
  return {parser, [options](base::Progress& progress) { runReference(*options, progress); }};
}

}  // namespace isolux::app
