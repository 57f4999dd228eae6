#include "app/commands/render_target.h"

#include "app/commands/command.h"
#include "app/light/light_picture.h"
#include "app/ready/ready_fields.h"
#include "scene/rules/automatic.h"

namespace isolux::app {

void addTargetOptions(CLI::App& parser, TargetOptions& options) {
  CLI::Option* const error = addOption(parser, "--error", options.error, "LIST",
                                       "Choose the cheapest settings whose errors are at most these: depth "
                                       "in mm or vox, missed (pixels) in %, normal in deg, curvature and "
                                       "light in %, as depth=0.01mm,light=2%. Settings given by --set stay")
                                 ->excludes("--light");
  addOption(parser, "--time", options.time, "TIME",
            "Choose the most accurate settings whose frames take at most this on this computer, as 100ms")
      ->excludes(error);
}

void checkTarget(const TargetOptions& options) {
  if (!options.error.empty()) parseErrorTarget(options.error);
  if (!options.time.empty()) parseTimeTarget(options.time);
}

namespace {

std::optional<TargetAnswer> searched(const TargetOptions& options, const TargetQuestion& question,
                                     render::Renderer& renderer, LightController& light,
                                     base::Progress& progress) {
  TargetSearch search(renderer, question);
  if (!options.error.empty()) return search.keepErrors(parseErrorTarget(options.error), progress);
  // A time is that of frames whose light is stored: it is baked before.
  scene::Scene lit = scene::resolve(question.given, question.volume->facts);
  completeFields(lit, *question.volume, !question.picture.aovs.empty(), progress);
  lightPicture(light, renderer, lit, question.picture, question.volume, progress);
  return search.keepTime(parseTimeTarget(options.time), progress);
}

}  // namespace

std::optional<TargetAnswer> chosenTarget(const TargetOptions& options, const TargetQuestion& question,
                                         render::Renderer& renderer, LightController& light,
                                         base::Progress& progress) {
  const std::string option = options.error.empty() ? "--time" : "--error";
  refuseCuts(question.given, ("isolux render " + option).c_str());
  const std::optional<TargetAnswer> answer = searched(options, question, renderer, light, progress);
  renderer.invalidate();  // the picture's passes are its own
  if (!answer) printNote(option + ": the first isosurface is not visible; no settings were chosen");
  return answer;
}

}  // namespace isolux::app
