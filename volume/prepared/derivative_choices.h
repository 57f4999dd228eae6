// What is automatic about derivatives and depends on the voxels near an isosurface: the noise there, and the
// scales at which curvatures and normals have the least error.
//
// Measured at points that can be seen (visible_points.h) over a ladder of scales (scale_errors.h). Data whose
// noise changes little choose 0. All members may be called from any thread; nobody waits for another's work.
#pragma once

#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.h"
#include "scene/noise.h"
#include "scene/scene.h"
#include "volume/grid.h"
#include "volume/skip/min_max_blocks.h"

namespace isolux::volume {

struct DerivativeChoice {
  double noise = 0.0;  // standard deviation of a voxel as the surface shows it, data units
  double scaleMm = 0.0, normalScaleMm = 0.0;  // derivatives.scale, derivatives.normal_scale
  // At scale 0 and at the one that was chosen: what noise does to a curvature, 1/mm, and to a normal,
  // radians; root mean squares. 0 without a surface.
  double curvatureNoise[2] = {}, normalNoise[2] = {};
  double curvature = 0.0;  // root mean square of the principal curvatures at the chosen scale, 1/mm
  std::string noiseReason, scaleReason, normalReason;  // a sentence each, without a full stop
};

// What a choice depends on.
struct DerivativeQuestion {
  double isovalue = 0.0;
  scene::Field field = scene::Field::cubic;
  std::optional<double> noise = std::nullopt;  // known by somebody; empty: estimated
  bool operator==(const DerivativeQuestion&) const = default;
};

class DerivativeChoices {
 public:
  // knownNoise: of a voxel, where somebody knows it; of data without any all is said at once: scale 0.
  // isMesh: of a distance field, whose roughness counts as noise for curvature (facets, and voxels between
  // them, have none), but is what normals show.
  DerivativeChoices(std::shared_ptr<const Grid> grid, std::shared_ptr<const MinMaxBlocks> blocks,
                    std::optional<double> knownNoise = {}, bool isMesh = false)
      : grid_(std::move(grid)), blocks_(std::move(blocks)), knownNoise_(knownNoise), isMesh_(isMesh) {}

  // Of the whole volume. Throws Error{interrupted}, as all that take a Progress.
  scene::NoiseModel noise(base::Progress& progress) const;

  std::optional<DerivativeChoice> find(const DerivativeQuestion& question) const;
  DerivativeChoice choose(const DerivativeQuestion& question, base::Progress& progress) const;

  // Fills in what is empty of derivatives.noise, .scale and .normal_scale of a scene whose isovalue is known:
  // with what has been chosen before (false: nothing has, and nothing is filled in), or by choosing.
  bool completeIfChosen(scene::Scene& scene) const;
  void complete(scene::Scene& scene, base::Progress& progress) const;

 private:
  struct Kept {
    DerivativeQuestion question;
    DerivativeChoice choice;
  };
  glm::dvec3 slices(base::Progress& progress) const;  // interpolatedSlices(), found once

  std::shared_ptr<const Grid> grid_;
  std::shared_ptr<const MinMaxBlocks> blocks_;
  std::optional<double> knownNoise_;
  bool isMesh_;
  mutable std::mutex mutex_;  // held for moments
  mutable std::optional<scene::NoiseModel> noise_;
  mutable std::optional<glm::dvec3> slices_;
  mutable std::vector<Kept> kept_;  // the latest last
};

}  // namespace isolux::volume
