#include "app/jobs/accuracy_job.h"

#include <utility>

#include "app/picture/field_job.h"
#include "app/picture/quiet_renderer.h"
#include "app/picture/rest_scene.h"

namespace isolux::app {

void AccuracyWork::run(base::Progress& progress) {
  QuietRenderer quiet(subject.volume, subject.light);
  scene::Scene shown = subject.scene;
  completeFields(shown, *subject.volume, true, progress);
  shown = atRest(std::move(shown), *subject.volume, progress);
  render::FrameRequest request;
  request.size = subject.size;
  request.stop = progress.token();
  PictureErrors errors = measureErrors(quiet.renderer(), std::move(shown), request, *subject.volume, progress,
                                       {subject.light, subject.volume}, subject.onProcessor);
  accuracy = accuracyOf(errors);
  if (subject.keepImages) images = std::make_shared<const PictureErrors>(std::move(errors));
}

}  // namespace isolux::app
