// isolux bake PATH --out FILE.vti: the light of a volume's isosurfaces, as a file.
#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>

#include "app/commands/command.h"
#include "app/commands/progress_bar.h"
#include "app/files/files.h"
#include "app/light/light_picture.h"
#include "app/light/light_report.h"
#include "app/version.h"
#include "base/error.h"
#include "base/number_text.h"
#include "gi/file/bake_file.h"
#include "scene/rules/relevance.h"
#include "scene/settings.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

constexpr double checkpointSeconds = 60.0;

struct BakeOptions {
  std::string path, out, stats, size = "1024x768", part;
  bool explain = false, overwrite = false, mixArithmetic = false;
  std::shared_ptr<render::ContextChoice> context;
  std::shared_ptr<SceneOptions> scene;
};

// A bake is asked for: it needs no look that reads it, and where nobody has said which texels, it is all.
scene::Scene bakeScene(const BakeOptions& options, scene::Scene scene) {
  if (scene::shadingOf(scene) != scene::Shading::gi) scene.look.mode = scene::LookMode::gi;
  const auto& words = options.scene->assignments;
  const bool said = std::any_of(words.begin(), words.end(),
                                [](const std::string& word) { return word.starts_with("gi.extent"); });
  if (!said && scene.gi.extent == scene::Gi{}.extent) scene.gi.extent = scene::GiExtent::full;
  return scene;
}

void seeView(LightController& controller, const BakeOptions& options, const scene::Scene& scene,
             const std::shared_ptr<const volume::PreparedVolume>& prepared, base::Progress& progress) {
  prepared->cubicFields->makeFor(scene, progress);
  const auto context = render::OffscreenContext::create(*options.context);
  context->makeCurrent();
  render::Renderer renderer(context->gl());
  renderer.setMachine(machineOf(*options.scene));
  renderer.setVolume(prepared);
  render::FrameRequest request;
  request.size = parseSize(options.size);
  while (std::max(request.size.x, request.size.y) > 4096)
    request.size = glm::max(request.size / 2, glm::ivec2(1));
  request.color = false;
  request.aovs = {render::Aov::voxel};
  renderer.render(scene, request);
  controller.setVisible(renderer.hitVoxels());
}

std::optional<gi::LatticePart> partOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  gi::LatticePart part;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, part.index);
  const bool slash = index.ec == std::errc() && index.ptr != end && *index.ptr == '/';
  const auto count = slash ? std::from_chars(index.ptr + 1, end, part.count) : index;
  if (!slash || count.ec != std::errc() || count.ptr != end || part.index < 1 || part.index > part.count ||
      part.count > gi::kMostParts)
    throw base::Error(base::ErrorKind::usage, "", "--part",
                      "\"" + text + "\" is not i/n, such as 2/5: part i of n, 1 <= i <= n");
  return part;
}

// L.vti, or of a part L.part-2-of-5.vti.
fs::path fileOf(const fs::path& out, const std::optional<gi::LatticePart>& part) {
  if (!part) return out;
  std::string words = gi::partWords(*part);
  std::replace(words.begin(), words.end(), ' ', '-');
  fs::path file = out;
  return file.replace_extension(words + ".vti");
}

// Which texels, in words that are the same for every part of a bake.
std::string texelsText(const BakeOptions& options, const scene::Scene& scene) {
  if (scene.gi.extent == scene::GiExtent::full) return "full";
  std::string text;
  if (scene.gi.extent == scene::GiExtent::band) {
    text = "band " + base::shortText(scene.gi.band->x, 17) + " " + base::shortText(scene.gi.band->y, 17);
  } else {
    text = "view " + options.size + " of";
    for (const glm::dvec3& point : {*scene.camera.eye, *scene.camera.target, *scene.camera.up})
      for (int a = 0; a < 3; ++a) text += " " + base::shortText(point[a], 17);
    text += scene.camera.projection == scene::Projection::orthographic ? " orthographic " : " ";
    text += base::shortText(scene.camera.fov, 17);
  }
  // What lookups read around a surface, and whose surface it is.
  const nlohmann::json settings = scene::toJson(scene);
  text += ", " + settings.at("gi").at("interpolation").dump() + " " + settings.at("hit").at("field").dump();
  text += ", surfaces " + base::shortText(*scene.isosurface.value, 17);
  for (const scene::ExtraIsosurface& extra : scene.extraIsosurfaces)
    if (extra.shown) text += " " + base::shortText(*extra.value, 17);
  return text;
}

// Goes on with a file of the same light; other light is replaced, as any picture would be. Returns why.
std::string resume(LightController& controller, const fs::path& out, const BakeOptions& options,
                   base::Progress& progress) {
  std::error_code missing;
  if (!fs::exists(out, missing)) return {};
  gi::BakeFacts facts;
  try {
    facts = controller.load(out, progress);
  } catch (const base::Error& error) {
    if (error.kind() != base::ErrorKind::input) throw;
    return error.reason();
  }
  const auto wanted = partOf(options.part);
  if (wanted && (!facts.part || facts.part->part != *wanted))
    base::throwInput(
        out.string(), "Array part",
        (facts.part ? "is " + gi::partWords(facts.part->part) : "is missing: this is a whole bake") +
            ", not " + gi::partWords(*wanted));
  const std::string here = controller.arithmetic();
  if (!options.mixArithmetic && !facts.arithmetic.empty() && facts.arithmetic != here)
    base::throwInput(
        out.string(), "Array arithmetic",
        "is \"" + facts.arithmetic + "\", and this machine's \"" + here +
            "\": the last bits of the light differ; --mix-arithmetic goes on, and the file says so");
  return {};
}

void runBake(const BakeOptions& options, base::Progress& progress) {
  if (fs::path(options.out).extension() != ".vti")
    throw base::Error(base::ErrorKind::usage, options.out, "", "the name of a bake must end in .vti");
  const auto part = partOf(options.part);
  const fs::path out = fileOf(options.out, part);
  requireSource(options.path, *options.scene);
  scene::Scene scene = bakeScene(options, sceneOf(options.path, *options.scene));
  if (!scene::giChoiceOf(scene).wanted)
    throw base::Error(base::ErrorKind::usage, "", "gi.mode",
                      "there is nothing to bake: " + scene::giChoiceOf(scene).reason);
  OutputGuard guard = outputGuard(options.path, *options.scene, scene);
  checkOutput(guard, out.string(), "--out");
  checkOutput(guard, options.stats, "--stats");
  std::error_code missing;
  if (!options.overwrite && fs::exists(out, missing) && !gi::looksLikeBakeFile(out))
    base::throwInput(out.string(), "", "holds something other than stored light; --overwrite replaces it");
  const auto prepared = loadWithProgressBar(scene.source, progress);
  scene = bakeScene(
      options, resolvedSceneOf(options.path, *options.scene, *prepared, parseSize(options.size), progress));

  LightController controller(
      {.threads = machineOf(*options.scene).threads, .innerSides = false, .part = part});
  std::string replaced;
  controller.setScene(scene, prepared);
  {
    const ProgressBar bar(progress);
    replaced = resume(controller, out, options, progress);
    if (scene.gi.extent == scene::GiExtent::view) seeView(controller, options, scene, prepared, progress);
    // What there is, also when it ends here: writing is not stopped.
    base::Progress writing;
    std::optional<gi::BakedPart> said;
    if (part) said = {*part, static_cast<std::uint32_t>(scene.gi.samples), texelsText(options, scene), false};
    while (!controller.finish(progress, checkpointSeconds)) {
      controller.save(out, writing, said);
      progress.throwIfStopped();
    }
    if (said) said->complete = true;
    controller.save(out, writing, said);
  }
  if (!replaced.empty()) printNote(out.string() + " held other light and was replaced: " + replaced);
  const LightState state = controller.state();
  if (!options.stats.empty()) {
    ordered_json json;
    json["version"] = version();
    json["bake"] = bakeJson(state);
    json["data_hash"] = base::hexText(prepared->grid().hash());
    writeTextFile(options.stats, jsonText(json));
  }
  if (options.explain) printBake(state);
  for (const std::string& warning : state.warnings) printNote(warning);
  printWarnings(prepared->volume);
}

}  // namespace

Command makeBake(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("bake", "Compute the light of a volume's isosurfaces and write it to a file");
  auto options = std::make_shared<BakeOptions>();
  parser->add_option("PATH", options->path,
                     "A volume file, a DICOM folder, phantom:NAME[:SIZE], or a session");
  parser
      ->add_option(
          "--out", options->out,
          "The file to write (.vti, opens in ParaView); an interrupted bake of the same light goes on "
          "from it")
      ->type_name("FILE")
      ->required();
  parser->add_option("--stats", options->stats, "Write what was computed and what it cost as JSON")
      ->type_name("FILE");
  parser->add_option("--size", options->size, "Pixels of the view, with gi.extent=view; default 1024x768")
      ->type_name("WxH");
  parser
      ->add_option(
          "--part", options->part,
          "Only part i of n, into FILE.part-i-of-n.vti: parts are baked anywhere, in any order, and put "
          "together by isolux merge")
      ->type_name("I/N");
  parser->add_flag(
      "--mix-arithmetic", options->mixArithmetic,
      "Go on with a bake that was begun on a processor whose last bits differ; the file says so");
  parser->add_flag("--overwrite", options->overwrite,
                   "Replace --out also where it is something other than stored light");
  parser->add_flag("--explain", options->explain, "Print what is stored, and why");
  options->context = addContextOption(*parser);
  addThreadsOption(*parser);
  options->scene = addSceneOptions(*parser);
  addVolumeOptions(*parser, options->scene);
  parser->footer(
      "All texels are lit unless gi.extent says otherwise.\n"
      "Examples:\n"
      "  isolux bake engine.nii.gz --environment probe.hdr --out engine_light.vti\n"
      "  isolux bake ct.nii.gz --set gi.extent=band --set gi.band=200,400 --out bone.vti --stats bone.json\n"
      "  isolux bake ct.nii.gz --out ct.vti --part 1/3\n"
      "  isolux render ct.nii.gz --look gi --light bone.vti --out bone.png");
  return {parser, [options](base::Progress& progress) { runBake(*options, progress); }};
}

}  // namespace isolux::app
