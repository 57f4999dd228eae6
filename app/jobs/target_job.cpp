#include "app/jobs/target_job.h"

#include <new>
#include <utility>

#include "app/jobs/give_way.h"
#include "render/gl/gl_context.h"
#include "render/passes/processor.h"

namespace isolux::app {

namespace {

std::atomic<int> searching{0};

}  // namespace

TargetJob::TargetJob(Subject subject)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->subject = std::move(subject);
            ++searching;
            return work;
          }(),
          run) {}

TargetJob::~TargetJob() {
  work_->progress.requestStop();
}

int TargetJob::running() {
  return searching;
}

void TargetJob::search(Work& work) {
  const Subject& subject = work.subject;
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  context->makeCurrent();
  render::Renderer renderer(context->gl());
  renderer.setMachine(subject.machine);
  renderer.setVolume(subject.volume);
  renderer.setLight(subject.light);
  TargetQuestion question{subject.volume,
                          subject.scene,
                          subject.picture,
                          subject.machine,
                          render::takesProcessor(subject.machine.executor, *context->gl()),
                          {}};
  question.picture.stop = work.progress.token();
  TargetSearch search(renderer, std::move(question));
  work.answer = subject.limits.empty() ? search.keepTime(subject.milliseconds, work.progress)
                                       : search.keepErrors(subject.limits, work.progress);
}

void TargetJob::run(Work& work) {
  giveWay();
  try {
    search(work);
  } catch (const base::Error& error) {
    work.error = error;
  } catch (const std::bad_alloc&) {
    work.error.emplace(base::ErrorKind::memory, "", "", "not enough memory to choose settings");
  }
  work.finished.store(true, std::memory_order_release);
  --searching;
}

}  // namespace isolux::app
