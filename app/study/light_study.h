// The quality settings of light: each value's light is baked for what the view shows, drawn, and compared
// with per-pixel path tracing at the exact hits.
//
// Bakes of a quality setting are made in turns with all others of it, anew each time; values that only change
// how the same stored light is kept or read share one bake. The truth has the scene's bounces, for the
// quality setting `bounces` kTruthBounces of them; it knows no lattice, no spherical harmonics and no
// compression. Pixels that show the surface from inside are left out.
#pragma once

#include <map>
#include <vector>

#include "app/light/light_controller.h"
#include "app/study/light_reference.h"
#include "app/study/study_results.h"
#include "app/study/surface_reference.h"
#include "render/renderer.h"

namespace isolux::app {

inline constexpr int kTruthBounces = 64;
inline constexpr std::size_t kTruthPixels = 1024;  // of the view's, at most

class LightStudyRunner {
 public:
  // All are the StudyRunner's own.
  LightStudyRunner(render::Renderer& renderer, SurfaceReference& reference, const StudySubject& subject);

  // A quality setting that has an effect in this scene. Throws Error{interrupted}.
  QualityStudy study(const QualitySetting& quality, base::Progress& progress, double from, double to);

 private:
  struct Alternative;
  void prepareHits(base::Progress& progress);
  const LightReference& referenceOf(scene::Scene lit, int bounces, base::Progress& progress);
  // anew: nothing of earlier light is kept; timed: what it takes counts.
  void bake(Alternative& alternative, bool anew, bool timed, base::Progress& progress);
  // E of every pixel; NaN where the picture does not show the truth's first crossing.
  std::vector<float> draw(Alternative& alternative);
  void time(Alternative& alternative, int frames, base::Progress& progress);

  render::Renderer& renderer_;
  SurfaceReference& reference_;
  const StudySubject& subject_;
  LightController controller_;
  std::vector<TrueHit> hits_;
  std::vector<glm::vec3> hitVoxels_;          // NaN where there is none
  std::map<int, LightReference> references_;  // of bounces
};

}  // namespace isolux::app
