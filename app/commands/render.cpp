// isolux render PATH... --out FILE: pictures, or their deferred images, without a window.
#include <algorithm>
#include <cstdio>
#include <iostream>
#include <optional>
#include <sstream>
#include <utility>

#include <unistd.h>

#include "app/accuracy/accuracy_report.h"
#include "app/accuracy/error_images.h"
#include "app/accuracy/error_overlay.h"
#include "app/accuracy/hidden_structure.h"
#include "app/commands/command.h"
#include "app/commands/render_plan.h"
#include "app/commands/render_target.h"
#include "app/documents/picture_scene.h"
#include "app/documents/session.h"
#include "app/documents/session_accuracy.h"
#include "app/error_budget/target_report.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/light/light_picture.h"
#include "app/light/light_report.h"
#include "app/overlay_text/annotation.h"
#include "app/picture/finished_picture.h"
#include "app/report/derivative_report.h"
#include "app/report/render_report.h"
#include "app/runtime/progress_bar.h"
#include "app/series/movie.h"
#include "base/error.h"
#include "render/offscreen_renderer.h"
#include "render/passes/processor.h"
#include "scene/rules/automatic.h"
#include "scene/rules/ghosts.h"
#include "scene/rules/whole_voxels.h"
#include "scene/settings/assignment.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;
using base::Error;
using base::ErrorKind;

struct RenderOptions {
  std::vector<std::string> paths;
  std::string light, out, aov, stats, sweep, overlay;
  std::optional<std::string> size;
  bool explain = false, lightAround = false, accuracy = false;
  int repeat = 0, turntable = 0;
  double fps = 24.0;
  TargetOptions target;
  std::shared_ptr<FrameChoice> frames;
  std::shared_ptr<render::ContextChoice> context;
  std::shared_ptr<SceneOptions> scene;
};

bool marksStructure(const RenderOptions& options) {
  return options.overlay == kStructureOverlay;
}

OverlayRequest overlayOf(const RenderOptions& options) {
  if (marksStructure(options)) return {};
  const std::string& error = options.target.error;
  return parseOverlay(options.overlay, error.empty() ? std::vector<Limit>{} : parseErrorTarget(error));
}

// What --aov asks for.
struct AskedImages {
  WantedImages drawn;
  bool structure = false;  // kHiddenStructure is among them
};

AskedImages askedImages(const std::string& list) {
  AskedImages asked;
  std::string others, name;
  for (std::istringstream names(list); std::getline(names, name, ',');)
    if (name == kHiddenStructure)
      asked.structure = true;
    else
      others += (others.empty() ? "" : ",") + name;
  if (!others.empty() || !asked.structure) asked.drawn = parseImageList(others);
  return asked;
}

// Checked before anything slow starts.
render::FrameRequest requestOf(const RenderOptions& options, const std::string& path,
                               const scene::Scene& scene, const std::string& out) {
  const bool toOutput = out == kStandardOutput;
  const std::string extension = toOutput ? ".png" : fs::path(out).extension().string();
  if (extension != ".png" && extension != ".exr")
    base::throwUsage(out, "", "the name of an image must end in .png or .exr");
  if (toOutput && options.explain)
    base::throwUsage("", "--explain", "prints to the output to which --out - writes the image");
  render::FrameRequest request{.size = pictureSize(options.size, path, *options.scene),
                               .linear = extension == ".exr",
                               .supersampling = scene.picture.supersampling,
                               .pixelRatio = scene.picture.pixelRatio};
  if (!options.overlay.empty() && extension != ".png")
    base::throwUsage(out, "", "--error-overlay requires a .png; use --aov for the numbers");
  if (!options.aov.empty()) {
    request.linear = false;
    request.aovs = drawnFor(askedImages(options.aov).drawn);
    if (extension != ".exr") base::throwUsage(options.out, "", "--aov writes .exr files only");
    request.color = false;
    request.supersampling = 1;
  }
  return request;
}

// `session`: what the picture carries. `others`: further channels of an .exr.
void writePicture(const FinishedPicture& picture, const std::string& name, const scene::Scene& session,
                  const WantedImages& images, const std::vector<FloatChannel>& others) {
  const auto sessionIn = [&](const fs::path& folder) {
    const std::string text = sessionText(session, folder);
    return picture.accuracy ? sessionWithAccuracy(text, *picture.accuracy) : text;
  };
  const render::StillPicture& still = picture.still;
  if (name == kStandardOutput) {
    const std::string bytes = pngBytes(still.color, sessionIn(fs::current_path()));
    std::cout.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    return;
  }
  const fs::path out(name);
  const std::string text = sessionIn(out.parent_path());
  if (out.extension() == ".png")
    writePng(still.color, out, text);
  else if (images.errors.empty() && others.empty())
    writeExr(picture.inputs.request.linear ? &still.linear : nullptr, still.aovs, out, text);
  else {
    std::vector<FloatChannel> channels =
        channelsOf(still.aovs, images, picture.errors.value_or(PictureErrors{}));
    channels.insert(channels.end(), others.begin(), others.end());
    writeExr(picture.inputs.request.size, channels, out, text);
  }
}

void checkRenderOutputs(const RenderOptions& options, const RenderPlan& plan) {
  OutputGuard guard;
  guard.reads(options.light, "the baked light");
  for (const VolumePictures& pictures : plan.volumes) {
    const scene::Scene scene = sceneOf(pictures.path, *options.scene);
    addReads(guard, pictures.path, *options.scene, scene);
    if (!pictures.pictures.empty()) requestOf(options, pictures.path, scene, pictures.pictures.front().out);
  }
  for (const VolumePictures& pictures : plan.volumes)
    for (const PlannedPicture& picture : pictures.pictures) {
      if (picture.out != kStandardOutput) checkOutput(guard, picture.out, "--out");
      checkOutput(guard, picture.stats, "--stats");
    }
}

// Draws what is planned with one renderer, a volume after the other.
class RenderRun {
 public:
  RenderRun(const RenderOptions& options, const RenderPlan& plan, base::Progress& progress)
      : options_(options),
        plan_(plan),
        progress_(progress),
        host_(hostSettingsOf(*options.scene)),
        overlay_(overlayOf(options)),
        light_({.threads = host_.threads, .around = options.lightAround}) {}

  // After all pictures, which are written: some have holes.
  void throwIfDamaged() const {
    if (!damage_) return;
    const std::string others =
        damagedPictures_ < 2
            ? ""
            : "; so are parts of " + std::to_string(damagedPictures_ - 1) + " other pictures";
    throw Error(damage_->kind(), damage_->file(), damage_->place(), damage_->reason() + others);
  }

  void drawVolume(const VolumePictures& pictures) {
    if (pictures.pictures.empty()) return noteMovie(pictures);  // all of them are there
    const std::string& path = pictures.path;
    const scene::Scene asked = sceneOf(path, *options_.scene);
    scene::Scene first = asked;
    if (plan_.sweep) plan_.sweep->apply(first, 0);
    images_ = options_.aov.empty() ? AskedImages{} : askedImages(options_.aov);
    load(first.source, pictures);
    readsLight_ = !options_.light.empty();
    target_.reset();
    isChosen_ = false;
    request_ = requestOf(options_, path, asked, pictures.pictures.front().out);
    request_.keepImages = pictures.pictures.size() > 1;
    const scene::Scene base = startingScene(path);
    // The pictures of a series keep the exposure of the front, so that a film does not flicker.
    // --light-around: as the window.
    light_.meterView(!options_.lightAround && !startsFromSession(path, *options_.scene) && !plan_.sweep &&
                     options_.turntable == 0);
    for (const PlannedPicture& picture : pictures.pictures) {
      progress_.throwIfStopped();
      const scene::Scene scene = sceneOfPicture(base, picture);
      load(scene.source, pictures);
      drawPlanned(scene, picture);
    }
    printWarnings(prepared_->volume);
    noteMovie(pictures);
  }

 private:
  void load(const scene::Source& source, const VolumePictures& pictures) {
    if (prepared_ && source == source_) return;
    prepared_ = loadWithProgressBar(source, host_, progress_);
    source_ = source;
    if (!renderer_) renderer_.emplace(*options_.context, host_);
    (*renderer_)->setVolume(prepared_);
    findIndex(source, pictures);
  }

  // Not resolved, but for the camera of a series and the isovalues of time steps: those of its first picture.
  scene::Scene startingScene(const std::string& path) {
    scene::Scene scene = sceneOf(path, *options_.scene, *prepared_);
    if (plan_.sweep) plan_.sweep->apply(scene, 0);
    const CameraRequest& wanted = options_.scene->camera;
    const bool automatic = !scene.camera.eye;
    scene::Scene framed = scene;
    if (overlay_.colors) framed.look.legend = false;  // the overlay has its own
    if (options_.turntable > 0)
      scene.camera = turntableStart(wanted, automatic, scene::resolve(framed, prepared_->facts), *prepared_,
                                    request_.size, progress_);
    else
      scene.camera = requestedCamera(wanted, framed, *prepared_, request_.size, progress_,
                                     overlayReserve(overlay_, request_.size));
    if (plan_.sweep && plan_.sweep->path == "source.time_step") {
      const scene::Scene resolved = scene::resolve(scene, prepared_->facts);
      for (std::size_t i = 0; i < scene.surfaces.size(); ++i)
        scene.surfaces[i].value = resolved.surfaces[i].value;
    }
    return scene;
  }

  scene::Scene sceneOfPicture(scene::Scene scene, const PlannedPicture& picture) const {
    if (plan_.sweep) plan_.sweep->apply(scene, picture.index);
    if (options_.turntable > 0)
      scene.camera = turntableCamera(scene.camera, prepared_->facts.axes, picture.index, options_.turntable);
    return scene;
  }

  void drawPlanned(scene::Scene scene, const PlannedPicture& picture) {
    if (options_.target.any()) scene = withTarget(std::move(scene));
    PictureInputs inputs{.volume = prepared_,
                         .scene = scene::resolve(scene, prepared_->facts),
                         .request = request_,
                         .repeat = options_.repeat,
                         .errors = boundsErrors(),
                         .legend = !overlay_.colors};  // the overlay has its own
    inputs.request.supersampling = request_.aovs.empty() ? inputs.scene.picture.supersampling : 1;
    inputs.request.pixelRatio = inputs.scene.picture.pixelRatio;
    if (!prepared_->grid().isWhole()) refuseWithoutVoxels(inputs.scene);
    FinishedPicture drawn;
    std::optional<HiddenStructure> structure;
    {
      progress_.report(0.0, "drawing");
      const ProgressBar bar(progress_);
      if (std::exchange(readsLight_, false)) {
        light_.setScene(litScene(inputs.scene, inputs.request), prepared_);
        light_.load(options_.light, progress_);
      }
      drawn = drawPicture(**renderer_, light_, std::move(inputs), progress_);
      const scene::Scene& shown = drawn.inputs.scene;
      render::StillPicture& still = drawn.still;
      if (overlay_.asked) paintOverlay(*drawn.errors, shown, still);
      if (whole_) {
        const volume::LostStructure gaps(*whole_, prepared_->grid(), scene::seenIsovalues(drawn.shown),
                                         progress_);
        structure = hiddenStructure(**renderer_, {prepared_, drawn.shown, nullptr, drawn.inputs.request.size},
                                    *whole_, gaps, progress_);
      }
      if (structure && marksStructure(options_)) {
        const auto legend =
            paintStructure(*structure, shown.look.legendCorner, still.report.legend, still.color);
        if (!still.report.legend) still.report.legend = legend;
      }
      if (request_.color && !request_.linear) annotate(shown, *prepared_, still.report, still.color);
      writePicture(drawn, picture.out, carriedScene(scene, shown, exposureToCarry(light_, shown)),
                   images_.drawn, otherChannels(structure));
    }
    report(scene.derivatives, drawn, picture, structure);
  }

  bool boundsErrors() const { return options_.accuracy || overlay_.asked || !images_.drawn.errors.empty(); }
  bool asksStructure() const { return images_.structure || marksStructure(options_); }

  // Of a coarser level, where somebody asks: what is known of the volume itself.
  void findIndex(const scene::Source& source, const VolumePictures& pictures) {
    whole_.reset();
    const bool isTold =
        options_.explain ||
        std::ranges::any_of(pictures.pictures, [](const PlannedPicture& p) { return !p.stats.empty(); });
    if (source.level == 0 || !(asksStructure() || isTold)) return;
    whole_ = volume::indexedVolume(source, progress_);
    if (!whole_ && asksStructure())
      base::throwUsage(source.path, marksStructure(options_) ? "--error-overlay" : "--aov",
                       "requires the volume's index; make it with `isolux index`");
  }

  std::vector<FloatChannel> otherChannels(const std::optional<HiddenStructure>& structure) const {
    if (!images_.structure) return {};
    const std::size_t pixels = volume::Extent2{request_.size}.count();
    FloatChannel channel{kHiddenStructure, std::vector<float>(pixels)};  // level 0 hides nothing
    if (structure) channel.values.assign(structure->hides.begin(), structure->hides.end());
    return {channel};
  }

  void refuseWithoutVoxels(const scene::Scene& scene) const {
    std::optional<std::string> needs = scene::needsWholeVoxels(scene);
    if (!needs && boundsErrors()) needs = "bounds of errors: without them it can be drawn";
    if (!needs && options_.target.any()) needs = "choosing settings by error or time";
    if (needs)
      throw Error(
          ErrorKind::memory, prepared_->volume.name, "",
          "its voxels stay in the file (memory.voxels), and all of them in memory would be needed for " +
              *needs);
  }

  void paintOverlay(const PictureErrors& errors, const scene::Scene& scene,
                    render::StillPicture& picture) const {
    const auto legend = paintErrors(errors, overlay_, prepared_->grid().geometry().leastSpacingMm(),
                                    scene.look.legendCorner, picture.report.legend, picture.color);
    if (legend && !picture.report.legend) picture.report.legend = legend;
  }

  // With the settings that keep --error or --time: chosen for the volume's first picture, taken for all.
  scene::Scene withTarget(scene::Scene scene) {
    if (!std::exchange(isChosen_, true)) {
      const ProgressBar bar(progress_);
      target_ = chosenTarget(options_.target, targetQuestion(scene), **renderer_, light_, progress_);
    }
    return target_ && !target_->measured.empty()
               ? applied(target_->measured[target_->chosen].candidate, std::move(scene))
               : scene;
  }

  TargetQuestion targetQuestion(const scene::Scene& given) const {
    TargetQuestion question{
        prepared_, given, request_, host_, render::takesProcessor(host_.executor, *renderer_->context().gl()),
        {}};
    for (const std::string& assignment : options_.scene->assignments)
      question.fixed.push_back(std::string(scene::pathOf(assignment)));
    if (plan_.sweep) question.fixed.push_back(plan_.sweep->path);
    return question;
  }

  void report(const scene::Derivatives& asked, const FinishedPicture& drawn, const PlannedPicture& picture,
              const std::optional<HiddenStructure>& structure) {
    const scene::Scene& scene = drawn.inputs.scene;
    const render::FrameReport& frame = drawn.still.report;
    if (!picture.stats.empty() || options_.explain) {
      const DerivativeFacts derivatives = derivativeFacts(**renderer_, asked, drawn);
      if (!picture.stats.empty()) {
        nlohmann::ordered_json json =
            renderJson(drawn, renderer_->context().description(), light_, derivatives);
        json["level"] = levelJson(scene.source.level, prepared_->grid(), structure);
        if (target_) json["target"] = targetJson(*target_);
        writeTextFile(picture.stats, jsonText(json));
      }
      if (options_.explain) {
        if (target_)
          for (const std::string& line : targetLines(*target_)) std::printf("%s\n", line.c_str());
        printPasses(frame);
        printDerivatives(derivatives);
        printRest(scene, *prepared_);
        printBake(light_.state());
        printExposure(scene, light_.light().get());
        if (drawn.accuracy) std::printf("%s\n", accuracyLine(*drawn.accuracy).c_str());
        if (structure) std::printf("%s\n", structureLine(*structure).c_str());
      }
    }
    for (const std::string& warning : light_.state().warnings) printNote(warning);
    noteOfPicture(scene, frame);
    if (frame.bricks.lost > 0.0) {
      if (!damage_) damage_ = Error(ErrorKind::input, picture.out, "", lostLine(frame.bricks));
      ++damagedPictures_;
    }
    if (structure && structure->blocks > 0) printNote(structureLine(*structure));
    if (target_)
      for (const std::string& note : std::exchange(target_->notes, {})) printNote("--error: " + note);
  }

  void noteMovie(const VolumePictures& pictures) {
    if (pictures.movie.empty()) return;
    const int count = plan_.sweep ? plan_.sweep->count : options_.turntable;
    const std::string note =
        makeMovie(pictures.folder, pictures.moviePrefix, count, options_.fps, pictures.movie, progress_);
    if (!note.empty()) printNote(note);
  }

  const RenderOptions& options_;
  const RenderPlan& plan_;
  base::Progress& progress_;
  const scene::HostSettings host_;
  const OverlayRequest overlay_;
  std::optional<render::OffscreenRenderer> renderer_;
  LightController light_;
  std::shared_ptr<const volume::PreparedVolume> prepared_;
  scene::Source source_;  // of prepared_
  render::FrameRequest request_;
  AskedImages images_;                          // of --aov
  std::optional<volume::IndexedVolume> whole_;  // of a volume read at a coarser level
  std::optional<TargetAnswer> target_;          // of the volume; none: nothing was asked for, or is seen
  bool isChosen_ = false;
  std::optional<Error> damage_;  // of the first picture of which a part cannot be read
  std::size_t damagedPictures_ = 0;
  bool readsLight_ = false;  // of a file, before the volume's first picture
};

void runRender(const RenderOptions& options, base::Progress& progress) {
  if (options.paths.empty()) requireSource("", *options.scene);
  checkTarget(options.target);
  if (options.target.any() && options.frames->frames)
    base::throwUsage(
        "", "--frames",
        "conflicts with --error and --time: each run would choose different settings; set those that "
        "--explain prints for one image");
  const RenderPlan plan = makeRenderPlan(
      {options.paths, options.out, options.stats, options.sweep, options.turntable, *options.frames});
  std::optional<MadeFolder> made;
  if (!plan.folder.empty()) made.emplace(plan.folder);
  checkRenderOutputs(options, plan);
  RenderRun run(options, plan, progress);
  for (const VolumePictures& pictures : plan.volumes) run.drawVolume(pictures);
  run.throwIfDamaged();
}

}  // namespace

Command makeRender(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("render", "Draw images to files, without a window");
  auto options = std::make_shared<RenderOptions>();
  parser->add_option(
      "PATH", options->paths,
      "Volume files, DICOM folders, phantom:NAME[:SIZE], sessions, or .png that carry one; each is drawn");
  addOption(*parser, "--out", options->out, "FILE",
            "Image to write: .png (8 bit sRGB, with its session), .exr (float), or - for a .png to standard "
            "output. If there are several, {name}, {n}, {i} and {value} in FILE number or name them")
      ->required();
  addOption(*parser, "--size", options->size, "WxH",
            "Pixels; default: those of the session's .png, otherwise 1024x768");
  addOption(*parser, "--aov", options->aov, "LIST",
            "Write these AOVs to the .exr instead of the colours: " + imageNames() + ", " + kHiddenStructure);
  addOption(*parser, "--stats", options->stats, "FILE",
            "Write results and costs as JSON (docs/reference/outputs.md)");
  parser->add_flag("--accuracy", options->accuracy,
                   "Bound the errors of depth, normal, curvature and baked light of each pixel; printed by "
                   "--stats and --explain");
  addOption(*parser, "--error-overlay", options->overlay, "ERROR",
            "Paint the bounds of an error on the image (" + overlayNames() +
                "), hatched where they exceed --error; limits: hatching only; " + kStructureOverlay +
                ": hatching where source.level may hide a surface");
  addOption(*parser, "--light", options->light, "FILE",
            "Use the baked light of this file of `isolux bake`; missing light is baked");
  parser->add_flag("--light-around", options->lightAround,
                   "Bake light around the visible surface and meter the front, as the window does: an image "
                   "bit-identical to the window's, with less noise at rims, for 25 to 50 % more bake time");
  CLI::Option* const sweep = addOption(*parser, "--sweep", options->sweep, "PATH=LOW:HIGH:COUNT",
                                       "Draw an image for each of COUNT evenly spaced values of a numeric "
                                       "setting; of source.time_step also a movie if ffmpeg is installed");
  addOption(*parser, "--turntable", options->turntable, "N",
            "Draw N views around the volume's up axis, and a movie if ffmpeg is installed")
      ->check(within(1, 100000))
      ->excludes(sweep);
  addOption(*parser, "--fps", options->fps, "N", "Frames per second of the movie; default 24")
      ->check(within(0.01, 240.0));
  parser->add_flag("--explain", options->explain,
                   "Print each pass, whether it ran, and why; and what light is baked");
  addOption(*parser, "--repeat", options->repeat, "N",
            "Draw N frames after one to warm up; --stats has their median time")
      ->check(within(0, 100000));
  addTargetOptions(*parser, options->target);
  options->frames = addFrameOptions(*parser);
  options->context = addContextOption(*parser);
  addThreadsOption(*parser);
  options->scene = addSceneOptions(*parser);
  addVolumeOptions(*parser, options->scene);
  parser->footer(
      "Examples:\n"
      "  isolux render ct.nii.gz --isovalue 300 --out skull.png --size 1600x1200\n"
      "  isolux render phantom:torus --out torus.exr --aov position,normal\n"
      "  isolux render skull.png --set look.mode=normal --out normals.png\n"
      "  isolux render a.nii.gz b.nii.gz --preset ct_bone --view left --fit surface --out '{name}.png'\n"
      "  isolux render ct.nii.gz --sweep isosurface.value=100:300:9 --out 'skull_{value}.png'\n"
      "  isolux render ct.nii.gz --isovalue 300 --turntable 72 --out turn\n"
      "  isolux render 'flow_*.vti' --sweep source.time_step=0:9:73 --out flow\n"
      "  isolux render ct.nii.gz --isovalue 300 --error depth=0.01mm,missed=0.1% --explain --out skull.png\n"
      "  isolux render ct.nii.gz --look gi --error light=5% --out lit.png\n"
      "  isolux render ct.nii.gz --time 100ms --out quick.png");
  return {parser, [options](base::Progress& progress) { runRender(*options, progress); }};
}

}  // namespace isolux::app
