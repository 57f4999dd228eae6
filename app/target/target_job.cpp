#include "app/target/target_job.h"

#include <atomic>
#include <utility>

#include "render/gl/gl_context.h"
#include "render/passes/processor.h"

namespace isolux::app {

namespace {

std::atomic<int> searching{0};
}  // namespace

int TargetJob::running() {
  return searching;
}

std::shared_ptr<const void> TargetWork::counted() {
  ++searching;
  return {&searching, [](const void*) { --searching; }};
}

void TargetWork::run(base::Progress& progress) {
  const std::shared_ptr<const void> untilTheEnd = std::move(counts);
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
  answer = subject.limits.empty() ? search.keepTime(subject.milliseconds, progress)
                                  : search.keepErrors(subject.limits, progress);
}

}  // namespace isolux::app
