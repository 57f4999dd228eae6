// isolux replay RECORDING --out DIR: a recorded session as numbered frames, and a movie when ffmpeg is there.
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>

#include "app/commands/command.h"
#include "app/documents/picture_scene.h"
#include "app/documents/recording.h"
#include "app/documents/session.h"
#include "app/files/files.h"
#include "app/files/image_io.h"
#include "app/overlay_text/annotation.h"
#include "app/picture/finished_picture.h"
#include "app/runtime/progress_bar.h"
#include "app/series/movie.h"
#include "base/error.h"
#include "base/number_text.h"
#include "render/offscreen_renderer.h"
#include "scene/rules/automatic.h"
#include "scene/settings/scene_diff.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;

constexpr int mostFrames = 100000;  // five digits

struct ReplayOptions {
  std::string recording, out, size = "1280x720";
  double fps = 30.0;
  std::shared_ptr<render::ContextChoice> context;
  std::shared_ptr<FrameChoice> frames;
};

std::string frameName(int frame) {
  std::array<char, 32> name{};
  std::snprintf(name.data(), name.size(), "frame_%05d.png", frame);
  return name.data();
}

// The frame at a time shows every change up to it; the last frame shows the last change.
int frameCount(const Recording& recording, double fps, const std::string& file) {
  const double count = std::ceil(recording.duration() * fps - 1e-9) + 1.0;
  if (count > mostFrames)
    base::throwUsage(
        file, "",
        "lasts " + base::shortestText(recording.duration()) + " s: more than 100000 frames at this --fps");
  return static_cast<int>(count);
}

// Draws scenes one after the other, loading a volume when the source changes.
class FrameMaker {
 public:
  FrameMaker(render::ContextChoice choice, glm::ivec2 size) : renderer_(choice) { request_.size = size; }

  void write(const scene::Scene& scene, const fs::path& file, base::Progress& progress) {
    if (!prepared_ || !(source_ == scene.source)) {
      prepared_ = volume::loadVolume(scene.source, progress);
      source_ = scene.source;
      renderer_->setVolume(prepared_);
    }
    scene::Scene resolved = scene::resolve(scene, prepared_->facts);
    if (!image_ || !(resolved == asked_)) {
      asked_ = resolved;
      request_.supersampling = resolved.picture.supersampling;
      request_.pixelRatio = resolved.picture.pixelRatio;
      FinishedPicture picture =
          drawPicture(*renderer_, light_,
                      {.volume = prepared_, .scene = std::move(resolved), .request = request_}, progress);
      drawn_ = std::move(picture.inputs.scene);
      annotate(drawn_, *prepared_, picture.still.report, picture.still.color);
      image_ = std::move(picture.still.color);
    }
    writePng(*image_, file, sessionText(carriedScene(scene, drawn_), file.parent_path()));
  }

 private:
  render::OffscreenRenderer renderer_;
  LightController light_{LightController::Options{}};
  render::FrameRequest request_;
  std::shared_ptr<const volume::PreparedVolume> prepared_;
  scene::Source source_;
  scene::Scene asked_, drawn_;  // of image_: resolved, and complete
  std::optional<render::ColorImage> image_;
};

void noteOlderFrames(const fs::path& folder, int frames) {
  std::error_code ignored;
  if (frames < mostFrames && fs::exists(folder / frameName(frames), ignored))
    printNote(folder.string() + " holds more frames, of an older replay");
}

// Every scene of the recording may name files of its own.
void checkOutputs(const fs::path& folder, int frames, const std::string& file, const Recording& recording) {
  OutputGuard guard;
  guard.reads(file, "the recording");
  scene::Scene scene = recording.start;
  guard.reads(scene);
  for (const Recording::Step& step : recording.steps) {
    scene::Scene next = scene::applied(scene, step.diff);
    if (!(next.source == scene.source) || next.light.environment.file != scene.light.environment.file)
      guard.reads(next);
    scene = std::move(next);
  }
  checkOutput(guard, (folder / frameName(0)).string(), "--out");
  for (int frame = 1; frame < frames; ++frame)
    if (std::error_code ignored; fs::exists(folder / frameName(frame), ignored))
      guard.writes(folder / frameName(frame), "--out");
  guard.writes(folder / "movie.mp4", "--out");
}

void runReplay(const ReplayOptions& options, base::Progress& progress) {
  const glm::ivec2 size = parseSize(options.size);
  const Recording recording = loadRecording(options.recording);
  const int frames = frameCount(recording, options.fps, options.recording);
  options.frames->check(frames);
  const MadeFolder made(options.out);
  const fs::path& folder = made.path();
  checkOutputs(folder, frames, options.recording, recording);

  {
    FrameMaker maker(*options.context, size);
    const ProgressBar bar(progress);
    Playback playback(recording);
    for (int frame = 0; frame < frames; ++frame) {
      progress.throwIfStopped();
      const scene::Scene& scene = playback.at(frame / options.fps);
      if (options.frames->wants(frame, folder / frameName(frame)))
        maker.write(scene, folder / frameName(frame), progress);
      progress.report((frame + 1.0) / frames, "drawing frames");
    }
  }
  for (const std::string& warning : recording.warnings) printNote(options.recording + ": " + warning);
  noteOlderFrames(folder, frames);
  if (options.frames->frames) return;
  const std::string note = makeMovie(folder, "frame_", frames, options.fps, "movie.mp4", progress);
  if (!note.empty()) printNote(note);
}

}  // namespace

Command makeReplay(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "replay", "Draw a recording as numbered frames, and a movie if ffmpeg is installed");
  auto options = std::make_shared<ReplayOptions>();
  parser->add_option("RECORDING", options->recording, "A file made by `isolux PATH --record FILE`")
      ->required();
  addOption(*parser, "--out", options->out, "DIR",
            "Folder for frame_00000.png, frame_00001.png, ... and movie.mp4; created if missing")
      ->required();
  addOption(*parser, "--fps", options->fps, "N", "Frames per second of the recording's time; default 30")
      ->check(within(0.01, 240.0));
  addOption(*parser, "--size", options->size, "WxH", "Pixels; default 1280x720");
  options->frames = addFrameOptions(*parser);
  options->context = addContextOption(*parser);
  addThreadsOption(*parser);
  parser->footer(
      "Examples:\n"
      "  isolux replay tour.jsonl --out frames --fps 25\n"
      "  isolux replay tour.jsonl --out frames --fps 25 --frames 100-199 --skip-existing");
  return {parser, [options](base::Progress& progress) { runReplay(*options, progress); }};
}

}  // namespace isolux::app
