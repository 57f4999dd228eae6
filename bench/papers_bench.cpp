// The tables of Hadwiger et al. 2005 beside ours, as Markdown for docs/records/2026-11-paper-tables.md: the
// paper's way (sampled hits, four refinements, cubic derivatives by filtered lookups, shaders) and the
// defaults of this program.
#include <algorithm>
#include <cstdio>
#include <optional>

#include "bench/bench.h"
#include "bench/papers_light.h"
#include "bench/pass_times.h"
#include "render/gl/gl_context.h"
#include "scene/settings/settings.h"
#include "tests/support/test_data.h"

namespace isolux::bench {
namespace {

constexpr int rounds = 5;
const scene::HostSettings shaders{.executor = scene::Executor::gpu};

scene::Scene paperScene(std::optional<double> isovalue, scene::LookMode look) {
  scene::Scene scene;
  scene.surfaces.front().value = isovalue;
  scene.look.mode = look;
  scene.hit.method = scene::HitMethod::sampled;
  scene.hit.rate = 1.0;
  scene.derivatives.fetch = scene::Fetch::fast;
  scene.derivatives.scale = scene.derivatives.normalScale = 0.0;
  return scene;
}

scene::Scene ownScene(std::optional<double> isovalue, scene::LookMode look) {
  scene::Scene scene;
  scene.surfaces.front().value = isovalue;
  scene.look.mode = look;
  return scene;
}

double perSecond(double milliseconds) {
  return 1e3 / milliseconds;
}

// ---- Table 1
// ------------------------------------------------------------------------------------------------

// Ours stand in the order in which the frame ran them.
void printPasses(const render::OffscreenContext& context, const VolumePointer& volume) {
  const PassTimes times =
      passTimes({Frame(context.gl(), volume, paperScene({}, scene::LookMode::flow), 1, shaders)}, 1).front();
  std::printf(
      "\nTable 1, passes of a picture of flow (paper: 3 ray casting, 3 gradient, 6 Hessian, 1 curvature, "
      "1 shading)\n\nours:");
  for (const auto& [name, milliseconds] : times.passes) std::printf(" %s", name.c_str());
  std::printf("\n");
}

// ---- Table 2
// ------------------------------------------------------------------------------------------------

struct Figure {
  const char *paper, *grid;  // its data set and size
  double paperFps;           // 0: the paper has none
  const char *name, *path;   // ours; path: below the data folder, or a phantom
  int meshVoxels;
  std::optional<double> isovalue;
  scene::LookMode look;
};

std::vector<Figure> figures() {
  using Look = scene::LookMode;
  return {
      {"asian dragon, figure 1",
       "512×256×256",
       20.3,
       "bunny, κ1",
       "mesh/stanford-bunny.obj",
       256,
       {},
       Look::kappa1},
      {"asian dragon, figure 9",
       "512×256×256",
       24.0,
       "rocker arm, accessibility",
       "mesh/rocker-arm.obj",
       256,
       {},
       Look::accessibility},
      {"David's head, figure 1", "512×512×512", 15.3, "CT head, κ1", "volumes/ct_head_skin_bone.nii.gz", 0,
       0.51, Look::kappa1},
      {"David's head, figure 10", "512×512×512", 14.9, "CT head, flow", "volumes/ct_head_skin_bone.nii.gz", 0,
       0.51, Look::flow},
      {"David, figure 2", "576×352×1536", 10.3, "head phantom, κ1", "phantom:head:256", 0, {}, Look::kappa1},
      {"cube, figure 8",
       "64×64×64",
       29.6,
       "torus, mean curvature",
       "phantom:torus:64",
       0,
       {},
       Look::mean_curvature},
      {"dragon, figure 7", "512×512×256", 11.7, "spot, κ1", "mesh/spot.obj", 256, {}, Look::kappa1},
      {"CT of a head, figure 11", "512×512×333", 0.0, "CT head, lines", "volumes/ct_head_skin_bone.nii.gz", 0,
       0.51, Look::tone}};
}

VolumePointer volumeOf(const Figure& figure, const std::filesystem::path& data) {
  const std::string path = figure.path;
  scene::Source source;
  source.path = path.starts_with("phantom:") ? path : (data / path).string();
  if (figure.meshVoxels > 0) source.meshVoxels = figure.meshVoxels;
  base::Progress progress;
  return volume::loadVolume(source, progress);
}

void printFigure(const render::OffscreenContext& context, const Figure& figure, const VolumePointer& volume) {
  scene::Scene paper = paperScene(figure.isovalue, figure.look), own = ownScene(figure.isovalue, figure.look);
  if (figure.paperFps == 0.0)
    for (scene::Scene* scene : {&paper, &own}) {
      scene->look.ridges = 1.0;
      scene->look.contours = 1.0;
    }
  const std::vector<double> times =
      medians({Frame(context.gl(), volume, paper, 1, shaders), Frame(context.gl(), volume, own)}, rounds);
  const glm::ivec3 size = volume->grid().dims();
  std::printf("| %s, %s | ", figure.paper, figure.grid);
  if (figure.paperFps > 0.0) std::printf("%.1f", figure.paperFps);
  std::printf(" | %s, %d×%d×%d | %.2f | %.2f |\n", figure.name, size.x, size.y, size.z, perSecond(times[0]),
              perSecond(times[1]));
  std::fflush(stdout);
}

// ---- Table 3
// ------------------------------------------------------------------------------------------------

void printStages(const char* name, const PassTimes& times) {
  double sum = 0.0;
  for (const auto& [pass, milliseconds] : times.passes) sum += milliseconds;
  const auto share = [&](std::initializer_list<const char*> passes) {
    double part = 0.0;
    for (const char* pass : passes) part += times.of(pass);
    return 100.0 * part / sum;
  };
  const double bounding = share({"blocks", "segments"}), cast = share({"cast", "refine", "bricks"}),
               shape = share({"gradient", "hessian", "curvature"});
  std::printf("| %s | %.1f %% | %.1f %% | %.1f %% | %.1f %% |\n", name, bounding, cast, shape,
              100.0 - bounding - cast - shape);
}

// ---- Table 4
// ------------------------------------------------------------------------------------------------

void printRates(const render::OffscreenContext& context, const VolumePointer& volume) {
  std::printf("\n| adaptive sampling | bricks |");
  const std::vector<double> rates = {0.25, 0.5, 1.0, 2.0, 4.0, 8.0};
  for (const double rate : rates) std::printf(" %g |", rate);
  std::printf("\n|---|---|---:|---:|---:|---:|---:|---:|\n");
  std::vector<Frame> frames;
  struct Row {
    bool adaptive;
    scene::MemoryLayout layout;
    const char *adaptiveText, *layoutText;
    std::vector<double> paperFps;  // of the rates it has
  };
  const std::vector<Row> rows = {
      {false, scene::MemoryLayout::whole, "no", "none", {33.2, 29.0, 22.7, 16.9, 12.4}},
      {false, scene::MemoryLayout::bricks, "no", "32", {23.8, 19.5, 16.1, 11.7, 7.2}},
      {true, scene::MemoryLayout::whole, "r1 = 8 r0", "none", {34.6, 27.4, 20.3, 15.2}},
      {true, scene::MemoryLayout::bricks, "r1 = 8 r0", "32", {19.2, 13.8, 10.2, 6.9}}};
  for (const Row& row : rows)
    for (const double rate : rates) {
      if (row.adaptive && rate < 1.0) continue;  // r0 = r1 / 8 is no less than 1/8
      scene::Scene scene = paperScene({}, scene::LookMode::kappa1);
      scene.hit.rate = row.adaptive ? rate / 8.0 : rate;
      scene.hit.nearFactor = row.adaptive ? 8.0 : 1.0;
      frames.emplace_back(
          context.gl(), volume, scene, 1,
          scene::HostSettings{.memory = {.layout = row.layout}, .executor = scene::Executor::gpu});
    }
  const std::vector<PassTimes> times = passTimes(frames, rounds);
  std::size_t next = 0;
  for (const Row& row : rows) {
    std::printf("| %s | %s |", row.adaptiveText, row.layoutText);
    std::size_t paper = 0;
    for (const double rate : rates) {
      if (row.adaptive && rate < 1.0) {
        std::printf(" |");
        continue;
      }
      std::printf(" %.2f", perSecond(times[next++].frame));
      if (paper < row.paperFps.size()) std::printf(" : %.1f", row.paperFps[paper++]);
      std::printf(" |");
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

void run() {
  const std::filesystem::path data = test::dataFolder();
  if (data.empty()) {
    std::printf("  skipped: the shared data folder is not there\n");
    return;
  }
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  std::printf("Hadwiger et al. 2005 on %s; 512 × 512, every pass of every frame\n",
              context->description().renderer.c_str());
  const std::vector<Figure> list = figures();
  const VolumePointer dragon = volumeOf(list.front(), data);
  printPasses(*context, dragon);
  std::printf(
      "\nTable 2, pictures per second\n\n| paper | GeForce 6800 | ours | the paper's way | defaults |\n"
      "|---|---:|---|---:|---:|\n");
  for (const Figure& figure : list) printFigure(*context, figure, volumeOf(figure, data));
  std::printf(
      "\nTable 3, share of a picture's time\n\n| | bounding geometry | ray-cast | differential properties "
      "| shading |\n|---|---:|---:|---:|---:|\n| paper | 1.7 %% | 66.1 %% | 31.0 %% | 1.1 %% |\n");
  const std::vector<PassTimes> stages =
      passTimes({Frame(context->gl(), dragon, paperScene({}, scene::LookMode::kappa1), 1, shaders),
                 Frame(context->gl(), dragon, ownScene({}, scene::LookMode::kappa1))},
                rounds);
  printStages("the paper's way, shaders", stages[0]);
  printStages("defaults", stages[1]);
  std::printf("\nTable 4, pictures per second at sampling rates (adaptive: r1), ours : paper\n");
  printRates(*context, dragon);
  printPapersLight(*context, data);
}

const Registration registration("papers", "every table of Hadwiger et al. 2005 and Wyman et al. 2006", run);

}  // namespace
}  // namespace isolux::bench
