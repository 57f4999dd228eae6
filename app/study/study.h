// `isolux study`: what each quality knob costs in time, and how far its pictures are from the truth: double
// precision for surfaces, path tracing for their light (app/study/light_study.h).
//
// A knob is turned while all else stays as the scene has it; knobs that act on sampled hits are turned with
// hit.method sampled, and exact hits are measured beside them for comparison. All settings of a knob are
// drawn in turns within one run, so that their times compare.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/compare/compared_picture.h"
#include "app/study/study_results.h"
#include "app/study/surface_truth.h"
#include "base/task.h"
#include "render/renderer.h"
#include "scene/settings/machine.h"

namespace isolux::app {

class LightStudio;
class PictureStudio;
class ScaleStudio;

class Studio {
 public:
  // `gl` stays current. Throws Error{usage} where no pixel of the view shows the surface.
  Studio(const std::shared_ptr<const render::Gl>& gl, StudySubject subject);
  ~Studio();

  // Studies one knob after the other; `each` takes a study as soon as it is finished. Throws
  // Error{interrupted}.
  void study(const std::vector<Knob>& knobs, base::Progress& progress,
             const std::function<void(KnobStudy)>& each);
  // `from`, `to`: what part of the progress this is. Throws Error{interrupted}.
  KnobStudy study(const Knob& knob, base::Progress& progress, double from, double to);

 private:
  struct Alternative;
  void measure(std::vector<Alternative>& alternatives, base::Progress& progress, double from, double to);
  void drawOnce(Alternative& alternative, bool timed);
  void requireSurface(const scene::Scene& scene, base::Progress& progress);
  DrawnImages imagesOf(const scene::Scene& scene);
  KnobStudy studySurface(const Knob& knob, base::Progress& progress, double from, double to);
  void judgeScale(const Alternative& alternative, StudySetting& setting, base::Progress& progress);
  StudySetting judge(const Knob& knob, const Alternative& alternative, base::Progress& progress);

  StudySubject subject_;
  bool software_;  // the processor draws
  render::Renderer renderer_;
  SurfaceTruth truth_;
  std::optional<scene::Field> drawnField_;  // of the hits of the last frame
  std::unique_ptr<ScaleStudio> scale_;      // once asked for
  std::unique_ptr<LightStudio> light_;      // the same
  std::unique_ptr<PictureStudio> picture_;  // the same
};

// Studies knobs in the view of a scene on a background thread that gives way, with a renderer of its own.
// Its news: the knobs that have been studied, in their order.
using StudyTask = base::Task<void, std::vector<KnobStudy>>;
std::unique_ptr<StudyTask> studyTask(StudySubject subject, std::vector<Knob> knobs);

}  // namespace isolux::app
