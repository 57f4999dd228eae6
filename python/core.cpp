#include "python/core.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <stdexcept>
#include <utility>

#include <unistd.h>

#include <pybind11/pybind11.h>

#include "app/accuracy/accuracy.h"
#include "app/annotation/annotation.h"
#include "app/documents/picture_scene.h"
#include "app/documents/session.h"
#include "app/files/files.h"
#include "app/light/light_picture.h"
#include "app/light/light_report.h"
#include "app/light/light_resume.h"
#include "app/picture/field_job.h"
#include "app/picture/rest_scene.h"
#include "app/report/render_report.h"
#include "app/study/study.h"
#include "app/study_report/study_report.h"
#include "app/version.h"
#include "base/error.h"
#include "base/number_text.h"
#include "base/numbers.h"
#include "scene/rules/automatic.h"
#include "scene/rules/relevance.h"
#include "scene/settings/assignment.h"
#include "volume/read/input/convert.h"
#include "volume/read/input/payload.h"
#include "volume/read/step_files.h"

namespace isolux::python {

namespace py = pybind11;
namespace fs = std::filesystem;
using base::Error;
using base::ErrorKind;

// Light of colours and of deferred images is kept apart: which texels are lit follows from the rays.
struct Core::Graphics {
  render::ContextChoice choice;
  std::unique_ptr<render::OffscreenContext> context;
  std::optional<render::Renderer> renderer;
  scene::Machine machine;
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

  Light& light(bool ofImages, const PictureWish& wish) {
    Light& one = ofImages ? images : pictures;
    if (!one.controller || one.around != wish.lightAround || one.threads != machine.threads) {
      one = {};
      one.around = wish.lightAround;
      one.threads = machine.threads;
      one.controller = std::make_unique<app::LightController>(
          app::LightController::Options{.threads = machine.threads, .around = wish.lightAround});
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
  throw Error(ErrorKind::usage, "", "array", "unknown type of voxels");
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

}  // namespace

std::shared_ptr<Core> Core::ofArray(const py::array& array, glm::dvec3 spacingMm, glm::dvec3 originMm,
                                    glm::dmat3 directions, const std::string& name, const std::string& unit,
                                    bool anatomical, const py::object& told) {
  if (array.ndim() != 3) throw Error(ErrorKind::usage, "", "array", "a volume has three axes");
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
      throw Error(ErrorKind::usage, "", std::string(scene::pathOf(assignment)),
                  "selects the volume to open; it cannot change in an open volume");
  scene::Scene scene = app::sceneOf(path_, options, *prepared_);
  scene.source = source_;
  return scene;
}

namespace {

// A driver's threads stay with the parent, and whoever waits for them in its child waits for ever.
void requireNoForkSinceDrawing() {
  static std::atomic<pid_t> drawing{0};
  pid_t nobody = 0;
  if (!drawing.compare_exchange_strong(nobody, ::getpid()) && nobody != ::getpid())
    throw std::runtime_error(
        "graphics do not outlive fork(), and the parent has drawn: start this process by \"spawn\" or "
        "\"forkserver\"");
}

}  // namespace

Core::Graphics& Core::graphics(render::ContextChoice choice) {
  std::unique_ptr<Graphics>& own = *graphics_;
  if (own && own->choice != choice) own.reset();
  if (!own) {
    requireNoForkSinceDrawing();
    auto made = std::make_unique<Graphics>();
    made->choice = choice;
    made->context = render::OffscreenContext::create(choice);
    made->context->makeCurrent();
    made->renderer.emplace(made->context->gl());
    made->renderer->setVolume(prepared_);
    own = std::move(made);
  }
  return *own;
}

namespace {

void addNotes(const scene::Scene& scene, const render::FrameReport& report, const app::LightState& light,
              std::vector<std::string>& notes) {
  static_cast<void>(scene);
  notes = light.warnings;
  if (report.empty) notes.push_back("the image is empty: " + report.empty->reason);
  for (const std::string& error : report.glErrors)
    notes.push_back("the graphics driver reports an error: " + error);
  if (report.bricks.missing > 0.0)
    notes.push_back(base::shortText(100.0 * report.bricks.missing, 2) +
                    " % of the image is missing: memory.gpu_budget_mb is too small for this view; raise it");
}

app::DerivativeFacts derivativesOf(const PictureWish& wish, render::Renderer& renderer,
                                   const scene::Derivatives& asked, const scene::Scene& drawn,
                                   const render::FrameRequest& request, const render::FrameReport& report,
                                   const volume::PreparedVolume& volume) {
  if (wish.explain) return app::derivativeFacts(renderer, asked, drawn, request, report, volume);
  return {asked, drawn, {}, report.curvature, {}};
}

}  // namespace

// As `isolux render` does it (app/commands/render.cpp), colours first, then deferred images.
std::shared_ptr<Picture> Core::draw(const PictureWish& wish, base::Progress& progress) {
  auto picture = std::make_shared<Picture>();
  const app::WantedImages wanted =
      wish.images.empty() ? app::WantedImages{} : app::parseImageList(wish.images);
  scene::Scene scene = sceneOf(wish.scene);
  Graphics& own = graphics(wish.context);
  const scene::Machine machine = app::machineOf(wish.scene);
  if (machine != own.machine) own.renderer->setMachine(own.machine = machine);
  picture->size = wish.size ? *wish.size : app::pictureSize(std::nullopt, path_, wish.scene);
  scene.camera = app::wishedCamera(wish.scene.camera, scene, *prepared_, picture->size, progress);
  const scene::Scene given = scene;
  const scene::Derivatives& asked = given.derivatives;
  scene = scene::resolve(std::move(scene), prepared_->facts);

  std::optional<double> exposure;
  const auto drawOne = [&](render::FrameRequest request, bool ofImages) {
    request.size = picture->size;
    request.pixelRatio = scene.picture.pixelRatio;
    Graphics::Light& light = own.light(ofImages, wish);
    progress.report(0.0, "drawing");
    if (wish.light.empty())
      light.file.clear();
    else
      Graphics::load(light, wish.light, app::litScene(scene, request), prepared_, progress);
    app::completeFields(scene, *prepared_, !request.aovs.empty(), progress);
    light.controller->meterView(!app::startsFromSession(path_, wish.scene));
    app::lightPicture(*light.controller, *own.renderer, scene, request, prepared_, progress);
    exposure = app::exposureToCarry(*light.controller, scene);
    const scene::Scene shown = request.aovs.empty() ? app::atRest(scene, *prepared_, progress) : scene;
    progress.report(0.0, "drawing");
    app::Drawn drawn;
    drawn.picture = render::drawStill(*own.renderer, shown, request, progress);
    drawn.milliseconds = drawn.picture.report.milliseconds;
    progress.throwIfStopped();
    if ((wish.accuracy && request.color) || !(wanted.errors.empty() || request.color)) {
      const app::PictureErrors errors = app::measureErrors(*own.renderer, shown, request, *prepared_,
                                                           progress, {light.controller->light(), prepared_});
      picture->accuracy = app::accuracyOf(errors);
      if (!request.color) picture->exr = app::channelsOf(drawn.picture.aovs, wanted, errors);
      if (!request.color)
        for (const app::ErrorImage image : wanted.errors)
          for (const app::ErrorImageInfo& info : app::errorImages())
            if (info.image == image) picture->errors.push_back({info.name, app::boundsOf(image, errors)});
    }
    const app::DerivativeFacts facts =
        derivativesOf(wish, *own.renderer, asked, scene, request, drawn.picture.report, *prepared_);
    picture->stats = app::renderJson(scene, request, *prepared_, own.context->description(), drawn,
                                     *light.controller, facts, picture->accuracy)
                         .dump();
    addNotes(scene, drawn.picture.report, light.controller->state(), picture->notes);
    return std::move(drawn.picture);
  };

  // Images come first, so that what is said last is said of the picture.
  if (!wish.images.empty()) {
    render::FrameRequest request;
    request.color = false;
    request.aovs = wanted.aovs;
    const auto has = [&](render::Aov aov) {
      return std::find(request.aovs.begin(), request.aovs.end(), aov) != request.aovs.end();
    };
    if (std::find(wanted.errors.begin(), wanted.errors.end(), app::ErrorImage::light) !=
            wanted.errors.end() &&
        !has(render::Aov::irradiance))
      request.aovs.push_back(render::Aov::irradiance);
    if (request.aovs.empty()) request.aovs = std::vector{render::Aov::hit};
    picture->images = drawOne(request, true).aovs;
  }
  if (wish.color || wish.linear) {
    render::FrameRequest request;
    request.supersampling = scene.picture.supersampling;
    request.linear = wish.linear;
    render::StillPicture drawn = drawOne(request, false);
    if (wish.linear) picture->linear = std::move(drawn.linear);
    if (wish.color) {
      app::annotate(scene, *prepared_, drawn.report, drawn.color);
      picture->color = std::move(drawn.color);
    }
  }
  picture->scene = app::carriedScene(given, scene, exposure);
  picture->opened = path_;
  return picture;
}

std::shared_ptr<const Picture> Core::render(const PictureWish& wish, const py::object& told) {
  const auto picture = std::make_shared<std::shared_ptr<Picture>>();
  desk_.run([self = shared_from_this(), wish,
             picture](base::Progress& progress) { *picture = self->draw(wish, progress); },
            told);
  return *picture;
}

void Core::ask(const app::SceneOptions& options,
               const std::function<void(const scene::Scene&, base::Progress&)>& question,
               const py::object& told) {
  desk_.run(
      [self = shared_from_this(), options, question](base::Progress& progress) {
        scene::Scene scene = scene::resolve(self->sceneOf(options), self->prepared_->facts);
        self->prepared_->derivativeChoices->complete(scene, progress);
        question(scene, progress);
      },
      told);
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

namespace {

// What is baked is all that there is, whatever the look: as `isolux bake`.
scene::Scene bakedScene(scene::Scene scene) {
  if (scene::shadingOf(scene) != scene::Shading::gi) scene.look.mode = scene::LookMode::gi;
  if (scene.gi.extent == scene::GiExtent::view) scene.gi.extent = scene::GiExtent::full;
  return scene;
}

}  // namespace

Baked Core::bake(const app::SceneOptions& options, const std::string& file, bool overwrite,
                 bool mixArithmetic, const py::object& told) {
  constexpr double checkpointSeconds = 60.0;
  const auto baked = std::make_shared<Baked>();
  const fs::path out(file);
  if (out.extension() != ".vti")
    throw Error(ErrorKind::usage, file, "", "the name of a bake must end in .vti");
  desk_.run(
      [self = shared_from_this(), this, options, out, overwrite, mixArithmetic,
       baked](base::Progress& progress) {
        const scene::Scene scene = bakedScene(scene::resolve(bakedScene(sceneOf(options)), prepared_->facts));
        if (!scene::giChoiceOf(scene).wanted)
          throw Error(ErrorKind::usage, "", "gi.mode", "nothing to bake: " + scene::giChoiceOf(scene).reason);
        app::OutputGuard guard = app::outputGuard(path_, options, scene);
        app::checkOutput(guard, out.string(), "bake");
        const app::OutputLock lock(out);
        std::error_code missing;
        const bool exists = fs::exists(out, missing);
        if (exists && !overwrite && !gi::looksLikeBakeFile(out))
          base::throwInput(out.string(), "", "is not baked light; overwrite=True replaces it");
        app::LightController controller({.threads = app::machineOf(options).threads, .innerSides = false});
        controller.setScene(scene, prepared_);
        if (exists && gi::looksLikeBakeFile(out)) {
          std::optional<gi::BakeFacts> facts;
          try {
            facts = controller.load(out, progress);  // goes on from it
          } catch (const Error& error) {
            if (error.kind() != ErrorKind::input) throw;
            baked->notes.push_back(out.string() + " held other light and was replaced: " + error.reason());
          }
          if (facts) app::checkMayGoOn(out, *facts, std::nullopt, controller.arithmetic(), mixArithmetic);
        }
        base::Progress writing;  // what there is, also when it ends here: writing is not stopped
        while (!controller.finish(progress, checkpointSeconds)) {
          controller.save(out, writing);
          progress.throwIfStopped();
        }
        controller.save(out, writing);
        nlohmann::ordered_json json;
        json["version"] = app::version();
        const app::LightState state = controller.state();
        json["bake"] = app::bakeJson(state);
        json["data_hash"] = base::hexText(prepared_->grid().hash());
        baked->stats = json.dump();
        baked->notes.insert(baked->notes.end(), state.warnings.begin(), state.warnings.end());
      },
      told);
  return *baked;
}

std::string Core::study(const app::SceneOptions& options, const std::string& knobs, glm::ivec2 size,
                        int repeat, const py::object& told) {
  const std::vector<app::Knob> chosen = app::parseKnobs(knobs);
  const auto result = std::make_shared<std::string>();
  desk_.run(
      [self = shared_from_this(), this, options, chosen, size, repeat, result](base::Progress& progress) {
        const scene::Scene scene = sceneOf(options);
        app::refuseCuts(scene, "study");
        Graphics& own = graphics(render::ContextChoice::automatic);
        const app::StudySubject subject{prepared_, scene::resolve(scene, prepared_->facts),
                                        own.context->description(), size, repeat};
        app::Studio studio(own.context->gl(), prepared_, scene, app::machineOf(options), size, repeat);
        double all = 0.0, done = 0.0;
        for (const app::Knob& knob : chosen) all += app::effortOf(knob, scene);
        std::vector<app::KnobStudy> studies;
        for (const app::Knob& knob : chosen) {
          const double from = done / all;
          done += app::effortOf(knob, scene);
          studies.push_back(studio.study(knob, progress, from, done / all));
        }
        *result = app::studyJson(subject, studies, true);
      },
      told);
  return *result;
}

}  // namespace isolux::python
