// Finds the settings that keep a target: draws combinations of them small, measures their errors, chooses.
//
// Errors are against double precision on the fields that the scene asks for (SurfaceReference), and against
// path tracing (LightEvaluator), of the first isosurface as a whole: hits and derivatives in a picture of the
// same view of at most kFewPixels pixels, light on few pixels of the picture; where those leave open whether
// a limit is kept, on more (app/error_budget/stages.h), at most kMostPixels. An error is kept by the
// combination of least work (app/error_budget/work.h), which no clock decides: the same scene, picture and
// executor give the same choice. A time is kept by the clock.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/error_budget/candidates.h"
#include "app/error_budget/choice.h"
#include "app/error_budget/light_evaluator.h"
#include "app/study/surface_reference.h"
#include "base/task.h"
#include "render/renderer.h"

namespace isolux::app {

inline constexpr int kFewPixels = 40000, kManyPixels = 160000, kMostPixels = 800000;
// `picture`, or smaller in about the same proportions.
glm::ivec2 measuredSize(glm::ivec2 picture, int mostPixels);

struct TargetAnswer {
  std::vector<MeasuredCandidate> measured;  // in the order of the search
  std::size_t chosen = 0;                   // of these
  std::vector<Limit> limits;       // that it was chosen by: those asked for, then those that nobody asked for
  std::size_t asked = 0;           // the first so many of them
  std::vector<std::string> notes;  // what was ignored, and why; one sentence each
  std::string reason;              // of the choice, one clause
  double expectedMilliseconds = 0.0;  // of a picture's frame, its light stored; of errors a rough one
};

class TargetSearch {
 public:
  // `renderer` shows the question's volume and is not used by others until the end.
  TargetSearch(render::Renderer& renderer, TargetQuestion question);

  // Nothing where nothing of the surface is seen: then there is nothing to choose by. Throws Error{usage}
  // where nothing reaches the target, naming what comes nearest; Error{interrupted}.
  std::optional<TargetAnswer> keepErrors(const std::vector<Limit>& asked, base::Progress& progress);
  std::optional<TargetAnswer> keepTime(double milliseconds, base::Progress& progress);

  // For tests and benchmarks: what the searches do one by one.
  std::vector<Candidate> candidates(bool turnDerivatives, base::Progress& progress);
  TargetErrors measure(const Candidate& candidate, Measuring measuring, base::Progress& progress);
  TargetErrors measureLight(const Candidate& candidate, Measuring measuring, base::Progress& progress);
  // Small, since measure(): milliseconds of a frame of the picture's look, times the picture's rays.
  double scaledMilliseconds(const Candidate& candidate, base::Progress& progress);

 private:
  bool prepare(base::Progress& progress);
  SurfaceReference& referenceAt(glm::ivec2 size);
  std::vector<Limit> actingLimits(const std::vector<Limit>& asked, TargetAnswer& answer,
                                  base::Progress& progress) const;
  bool acts(Quantity quantity) const;
  void addUnasked(TargetAnswer& answer) const;
  void addSurface(TargetAnswer& answer, base::Progress& progress);
  void addLight(TargetAnswer& answer, const MeasuredCandidate& surface, base::Progress& progress);
  Candidate asGiven() const;
  scene::Scene sceneOf(const Candidate& candidate, base::Progress& progress) const;
  double frameMilliseconds(const Candidate& candidate, double most, base::Progress& progress);
  Turning turning(bool derivatives) const;

  render::Renderer& renderer_;
  TargetQuestion question_;
  glm::ivec2 size_;                        // of Measuring::few
  std::optional<scene::Scene> reference_;  // resolved and complete, its hits those at rest
  std::map<std::pair<int, int>, SurfaceReference> references_;  // by size
  double lightNoise_ = 0.01;  // of the truth: app/error_budget/light_evaluator.h
  std::optional<LightEvaluator> light_;
};

// Searches the settings that keep an error or a time for the view on show, on a background thread that gives
// way, with a renderer of its own.
struct TargetSubject : TargetQuestion {           // whose executor the machine decides
  std::shared_ptr<const gi::PictureLight> light;  // that is stored: frames that are timed read it
  std::vector<Limit> limits;                      // empty: `milliseconds` is what is to be kept
  double milliseconds = 0.0;
};
// Its value: none where nothing of the first isosurface is seen. Its error: also that nothing keeps it.
using TargetTask = base::Task<std::optional<TargetAnswer>>;
std::unique_ptr<TargetTask> targetTask(TargetSubject asked);

// Searches of this process that have not ended.
int runningSearches();

}  // namespace isolux::app
