#include "app/jobs/glimpse_job.h"

#include <utility>

#include "app/picture/field_job.h"
#include "app/picture/quiet_renderer.h"
#include "render/still_picture.h"
#include "scene/rules/automatic.h"

namespace isolux::app {

void GlimpseWork::run(base::Progress& progress) {
  std::optional<volume::Glimpse> glimpse = volume::readGlimpse(subject.scene.source, progress, subject.least);
  if (!glimpse) return;
  step = glimpse->step;
  fromIndex = glimpse->fromIndex;
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
  picture = render::drawStill(quiet.renderer(), scene, request, progress).color;
}

}  // namespace isolux::app
