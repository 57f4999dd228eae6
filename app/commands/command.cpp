#include "app/commands/command.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iostream>
#include <sstream>

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <nlohmann/json.hpp>

#include "app/files/files.h"
#include "app/files/number_rows.h"
#include "app/runtime/progress_bar.h"
#include "base/decimal_text.h"
#include "base/error.h"
#include "base/memory_budget.h"
#include "scene/named_camera.h"
#include "scene/rules/quality.h"
#include "scene/settings/assignment.h"
#include "scene/settings/settings.h"

namespace isolux::app {

using base::Error;

namespace {

// "ex,ey,ez tx,ty,tz ux,uy,uz fov" as four assignments; the settings check each part.
void addCamera(const std::string& text, std::vector<std::string>& assignments) {
  constexpr std::array<const char*, 4> paths{"camera.eye=", "camera.target=", "camera.up=", "camera.fov="};
  std::istringstream words(text);
  std::vector<std::string> parts;
  for (std::string word; words >> word;) parts.push_back(word);
  if (parts.size() != paths.size())
    base::throwUsage("", "--camera", "expected \"ex,ey,ez tx,ty,tz ux,uy,uz fov\"");
  for (std::size_t i = 0; i < paths.size(); ++i) assignments.push_back(paths[i] + parts[i]);
}

// A built-in light takes the place of what a session has; a light probe does by itself
// (scene/rules/environment.h).
void addEnvironment(const std::string& value, std::vector<std::string>& assignments) {
  const std::vector<std::string>& names = scene::setting("light.environment.builtin").choices;
  const bool builtIn = std::ranges::find(names, value) != names.end();
  assignments.push_back("light.environment.file=" + (builtIn ? "" : value));
  if (!builtIn) return;
  assignments.emplace_back("light.environment.constant=auto");
  assignments.push_back("light.environment.builtin=" + value);
}

// "look.colormap_points=@FILE": the rows of the file as the list that stands for them. Others stay.
std::string withPointsOfFile(const std::string& assignment) {
  const std::size_t at = assignment.find("=@");
  if (at == std::string::npos) return assignment;
  const std::string_view path = scene::pathOf(assignment);
  for (const scene::Setting& setting : scene::settings()) {
    const bool points = setting.type == scene::SettingType::points;
    if (setting.path != path || (!points && setting.type != scene::SettingType::color_points)) continue;
    nlohmann::json list = nlohmann::json::array();
    for (const NumberRow& row : readNumberRows(assignment.substr(at + 2), points ? 5 : 4))
      list.push_back(row.numbers);
    return assignment.substr(0, at + 1) + list.dump();
  }
  return assignment;
}

void addCameraOptions(CLI::App& parser, const std::shared_ptr<SceneOptions>& options) {
  constexpr const char* group = "Camera";
  CameraRequest& request = options->camera;
  addOption(parser, "--view", request.view, "SIDE",
            "View from left, right, anterior, posterior, superior or inferior, or from the end of an axis, "
            "as +x or -y")
      ->check([](const std::string& name) -> std::string {
        try {
          scene::standardViewNamed(name, scene::WorldAxes::anatomical);
        } catch (const Error& error) {
          return error.reason();
        }
        return {};
      })
      ->group(group);
  const auto angle = [&](const char* name, double& degrees, const char* help) {
    addOption(parser, name, degrees, "DEG", help)->check(within(-36000.0, 36000.0))->group(group);
  };
  angle("--azimuth", request.azimuth,
        "Then orbit the target: move the eye to its right, about the up direction");
  angle("--elevation", request.elevation,
        "Then orbit upwards: move the eye up, over the top and down behind");
  angle("--roll", request.roll, "Then roll about the line of sight: turn the image clockwise");
  parser
      .add_option_function<std::string>(
          "--fit",
          [options](const std::string& word) {
            options->camera.fit = word == "surface" ? Framing::surface : Framing::volume;
          },
          "Then frame the shown surface, or the volume's box, in this direction")
      ->type_name("surface|volume")
      ->check(oneOf({"surface", "volume"}))
      ->group(group);
  addOption(parser, "--zoom", request.zoom, "F", "Then move closer: 2 shows everything twice as large")
      ->check(within(1e-3, 1e3))
      ->group(group);
}

// More than a few per core gain nothing, and each takes stacks, and code of the software driver.
int mostThreads() {
  return std::max(16, 4 * tbb::info::default_concurrency());
}

}  // namespace

std::shared_ptr<SceneOptions> addSceneOptions(CLI::App& parser, Draws draws) {
  auto options = std::make_shared<SceneOptions>();
  // trigger_on_parse: each occurrence is handled as it is met, so that their order is that of the line.
  const auto add = [&](const char* name, const std::function<void(const std::string&)>& handle,
                       const char* type, const char* help) {
    parser.add_option_function<std::string>(name, handle, help)
        ->type_name(type)
        ->trigger_on_parse()
        ->group("Scene");
  };
  const auto addOfSurface = [&](const char* name, const std::function<void(const std::string&)>& handle,
                                const char* type, const char* help) {
    add(name, handle, type, help);
    if (draws == Draws::slice) parser.get_option(name)->group("");  // hidden
  };
  const auto assign = [options](const char* path) {
    return
        [options, path](const std::string& value) { options->assignments.push_back(path + ("=" + value)); };
  };
  add(
      "--set",
      [options](const std::string& value) { options->assignments.push_back(withPointsOfFile(value)); },
      "PATH=VALUE",
      "Change one setting; may be repeated; `isolux settings` lists all; PATH=@FILE reads control points "
      "from rows of numbers");
  addOption(parser, "--session", options->session, "FILE",
            "Start from this session (.isolux, or a .png that carries one)")
      ->group("Scene");
  add("--isovalue", assign("isosurface.value"), "VALUE", "Short for --set isosurface.value=VALUE");
  addOfSurface("--look", assign("look.mode"), "MODE", "Short for --set look.mode=MODE");
  addOfSurface(
      "--environment", [options](const std::string& value) { addEnvironment(value, options->assignments); },
      "NAME|FILE",
      "Environment: studio, window, overcast, sunset, dark_studio, or an environment map (.hdr, .exr)");
  addOfSurface(
      "--camera", [options](const std::string& value) { addCamera(value, options->assignments); },
      "\"EYE TARGET UP FOV\"",
      "\"ex,ey,ez tx,ty,tz ux,uy,uz fov\": world mm (x left, y back, z up), vertical degrees");
  addOfSurface(
      "--quality",
      [options](const std::string& name) {
        for (const std::string& assignment : scene::quality(name).assignments)
          options->assignments.push_back(assignment);
      },
      "draft|screen|print",
      "Rays per pixel, light paths and hits of a still; a later --set overrides parts of it");
  addOfSurface("--executor", assign("picture.executor"), "NAME",
               "Device for hits and derivatives: auto, gpu, cpu; short for --set picture.executor=NAME");
  add("--raw", assign("source.raw"), "TEXT",
      "Layout of a file without a header: \"WxHxD TYPE [little|big] [spacing x,y,z] [header BYTES]\"");
  add("--time-step", assign("source.time_step"), "N",
      "Time step of a file with several, from 0; short for --set source.time_step=N");
  add("--channel", assign("source.component"), "N",
      "Channel of a file with several values per voxel, from 0; -1: the magnitude; short for --set "
      "source.component=N");
  return options;
}

void addPath(CLI::App& parser, std::string& path, Opens opens) {
  const std::string files = "A volume file, a DICOM folder, phantom:NAME[:SIZE], ";
  parser.add_option(
      "PATH", path,
      files + (opens == Opens::pictures ? "a session, or a .png that carries one" : "or a session"));
}

void addVolumeOptions(CLI::App& parser, const std::shared_ptr<SceneOptions>& options, bool cameras) {
  addOption(parser, "--preset", options->preset, "NAME|FILE",
            "Apply this preset (`isolux presets`) or preset file, after --session and before --set")
      ->group("Scene");
  addOption(parser, "--shift", options->shift, "V", "Add this to the isovalues of the preset, data units")
      ->check(CLI::Number.description(""))
      ->group("Scene")
      ->needs("--preset");
  if (cameras) addCameraOptions(parser, options);
}

void printThreadsNote(const CLI::App& parser) {
  const CLI::Option* const option = parser.get_option_no_throw("--threads");
  if (option == nullptr || option->count() == 0 || option->as<int>() <= mostThreads()) return;
  std::cerr << "isolux: note: --threads: " << mostThreads()
            << " threads are used, the most that is useful on this computer\n";
}

void addThreadsOption(CLI::App& parser) {
  auto limit = std::make_shared<std::optional<tbb::global_control>>();
  parser
      .add_option_function<int>(
          "--threads",
          [limit](int wanted) {
            const int threads = std::min(wanted, mostThreads());
            limit->emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
            setenv("LP_NUM_THREADS", std::to_string(std::min(threads, 32)).c_str(), 0);  // Mesa's llvmpipe
          },
          "Number of CPU threads; default: all")
      ->type_name("N")
      ->check(within(1, 1024));
}

void addMemoryOption(CLI::App& parser) {
  // The limit from before comes back, so that one process may run several commands.
  struct Limit {
    std::size_t before = base::machineMemory().limit();
    ~Limit() { base::machineMemory().setLimit(before); }
  };
  auto limit = std::make_shared<std::optional<Limit>>();
  parser
      .add_option_function<std::string>(
          "--memory-budget",
          [limit](const std::string& size) {
            if (!*limit) limit->emplace();
            base::machineMemory().setLimit(base::parseMemorySize(size));
          },
          "Memory limit for volumes, light and images together, as 16G or 800M; default: free memory less a "
          "reserve")
      ->type_name("SIZE");
}

int threadsInForce() {
  return static_cast<int>(tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism));
}

std::shared_ptr<FrameChoice> addFrameOptions(CLI::App& parser) {
  auto choice = std::make_shared<FrameChoice>();
  parser
      .add_option_function<std::string>(
          "--frames", [choice](const std::string& text) { choice->frames = parseFrames(text); },
          "Draw only these images of the series, numbered from 0; no movie is made")
      ->type_name("A-B");
  parser.add_flag("--skip-existing", choice->skipExisting, "Draw only images whose files do not exist yet");
  return choice;
}

std::shared_ptr<render::ContextChoice> addContextOption(CLI::App& parser) {
  auto choice = std::make_shared<render::ContextChoice>(render::ContextChoice::automatic);
  parser
      .add_option_function<std::string>(
          "--context", [choice](const std::string& word) { *choice = render::contextChoiceNamed(word); },
          "Graphics context: auto (default; `isolux doctor` shows which), software, egl, osmesa")
      ->type_name("NAME")
      ->check(oneOf({"auto", "software", "egl", "osmesa"}));
  return choice;
}

std::shared_ptr<const volume::PreparedVolume> loadWithProgressBar(const scene::Source& source,
                                                                  base::Progress& progress) {
  const ProgressBar bar(progress);
  return volume::loadVolume(source, progress);
}

std::shared_ptr<const volume::PreparedVolume> loadWithProgressBar(const scene::Source& source,
                                                                  const scene::HostSettings& host,
                                                                  base::Progress& progress) {
  const ProgressBar bar(progress);
  return volume::loadVolume(source, host, progress);
}

std::pair<int, int> parsePart(const std::string& text, int most) {
  const auto part = base::readTwoIntegers(text, '/');
  if (!part || part->first < 1 || part->first > part->second || part->second > most)
    base::throwUsage("", "--part", "\"" + text + "\" is not i/n, such as 2/5: part i of n, 1 <= i <= n");
  return *part;
}

}  // namespace isolux::app
