// How far the light of a scene's picture is from path tracing: bakes what the picture needs, and draws it.
//
// References are of the first scene that is judged: traced with its bounces, at exact hits of some of the
// picture's pixels (app/study/light_reference.h), those of a measuring once it is asked for. More pixels say
// more of an error's root mean square than more paths at each, because the reference's own noise is taken out
// of it. The light is that of the whole picture: of a smaller one fewer texels are lit, and what lies between
// them is noisier.
#pragma once

#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "app/error_budget/candidates.h"
#include "app/light/light_controller.h"
#include "app/study/light_errors.h"
#include "app/study/surface_reference.h"
#include "render/renderer.h"

namespace isolux::app {

// At most so many pixels are judged; of `picture`, which only tests ask for, all.
constexpr std::size_t judgedPixels(Measuring measuring) {
  constexpr std::size_t pixels[] = {4096, 16384, 65536, std::numeric_limits<std::size_t>::max()};
  return pixels[static_cast<int>(measuring)];
}

class LightEvaluator {
 public:
  // Light is baked for the question's picture. `truth`: of the view in `size`, whose pixels are judged.
  // `noise`: of the light's truth, in parts of the mean E, at most, as far as kMostPaths reach.
  LightEvaluator(render::Renderer& renderer, SurfaceReference& reference, const TargetQuestion& question,
                 glm::ivec2 size, double noise);

  // `scene` resolved and complete, its light stored. The same scene again is not baked again. The standard
  // error is that of a part of the picture's pixels, drawn by lot: none where all are judged. Throws
  // Error{interrupted}.
  LightErrors judge(const scene::Scene& scene, Measuring measuring, base::Progress& progress);

 private:
  const LightReference& referenceOf(Measuring measuring, base::Progress& progress);
  void draw(const scene::Scene& scene, base::Progress& progress);

  render::Renderer& renderer_;
  SurfaceReference& surface_;
  const TargetQuestion& question_;
  glm::ivec2 size_;
  double noise_;
  LightController controller_;
  std::optional<scene::Scene> reference_;             // the first that was judged
  const std::vector<TrueHit>* hits_ = nullptr;        // of reference_
  std::size_t seen_ = 0;                              // pixels that can be judged
  std::map<std::size_t, LightReference> references_;  // by number of pixels
  std::optional<scene::Scene> drawn_;
  std::vector<float> irradiance_;  // of drawn_; NaN where another crossing was hit
};

}  // namespace isolux::app
