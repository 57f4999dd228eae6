#include "app/tasks/volume_preview_task.h"

#include <utility>

#include "app/ready/quiet_renderer.h"
#include "app/ready/ready_fields.h"
#include "render/still_picture.h"
#include "scene/rules/automatic.h"

namespace isolux::app {

std::unique_ptr<VolumePreviewTask> volumePreviewTask(VolumePreviewSubject asked) {
  const auto work = [subject =
                         std::move(asked)](base::Progress& progress) -> std::optional<DrawnVolumePreview> {
    std::optional<volume::VolumePreview> preview =
        volume::readVolumePreview(subject.scene.source, progress, subject.least);
    if (!preview) return std::nullopt;
    DrawnVolumePreview drawn{{}, preview->step, preview->fromIndex};
    const auto prepared = volume::prepareVolume(std::move(preview->volume), progress);
    scene::Scene scene = scene::resolve(subject.scene, prepared->facts);
    scene.picture.transparent = false;
    scene = withReadyFields(std::move(scene), *prepared);
    QuietRenderer quiet(prepared, nullptr);
    const render::FrameRequest request{
        .size = subject.size, .supersampling = 2, .pixelRatio = subject.pixelRatio, .stop = progress.token()};
    drawn.picture = render::drawStill(*quiet, scene, request, progress).color;
    return drawn;
  };
  return VolumePreviewTask::start({"", "take a first look at the volume"}, work);
}

}  // namespace isolux::app
