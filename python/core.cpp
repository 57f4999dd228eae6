#include "python/core.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <utility>

#include <unistd.h>

#include <pybind11/pybind11.h>
#include <nlohmann/json.hpp>

#include "app/documents/picture_scene.h"
#include "app/files/files.h"
#include "app/light/light_picture.h"
#include "app/light/light_report.h"
#include "app/light/light_resume.h"
#include "app/overlay_text/annotation.h"
#include "app/picture/finished_picture.h"
#include "app/report/render_report.h"
#include "app/study/study.h"
#include "app/study_report/study_report.h"
#include "base/error.h"
#include "scene/rules/automatic.h"
#include "scene/rules/needs.h"
#include "scene/settings/assignment.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/payload.h"
#include "volume/read/step_files.h"

namespace isolux::python {

namespace py = pybind11;
namespace fs = std::filesystem;

// Light of colours and of deferred images is kept apart: which texels are lit follows from the rays.
struct Core::Graphics {
  explicit Graphics(render::ContextChoice context) : choice(context), renderer(context) {}

  render::ContextChoice choice;
  render::OffscreenRenderer renderer;
  scene::HostSettings host;
  struct Light {
    std::unique_ptr<app::LightController> controller;
    bool around = false;
    std::optional<int> threads;
    // The file that it has read, as it was then, and for which light.
    std::string file;
    fs::file_time_type time;
    std::uintmax_t bytes = 0;
    scene::Scene lit;
  };
  Light pictures, images;

  Light& light(bool ofImages, const PictureRequest& asked) {
    Light& one = ofImages ? images : pictures;
    if (!one.controller || one.around != asked.lightAround || one.threads != host.threads) {
      one = {};
      one.around = asked.lightAround;
      one.threads = host.threads;
      one.controller = std::make_unique<app::LightController>(
          app::LightController::Options{.threads = host.threads, .around = asked.lightAround});
    }
    return one;
  }
  // Reads `file` unless it is what is there already.
  static void load(Light& light, const std::string& file, scene::Scene lit,
                   const std::shared_ptr<const volume::PreparedVolume>& volume, base::Progress& progress) {
    std::error_code ignored;
    const auto time = fs::last_write_time(file, ignored);
    const auto bytes = fs::file_size(file, ignored);
    scene::Scene key = lit;  // light does not depend on these
    key.camera = {};
    key.picture = {};
    key.look = {};
    key.marks.clear();
    if (light.file == file && light.time == time && light.bytes == bytes && light.lit == key) return;
    light.file.clear();  // and stays so where it cannot be read
    light.controller->setScene(lit, volume);
    light.controller->load(file, progress);
    light.file = file;
    light.time = time;
    light.bytes = bytes;
    light.lit = std::move(key);
  }
};

Core::Core()
    : graphics_(std::make_shared<std::unique_ptr<Graphics>>()),
      desk_([graphics = graphics_] { graphics->reset(); }) {}

std::shared_ptr<Core> Core::open(const std::string& path, const app::SceneOptions& options,
                                 const py::object& told) {
  const std::shared_ptr<Core> core(new Core);
  std::error_code ignored;  // a later change of folder changes nothing
  const bool isThere = fs::exists(path, ignored) || !volume::stepFiles(path).empty();
  core->path_ = isThere ? fs::absolute(path).string() : path;
  core->desk_.run(
      [core, options](base::Progress& progress) {
        core->source_ = app::sceneOf(core->path_, options).source;
        core->prepared_ = volume::loadVolume(core->source_, progress);
      },
      told);
  return core;
}

namespace {

volume::VoxelType voxelTypeOf(const py::dtype& type) {
  const char kind = type.kind();
  const auto bytes = type.itemsize();
  for (const volume::VoxelType each :
       {volume::VoxelType::int8, volume::VoxelType::uint8, volume::VoxelType::int16,
        volume::VoxelType::uint16, volume::VoxelType::int32, volume::VoxelType::uint32,
        volume::VoxelType::int64, volume::VoxelType::uint64, volume::VoxelType::float32,
        volume::VoxelType::float64}) {
    const std::string_view name = nameOf(each);
    const char its = name.front();  // 'i', 'u', 'f', as of NumPy
    if (its == kind && static_cast<py::ssize_t>(volume::bytesOf(each)) == bytes) return each;
  }
  base::throwUsage("", "array", "unknown type of voxels");
}

struct ArrayVoxels {
  volume::ImageHeader header;
  const void* data;
};

volume::Volume volumeOf(const ArrayVoxels& voxels, const std::string& name, base::Progress& progress) {
  const volume::ReadOptions options;
  volume::checkBudget(voxels.header, "", options);
  progress.report(0.0, "reading");
  volume::FileVoxels copy = volume::withType(voxels.header.type, [&](auto zero) {
    using T = decltype(zero);
    std::vector<T> values;
    const auto count = static_cast<std::size_t>(voxels.header.voxels());
    const T* const from = static_cast<const T*>(voxels.data);
    constexpr std::size_t piece = (std::size_t{4} << 20) / sizeof(T);
    values.reserve(count);
    for (std::size_t at = 0; at < count; at += piece) {
      progress.throwIfStopped();
      values.insert(values.end(), from + at, from + std::min(count, at + piece));
    }
    return volume::FileVoxels(std::move(values));
  });
  volume::Volume volume = finishVolume(voxels.header, std::move(copy), options, progress);
  volume.name = name;
  return volume;
}

// A driver's threads stay with the parent, and whoever waits for them in its child waits for ever.
void requireNoForkSinceDrawing() {
  static std::atomic<pid_t> drawing{0};
  pid_t nobody = 0;
  if (!drawing.compare_exchange_strong(nobody, ::getpid()) && nobody != ::getpid())
    throw std::runtime_error(
        "graphics do not outlive fork(), and the parent has drawn: start this process by \"spawn\" or "
        "\"forkserver\"");
}

// What is baked is all that there is, whatever the look: as `isolux bake`.
scene::Scene bakedScene(scene::Scene scene) {
  if (scene::shadingOf(scene) != scene::Shading::gi) scene.look.mode = scene::LookMode::gi;
  if (scene.gi.extent == scene::GiExtent::view) scene.gi.extent = scene::GiExtent::full;
  return scene;
}

}  // namespace

std::shared_ptr<Core> Core::ofArray(const py::array& array, glm::dvec3 spacingMm, glm::dvec3 originMm,
                                    glm::dmat3 directions, const std::string& name, const std::string& unit,
                                    bool anatomical, const py::object& told) {
  if (array.ndim() != 3) base::throwUsage("", "array", "a volume has three axes");
  ArrayVoxels voxels{{}, array.data()};
  voxels.header.format = "array";
  voxels.header.type = voxelTypeOf(array.dtype());
  voxels.header.dims = {array.shape(2), array.shape(1), array.shape(0)};
  volume::checkDims(voxels.header, "", "array");
  voxels.header.worldFromVoxel =
      volume::checkedGeometry(directions, spacingMm, originMm, "", voxels.header.warnings);
  voxels.header.unit = unit;
  voxels.header.axes = anatomical ? scene::WorldAxes::anatomical : scene::WorldAxes::zUp;
  const std::shared_ptr<Core> core(new Core);
  core->source_.path = volume::kArrayPath + name;
  // The desk may go on after an interrupt: it holds what it reads.
  auto kept = std::shared_ptr<py::array>(new py::array(array), [](py::array* held) {
    const py::gil_scoped_acquire lock;
    delete held;
  });
  core->desk_.run(
      [core, voxels, name, kept](base::Progress& progress) {
        core->prepared_ = volume::prepareVolume(volumeOf(voxels, name, progress), progress);
      },
      told);
  return core;
}

scene::Scene Core::sceneOf(const app::SceneOptions& options) const {
  for (const std::string& assignment : options.assignments)
    if (assignment.starts_with("source."))
      base::throwUsage("", std::string(scene::pathOf(assignment)),
                       "selects the volume to open; it cannot change in an open volume");
  scene::Scene scene = app::sceneOf(path_, options, *prepared_);
  scene.source = source_;
  return scene;
}

Core::Graphics& Core::graphics(render::ContextChoice choice) {
  std::unique_ptr<Graphics>& own = *graphics_;
  if (own && own->choice != choice) own.reset();
  if (!own) {
    requireNoForkSinceDrawing();
    own = std::make_unique<Graphics>(choice);
    own->renderer->setVolume(prepared_);
  }
  return *own;
}

// As `isolux render` does it (app/commands/render.cpp), colours first, then deferred images.
std::shared_ptr<Picture> Core::draw(const PictureRequest& asked, base::Progress& progress) {
  auto picture = std::make_shared<Picture>();
  const app::WantedImages wanted =
      asked.images.empty() ? app::WantedImages{} : app::parseImageList(asked.images);
  scene::Scene scene = sceneOf(asked.scene);
  Graphics& own = graphics(asked.context);
  const scene::HostSettings host = app::hostSettingsOf(asked.scene);
  if (host != own.host) own.renderer->setHostSettings(own.host = host);
  picture->size = asked.size ? *asked.size : app::pictureSize(std::nullopt, path_, asked.scene);
  scene.camera = app::requestedCamera(asked.scene.camera, scene, *prepared_, picture->size, progress);
  const scene::Scene given = scene;
  scene = scene::resolve(std::move(scene), prepared_->facts);

  std::optional<double> exposure;
  const auto drawOne = [&](render::FrameRequest request, bool ofImages) {
    request.size = picture->size;
    request.pixelRatio = scene.picture.pixelRatio;
    Graphics::Light& light = own.light(ofImages, asked);
    progress.report(0.0, "drawing");
    if (asked.light.empty())
      light.file.clear();
    else
      Graphics::load(light, asked.light, app::litScene(scene, request), prepared_, progress);
    light.controller->meterView(!app::startsFromSession(path_, asked.scene));
    const bool errors = request.color ? asked.accuracy : !wanted.errors.empty();
    app::FinishedPicture drawn = app::drawPicture(
        *own.renderer, *light.controller,
        {.volume = prepared_, .scene = scene, .request = request, .errors = errors}, progress);
    scene = drawn.inputs.scene;
    exposure = app::exposureToCarry(*light.controller, scene);
    if (errors && !request.color) {
      picture->exr = app::channelsOf(drawn.still.aovs, wanted, *drawn.errors);
      for (const app::ErrorImage image : wanted.errors) {
        const app::ErrorImageInfo& info = app::errorImage(image);
        picture->errors.push_back({info.name, *drawn.errors.*info.bounds});
      }
    }
    const app::DerivativeFacts facts =
        asked.explain ? app::derivativeFacts(*own.renderer, given.derivatives, drawn)
                      : app::DerivativeFacts{given.derivatives, scene, {}, drawn.still.report.curvature, {}};
    if (errors)
      picture->accuracy = drawn.accuracy;
    else
      drawn.accuracy = picture->accuracy;  // of the images
    picture->stats =
        app::renderJson(drawn, own.renderer.context().description(), *light.controller, facts).dump();
    picture->notes = light.controller->state().warnings;
    for (std::string& note : app::notesOf(drawn.still.report)) picture->notes.push_back(std::move(note));
    return std::move(drawn.still);
  };

  // Images come first, so that what is said last is said of the picture.
  if (!asked.images.empty()) {
    picture->images = drawOne({.color = false, .aovs = app::drawnFor(wanted)}, true).aovs;
  }
  if (asked.color || asked.linear) {
    render::StillPicture drawn =
        drawOne({.linear = asked.linear, .supersampling = scene.picture.supersampling}, false);
    if (asked.linear) picture->linear = std::move(drawn.linear);
    if (asked.color) {
      app::annotate(scene, *prepared_, drawn.report, drawn.color);
      picture->color = std::move(drawn.color);
    }
  }
  picture->scene = app::carriedScene(given, scene, exposure);
  picture->opened = path_;
  return picture;
}

std::shared_ptr<const Picture> Core::render(const PictureRequest& asked, const py::object& told) {
  return desk_.answer(
      [self = shared_from_this(), asked](base::Progress& progress) { return self->draw(asked, progress); },
      told);
}

scene::Scene Core::completeScene(const app::SceneOptions& options, base::Progress& progress) const {
  scene::Scene scene = scene::resolve(sceneOf(options), prepared_->facts);
  prepared_->derivativeChoices->complete(scene, progress);
  return scene;
}

void Core::forgetLight(const py::object& told) {
  desk_.run(
      [graphics = graphics_](base::Progress&) {
        if (!*graphics) return;
        (*graphics)->pictures = {};
        (*graphics)->images = {};
      },
      told);
}

Baked Core::bake(const app::SceneOptions& options, const std::string& file, bool overwrite,
                 bool mixArithmetic, const py::object& told) {
  constexpr double checkpointSeconds = 60.0;
  const fs::path out(file);
  if (out.extension() != ".vti") base::throwUsage(file, "", "the name of a bake must end in .vti");
  return desk_.answer(
      [self = shared_from_this(), this, options, out, overwrite, mixArithmetic](base::Progress& progress) {
        const scene::Scene scene = bakedScene(scene::resolve(bakedScene(sceneOf(options)), prepared_->facts));
        if (!scene::giChoiceOf(scene).wanted)
          base::throwUsage("", "gi.mode", "nothing to bake: " + scene::giChoiceOf(scene).reason);
        app::OutputGuard guard = app::outputGuard(path_, options, scene);
        app::checkOutput(guard, out.string(), "bake");
        const app::OutputLock lock(out);
        std::error_code missing;
        const bool holdsLight = gi::looksLikeBakeFile(out);
        if (!holdsLight && !overwrite && fs::exists(out, missing))
          base::throwInput(out.string(), "", "is not baked light; overwrite=True replaces it");
        app::LightController controller(
            {.threads = app::hostSettingsOf(options).threads, .innerSides = false});
        controller.setScene(scene, prepared_);
        std::string replaced;
        if (holdsLight) replaced = app::resumeBake(controller, out, std::nullopt, mixArithmetic, progress);
        app::bakeToFile(controller, out, std::nullopt, checkpointSeconds, progress);
        const app::LightState state = controller.state();
        Baked baked{app::bakeStats(state, prepared_->grid()).dump(), state.warnings};
        if (!replaced.empty()) baked.notes.insert(baked.notes.begin(), replaced);
        return baked;
      },
      told);
}

std::string Core::study(const app::SceneOptions& options, const std::string& qualities, glm::ivec2 size,
                        int repeat, const py::object& told) {
  return desk_.answer(
      [self = shared_from_this(), this, options, chosen = app::parseQualitySettings(qualities), size,
       repeat](base::Progress& progress) {
        const scene::Scene scene = sceneOf(options);
        app::refuseCuts(scene, "study");
        const render::OffscreenContext& context =
            graphics(render::ContextChoice::automatic).renderer.context();
        const app::StudySubject subject{prepared_, scene, app::hostSettingsOf(options), size, repeat};
        app::StudyRunner studio(context.gl(), subject);
        std::vector<app::QualityStudy> studies;
        studio.study(chosen, progress, [&](app::QualityStudy study) { studies.push_back(std::move(study)); });
        return app::studyJson(subject, context.description(), studies, true);
      },
      told);
}

}  // namespace isolux::python
