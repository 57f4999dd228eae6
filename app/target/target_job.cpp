#include "app/target/target_job.h"

#include <atomic>
#include <utility>

#include "app/jobs/give_way.h"
#include "render/gl/gl_context.h"
#include "render/passes/processor.h"

namespace isolux::app {

namespace {

std::atomic<int> searching{0};

std::optional<TargetAnswer> answerTo(const TargetSubject& subject, base::Progress& progress) {
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
  question.picture.stop = progress.token();
  TargetSearch search(renderer, std::move(question));
  return subject.limits.empty() ? search.keepTime(subject.milliseconds, progress)
                                : search.keepErrors(subject.limits, progress);
}

}  // namespace

std::unique_ptr<TargetTask> targetTask(TargetSubject asked) {
  ++searching;
  const std::shared_ptr<const void> counted(&searching, [](const void*) { --searching; });
  const auto work = [subject = std::move(asked), counted](base::Progress& progress) {
    giveWay();
    return answerTo(subject, progress);
  };
  return TargetTask::start({"", "choose settings"}, work);
}

int runningSearches() {
  return searching;
}

}  // namespace isolux::app
