#include "app/jobs/accuracy_job.h"

#include <utility>

#include "app/jobs/give_way.h"
#include "app/ready/quiet_renderer.h"
#include "app/ready/ready_fields.h"
#include "app/ready/rest_scene.h"

namespace isolux::app {

std::unique_ptr<AccuracyTask> accuracyTask(AccuracySubject asked) {
  const auto work = [subject = std::move(asked)](base::Progress& progress) {
    giveWay();
    QuietRenderer quiet(subject.volume, subject.light);
    scene::Scene shown = subject.scene;
    completeFields(shown, *subject.volume, true, progress);
    shown = atRest(std::move(shown), *subject.volume, progress);
    render::FrameRequest request;
    request.size = subject.size;
    request.stop = progress.token();
    PictureErrors errors = measureErrors(quiet.renderer(), std::move(shown), request, *subject.volume,
                                         progress, {subject.light, subject.volume}, subject.onProcessor);
    MeasuredPicture measured{accuracyOf(errors), nullptr};
    if (subject.keepImages) measured.images = std::make_shared<const PictureErrors>(std::move(errors));
    return measured;
  };
  return AccuracyTask::start({"", "bound the errors of the image"}, work);
}

}  // namespace isolux::app
