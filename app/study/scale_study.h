// Studies what noise makes of normals and curvatures at a scale: the quality setting `derivatives_scale`.
//
// Noise is added to the volume, kNoiseSeeds times, and each time the shape at points of the view's surface is
// derived at the scale, in double precision. The points stay those of the volume as it is.
// A phantom has no noise of its own: it gets what moves its surface by kPhantomNoiseVoxels at points of
// median gradient, and shapes are compared with those of the volume without noise at scale 0, so that what
// smoothing takes from the shape counts too. A scan gets noise as it has: shapes are compared with those at
// the same scale without the addition, which is how far another scan of the same patient would differ.
#pragma once

#include <map>
#include <memory>
#include <vector>

#include "app/study/study_errors.h"
#include "base/progress.h"
#include "scene/noise.h"
#include "scene/scene.h"
#include "volume/prepared/prepared_volume.h"

namespace isolux::app {

inline constexpr std::size_t kScalePoints = 1000;  // at most
inline constexpr int kNoiseSeeds = 3;
inline constexpr double kPhantomNoiseVoxels = 0.1;  // deviation

struct ScaleFindings {
  NoiseErrors errors;
  double buildSeconds = 0.0;  // of the field at the scale, median of the seeds; 0: none is built
};

class ScaleStudyRunner {
 public:
  // points: voxel coordinates on the surface. `noise`: of the volume. `resolved`: its source, field of
  // derivatives, inside and isovalue count.
  ScaleStudyRunner(std::shared_ptr<const volume::PreparedVolume> volume, const scene::Scene& resolved,
                   std::vector<glm::dvec3> points, scene::NoiseModel noise);

  bool isPhantom() const { return phantom_; }
  double deviation() const { return deviation_; }  // of the noise that is added, data units
  ScaleFindings at(double scaleMm, base::Progress& progress);

 private:
  using Shapes = std::vector<TrueShape>;
  // seconds: what building the field took is added to them.
  Shapes shapesOf(const volume::Grid& grid, scene::Field field, double scaleMm, std::vector<double>& seconds,
                  base::Progress& progress) const;
  const Shapes& referenceAt(double scaleMm, base::Progress& progress);
  volume::Grid noisy(int seed, base::Progress& progress) const;

  std::shared_ptr<const volume::PreparedVolume> volume_;
  std::vector<glm::dvec3> points_;
  scene::NoiseModel noise_;
  scene::Field field_;
  bool phantom_;
  double outward_, flatCurvature_, deviation_ = 0.0;
  std::map<double, Shapes> references_;  // by scale; of a phantom there is that of 0 alone
};

}  // namespace isolux::app
