#include "app/commands/render_plan.h"

#include <algorithm>
#include <filesystem>

#include <unistd.h>

#include "app/series/picture_names.h"
#include "base/error.h"
#include "base/number_text.h"

namespace isolux::app {

namespace fs = std::filesystem;

namespace {

// "turn.mp4" of the pictures "turn_00000.png", ...; "movie.mp4" of "frame_00000.png", as of a replay.
void planMovie(const std::string& pattern, const PictureOfSeries& first, VolumePictures& pictures) {
  const fs::path file(pattern);
  const std::string name = file.filename().string();
  const std::string end = "{i}.png";
  if (!name.ends_with(end)) return;
  pictures.moviePrefix = expandedName(name.substr(0, name.size() - end.size()), first);
  std::string stem = pictures.moviePrefix;
  while (!stem.empty() && (stem.back() == '_' || stem.back() == '-')) stem.pop_back();
  pictures.movie = (stem.empty() || stem == "frame" ? "movie" : stem) + ".mp4";
}

void checkPipe(std::size_t pictures) {
  if (pictures > 1)
    base::throwUsage("", "--out", "standard output takes one image; these are " + std::to_string(pictures));
  if (::isatty(STDOUT_FILENO) != 0)
    base::throwUsage("", "--out", "standard output is a terminal; send the image to a file or a pipe");
}

std::string seriesValue(const RenderPlan& plan, int turntable, int index) {
  if (plan.sweep) return base::shortestText(plan.sweep->value(index));
  return turntable > 0 ? base::shortText(360.0 * index / turntable) : std::string();
}

// A run that draws a part of the pictures makes no movie of them.
void chooseFrames(const FrameChoice& choice, RenderPlan& plan) {
  for (VolumePictures& pictures : plan.volumes) {
    std::erase_if(pictures.pictures,
                  [&](const PlannedPicture& picture) { return !choice.wants(picture.index, picture.out); });
    if (choice.frames) pictures.movie.clear();
  }
}

}  // namespace

RenderPlan makeRenderPlan(const RenderPlanRequest& request) {
  RenderPlan plan;
  if (!request.sweep.empty()) plan.sweep = parseSweep(request.sweep);
  const bool series = plan.sweep || request.turntable > 0;
  const int count = plan.sweep ? plan.sweep->count : std::max(request.turntable, 1);
  std::vector<std::string> paths = request.paths;
  if (paths.empty()) paths.emplace_back();
  const bool several = series || paths.size() > 1;
  const std::string out = several ? completePattern(request.out, paths.size(), series) : request.out;
  if (!series && request.frames.frames) base::throwUsage("", "--frames", "requires --turntable or --sweep");
  request.frames.check(count);
  if (out != request.out && out.starts_with(request.out)) plan.folder = request.out;
  if (out == kStandardOutput) checkPipe(paths.size() * static_cast<std::size_t>(count));

  const bool isFilm = count > 1 && (!plan.sweep || plan.sweep->path == "source.time_step");
  std::vector<std::string> outs, stats;
  for (std::size_t v = 0; v < paths.size(); ++v) {
    VolumePictures pictures{paths[v], {}, {}, {}, {}};
    PictureOfSeries of{paths[v], static_cast<int>(v) + 1, 0, ""};
    for (of.i = 0; of.i < count; ++of.i) {
      of.value = seriesValue(plan, request.turntable, of.i);
      pictures.pictures.push_back({expandedName(out, of), expandedName(request.stats, of), of.i});
      outs.push_back(pictures.pictures.back().out);
      stats.push_back(pictures.pictures.back().stats);
    }
    pictures.folder = fs::path(pictures.pictures.front().out).parent_path();
    of.i = 0;
    if (isFilm) planMovie(out, of, pictures);
    plan.volumes.push_back(std::move(pictures));
  }
  checkNamesDiffer(outs, "--out");
  if (!request.stats.empty()) checkNamesDiffer(stats, "--stats");
  chooseFrames(request.frames, plan);
  return plan;
}

}  // namespace isolux::app
