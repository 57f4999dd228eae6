// `isolux study`: what each quality knob costs in time, and how far its pictures are from the truth: double
// precision for surfaces, path tracing for their light (app/study/light_study.h).
//
// A knob is turned while all else stays as the scene has it; knobs that act on sampled hits are turned with
// hit.method sampled, and exact hits are measured beside them for comparison. All settings of a knob are
// drawn in turns within one run, so that their times compare.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/study/study_errors.h"
#include "app/study/study_knobs.h"
#include "app/study/surface_truth.h"
#include "base/progress.h"
#include "render/renderer.h"
#include "scene/machine.h"

namespace isolux::app {

// What stored light costs.
struct LightCost {
  double bakeSeconds = 0.0;            // median; NaN where the settings of a knob share one bake
  double lookupMilliseconds = 0.0;     // pass irradiance, median
  std::uint64_t rays = 0, texels = 0;  // rays: 0 where the bake is shared
  std::uint64_t latticeBytes = 0, gpuBytes = 0;
};

// What a field at a scale costs beside its pictures.
struct ScaleCost {
  double scaleMm = 0.0;
  double buildSeconds = 0.0;  // 0: none is built
  double unknown = 0.0;       // part of the surface's pixels whose curvature has a confidence below 1/2
};

struct StudySetting {
  std::string value;
  bool isDefault = false;
  bool comparison = false;                         // exact hits beside a knob of sampled ones
  double frameMilliseconds = 0.0;                  // the picture of the scene's look, every pass run again
  std::map<std::string, double> passMilliseconds;  // with gradient and hessian each run for themselves
  Errors errors;                                   // against double precision on the same fields
  std::optional<Errors> fieldErrors;  // of a field: against cubic_interpolating in double precision
  std::optional<ScaleCost> scale{};   // of the knob of the scale; then only errors.noise is defined
  std::optional<LightCost> light;     // of a knob of light; then only errors.light is defined
};

struct KnobStudy {
  Knob knob;
  std::vector<StudySetting> settings;
  std::string plot;       // file name beside study.json; "" where there is none
  std::string skipped{};  // why it was not studied: it has no effect in this scene
  // Of the knob of the scale: the noise that was added, data units, and whether the truth is a phantom's own.
  double addedNoise = 0.0;
  bool knowsTruth = false;
  // Of a knob of light: what it was compared with.
  std::uint64_t truthSamples = 0;  // paths per pixel
  int truthBounces = 0;
};

// The time of the passes that make a panel's error.
double milliseconds(const StudySetting& setting, const Panel& panel);
// What the panel shows its error against: that time, or what the light costs.
double costOf(const Knob& knob, const StudySetting& setting, const Panel& panel);
// What the setting is judged by: the errors of its field where it is a field, otherwise of its arithmetic.
const Errors& judged(const StudySetting& setting);
// The cheapest of the knob's settings whose first panel's error is at most this; null: none is.
const StudySetting* cheapest(const KnobStudy& study, double error);
// What cheapest() is asked for: of hits in voxels, of shapes in degrees, of scales in parts of the curvature,
// of light in parts of its mean.
const std::array<double, 3>& errorsToReach(Measure measure);

class LightStudio;
class ScaleStudio;

class Studio {
 public:
  // `scene` as the user gave it. `gl` stays current. Throws Error{usage} where no pixel of the view shows the
  // surface.
  Studio(const std::shared_ptr<const render::Gl>& gl, std::shared_ptr<const volume::PreparedVolume> volume,
         scene::Scene scene, const scene::Machine& machine, glm::ivec2 size, int repeat);
  ~Studio();

  // `from`, `to`: what part of the progress this is. Throws Error{interrupted}.
  KnobStudy study(const Knob& knob, base::Progress& progress, double from, double to);

 private:
  struct Alternative;
  void measure(std::vector<Alternative>& alternatives, base::Progress& progress, double from, double to);
  void drawOnce(Alternative& alternative, bool timed);
  void requireSurface(const scene::Scene& scene, base::Progress& progress);
  DrawnImages imagesOf(const scene::Scene& scene);
  void judgeScale(const Alternative& alternative, StudySetting& setting, base::Progress& progress);
  StudySetting judge(const Knob& knob, const Alternative& alternative, base::Progress& progress);

  std::shared_ptr<const volume::PreparedVolume> volume_;
  scene::Scene scene_;
  glm::ivec2 size_;
  scene::Machine machine_;
  int repeat_;
  render::Renderer renderer_;
  SurfaceTruth truth_;
  std::optional<scene::Field> drawnField_;  // of the hits of the last frame
  std::unique_ptr<ScaleStudio> scale_;      // once asked for
  std::unique_ptr<LightStudio> light_;      // the same
};

}  // namespace isolux::app
