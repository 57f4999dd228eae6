#include "app/jobs/study_job.h"

#include <utility>

#include "app/jobs/give_way.h"
#include "render/gl/gl_context.h"

namespace isolux::app {

std::unique_ptr<StudyTask> studyTask(StudySubject subject, std::vector<Knob> knobs) {
  const auto work = [subject = std::move(subject), knobs = std::move(knobs)](base::Progress& progress,
                                                                             const auto& tell) {
    giveWay();
    const auto context = render::OffscreenContext::create(render::ContextChoice::automatic);
    context->makeCurrent();
    Studio studio(context->gl(), subject);
    const double part = 1.0 / static_cast<double>(knobs.size());
    for (std::size_t i = 0; i < knobs.size(); ++i) {
      const double from = part * static_cast<double>(i);
      KnobStudy study = studio.study(knobs[i], progress, from, from + part);
      tell([&](std::vector<KnobStudy>& found) { found.push_back(std::move(study)); });
    }
  };
  return StudyTask::start({"", "measure accuracy"}, work);
}

}  // namespace isolux::app
