#include "app/jobs/accuracy_job.h"

#include <new>
#include <utility>

#include "app/jobs/field_job.h"
#include "app/jobs/give_way.h"
#include "app/jobs/rest_scene.h"
#include "render/gl/gl_context.h"

namespace isolux::app {

AccuracyJob::AccuracyJob(Subject subject)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->subject = std::move(subject);
            return work;
          }(),
          run) {}

AccuracyJob::~AccuracyJob() {
  work_->progress.requestStop();
}

void AccuracyJob::measure(Work& work) {
  const Subject& subject = work.subject;
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  context->makeCurrent();
  render::Renderer renderer(context->gl());
  scene::Machine machine;
  machine.executor = scene::Executor::cpu;  // the volume is on the graphics card once, for the user
  renderer.setMachine(machine);
  renderer.setVolume(subject.volume);
  renderer.setLight(subject.light);
  scene::Scene shown = subject.scene;
  completeFields(shown, *subject.volume, true, work.progress);
  shown = atRest(std::move(shown), *subject.volume, work.progress);
  render::FrameRequest request;
  request.size = subject.size;
  request.stop = work.progress.token();
  work.accuracy =
      accuracyOf(measureErrors(renderer, std::move(shown), request, *subject.volume, work.progress,
                               {subject.light, subject.volume}, subject.onProcessor));
}

void AccuracyJob::run(Work& work) {
  giveWay();
  try {
    measure(work);
  } catch (const base::Error& error) {
    work.error = error;
  } catch (const std::bad_alloc&) {
    work.error.emplace(base::ErrorKind::memory, "", "", "not enough memory to bound the picture's errors");
  }
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
