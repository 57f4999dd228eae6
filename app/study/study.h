// `isolux study`: what each quality setting costs in time, and how far its pictures are from the truth:
// double precision for surfaces, path tracing for their light (app/study/light_study.h).
//
// A quality setting is turned while all else stays as the scene has it; quality settings that act on sampled
// hits are turned with hit.method sampled, and exact hits are measured beside them for comparison. All
// values of a quality setting are drawn in turns within one run, so that their times compare.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "app/study/light_study.h"
#include "app/study/picture_study.h"
#include "app/study/scale_study.h"
#include "app/study/study_results.h"
#include "app/study/surface_reference.h"
#include "base/task.h"
#include "render/renderer.h"

namespace isolux::app {

class StudyRunner {
 public:
  // `gl` stays current. Throws Error{usage} where no pixel of the view shows the surface.
  StudyRunner(const std::shared_ptr<const render::Gl>& gl, StudySubject subject);

  // Studies one quality setting after the other; `each` takes a study as soon as it is finished. Throws
  // Error{interrupted}.
  void study(const std::vector<QualitySetting>& qualities, base::Progress& progress,
             const std::function<void(QualityStudy)>& each);
  // `from`, `to`: what part of the progress this is. Throws Error{interrupted}.
  QualityStudy study(const QualitySetting& quality, base::Progress& progress, double from, double to);

 private:
  struct Alternative;
  void measure(std::vector<Alternative>& alternatives, base::Progress& progress, double from, double to);
  void drawOnce(Alternative& alternative, bool timed);
  void requireSurface(const scene::Scene& scene, base::Progress& progress);
  DrawnImages imagesOf(const scene::Scene& scene);
  QualityStudy studySurface(const QualitySetting& quality, base::Progress& progress, double from, double to);
  void judgeScale(const Alternative& alternative, StudySetting& setting, base::Progress& progress);
  StudySetting judge(const QualitySetting& quality, const Alternative& alternative, base::Progress& progress);

  StudySubject subject_;
  bool software_;  // the processor draws
  render::Renderer renderer_;
  SurfaceReference reference_;
  std::optional<scene::Field> drawnField_;     // of the hits of the last frame
  std::optional<ScaleStudyRunner> scale_;      // once asked for
  std::optional<LightStudyRunner> light_;      // the same
  std::optional<PictureStudyRunner> picture_;  // the same
};

// Studies quality settings in the view of a scene on a background thread that gives way, with a renderer of
// its own. Its news: the quality settings that have been studied, in their order.
using StudyTask = base::Task<void, std::vector<QualityStudy>>;
std::unique_ptr<StudyTask> studyTask(StudySubject subject, std::vector<QualitySetting> qualities);

}  // namespace isolux::app
