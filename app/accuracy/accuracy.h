// What is said of the accuracy of a whole picture, and drawing what it takes to say it.
#pragma once

#include <limits>
#include <memory>
#include <optional>

#include "app/accuracy/light_bounds.h"
#include "app/accuracy/picture_errors.h"
#include "base/task.h"
#include "render/renderer.h"

namespace isolux::app {

// The middle of a bound over the pixels that have one, and what 99 % of them do not exceed; NaN without any.
struct BoundSpread {
  double median = 0.0, most99 = 0.0;
};

struct Accuracy {
  std::size_t pixels = 0;                                            // of the picture
  std::size_t seen = 0;                                              // that show a surface, or may
  std::size_t uncertain = 0;                                         // whose answer may change by a jump
  BoundSpread depthMm, normalDegrees, curvature, relativeCurvature;  // curvature: 1/mm
  BoundSpread normalNoiseDegrees, curvatureNoise;                    // at kNoiseLevel
  BoundSpread depthNoiseMm;                                          // of noise and sampling
  // Of stored light, at kLightLevel: of E, and in parts of the picture's mean E. NaN without any.
  BoundSpread light, relativeLight;
  // What kLightLevel of the pixels do not exceed, in parts of the mean E.
  double relativeLightWithin = std::numeric_limits<double>::quiet_NaN();

  double uncertainShare() const;  // of the picture's pixels
};
Accuracy accuracyOf(const PictureErrors& errors);

// Whether the picture's rays were cast by the processor, whose arithmetic is another than that of shaders.
bool castsOnProcessor(const render::FrameReport& report);

// Bounds of the picture `drawn` (what of its scene's derivatives is automatic is filled in here): its rays
// are cast again. Its light is bounded, too, where it is stored. `drawnOnProcessor`: who drew the picture,
// where that was another renderer; its arithmetic is bounded. Throws as render::drawStill(), pictureErrors()
// and boundLight().
PictureErrors measureErrors(render::Renderer& renderer, ShownPicture drawn, base::Progress& progress,
                            std::optional<bool> drawnOnProcessor = {});

// The same on a background thread, with a renderer of its own that casts on the processor, of a picture whose
// scene is resolved and as it is shown in motion; what is there at rest is found here.
struct AccuracySubject : ShownPicture {
  bool onProcessor = false;  // who drew it
  bool keepImages = false;   // what each pixel errs by is wanted, too
};
struct MeasuredPicture {
  Accuracy accuracy;
  std::shared_ptr<const PictureErrors> images;  // null: not wanted
};
using AccuracyTask = base::Task<MeasuredPicture>;
std::unique_ptr<AccuracyTask> accuracyTask(AccuracySubject asked);

}  // namespace isolux::app
