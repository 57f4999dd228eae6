#include "app/jobs/study_job.h"

#include <utility>

#include "render/gl/gl_context.h"

namespace isolux::app {

std::vector<KnobStudy> StudyJob::take() {
  const std::lock_guard lock(work().mutex);
  return std::exchange(work().found, {});
}

void StudyWork::run(base::Progress& progress) {
  const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
  context->makeCurrent();
  Studio studio(context->gl(), subject.volume, subject.scene, subject.machine, subject.size, subject.repeat);
  const double part = 1.0 / static_cast<double>(subject.knobs.size());
  for (std::size_t i = 0; i < subject.knobs.size(); ++i) {
    const double from = part * static_cast<double>(i);
    KnobStudy study = studio.study(subject.knobs[i], progress, from, from + part);
    const std::lock_guard lock(mutex);
    found.push_back(std::move(study));
  }
}

}  // namespace isolux::app
