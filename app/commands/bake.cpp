// isolux bake PATH --out FILE.vti: the light of a volume's isosurfaces, as a file. Under an MPI launcher all
// ranks bake one file.
#include <algorithm>
#include <cstdio>
#include <optional>

#include <nlohmann/json.hpp>

#include "app/cluster/cluster_bake.h"
#include "app/cluster/mpi_ranks.h"
#include "app/cluster/rank_facts.h"
#include "app/commands/command.h"
#include "app/files/files.h"
#include "app/light/light_report.h"
#include "app/light/light_resume.h"
#include "app/runtime/progress_bar.h"
#include "base/error.h"
#include "base/number_text.h"
#include "gi/arithmetic.h"
#include "gi/file/bake_file.h"
#include "render/offscreen_renderer.h"
#include "scene/rules/needs.h"
#include "scene/settings/settings.h"
#include "scene/shown_surfaces.h"

namespace isolux::app {

namespace {

using nlohmann::ordered_json;
namespace fs = std::filesystem;

struct BakeOptions {
  std::string path, out, stats, size = "1024x768", part, arithmetic;
  double checkpointSeconds = 60.0;
  int pieces = 0;
  bool explain = false, overwrite = false, mixArithmetic = false;
  bool mpi = false, noMpi = false, sendVolume = false;
  CLI::Option* threads = nullptr;
  std::shared_ptr<render::ContextChoice> context;
  std::shared_ptr<SceneOptions> scene;
};

// "2/5"; empty: none.
std::optional<gi::LatticePart> partOf(const std::string& text) {
  if (text.empty()) return std::nullopt;
  const auto [index, count] = parsePart(text, gi::kMostParts);
  return gi::LatticePart{index, count};
}

// L.vti, or of a part L.part-2-of-5.vti.
fs::path fileOf(const fs::path& out, const std::optional<gi::LatticePart>& part) {
  if (!part) return out;
  std::string words = gi::partWords(*part);
  std::ranges::replace(words, ' ', '-');
  fs::path file = out;
  return file.replace_extension(words + ".vti");
}

// Which texels, in words that are the same for every part of a bake. `size`: of the view, "WxH"; `scene` is
// resolved.
std::string texelsText(const std::string& size, const scene::Scene& scene) {
  if (scene.gi.extent == scene::GiExtent::full) return "full";
  std::string text;
  if (scene.gi.extent == scene::GiExtent::band) {
    text = "band " + base::shortText(scene.gi.band->x, 17) + " " + base::shortText(scene.gi.band->y, 17);
  } else {
    text = "view " + size + " of";
    for (const glm::dvec3& point : {*scene.camera.eye, *scene.camera.target, *scene.camera.up})
      for (int a = 0; a < 3; ++a) text += " " + base::shortText(point[a], 17);
    text += scene.camera.projection == scene::Projection::orthographic ? " orthographic " : " ";
    text += base::shortText(scene.camera.fov, 17);
  }
  // What lookups read around a surface, and whose surface it is.
  const nlohmann::json settings = scene::toJson(scene);
  text += ", " + settings.at("gi").at("interpolation").dump() + " " + settings.at("hit").at("field").dump();
  text += ", surfaces";
  for (const scene::Surface& surface : scene::shownSurfaces(scene))
    text += " " + base::shortText(*surface.value, 17);
  return text;
}

// A bake is asked for: it needs no look that reads it, and where nobody has said which texels, it is all.
scene::Scene bakeScene(const BakeOptions& options, scene::Scene scene) {
  if (scene::shadingOf(scene) != scene::Shading::gi) scene.look.mode = scene::LookMode::gi;
  const auto& words = options.scene->assignments;
  const bool said =
      std::ranges::any_of(words, [](const std::string& word) { return word.starts_with("gi.extent"); });
  if (!said && scene.gi.extent == scene::Gi{}.extent) scene.gi.extent = scene::GiExtent::full;
  return scene;
}

gi::VisiblePointSet seenPoints(const BakeOptions& options, const scene::Scene& scene,
                               const std::shared_ptr<const volume::PreparedVolume>& prepared,
                               base::Progress& progress) {
  prepared->cubicFields->makeFor(scene, progress);
  render::OffscreenRenderer renderer(*options.context, hostSettingsOf(*options.scene));
  renderer->setVolume(prepared);
  render::FrameRequest request;
  request.size = parseSize(options.size);
  while (std::max(request.size.x, request.size.y) > 4096)
    request.size = glm::max(request.size / 2, glm::ivec2(1));
  request.color = scene::isTransparent(scene);  // what is behind is found where it is shaded
  request.aovs = std::vector{render::Aov::voxel};
  renderer->render(scene, request);
  return renderer->hitVoxels();
}

struct PreparedBake {
  scene::Scene scene;  // resolved
  std::shared_ptr<const volume::PreparedVolume> volume;
  std::optional<OutputLock> lock;  // of the file that is baked
};

fs::path indexOfPieces(const BakeOptions& options) {
  return fs::path(options.out).replace_extension(".pvti");
}

[[noreturn]] void refuseForeign(const fs::path& file, const char* what) {
  base::throwInput(file.string(), "",
                   std::string("holds something other than ") + what + "; --overwrite replaces it");
}

// Files under the names of the pieces and their index that hold something else.
void checkPieces(const fs::path& index, int pieces) {
  constexpr std::size_t searched = std::size_t{1} << 16;
  std::error_code missing;
  if (fs::exists(index, missing) && readBeginning(index, searched).find(".piece-1-of-") == std::string::npos)
    refuseForeign(index, "the index of baked light");
  for (int count = 1; count <= pieces; ++count)
    for (int number = 1; number <= count; ++number)
      if (const fs::path file = gi::bakePieceFile(index, number, count);
          fs::exists(file, missing) && !gi::looksLikeBakeFile(file))
        refuseForeign(file, "stored light");
}

// Checks all that can be checked before the light is computed.
PreparedBake prepareBake(const BakeOptions& options, const fs::path& out, base::Progress& progress) {
  if (fs::path(options.out).extension() != ".vti")
    base::throwUsage(options.out, "", "the name of a bake must end in .vti");
  if (options.pieces > 0 && !options.part.empty())
    base::throwUsage("", "--pieces", "a part of a bake has no pieces: merge it first");
  requireSource(options.path, *options.scene);
  PreparedBake bake;
  bake.scene = bakeScene(options, sceneOf(options.path, *options.scene));
  if (!scene::giChoiceOf(bake.scene).wanted)
    base::throwUsage("", "gi.mode", "nothing to bake: " + scene::giChoiceOf(bake.scene).reason);
  OutputGuard guard = outputGuard(options.path, *options.scene, bake.scene);
  checkOutput(guard, out.string(), "--out");
  if (options.pieces > 0) checkOutput(guard, indexOfPieces(options).string(), "--pieces");
  checkOutput(guard, options.stats, "--stats");
  bake.lock.emplace(out);
  std::error_code missing;
  if (!options.overwrite && fs::exists(out, missing) && !gi::looksLikeBakeFile(out))
    refuseForeign(out, "stored light");
  if (!options.overwrite && options.pieces > 0) checkPieces(indexOfPieces(options), options.pieces);
  bake.volume = loadWithProgressBar(bake.scene.source, progress);
  bake.scene = bakeScene(options, resolvedSceneOf(options.path, *options.scene, *bake.volume,
                                                  parseSize(options.size), progress));
  return bake;
}

void reportBake(const BakeOptions& options, const PreparedBake& bake, const LightState& state,
                const ordered_json& ranks) {
  if (!options.stats.empty()) {
    ordered_json json = bakeStats(state, bake.volume->grid());
    if (!ranks.is_null()) json["bake"]["ranks"] = ranks;
    writeTextFile(options.stats, jsonText(json));
  }
  if (options.explain) printBake(state);
  for (const std::string& warning : state.warnings) printNote(warning);
  printWarnings(bake.volume->volume);
}

void bakeHere(const BakeOptions& options, base::Progress& progress) {
  const auto part = partOf(options.part);
  const fs::path out = fileOf(options.out, part);
  const PreparedBake bake = prepareBake(options, out, progress);
  const scene::Scene& scene = bake.scene;
  LightController controller(
      {.threads = hostSettingsOf(*options.scene).threads, .innerSides = false, .part = part});
  std::string replaced;
  controller.setScene(scene, bake.volume);
  {
    const ProgressBar bar(progress);
    replaced = resumeBake(controller, out, part, options.mixArithmetic, progress);
    if (scene.gi.extent == scene::GiExtent::view)
      controller.setVisible(seenPoints(options, scene, bake.volume, progress));
    std::optional<gi::BakedPart> said;
    if (part)
      said = {*part, static_cast<std::uint32_t>(scene.gi.samples), texelsText(options.size, scene), false};
    bakeToFile(controller, out, said, options.checkpointSeconds, progress);
    if (options.pieces > 0)
      gi::writeBakePieces(indexOfPieces(options), options.pieces, bake.volume->grid(), controller.stored(),
                          progress);
  }
  if (!replaced.empty()) printNote(replaced);
  reportBake(options, bake, controller.state(), nullptr);
}

ClusterOptions clusterOptions(const BakeOptions& options) {
  return {.out = options.out,
          .checkpointSeconds = options.checkpointSeconds,
          .mixArithmetic = options.mixArithmetic,
          .sendVolume = options.sendVolume,
          .threads = hostSettingsOf(*options.scene).threads,
          .threadsAsked = options.threads->count() > 0 || hostSettingsOf(*options.scene).threads};
}

void bakeAsFirst(const BakeOptions& options, ClusterBake& cluster, base::Progress& progress) {
  if (!options.part.empty())
    base::throwUsage("", "--part", "under MPI all ranks bake one file; --no-mpi bakes parts");
  const PreparedBake bake = prepareBake(options, options.out, progress);
  ClusterResult result;
  {
    const ProgressBar bar(progress);
    ClusterScene scene{bake.scene, bake.volume, nullptr};
    if (bake.scene.gi.extent == scene::GiExtent::view)
      scene.seen = seenPoints(options, bake.scene, bake.volume, progress);
    result = cluster.run(options.path, std::move(scene), progress);
    if (options.pieces > 0)
      gi::writeBakePieces(indexOfPieces(options), options.pieces, bake.volume->grid(), result.light,
                          progress);
  }
  for (const std::string& note : result.notes) printNote(note);
  reportBake(options, bake, result.state, ranksJson(result.ranks));
}

void bakeAsOther(const BakeOptions& options, MpiRanks& ranks, base::Progress& progress) {
  const auto load = [&](const std::string& path, const scene::Source& source) {
    const bool same = path == options.path;
    return volume::loadVolume(same ? source : sceneOf(options.path, *options.scene).source, progress);
  };
  const auto unheard = serveClusterBake(ranks, clusterOptions(options), load, progress);
  if (!unheard) return ranks.end();
  std::fprintf(stderr, "isolux: %s\n", unheard->what());
  ranks.abort(static_cast<int>(unheard->kind()));
}

void bakeOverMpi(const BakeOptions& options, base::Progress& progress) {
  const std::unique_ptr<MpiRanks> ranks = connectMpi();
  if (ranks->rank() > 0) return bakeAsOther(options, *ranks, progress);
  ClusterBake cluster(*ranks, clusterOptions(options));
  int exitCode = 0;
  try {
    bakeAsFirst(options, cluster, progress);
    if (cluster.release()) return ranks->end();
  } catch (const base::Error& error) {
    if (error.kind() == base::ErrorKind::interrupted) throw;  // the launcher ends the others
    if (cluster.release()) {
      ranks->end();
      throw;
    }
    std::fprintf(stderr, "isolux: %s\n", error.what());
    exitCode = static_cast<int>(error.kind());
  }
  ranks->abort(exitCode);  // one stands still: MPI has no other way to leave it
}

void runBake(const BakeOptions& options, base::Progress& progress) {
  std::optional<gi::NoFusedArithmetic> lowered;
  if (!options.arithmetic.empty()) lowered.emplace();
  const bool launched = startedByMpi() && !options.noMpi;
  if (options.mpi || (launched && !isOnlyRank())) return bakeOverMpi(options, progress);
  bakeHere(options, progress);
  if (launched && !clusterOptions(options).threadsAsked && isBoundToOneCore())
    printNote(boundNote("the only rank", coresOfMachine()));
}

}  // namespace

Command makeBake(CLI::App& program) {
  CLI::App* const parser =
      program.add_subcommand("bake", "Bake the global illumination of a volume's isosurfaces to a file");
  auto options = std::make_shared<BakeOptions>();
  addPath(*parser, options->path);
  addOption(*parser, "--out", options->out, "FILE",
            "File to write (.vti, opens in ParaView); an interrupted bake of the same light resumes from it")
      ->required();
  addOption(*parser, "--stats", options->stats, "FILE",
            "Write results and costs as JSON (docs/reference/outputs.md)");
  addOption(*parser, "--size", options->size, "WxH",
            "Pixels of the view, with gi.extent=view; default 1024x768");
  addOption(*parser, "--part", options->part, "I/N",
            "Bake only part I of N, into FILE.part-I-of-N.vti. Parts may be baked anywhere, in any order; "
            "isolux merge joins them");
  parser->add_flag("--mix-arithmetic", options->mixArithmetic,
                   "Resume a bake from a CPU whose results differ in the last bits; the file records it");
  addOption(*parser, "--arithmetic", options->arithmetic, "no-fma",
            "no-fma: compute without fused multiply-add, as CPUs without AVX2 do; light is then "
            "bit-identical on both")
      ->check(oneOf({"no-fma"}));
  addOption(*parser, "--checkpoint", options->checkpointSeconds, "SECONDS",
            "Save the result so far every SECONDS; default 60")
      ->check(within(0.1, 1e6));
  addOption(*parser, "--pieces", options->pieces, "N",
            "Also write the light as N pieces and their index (.pvti, opens in ParaView)")
      ->check(within(1, 4096));
  CLI::Option* const mpi =
      parser->add_flag("--mpi", options->mpi, "Bake over MPI ranks even if no launcher's variables are set");
  parser->add_flag("--no-mpi", options->noMpi, "Bake alone, even under an MPI launcher")->excludes(mpi);
  parser->add_flag("--send-volume", options->sendVolume,
                   "With MPI: rank 0 reads the volume and sends it to all");
  parser->add_flag("--overwrite", options->overwrite, "Replace --out even if it is not baked light");
  parser->add_flag("--explain", options->explain, "Print what is baked, and why");
  options->context = addContextOption(*parser);
  addThreadsOption(*parser);
  options->threads = parser->get_option("--threads");
  options->scene = addSceneOptions(*parser);
  addVolumeOptions(*parser, options->scene);
  parser->footer(
      "All texels are lit unless gi.extent limits them.\n"
      "Examples:\n"
      "  isolux bake engine.nii.gz --environment probe.hdr --out engine_light.vti\n"
      "  isolux bake ct.nii.gz --set gi.extent=band --set gi.band=200,400 --out bone.vti --stats bone.json\n"
      "  isolux bake ct.nii.gz --out ct.vti --part 1/3\n"
      "  mpirun --bind-to none -n 4 isolux bake ct.nii.gz --out ct.vti\n"
      "  isolux render ct.nii.gz --look gi --light bone.vti --out bone.png");
  return {parser, [options](base::Progress& progress) { runBake(*options, progress); }};
}

}  // namespace isolux::app
