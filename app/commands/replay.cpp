// isolux replay RECORDING --out DIR: a recorded session as numbered frames, and a movie when ffmpeg is there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <optional>

#include "app/commands/command.h"
#include "app/external_program.h"
#include "app/files.h"
#include "app/image_io.h"
#include "app/light_picture.h"
#include "app/progress_bar.h"
#include "app/recording.h"
#include "app/session.h"
#include "render/renderer.h"
#include "scene/automatic.h"
#include "scene/error.h"

namespace isolux::app {

namespace {

namespace fs = std::filesystem;
using scene::Error;
using scene::ErrorKind;

constexpr int mostFrames = 100000;  // five digits

struct ReplayOptions {
  std::string recording, out, size = "1280x720";
  double fps = 30.0;
  std::shared_ptr<render::ContextChoice> context;
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
    throw Error(ErrorKind::usage, file, "",
                "lasts " + numberText(recording.duration()) + " s: more than 100000 frames at this --fps");
  return static_cast<int>(count);
}

// Draws scenes one after the other, loading a volume when the source changes.
class FrameMaker {
 public:
  FrameMaker(render::ContextChoice choice, glm::ivec2 size)
      : context_(render::OffscreenContext::create(choice)) {
    context_->makeCurrent();
    renderer_.emplace(context_->gl());
    request_.size = size;
  }

  void write(const scene::Scene& scene, const fs::path& file, scene::Progress& progress) {
    if (!prepared_ || !(source_ == scene.source)) {
      prepared_ = volume::loadVolume(scene.source, progress);
      source_ = scene.source;
      renderer_->setVolume(prepared_);
    }
    const scene::Scene resolved = scene::resolve(scene, prepared_->facts);
    if (!image_ || !(resolved == drawn_)) {
      request_.supersampling = resolved.picture.supersampling;
      lightPicture(light_, *renderer_, resolved, request_, prepared_, progress);
      renderer_->render(resolved, request_);
      image_ = renderer_->readColor();
      drawn_ = resolved;
    }
    writePng(*image_, file, sessionText(resolved, file.parent_path()));
  }

 private:
  std::unique_ptr<render::OffscreenContext> context_;
  std::optional<render::Renderer> renderer_;
  LightController light_{LightController::Options{}};
  render::FrameRequest request_;
  std::shared_ptr<const volume::PreparedVolume> prepared_;
  scene::Source source_;
  scene::Scene drawn_;
  std::optional<render::ColorImage> image_;
};

std::string lastLine(std::string text) {
  while (!text.empty() && (text.back() == '\n' || text.back() == '\r')) text.pop_back();
  return text.substr(text.rfind('\n') + 1);
}

// A movie is an extra: without a working ffmpeg the frames are the result, and a note says so.
void makeMovie(const fs::path& folder, int frames, double fps, scene::Progress& progress) {
  const fs::path ffmpeg = findProgram("ffmpeg");
  if (ffmpeg.empty()) {
    std::cerr << "isolux: note: no movie.mp4: ffmpeg was not found\n";
    return;
  }
  PendingFile movie(folder / "movie.mp4");
  // In the folder, by plain names: a "%" in the folder's own name would be taken for a pattern.
  const ProgramResult result = runProgram(
      ffmpeg,
      {"-nostdin", "-loglevel", "error", "-y", "-framerate", numberText(fps), "-start_number", "0", "-i",
       "frame_%05d.png", "-frames:v", std::to_string(frames), "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2",
       "-pix_fmt", "yuv420p", "-f", "mp4", movie.path().filename().string()},
      folder, progress);
  std::error_code missing;
  if (result.exitCode == 0 && fs::file_size(movie.path(), missing) > 0 && !missing) {
    movie.commit();
    return;
  }
  std::cerr << "isolux: note: no movie.mp4: ffmpeg failed (" << result.exitCode
            << "): " << lastLine(result.output) << '\n';
}

void noteOlderFrames(const fs::path& folder, int frames) {
  std::error_code ignored;
  if (frames < mostFrames && fs::exists(folder / frameName(frames), ignored))
    std::cerr << "isolux: note: " << folder.string() << " holds more frames, of an older replay\n";
}

void runReplay(const ReplayOptions& options, scene::Progress& progress) {
  const glm::ivec2 size = parseSize(options.size);
  const Recording recording = loadRecording(options.recording);
  const int frames = frameCount(recording, options.fps, options.recording);
  const fs::path folder(options.out);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error || !fs::is_directory(folder))
    scene::throwInput(options.out, "", "is not a folder and cannot be made one");
  { const PendingFile writable(folder / frameName(0)); }

  {
    FrameMaker maker(*options.context, size);
    const ProgressBar bar(progress);
    scene::Scene scene = recording.start;
    std::size_t next = 0;
    for (int frame = 0; frame < frames; ++frame) {
      progress.throwIfStopped();
      // The small slack keeps a change at exactly n/fps in frame n for every rounding of the quotient.
      const double until = frame / options.fps + 1e-9;
      for (; next < recording.steps.size() && recording.steps[next].seconds <= until; ++next)
        scene = scene::applied(std::move(scene), recording.steps[next].diff);
      maker.write(scene, folder / frameName(frame), progress);
      progress.report((frame + 1.0) / frames, "drawing frames");
    }
  }
  noteOlderFrames(folder, frames);
  makeMovie(folder, frames, options.fps, progress);
}

}  // namespace

Command makeReplay(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand(
      "replay", "Draw a recording as numbered frames, and a movie when ffmpeg is found");
  auto options = std::make_shared<ReplayOptions>();
  parser->add_option("RECORDING", options->recording, "A file made by `isolux PATH --record FILE`")
      ->required();
  parser
      ->add_option("--out", options->out,
                   "The folder for frame_00000.png, frame_00001.png, ... and movie.mp4; made if missing")
      ->type_name("DIR")
      ->required();
  parser->add_option("--fps", options->fps, "Frames per second of the recording's time; default 30")
      ->type_name("N")
      ->check(CLI::Range(0.01, 240.0).description(""));
  parser->add_option("--size", options->size, "Pixels; default 1280x720")->type_name("WxH");
  options->context = addContextOption(*parser);
  addThreadsOption(*parser);
  parser->footer("Example:\n  isolux replay tour.jsonl --out frames --fps 25");
  return {parser, [options](scene::Progress& progress) { runReplay(*options, progress); }};
}

}  // namespace isolux::app
