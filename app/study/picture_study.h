// The quality settings that are judged by the picture of the scene's look alone.
//
// `supersampling`: against the same picture with kReferenceBlock x kReferenceBlock times its pixels, each of
// 4 x 4 rays, averaged in linear light: 256 rays per pixel; an edge is where colours within a pixel of that
// differ (kEdgeContrast). `shadow`: the key light's, on against off; its rays are exact, and no setting
// trades their accuracy, so what is told is what it costs and what it changes.
#pragma once

#include "app/image_metrics/compared_picture.h"
#include "app/study/study_results.h"
#include "base/progress.h"
#include "render/renderer.h"

namespace isolux::app {

inline constexpr int kReferenceBlock = 4;
inline constexpr double kEdgeContrast = 0.1;  // luma of sRGB values, in parts of the full range

// FLIP and root mean square over the whole picture; the edges' figures stay NaN.
ImageErrors pictureErrorsOf(const ComparedPicture& picture, const ComparedPicture& reference);

// One frame of the scene's look.
ComparedPicture drawnPicture(render::Renderer& renderer, const scene::Scene& scene, glm::ivec2 size,
                             int supersampling);

class PictureStudyRunner {
 public:
  // All are the StudyRunner's own. software: the processor draws.
  PictureStudyRunner(render::Renderer& renderer, bool software, const StudySubject& subject);

  // A quality setting of edges or shadow that has an effect in this scene. Throws Error{interrupted, memory}.
  QualityStudy study(const QualitySetting& quality, base::Progress& progress, double from, double to);

 private:
  struct Alternative;
  void time(Alternative& alternative);
  ComparedPicture manyRays(const scene::Scene& scene, base::Progress& progress);

  render::Renderer& renderer_;
  bool software_;
  const StudySubject& subject_;
};

}  // namespace isolux::app
