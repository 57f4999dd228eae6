#include "app/jobs/glimpse_job.h"

#include <utility>

#include "app/ready/quiet_renderer.h"
#include "app/ready/ready_fields.h"
#include "render/still_picture.h"
#include "scene/rules/automatic.h"

namespace isolux::app {

std::unique_ptr<GlimpseTask> glimpseTask(GlimpseSubject asked) {
  const auto work = [subject = std::move(asked)](base::Progress& progress) -> std::optional<DrawnGlimpse> {
    std::optional<volume::Glimpse> glimpse =
        volume::readGlimpse(subject.scene.source, progress, subject.least);
    if (!glimpse) return std::nullopt;
    DrawnGlimpse drawn{{}, glimpse->step, glimpse->fromIndex};
    const auto prepared = volume::prepareVolume(std::move(glimpse->volume), progress);
    scene::Scene scene = scene::resolve(subject.scene, prepared->facts);
    scene.picture.transparent = false;
    scene = withReadyFields(std::move(scene), *prepared);
    QuietRenderer quiet(prepared, nullptr);
    render::FrameRequest request;
    request.size = subject.size;
    request.pixelRatio = subject.pixelRatio;
    request.supersampling = 2;
    request.stop = progress.token();
    drawn.picture = render::drawStill(quiet.renderer(), scene, request, progress).color;
    return drawn;
  };
  return GlimpseTask::start({"", "take a first look at the volume"}, work);
}

}  // namespace isolux::app
