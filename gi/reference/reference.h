// Path-traces every pixel of an image without baked lighting: the reference for the light lattice, and a
// still for print.
//
// One ray per pixel, through its centre, as in the renderer's AOVs. E is that of the path tracer at the hit
// itself, on the visible side (back faces: innerSideOf()). The sky and the light sources each have their own
// pattern of samples. Paths are traced against the surface's isovalue; if hits are on a cubic field, against
// the trilinear isosurface through the hit. The colour is albedo * E / pi * 2^picture.exposure (or the
// automatic exposure), times look.inner_tint on back faces. Front faces have their gloss over it
// (gi/sampling/gloss_lobe.h). The ground is that of frames (gi/ground/ground_shadow.h). Solid textures, lines
// and fog are not drawn. gi.mode has no effect, except that `vicinity` uses the sky's mean without bounces,
// and `shadow` no bounces.
//
// One owner thread. It shares the work among its own threads; the result does not depend on their number.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/memory_budget.h"
#include "base/progress.h"
#include "gi/gloss/reflections.h"
#include "gi/ground/ground_shadow.h"
#include "gi/picture_light.h"
#include "gi/sampling/environment.h"
#include "gi/trace/path_tracer.h"
#include "gi/trace/primary_hits.h"

namespace isolux::gi {

// Row 0 is the top row; one entry per pixel. A pixel without a hit or sample is NaN. Its colour is then that
// of the environment, if that is shown as the background.
struct ReferenceImage {
  glm::ivec2 size{0};
  std::vector<glm::vec3> color;       // linear
  std::vector<glm::vec3> irradiance;  // E, with the environment's exposure
  std::vector<float> variance;        // of the mean's luminance of E, estimated from the samples
  // R of glossy front faces and the variance of its mean's luminance; empty if there are none.
  std::vector<glm::vec3> gloss;
  std::vector<float> glossVariance;
  std::vector<std::uint32_t> samples;  // paths of each kind of light
  std::vector<std::uint8_t> hit;
  std::vector<float> ground;  // fraction of the light that reaches the ground there; empty if there is none
  std::uint64_t rays = 0;     // of the paths
  std::uint64_t cappedPaths = 0;  // PathTracer::cappedPaths()
};

class Reference {
 public:
  struct Options {
    glm::ivec2 size{512, 512};
    int threads = 1;
    std::vector<std::uint32_t> pixels = {};  // only these, ascending, x fastest; empty: all
    bool meterView = false;                  // automatic exposure: of the view, not of the front
  };
  // Finds the visible points. `environment`: that of light.environment; `tracer`: of the volume and
  // isosurface.inside. Throws Error: usage if a surface is transparent; memory before anything is allocated;
  // interrupted.
  Reference(std::shared_ptr<const volume::PreparedVolume> volume,
            std::shared_ptr<const volume::IsosurfaceTracer> tracer,
            std::shared_ptr<const Environment> environment, const scene::Scene& resolved,
            const Options& options, base::Progress& progress);

  // Adds samples to all pixels up to this number and reports fractions in [from, to]. Returns false when
  // stopped (within 100 ms): finished samples stay, and pixels then differ in their number of samples.
  bool refineTo(std::uint32_t samples, base::Progress& progress, double from = 0.0, double to = 1.0);
  ReferenceImage image() const;
  double exposure() const;  // stops: picture.exposure or the automatic one

  std::size_t litPixels() const { return points_.size(); }  // pixels from which paths start

 private:
  // Mean and sum of squares of one point's samples, merged round by round (Chan et al. 1979).
  struct Estimate {
    glm::dvec3 mean{0.0};
    double count = 0.0, luminance = 0.0, squares = 0.0;
    void merge(glm::vec3 roundMean, float roundVariance, std::uint32_t roundCount);
  };
  void findHits(const Options& options, base::Progress& progress);
  struct Task {  // points of one side
    std::size_t first = 0, count = 0;
    std::uint32_t samples = 0;
  };
  struct RowPoints {  // outer, inner
    std::array<std::vector<LightPoint>, 2> points;
    std::array<std::vector<std::uint32_t>, 2> pixels;
    std::vector<glm::vec3> rays;  // of outer points: unit, world, from the eye
  };
  std::vector<float> groundOfPixels() const;  // 1 on the surface
  // `wanted`: columns.
  bool findHitsOfRow(std::size_t row, std::span<const std::uint32_t> wanted, const base::Progress& progress,
                     RowPoints& found);
  std::vector<glm::vec3> gradientsAt(const std::vector<glm::vec3>& voxels) const;
  void findGloss(const std::vector<RowPoints>& rows);
  bool refineGloss(const Task& task, SampleRange range, std::uint64_t& rays, const std::stop_token& stop);
  bool refineTask(Task& task, std::uint32_t samples, std::uint64_t& rays, const std::stop_token& stop);

  static std::size_t bytesOf(glm::ivec2 size);  // of all data per pixel, with an image()

  base::MemoryBudget::Held held_;
  scene::Scene scene_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
  glm::ivec2 size_;
  int threads_;
  PrimaryHits hits_;
  std::optional<PathTracer> tracer_, innerTracer_;  // innerTracer_: if back faces are visible
  PictureLight light_;
  std::shared_ptr<const Environment> background_;
  std::shared_ptr<const GroundShadow> ground_;
  bool hasSky_ = false, hasLamps_ = false;

  std::vector<int> surfaces_;           // of pixels; -1: no hit
  std::vector<std::uint32_t> pixelOf_;  // of points
  std::vector<LightPoint> points_;      // those of front faces first
  std::size_t outerPoints_ = 0;
  std::vector<Estimate> sky_, lamps_;  // of points
  // These are of front faces; empty if no surface is glossy. A matt point has the share 0.
  std::vector<GlossPoint> glossPoints_;
  std::vector<float> glossShares_;  // F
  std::vector<RadianceSum> gloss_;
  std::vector<Task> tasks_;
  std::uint64_t rays_ = 0;
};

// Returns the numbers of paths, up to `samples`, at which to show an image while it is refined: 1, 4, 16, 64,
// 128, 192, ...
std::vector<std::uint32_t> referenceRounds(std::uint32_t samples);

}  // namespace isolux::gi
