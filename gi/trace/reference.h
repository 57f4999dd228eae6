// A picture whose every pixel is path traced, without stored light: the yardstick of the light lattice, and a
// still for print.
//
// One ray a pixel, through its middle, as in the renderer's deferred images. E is that of the path tracer at
// the hit itself, on the side that is seen (inner sides: innerSideOf()), of the sky and of the lamps, each
// from its own pattern of samples; the paths are traced against the surface's isovalue, or, where hits are on
// a cubic field, against that of the trilinear isosurface through the hit. The colour is albedo * E / pi *
// 2^picture.exposure, or the automatic exposure of a picture of the scene, times look.inner_tint on inner
// sides; solid textures, lines and fog are not drawn. What gi.mode stores does not matter, but that
// `vicinity` takes the sky's mean and no bounces and `shadow` no bounces.
//
// One owner thread; the work is spread over threads of its own, and the result does not depend on how many.
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
#include "gi/picture_light.h"
#include "gi/sampling/environment.h"
#include "gi/trace/path_tracer.h"
#include "gi/trace/primary_hits.h"

namespace isolux::gi {

// Row 0 is the top row; one entry a pixel. NaN where there is no hit, or no sample yet; the colour
// is then that of the environment where that is shown behind the surface, else NaN.
struct ReferenceImage {
  glm::ivec2 size{0};
  std::vector<glm::vec3> color;        // linear
  std::vector<glm::vec3> irradiance;   // E, with the environment's exposure
  std::vector<float> variance;         // of the mean's luminance of E, from the samples themselves
  std::vector<std::uint32_t> samples;  // paths of each light
  std::vector<std::uint8_t> hit;
  std::uint64_t rays = 0;         // of the paths
  std::uint64_t cappedPaths = 0;  // PathTracer::cappedPaths()
};

class Reference {
 public:
  struct Options {
    glm::ivec2 size{512, 512};
    int threads = 1;
    std::vector<std::uint32_t> pixels = {};  // these alone, rising, x fastest; none: all
  };
  // Finds what the pixels see. `environment`: what light.environment names; `tracer`: of the volume and
  // isosurface.inside. Throws Error: usage where a surface is transparent,
  // memory before anything is made, interrupted.
  Reference(std::shared_ptr<const volume::PreparedVolume> volume,
            std::shared_ptr<const volume::IsosurfaceTracer> tracer,
            std::shared_ptr<const Environment> environment, const scene::Scene& resolved,
            const Options& options, base::Progress& progress);

  // Adds samples to all pixels up to this number and reports fractions of [from, to]. False when stopped
  // (within 100 ms): what is finished stays, pixels then differ in their number of samples.
  bool refineTo(std::uint32_t samples, base::Progress& progress, double from = 0.0, double to = 1.0);
  ReferenceImage image() const;

  std::size_t litPixels() const { return points_.size(); }  // that paths start from

 private:
  // Of one point: mean and sum of squares of its samples, merged round by round (Chan et al. 1979).
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
  };
  // `wanted`: columns.
  bool findHitsOfRow(std::size_t row, std::span<const std::uint32_t> wanted, const base::Progress& progress,
                     RowPoints& found);
  std::vector<glm::vec3> gradientsAt(const std::vector<glm::vec3>& voxels) const;
  void addTasks(std::size_t first, std::size_t pointsOfTask);  // of all points from there on
  bool refineTask(Task& task, std::uint32_t samples, std::uint64_t& rays, const std::stop_token& stop);

  static std::size_t bytesOf(glm::ivec2 size);  // of all that there is per pixel, with an image()

  base::MemoryBudget::Held held_;
  scene::Scene scene_;
  std::shared_ptr<const volume::PreparedVolume> volume_;
  glm::ivec2 size_;
  int threads_;
  PrimaryHits hits_;
  std::optional<PathTracer> tracer_, innerTracer_;  // innerTracer_: where inner sides are seen
  PictureLight light_;
  std::shared_ptr<const Environment> background_;
  bool hasSky_ = false, hasLamps_ = false;

  std::vector<int> surfaces_;           // of pixels; -1: no hit
  std::vector<std::uint32_t> pixelOf_;  // of points
  std::vector<LightPoint> points_;      // first those of outer sides
  std::size_t outerPoints_ = 0;
  std::vector<Estimate> sky_, lamps_;  // of points
  std::vector<Task> tasks_;
  std::uint64_t rays_ = 0;
};

// Where to look at a picture of up to `samples` paths while it becomes better: 1, 4, 16, 64, 128, 192, ...
std::vector<std::uint32_t> referenceRounds(std::uint32_t samples);

}  // namespace isolux::gi
