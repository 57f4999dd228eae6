#include "app/jobs/study_job.h"

#include <new>
#include <utility>

#include "app/jobs/give_way.h"
#include "render/gl/gl_context.h"

namespace isolux::app {

StudyJob::StudyJob(Subject subject)
    : work_(
          [&] {
            auto work = std::make_shared<Work>();
            work->subject = std::move(subject);
            return work;
          }(),
          run) {}

StudyJob::~StudyJob() {
  work_->progress.requestStop();
}

std::vector<KnobStudy> StudyJob::take() {
  const std::lock_guard lock(work_->mutex);
  return std::exchange(work_->found, {});
}

void StudyJob::study(Work& work) {
  const Subject& subject = work.subject;
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  context->makeCurrent();
  Studio studio(context->gl(), subject.volume, subject.scene, subject.machine, subject.size, subject.repeat);
  const double part = 1.0 / static_cast<double>(subject.knobs.size());
  for (std::size_t i = 0; i < subject.knobs.size(); ++i) {
    const double from = part * static_cast<double>(i);
    KnobStudy found = studio.study(subject.knobs[i], work.progress, from, from + part);
    const std::lock_guard lock(work.mutex);
    work.found.push_back(std::move(found));
  }
}

void StudyJob::run(Work& work) {
  giveWay();
  try {
    study(work);
  } catch (const base::Error& error) {
    work.error = error;
  } catch (const std::bad_alloc&) {
    work.error.emplace(base::ErrorKind::memory, "", "", "not enough memory to measure accuracy");
  }
  work.finished.store(true, std::memory_order_release);
}

}  // namespace isolux::app
