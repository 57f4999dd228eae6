#include "app/report/machine_report.h"

#include <unistd.h>

#include <algorithm>
#include <limits>

#include <tbb/info.h>
#include <tbb/version.h>
#include <CLI/Version.hpp>
#include <glm/glm.hpp>

#include "app/report/notes.h"
#include "app/runtime/external_program.h"
#include "app/runtime/program_store.h"
#include "app/version.h"
#include "base/memory_budget.h"
#include "base/number_text.h"
#include "render/gl/gl.h"
#include "render/gl/gl_context.h"
#include "render/gl/program_cache.h"
#include "render/graph/pass.h"
#include "render/passes/processor.h"
#include "render/renderer.h"
#include "scene/rules/automatic.h"
#include "volume/cast/surface_caster.h"
#include "volume/prepared/prepared_volume.h"
#include "volume/read/process/foreign.h"

namespace isolux::app {

namespace {

std::string memoryText() {
  const auto page = static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
  const auto pages = [page](int name) {
    return page * static_cast<std::uint64_t>(std::max(::sysconf(name), 0L));
  };
  return base::memoryText(pages(_SC_PHYS_PAGES)) + ", " + base::memoryText(pages(_SC_AVPHYS_PAGES)) + " free";
}

std::string dotted(int major, int minor, int patch) {
  return std::to_string(major) + '.' + std::to_string(minor) + '.' + std::to_string(patch);
}

std::string movieText(base::Progress& progress) {
  const std::filesystem::path ffmpeg = findProgram("ffmpeg");
  if (ffmpeg.empty()) return "not found: replay writes frames but no movie";
  const ProgramResult result = runProgram(ffmpeg, {"-version"}, {}, progress);
  if (result.exitCode != 0) return ffmpeg.string() + " does not run: replay writes frames but no movie";
  return ffmpeg.string() + ", " + result.output.substr(0, result.output.find(" Copyright"));
}

// Milliseconds of what finds hits and gradients, the least of a few pictures of 256 x 256.
double hitMilliseconds(render::Renderer& renderer, const scene::Scene& scene, scene::Executor executor) {
  constexpr int rounds = 4;
  renderer.setHostSettings({.executor = executor});
  const render::FrameRequest request{.size = glm::ivec2(256)};
  double least = std::numeric_limits<double>::infinity();
  for (int round = 0; round < rounds; ++round) {
    renderer.invalidate();
    double sum = 0.0;
    for (const render::PassReport& pass : renderer.render(scene, request).passes)
      for (const char* const name : {"segments", render::pass::cast, render::pass::gradient})
        if (pass.name == name) sum += pass.milliseconds;
    least = std::min(least, sum);
  }
  return least;
}

std::string storedProgramsText() {
  const std::filesystem::path folder = programFolder();
  if (folder.empty()) return "none: the user has no home folder";
  const render::StoredPrograms stored = render::storedPrograms(folder);
  return std::to_string(stored.count) + " programs, " + base::memoryText(stored.bytes) + ", in " +
         folder.string();
}

// Prints what the driver has of what Isolux uses, and what follows.
void printLimits(std::ostream& out, const render::Gl& gl) {
  out << "\nLimits and extensions of this OpenGL:\n";
  for (const render::GlFact& fact : render::glFacts(gl)) {
    out << "  " << fact.use.name << ": " << fact.value << " (" << fact.use.purpose << ')';
    if (fact.value != "yes") out << "; " << fact.use.without;
    out << '\n';
  }
  const int asked = scene::Memory{}.gpuBudgetMb;
  if (gl.software)
    out << "  Textures are in main memory, and linked programs are not stored: the driver has its own "
           "cache.\n";
  else if (gl.memoryBytes == 0)
    out << "  The memory of the card is unknown; memory.gpu_budget_mb (default " << asked
        << ") limits its use.\n";
  else
    out << "  The card has " << base::memoryText(gl.memoryBytes) << "; memory.gpu_budget_mb (default "
        << asked << ") is limited to " << gl.budgetMb(std::numeric_limits<int>::max()) << ".\n";
}

// Which executor finds hits and gradients sooner here, and which one is taken.
void printExecutors(std::ostream& out, const std::shared_ptr<const render::Gl>& gl,
                    base::Progress& progress) {
  scene::Source source;
  source.path = "phantom:gyroid:96";
  const auto prepared = volume::loadVolume(source, progress);
  render::Renderer renderer(gl);
  renderer.setVolume(prepared);
  const scene::Scene scene = scene::resolve({}, prepared->facts);
  scene::Scene cubic = scene;
  cubic.hit.field = scene::Field::cubic;
  const auto measured = [&](scene::Executor executor) {
    return base::shortText(hitMilliseconds(renderer, scene, executor), 3) + " ms, of the cubic field " +
           base::shortText(hitMilliseconds(renderer, cubic, executor), 3) + " ms";
  };
  out << "\nHits and gradients of an image of 256x256 (phantom:gyroid:96):\n";
  const bool taken = render::takesProcessor(scene::Executor::automatic, *gl);
  out << (taken ? "  " : "* ") << "gpu: " << measured(scene::Executor::gpu) << '\n';
  if (!volume::SurfaceCaster::available()) {
    out << "  cpu: this CPU lacks the vector instructions needed\n";
    return;
  }
  out << (taken ? "* " : "  ") << "cpu: " << measured(scene::Executor::cpu) << " ("
      << volume::SurfaceCaster::target() << ")\n"
      << "* marks the choice of --executor auto: the CPU if OpenGL is software.\n";
}

}  // namespace

void printDoctor(std::ostream& out, const std::string& window, base::Progress& progress) {
  printRow(out, "isolux", std::string(version()));
  printRow(out, "compiler", __VERSION__);
  printRow(out, "CPU threads", std::to_string(tbb::info::default_concurrency()));
  printRow(out, "memory", memoryText());
  printRow(out, "memory budget", base::memoryText(base::machineMemory().limit()));
  for (const std::string& version : volume::readerVersions(progress)) printRow(out, "file reader", version);
  printRow(out, "oneTBB", TBB_runtime_version());
  printRow(out, "GLM", dotted(GLM_VERSION_MAJOR, GLM_VERSION_MINOR, GLM_VERSION_PATCH));
  printRow(out, "JSON",
           dotted(NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH));
  printRow(out, "CLI11", CLI11_VERSION);
  printRow(out, "ffmpeg", movieText(progress));
  if (!window.empty()) printRow(out, "window", window);
  printRow(out, "shader cache", storedProgramsText());

  out << "\nGraphics contexts without a window (OpenGL 4.5 core), in the order they are tried:\n";
  std::string chosen;
  for (const render::ContextProbe& probe : render::probeContexts()) {
    progress.throwIfStopped();
    out << (probe.chosen ? "* " : "  ") << probe.kind << ": " << (probe.works ? "works: " : "does not work: ")
        << probe.detail << '\n';
    if (probe.chosen) chosen = probe.kind;
  }
  if (chosen.empty())
    out << "None works, so `isolux render` and `isolux replay` cannot draw; install an EGL driver "
           "(libegl-mesa0 and libgl1-mesa-dri draw without a graphics card).\n";
  else
    out << "* " << chosen
        << " is the choice of --context auto: first a GPU through EGL, then OSMesa, then software EGL.\n";
  if (chosen.empty()) return;
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  printLimits(out, *context->gl());
  printExecutors(out, context->gl(), progress);
}

}  // namespace isolux::app
