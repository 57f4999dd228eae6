#include "app/jobs/accuracy_job.h"

#include <utility>

#include "app/jobs/field_job.h"
#include "app/jobs/rest_scene.h"
#include "render/gl/gl_context.h"

namespace isolux::app {

void AccuracyWork::run(base::Progress& progress) {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  context->makeCurrent();
  render::Renderer renderer(context->gl());
  scene::Machine machine;
  machine.executor = scene::Executor::cpu;  // the volume is on the graphics card once, for the user
  renderer.setMachine(machine);
  renderer.setVolume(subject.volume);
  renderer.setLight(subject.light);
  scene::Scene shown = subject.scene;
  completeFields(shown, *subject.volume, true, progress);
  shown = atRest(std::move(shown), *subject.volume, progress);
  render::FrameRequest request;
  request.size = subject.size;
  request.stop = progress.token();
  PictureErrors errors = measureErrors(renderer, std::move(shown), request, *subject.volume, progress,
                                       {subject.light, subject.volume}, subject.onProcessor);
  accuracy = accuracyOf(errors);
  if (subject.keepImages) images = std::make_shared<const PictureErrors>(std::move(errors));
}

}  // namespace isolux::app
