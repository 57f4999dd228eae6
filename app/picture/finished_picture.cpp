#include "app/picture/finished_picture.h"

#include <utility>
#include <vector>

#include "app/light/light_picture.h"
#include "app/ready/ready_fields.h"
#include "app/ready/rest_scene.h"
#include "base/quantiles.h"

namespace isolux::app {

FinishedPicture drawPicture(render::Renderer& renderer, LightController& light, PictureInputs inputs,
                            base::Progress& progress) {
  FinishedPicture picture{std::move(inputs)};
  auto& [volume, scene, request, repeat, errors, legend] = picture.inputs;
  completeFields(scene, *volume, !request.aovs.empty(), progress);
  lightPicture(light, renderer, scene, request, volume, progress);
  picture.shown = request.aovs.empty() ? atRest(scene, *volume, progress) : scene;
  picture.shown.look.legend = legend && scene.look.legend;
  progress.report(0.0, "drawing");
  picture.still = render::drawStill(renderer, picture.shown, request, progress);
  picture.milliseconds = picture.still.report.milliseconds;
  std::vector<double> times;
  for (int i = 0; i < repeat; ++i) {
    progress.throwIfStopped();
    progress.report(static_cast<double>(i) / repeat, "measuring");
    renderer.invalidate();
    picture.still = render::drawStill(renderer, picture.shown, request, progress);
    times.push_back(picture.still.report.milliseconds);
  }
  if (!times.empty()) picture.milliseconds = base::median(std::move(times));
  progress.throwIfStopped();
  if (!errors) return picture;
  picture.errors = measureErrors(renderer, {volume, picture.shown, light.light(), request.size}, progress);
  picture.accuracy = accuracyOf(*picture.errors);
  return picture;
}

}  // namespace isolux::app
